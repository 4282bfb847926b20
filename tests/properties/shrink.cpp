#include "shrink.hpp"

#include <algorithm>

namespace isogloss::properties {

namespace {

constexpr int most_trials = 3'000;

class Shrinking {
 public:
  Shrinking(const Property& property, Case program) : property_(property), best_(std::move(program)) {}

  Case run() {
    for (std::size_t size = std::max<std::size_t>(best_.lines.size() / 2, 1); size > 0; size /= 2) drop_lines(size);
    for (std::size_t line = 0; line < best_.lines.size(); ++line) drop_words(line);
    drop_lines(1);
    return best_;
  }

 private:
  /// Keeps the shorter program when it shows a fault, too.
  bool keep(Case shorter) {
    if (++trials_ > most_trials || property_.judge(shorter).fault.empty()) return false;
    best_ = std::move(shorter);
    return true;
  }

  void drop_lines(std::size_t size) {
    for (std::size_t at = 0; at < best_.lines.size();) {
      Case shorter = best_;
      const auto first = shorter.lines.begin() + static_cast<std::ptrdiff_t>(at);
      const std::size_t count = std::min(size, shorter.lines.size() - at);
      shorter.lines.erase(first, first + static_cast<std::ptrdiff_t>(count));
      if (!keep(std::move(shorter))) at += size;
    }
  }

  /// Words end at blanks here, whatever the dialect.
  void drop_words(std::size_t line) {
    std::size_t at = 0;
    while (at < best_.lines[line].size()) {
      const std::string& text = best_.lines[line];
      const std::size_t end = std::min(text.find(' ', at), text.size() - 1) + 1;
      Case shorter = best_;
      shorter.lines[line].erase(at, end - at);
      if (!keep(std::move(shorter))) at = end;
    }
  }

  const Property& property_;
  Case best_;
  int trials_ = 0;
};

}  // namespace

Case shrink(const Property& property, Case program) { return Shrinking(property, std::move(program)).run(); }

}  // namespace isogloss::properties
