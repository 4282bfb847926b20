/// Changes of XML that leave all the rest, comments and blanks too, as it is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"

namespace isogloss::cli {

/// Parts of a text that become others; places are offsets of the old text, which must outlive it.
class TextEdits {
 public:
  explicit TextEdits(const std::string& text);

  void replace(std::size_t begin, std::size_t end, std::string by) { all_.push_back({begin, end, std::move(by)}); }
  /// Removes the element, and its lines where nothing else stands on them.
  void remove(std::size_t begin);
  std::string apply();

  std::size_t offset(const Location& where) const;
  /// One past the element that begins there.
  std::size_t end_of(std::size_t begin) const;
  std::string element(std::size_t begin) const { return text_.substr(begin, end_of(begin) - begin); }
  /// The blanks before the element on its line.
  std::string indentation(std::size_t at) const;
  std::string line_end() const { return text_.find("\r\n") != std::string::npos ? "\r\n" : "\n"; }
  /// Not in comments.
  std::size_t find_last(std::string_view what) const { return elements_.rfind(what); }

 private:
  std::size_t line_begin(std::size_t at) const;

  struct One {
    std::size_t begin, end;
    std::string by;
  };
  const std::string& text_;
  std::string elements_;  ///< the text with blanks for comments and the like
  std::vector<One> all_;
};

}  // namespace isogloss::cli
