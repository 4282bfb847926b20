/// Searches the text of a program for what only lathe programs hold. It distinguishes words (a letter and a number),
/// blocks and comments, but knows no codes: the dialect names the words that are signs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace iso {

class TurningSigns {
 public:
  /// `signs` is a list such as "T???? G50+S": each sign is a set of words that stand in one block. A word is a letter,
  /// or a letter and a number, in which ? stands for any digit; without ? leading zeros do not matter. A sign with ? is
  /// void where `tool_change` stands anywhere in the text. More than `most` words of the address `axis` make the text a
  /// milling program.
  TurningSigns(std::string_view signs, std::string_view tool_change, char axis, std::int64_t most)
      : tool_change_(word_of(tool_change)), axis_(axis), most_(most) {
    for (const std::string_view sign : split(signs, ' ')) {
      Sign& added = signs_.emplace_back();
      for (const std::string_view word : split(sign, '+')) added.words.push_back(word_of(word));
      added.is_tool = sign.find('?') != std::string_view::npos;
    }
  }

  struct Found {
    std::string words;
    std::uint32_t line = 0;
    std::uint64_t begin = 0, end = 0;  ///< of the line, in bytes of the text
  };

  /// Reads the text in pieces of any size. False: it is a milling program, and the rest need not be read.
  bool read(std::string_view piece) {
    for (const char c : piece) {
      if (!read(c)) return false;
    }
    return true;
  }

  /// The sign that was found; call it after the last piece.
  std::optional<Found> result() {
    read('\n');
    if (axis_words_ > most_) return std::nullopt;
    if (code_sign_) return code_sign_;
    return changes_tools_ ? std::nullopt : tool_sign_;
  }

 private:
  struct Word {
    char letter = '\0';
    std::string number;
  };
  struct Sign {
    std::vector<Word> words;
    bool is_tool = false;
  };

  static std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> out;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find(at), text.size());
      if (end > 0) out.push_back(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
  }
  static Word word_of(std::string_view text) {
    return text.empty() ? Word{} : Word{text.front(), std::string(text.substr(1))};
  }

  static bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
  static bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }

  static bool fits(const Word& pattern, const Word& word) {
    if (pattern.letter != word.letter) return false;
    if (pattern.number.empty()) return !word.number.empty();
    if (pattern.number.find('?') == std::string::npos)
      return without_zeros(pattern.number) == without_zeros(word.number);
    if (pattern.number.size() != word.number.size()) return false;
    for (std::size_t i = 0; i < pattern.number.size(); ++i) {
      const bool is_digit = word.number[i] >= '0' && word.number[i] <= '9';
      if (pattern.number[i] == '?' ? !is_digit : pattern.number[i] != word.number[i]) return false;
    }
    return true;
  }
  static std::string_view without_zeros(std::string_view number) {
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
    return number;
  }

  /// False where the text is known to be a milling program.
  bool read(char c) {
    const bool is_rest_of_end = c == '\n' && last_ == '\r';
    last_ = c;
    ++bytes_;
    if (is_rest_of_end) {
      begin_ = bytes_;
      return true;
    }
    if (c == '\n' || c == '\r') {
      const bool may_turn = end_block();
      begin_ = bytes_;
      ++line_;
      depth_ = 0;
      in_remark_ = false;
      return may_turn;
    }
    if (in_remark_) return true;
    if (c == '(') ++depth_;
    if (depth_ > 0) {
      depth_ -= c == ')' ? 1 : 0;
      return true;
    }
    if (c == ';') {
      in_remark_ = true;
      return true;
    }
    if (c == ' ' || c == '\t') return true;
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (is_letter(c)) {
      // Letters side by side are a name or an operator, not words.
      const bool is_name = is_after_letter_;
      if (is_name && !words_.empty()) words_.back().letter = '\0';
      if (words_.size() < most_words) words_.push_back({is_name ? '\0' : c, {}});
    } else if (!words_.empty() && words_.size() < most_words) {
      if (is_of_number(c) || words_.back().number.empty()) words_.back().number += c;
    }
    is_after_letter_ = is_letter(c);
    return true;
  }

  bool end_block() {
    for (const Word& word : words_) {
      if (word.letter == axis_ && !word.number.empty() && ++axis_words_ > most_) return false;
      changes_tools_ = changes_tools_ || fits(tool_change_, word);
    }
    if (!words_.empty())
      for (const Sign& sign : signs_) look_for(sign);
    words_.clear();
    is_after_letter_ = false;
    return true;
  }

  void look_for(const Sign& sign) {
    std::optional<Found>& kept = sign.is_tool ? tool_sign_ : code_sign_;
    if (kept) return;
    std::string said;
    for (const Word& wanted : sign.words) {
      const Word* found = nullptr;
      for (const Word& word : words_)
        if (found == nullptr && fits(wanted, word)) found = &word;
      if (found == nullptr) return;
      said += (said.empty() ? "" : " ") + (found->letter + found->number);
    }
    kept = Found{std::move(said), line_, begin_, bytes_ - 1};
  }

  static constexpr std::size_t most_words = 64;  // in a block that can be a sign

  std::vector<Sign> signs_;
  Word tool_change_;
  char axis_;
  std::int64_t most_;
  std::vector<Word> words_;
  std::optional<Found> code_sign_, tool_sign_;
  std::int64_t axis_words_ = 0;
  std::uint32_t line_ = 1;
  std::uint64_t bytes_ = 0, begin_ = 0;  // read; before the line
  std::uint32_t depth_ = 0;
  char last_ = '\0';
  bool in_remark_ = false, is_after_letter_ = false, changes_tools_ = false;
};

}  // namespace iso
