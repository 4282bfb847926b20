/// The variables of a run: R parameters, and the named ones of each running program. The dependency SiemensVariables
/// owns one store; the syntaxes of this plugin reach it through its service.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "flow/program_path.hpp"
#include "language/variable.hpp"

namespace siemens {

inline constexpr const char* variable_service = "siemens.variables/1";

/// MCALL NAME(…): a call after each block of that program that moves.
struct ModalCall {
  CalledProgram program;
  std::vector<Argument> arguments;
  std::uint64_t frame = 0;
};

/// A pattern of holes at each of which MCALL calls a subprogram. Its block is executed once for each hole: the
/// subprogram's end returns to it.
struct PatternCall {
  std::uint64_t frame = 0;   ///< of the block with the pattern
  std::uint64_t offset = 0;  ///< where that block begins
  std::uint64_t tag = 0;     ///< of the call that is running
  std::string label;
  std::vector<std::array<double, 3>> holes;
  std::size_t next = 0;
  bool is_open() const { return next < holes.size(); }
  bool is_at(std::uint64_t f, std::uint64_t o) const { return frame == f && offset == o; }
};

class VariableStore {
 public:
  ModalCall modal;
  std::vector<std::string> call_path;          ///< folders that CALLPATH has added to the search of programs
  std::vector<PatternCall> patterns;           ///< the innermost last
  std::optional<std::int64_t> master_spindle;  ///< the spindle that SETMS has named
  std::uint32_t curve_begins = 0;              ///< line of the CTABDEF in force; 0: none

  std::size_t most_names = 100'000;  ///< of one program, with elements of arrays

  void set_r_count(std::size_t count) { r_.assign(count, {}); }
  std::size_t r_count() const { return r_.size(); }

  /// One R parameter; r() gives null for a number that the control does not have.
  struct RParameter {
    double value = 0;
    bool is_given = false;  ///< by the user or by the program
  };
  RParameter* r(std::size_t number) { return number < r_.size() ? &r_[number] : nullptr; }

  /// Gives a value to a name: data of the machine, from the user.
  void give(std::string name, double value) { given_[std::move(name)] = value; }

  /// Makes the program with this frame the running one. Programs above it have ended: the values of their VAR
  /// parameters go to the caller.
  void enter(std::uint64_t frame) {
    if (frame != scopes_.back().frame) enter_other(frame);
  }

  Variable* find(const std::string& name) {
    Scope& scope = scopes_.back();
    const auto it = scope.variables.find(name);
    return it == scope.variables.end() ? nullptr : &it->second;
  }
  /// Like give(), but only up to the end of the run.
  void give_for_run(const std::string& name, double value);
  std::optional<double> given(const std::string& name) const;
  /// Defines a variable; false where there are too many.
  bool define(const std::string& name, Value value, bool is_array = false);
  /// Gives every element of the array this value.
  void fill(const std::string& array, Value value);
  /// The elements of an array that have a value of their own.
  std::vector<std::pair<std::string, Value>> elements(const std::string& array);
  void refer(const std::string& inner, const std::string& outer) { scopes_.back().references[inner] = outer; }

  std::uint64_t pass(std::vector<Argument> arguments) {
    passed_ = std::move(arguments);
    return ++tag_;
  }
  /// Other arguments for the call that pass() has answered last.
  void pass_again(std::vector<Argument> arguments) { passed_ = std::move(arguments); }
  /// The arguments of the present program's call, for the first statement that asks.
  const std::vector<Argument>& passed(std::uint64_t tag) {
    if (tag != 0 && tag == tag_) scopes_.back().arguments = passed_;
    return scopes_.back().arguments;
  }

  /// The call of the present program gives a value to its parameter n, counted from 1.
  bool is_passed(std::size_t n) const {
    const std::vector<Argument>& arguments = scopes_.back().arguments;
    return n > 0 && n <= arguments.size() && arguments[n - 1].value.has_value();
  }

  /// DEFINE NAME AS TEXT.
  void define_macro(const std::string& name, std::string text) { macros_[name] = std::move(text); }
  bool has_macros() const { return !macros_.empty(); }
  const std::string* macro(const std::string& name) const {
    const auto it = macros_.find(name);
    return it == macros_.end() ? nullptr : &it->second;
  }

  bool is_first_report(const std::string& what) { return said_.emplace(what, true).second; }

  /// Forgets what programs have defined; values that the user has given stay.
  void restart();

 private:
  void enter_other(std::uint64_t frame);
  /// Gives the value to an R parameter, a variable or an element of the present program, where it has such a one.
  void set(const std::string& name, const Value& value);

  struct Scope {
    std::uint64_t frame = 0;
    std::unordered_map<std::string, Variable> variables;
    std::map<std::string, std::string> references;
    std::vector<Argument> arguments;  // set again for each pass
  };
  std::vector<RParameter> r_;
  std::unordered_map<std::string, double> given_, given_for_run_;
  std::vector<Scope> scopes_{1};
  std::vector<Argument> passed_;
  std::uint64_t tag_ = 0;
  std::unordered_map<std::string, bool> said_;
  std::unordered_map<std::string, std::string> macros_;
};

}  // namespace siemens
