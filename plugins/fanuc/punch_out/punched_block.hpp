/// Blocks of the text files that a control puts out: words follow each other without blanks, `;` or `$` may end a
/// block.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/cnc/file_length.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

/// The beginning of a text for a report, up to a character that is not ASCII.
inline std::string_view shown_part(std::string_view text) {
  const auto is_shown = [](char c) { return c >= ' ' && c <= '~'; };
  const auto end = std::find_if_not(text.begin(), text.end(), is_shown) - text.begin();
  text = text.substr(0, std::min<std::size_t>(static_cast<std::size_t>(end), 30));
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

struct PunchedWord {
  char letter = 0;
  ig::Decimal number{};
  std::string_view digits;         // the number as written
  std::size_t begin = 0, end = 0;  // in the file

  std::optional<std::int64_t> whole() const { return ig::cnc::whole_number(number.value); }
  bool is(char l, double value) const { return letter == l && number.value == value; }
};

/// The words of a line without its comments. A block that holds anything else has a fault and is not to be read.
class PunchedBlock {
 public:
  /// The vector of an earlier block is used again.
  void read(const ig::TextLine& line) {
    words_.clear();
    comment_ = fault_ = {};
    is_sound_ = true;
    begin_ = end_ = line.begin;
    const std::string_view text = line.text;
    for (std::size_t i = 0; i < text.size();) {
      if (is_padding(text[i])) {
        ++i;
        continue;
      }
      if (begin_ == end_) begin_ = line.begin + i;
      std::size_t end = i + 1;
      if (text[i] == '(') {
        end = std::min(text.find(')', i), text.size() - 1) + 1;
        comment_ = text.substr(i + 1, end - i - 1);
        if (comment_.ends_with(')')) comment_.remove_suffix(1);
      } else if (!read_word(line, i, end)) {
        fault_ = shown_part(text.substr(i));
        fault_begin_ = line.begin + i;
        is_sound_ = false;
        end = text.size();
      }
      end_ = line.begin + end;
      i = end;
    }
  }

  const std::vector<PunchedWord>& words() const { return words_; }
  bool is_empty() const { return words_.empty() && is_sound_; }
  bool is_sound() const { return is_sound_; }
  std::string_view comment() const { return comment_; }
  std::size_t begin() const { return begin_; }
  std::size_t end() const { return end_; }

  /// Of several such words the last one, as on the control.
  const PunchedWord* find(char letter) const {
    const auto found =
        std::find_if(words_.rbegin(), words_.rend(), [&](const PunchedWord& w) { return w.letter == letter; });
    return found == words_.rend() ? nullptr : &*found;
  }
  bool has(char letter, double value) const {
    return std::any_of(words_.begin(), words_.end(), [&](const PunchedWord& w) { return w.is(letter, value); });
  }
  /// True for blocks beside the data of a file that a control puts out.
  bool is_frame() const {
    return std::all_of(words_.begin(), words_.end(), [](const PunchedWord& w) {
      const double n = w.number.value;
      return w.letter == 'O' || w.letter == 'N' || (w.letter == 'M' && (n == 2 || n == 30 || n == 99)) ||
             (w.letter == 'G' && (n == 10 || n == 11 || n == 20 || n == 21 || n == 90 || n == 91));
    });
  }
  /// Says of L, P and R that the block has a later one. Values of axes the host compares.
  void report_repeated(ig::Import& file) const {
    for (const PunchedWord& w : words_)
      if ((w.letter == 'L' || w.letter == 'P' || w.letter == 'R') && &w != find(w.letter))
        file.unused(std::string("word ") + w.letter, "the block has a later one, which is read", w.begin, w.end);
  }
  void report_fault(ig::Import& file) const {
    file.report(ig::diag("FAN-0230"), fault_begin_, fault_begin_ + fault_.size(), fault_);
  }

  static constexpr std::string_view padding = " \t;$%";
  static bool is_padding(char c) { return padding.find(c) != std::string_view::npos; }

 private:
  bool read_word(const ig::TextLine& line, std::size_t i, std::size_t& end) {
    const std::string_view text = line.text;
    const char letter = text[i] == ':' ? 'O' : text[i];
    if (letter < 'A' || letter > 'Z') return false;
    const std::size_t first = std::min(text.find_first_not_of(' ', i + 1), text.size());
    const ig::Decimal number = ig::read_decimal(text, first);
    if (!number.ok || std::abs(number.value) > largest) return false;
    end = number.end;
    words_.push_back({letter, number, text.substr(first, end - first), line.begin + i, line.begin + end});
    return true;
  }

  static constexpr double largest = 1e15;  // a damaged file has longer numbers; their products may not be finite

  std::vector<PunchedWord> words_;
  std::string_view comment_, fault_;
  std::size_t begin_ = 0, end_ = 0, fault_begin_ = 0;
  bool is_sound_ = true;
};

/// How the offsets of a file are measured. A unit that the file does not name is assumed to be mm, with a warning.
enum class OffsetUnit { unknown, mm, inch };
enum class ToolRadius { radius, diameter };

/// A value in mm (of a linear axis) or degrees. Without a decimal point it counts increments.
struct PunchedUnit {
  bool is_inch = false;
  bool counts_increments = true;
  double counts_per_mm = 1000;  // an inch has a tenth of them for each mm of 10
  bool is_assumed = false;      // neither the file nor the user names it

  double mm(const ig::Decimal& n) const {
    const double in_unit = n.has_point || !counts_increments ? n.value : n.value / counts_per_mm / (is_inch ? 10 : 1);
    return ig::cnc::length_in_mm(in_unit, is_inch ? ig::cnc::mm_per_inch : 1);
  }
  /// The same; the first length of an assumed unit is reported.
  double mm(ig::Import& file, const PunchedWord& word) {
    report_assumption(file, word.number.value, word.begin, word.end);
    return mm(word.number);
  }
  double mm(ig::Import& file, double value, std::size_t begin, std::size_t end) {
    report_assumption(file, value, begin, end);
    return ig::cnc::length_in_mm(value, is_inch ? ig::cnc::mm_per_inch : 1);
  }
  double degrees(const ig::Decimal& n) const {
    return n.has_point || !counts_increments ? n.value : n.value / counts_per_mm;
  }

 private:
  void report_assumption(ig::Import& file, double value, std::size_t begin, std::size_t end) {
    if (!is_assumed || value == 0) return;
    file.report(ig::diag("FAN-0241"), begin, end);
    is_assumed = false;
  }
};

/// Gives the value of an axis to the row of a work offset.
inline void put_offset(ig::Import& file, std::string_view id, char axis, double value, const PunchedWord& word) {
  constexpr double most = 1e9;  // that of the table
  const std::string_view column(&axis, 1);
  if (std::abs(value) > most)
    return file.report(ig::diag("FAN-0239"), word.begin, word.end, shown_part(word.digits), column);
  file.row("IsoCoordinateTable", id, word.begin);
  file.cell(column, value, word.begin);
}

inline bool is_rotary(char axis) { return axis >= 'A' && axis <= 'C'; }

/// A number as a control writes it: "12.5", "-3.".
inline std::string punched_number(double value) {
  std::string out = ig::cnc::fixed_text(value);
  if (out.find('.') == std::string::npos) out += '.';
  return out;
}

}  // namespace fanuc
