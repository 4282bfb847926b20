/// The words of a macro call: the program that P or <NAME> calls, how often L calls it, and its arguments, of which a
/// call may have I, J and K ten times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/cnc/block_skip.hpp>
#include <isogloss/sdk.hpp>

#include "macro/expression.hpp"
#include "macro/macro_arguments.hpp"
#include "macro/macro_environment.hpp"
#include "macro/macro_store.hpp"

namespace fanuc {

using namespace ig::cnc;

/// What a second I, J or K does: it begins the next set, #7 #8 #9, or replaces the first one.
enum class IjkSets { automatic, one };

/// What // among the words is: two signs of block skip, or a comment, which another scanner reads.
enum class Slashes { none, comment };

/// The numbers are as programmed: whoever calls the program checks them.
struct MacroCallWords {
  bool has_program = false;
  double program = 0, repeats = 1;
  std::string name{};  ///< <PART>; empty where the program has a number
  MacroStore::Locals arguments = MacroStore::no_locals();

  CalledProgram called() const { return {name.empty() ? static_cast<std::int64_t>(program) : 0, name}; }
};

/// Reads the words of one call into `out`, and reports those that are not passed.
class MacroCallReader {
 public:
  /// Whether <NAME> may name the program: not where a code is bound to one.
  enum class Names { accepted, refused };

  MacroCallReader(ig::Block& b, std::string_view text, const MacroEnvironment& environment, const ArgumentUnits& units,
                  const BlockSkip& block_skip, IjkSets ijk_sets, Slashes slashes, MacroCallWords& out)
      : block_(b),
        text_(text),
        environment_(environment),
        units_(units),
        block_skip_(block_skip),
        ijk_sets_(ijk_sets),
        slashes_(slashes),
        out_(out) {}

  /// Returns the end of the last word; rest() is where the scanners after this one go on.
  std::size_t read(std::size_t position, Names names);
  std::size_t rest() const { return rest_; }

 private:
  struct Argument {
    char letter;
    MacroValue value;
    bool without_point;
    std::size_t begin, end;
  };

  /// True where the rest of the block is skipped from the sign of block skip on; otherwise `begin` moves behind it.
  bool skips(std::size_t& begin);
  /// Returns the end of the word; refuse() as well.
  std::size_t word(std::size_t begin, Names names);
  std::size_t refuse(std::size_t begin, std::size_t end);
  void set_program_or_repeats(char letter, const MacroValue& value);
  void pass(const Argument& argument);

  std::uint32_t variable_for(char letter);
  std::optional<MacroValue> computed(std::size_t begin, std::size_t position, std::size_t& end);

  ig::Block& block_;
  std::string_view text_;
  const MacroEnvironment& environment_;
  const ArgumentUnits& units_;
  const BlockSkip& block_skip_;
  IjkSets ijk_sets_;
  Slashes slashes_;
  MacroCallWords& out_;
  std::size_t rest_ = 0;
  std::uint32_t set_ = 0, seen_ = 0;  // sets of I J K; letters read
  char last_of_set_ = 0;
};

}  // namespace fanuc
