/// Requests of calls, with the arguments of a block.
#pragma once

#include <cmath>
#include <string>

#include <isogloss/cnc/block_skip.hpp>
#include <isogloss/cnc/program_name.hpp>

#include "macro/macro_environment.hpp"
#include "macro/macro_shared.hpp"

namespace syntec {

inline constexpr std::string_view axis_arguments = "XYZABCIJKUVW";
inline constexpr std::string_view all_letters = "ABCDEFHIJKLPQRSTUVWXYZ";

/// O9010 by its number, or a file by its name.
inline ig::Flow::Answer request_call(ig::Block& b, const ig::Flow& flow, std::int64_t number, std::string_view name,
                                     std::uint32_t repeats, std::uint64_t tag) {
  if (number > 0) {
    const ig::cnc::NumberedName program('O', number);
    const ig::cnc::ProgramFileNames files(number);
    return flow.call(b, {.program = program.text(), .files = files.list(), .repeats = repeats, .tag = tag});
  }
  const ig_text file = ig::to_text(name);
  return flow.call(b, {.program = name, .files = {&file, 1}, .repeats = repeats, .tag = tag});
}

/// How often L calls; nothing, and said, where it is no count. 0 is said, too.
inline std::optional<std::uint32_t> repeats_of(ig::Block& b, const MacroValue& l, std::string_view code,
                                               ig::Where where) {
  if (!l.is_number()) return 1;
  if (!(l.number >= 0 && l.number <= 99'999'999) || l.number != std::floor(l.number)) {
    b.report(ig::diag("SYN-0073"), where, code, l.number);
    return std::nullopt;
  }
  if (l.number == 0) b.report(ig::diag("SYN-0074"), where, code);
  return static_cast<std::uint32_t>(l.number);
}

/// G65, G66 and G66.1.
constexpr bool is_macro_call(double code) { return code == 65 || code == 66 || code == 66.1; }

/// The words of a block in ISO format up to a call, or to the sign from which the block was skipped: the first one of
/// `skipped_layer`, which is 0 where nothing was skipped. Other syntaxes report what is wrong with the words.
inline Arguments iso_arguments(std::string_view text, std::size_t position, std::int64_t skipped_layer) {
  Arguments out;
  using namespace ig::cnc;
  while (position < text.size()) {
    position = skip_while(text, position, [](char c) { return !is_letter(c) && c != '(' && c != ';' && c != '/'; });
    const char letter = to_upper(at(text, position));
    if (letter == '(') {
      position = skip_bracketed(text, position);
      continue;
    }
    if (letter == '/') {
      const SkipSign sign = read_skip_sign(text, position);
      if (static_cast<std::int64_t>(sign.layer) == skipped_layer) break;
      position = sign.end;
      continue;
    }
    if (!is_letter(letter)) break;
    const std::size_t name = skip_name_of(text, position, [](char c) { return is_letter(c) || is_digit(c); });
    const bool is_named = at(text, name) == '=';
    const std::size_t first = skip_blanks(text, is_named ? name + 1 : position + 1);
    const ig::Decimal d = first < text.size() ? ig::read_decimal(text, first) : ig::Decimal{.end = first};
    if (letter == 'G' && d.ok && is_macro_call(d.value)) break;
    if (d.ok && letter != 'P')
      out.set(is_named ? in_capitals(piece(text, position, name)) : std::string(1, letter),
              d.has_point ? MacroValue::real(d.value) : MacroValue::of_number(d.value));
    position = std::max(d.end, position + 1);
  }
  return out;
}

/// A member of the syntaxes that make calls: the words of the block as arguments.
class BlockArguments {
 public:
  BlockArguments() : format_(ig::read) {
    for (const char letter : all_letters) {
      words_.emplace_back(std::string("Parsing.") + letter, ig::read);
      by_letter_[ig::cnc::letter_index(letter)] = words_.back().id();
    }
  }

  /// In a file in MACRO format the scanner has kept them with their types. In ISO format a number with a point is real.
  Arguments read(ig::Block& b, const SharedScan& scan) const {
    if (format_.is_macro(b)) return scan->arguments;
    Arguments out;
    for (std::size_t i = 0; i < by_letter_.size(); ++i) {
      ig_word word{};
      ig_value value;
      if (by_letter_[i] == IG_NO_FIELD || !b.get(by_letter_[i], value) || !b.is_fresh(by_letter_[i])) continue;
      const bool has_place = b.word(by_letter_[i], word) && word.end <= b.source().size();
      const bool has_point =
          has_place && ig::cnc::piece(b.source(), word.begin, word.end).find('.') != std::string::npos;
      out.letters[i] = has_point ? MacroValue::real(value.number) : MacroValue::of_number(value.number);
    }
    return out;
  }
  bool is_macro(const ig::Block& b) const { return format_.is_macro(b); }

  /// The words are not left to the block.
  void take(ig::Block& b, std::string_view letters) const {
    for (const char letter : letters)
      if (const ig_field field = by_letter_[ig::cnc::letter_index(letter)]; field != IG_NO_FIELD) b.take(field);
  }

 private:
  std::vector<ig::Word> words_;
  FormatField format_;
  std::array<ig_field, 26> by_letter_ = [] {
    std::array<ig_field, 26> out;
    out.fill(IG_NO_FIELD);
    return out;
  }();
};

}  // namespace syntec
