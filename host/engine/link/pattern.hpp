/// Field patterns of options: `Parsing.?` (one address), `Parsing.*.X` (one segment), `Parsing.**{mm}` (any number of
/// segments, of one unit). A code keeps its decimals in one segment.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isogloss {

class FieldPattern {
 public:
  explicit FieldPattern(std::string_view text);
  bool is_literal() const { return literal_; }
  const std::string& path() const { return path_; }
  bool matches(std::string_view path, std::string_view unit) const;

 private:
  std::string path_;
  std::string unit_;
  bool any_unit_ = true;
  std::size_t prefix_size_ = 0;  // before the first wildcard
  bool literal_ = true;
  std::vector<std::string> segments_;
};

/// The patterns of an option's text, separated by blanks.
std::vector<FieldPattern> parse_patterns(std::string_view text);

/// "Parsing", "Flags", "A1.2" of "Parsing.Flags.A1.2".
std::vector<std::string> path_segments(std::string_view path);

}  // namespace isogloss
