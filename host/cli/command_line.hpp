/// What a command accepts, declared as data: options, flags and operands, bound to the variables that they fill.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"

namespace isogloss::cli {

/// One option, flag or operand. Each call refines it and returns it, so that a declaration reads as one sentence.
class Option {
 public:
  Option& required();
  /// What --help shows in place of the value: FILE, N, stop|continue.
  Option& type_name(const std::string& name);
  /// Any other value is wrong usage.
  Option& one_of(const std::vector<std::string>& words);
  /// A whole number; a smaller one is wrong usage.
  Option& at_least(std::uint64_t minimum);
  Option& existing_folder();
  /// An empty value is wrong usage: it would mean the same as no option.
  Option& not_empty();
  /// --help shows the value that the variable has now.
  Option& shows_default();
  /// The heading under which --help lists it; empty: it is not listed.
  Option& group(const std::string& heading);

 private:
  friend class CommandLine;
  Option(void* option, std::vector<std::string>& words) : option_(option), words_(&words) {}
  void* option_;  // the parser's own, alive as long as the CommandLine
  std::vector<std::string>* words_;
};

/// The command line of one command. The variables must outlive parse().
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& description, const std::string& example);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// `names`: "-o,--output" for an option, "PROGRAM" for an operand.
  Option option(const std::string& names, std::string& value, const std::string& description = {});
  Option option(const std::string& names, std::uint32_t& value, const std::string& description = {});
  Option option(const std::string& names, std::uint64_t& value, const std::string& description = {});
  /// For an option of which a command has to know whether it was given.
  Option option(const std::string& names, std::optional<std::uint64_t>& value, const std::string& description = {});
  /// Repeatable, one value each time; an operand takes all that are left.
  Option option(const std::string& names, std::vector<std::string>& values, const std::string& description = {});
  Option flag(const std::string& names, bool& value, const std::string& description);

  /// A status when the command is done already (help, wrong usage, described).
  std::optional<int> parse(const Arguments& arguments);
  /// After parse(): does the option, "--format", stand on the command line?
  bool is_given(const std::string& option) const;

 private:
  struct Parser;
  template <class Number>
  Option number(const std::string& names, Number& value, const std::string& description);
  void describe(Usage& usage) const;
  std::unique_ptr<Parser> parser_;
};

}  // namespace isogloss::cli
