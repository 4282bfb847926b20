/// Random programs that look as programs do: blocks of the golden programs, put together anew.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isogloss::properties {

/// Numbers that depend on the seed alone, on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(next() % count); }
  bool one_in(std::size_t count) { return below(count) == 0; }

 private:
  std::uint64_t state_;
};

/// Of a place in a program, whatever stands before it: a choice that stays when other blocks are taken away.
std::uint64_t choice_at(std::uint64_t seed, std::string_view text, std::size_t place);

struct Case {
  std::string dialect;
  std::uint64_t seed = 0;          ///< of the choices that a property makes
  std::vector<std::string> lines;  ///< without their ends
  std::string text() const;
  /// Values of tables that every run is given: "ToolOffsetTable.1.H", "120".
  std::vector<std::pair<std::string, std::string>> assignments() const;
};

const std::vector<std::string>& dialect_names();
/// Whether its blocks are words, one letter and a number each.
bool is_iso(std::string_view dialect);
/// Whether most of its blocks are such words, beside names and statements.
bool has_plain_words(std::string_view dialect);

/// The program of this number: the same one whatever ran before.
Case make_case(const std::string& dialect, std::uint64_t seed, std::uint64_t number);
Case case_of_text(const std::string& dialect, std::uint64_t seed, std::string_view text);

}  // namespace isogloss::properties
