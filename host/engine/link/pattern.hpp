/// Field patterns of options: `Parsing.?` (one address), `Parsing.*.X` (one segment), `Parsing.**{mm}` (any number of
/// segments, of one unit), `Parsing.*{canned-cycle}.X` (of what has that unit itself). A code keeps its decimals in one
/// segment.
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
  /// The letter at the end of each path that matches; 0: any.
  char last() const { return last_; }
  /// Does not look at owner_unit().
  bool matches(std::string_view path, std::string_view unit) const;
  /// The unit that owner(path) must have; empty: any.
  const std::string& owner_unit() const { return owner_unit_; }
  /// "Parsing.CODE" of "Parsing.CODE.X": what stands before the braces of the pattern.
  std::string_view owner(std::string_view path) const;

 private:
  std::string path_;
  std::string unit_;
  std::string owner_unit_;
  std::size_t owner_segments_ = 0;
  bool any_unit_ = true;
  std::size_t prefix_size_ = 0;  // before the first wildcard
  bool literal_ = true;
  std::string suffix_;  // ".X" where the last of several segments has no wildcard
  char last_ = '\0';    // of the suffix
  enum class Wild { all, letter, segment, segment_and_suffix, segment_and_letter, other };
  Wild wild_ = Wild::other;  // what stands after the prefix
  std::vector<std::string> segments_;
};

/// The patterns of an option's text, separated by blanks.
std::vector<FieldPattern> parse_patterns(std::string_view text);

/// "Parsing", "Flags", "A1.2" of "Parsing.Flags.A1.2".
std::vector<std::string> path_segments(std::string_view path);

}  // namespace isogloss
