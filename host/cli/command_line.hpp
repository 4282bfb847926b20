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
  /// Wrong usage without that other option, "--slurm", and beside it: this one has no effect then.
  Option& only_with(const std::string& other);
  Option& not_with(const std::string& other);
  /// Of NAME=VALUE, repeatable: a NAME that stands there twice is wrong usage.
  Option& names_once();
  /// --help shows the value that the variable has now.
  Option& shows_default();
  /// The heading under which --help lists it; empty: it is not listed.
  Option& group(const std::string& heading);

 private:
  friend class CommandLine;
  /// Beside or without which other option this one has no effect; without an `other`: the names that it gives differ.
  struct Rule {
    const void* option;
    std::string other;
    bool needs_other;
  };
  Option(void* option, std::vector<std::string>& words, std::vector<Rule>& rules)
      : option_(option), words_(&words), rules_(&rules) {}
  void* option_;  // the parser's own, alive as long as the CommandLine
  std::vector<std::string>* words_;
  std::vector<Rule>* rules_;
};

/// The command line of one command. The variables must outlive parse(). An empty value is wrong usage: it would mean
/// the same as none.
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
  /// "--json" as another way to say "--format json": parse() puts `word` into the `value` of `option`, which may not
  /// name another one.
  Option flag_for(const std::string& option, std::string& value, const std::string& word, const std::string& name,
                  const std::string& more = {});

  /// A status when the command is done already (help, wrong usage, described).
  std::optional<int> parse(const Arguments& arguments);
  /// After parse(): does the option, "--format", stand on the command line?
  bool is_given(const std::string& option) const;
  /// After parse(): the options that stand there, by their long names, but for those of the group and of `others`.
  std::vector<std::string> given_besides(const std::string& group, const std::vector<std::string>& others) const;

 private:
  struct Parser;
  Option added(void* option);
  int wrong_usage(const std::string& what) const;
  template <class Number>
  Option number(const std::string& names, Number& value, const std::string& description);
  void describe(Usage& usage) const;
  std::unique_ptr<Parser> parser_;
};

}  // namespace isogloss::cli
