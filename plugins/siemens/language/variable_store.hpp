/// The variables of a run: R parameters, and the named ones of each running program. The dependency SiemensVariables
/// owns one store; the syntaxes of this plugin reach it through its service.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <isogloss/provenance.hpp>

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

  /// Values of VAR parameters that the caller's variables cannot hold.
  struct NotGivenBack {
    std::string name;
    Value value;
    Stored outcome;
  };
  std::vector<NotGivenBack> not_given_back;

  bool cuts_texts = false;           ///< a text that is too long for its STRING is cut
  std::size_t most_names = 100'000;  ///< of one program, with elements of arrays

  void set_r_count(std::size_t count) { r_.assign(count, {}); }
  std::size_t r_count() const { return r_.size(); }

  /// One R parameter; r() gives null for a number that the control does not have.
  struct RParameter {
    double value = 0;
    bool is_given = false;  ///< by the user or by the program
  };
  RParameter* r(std::size_t number) { return number < r_.size() ? &r_[number] : nullptr; }

  void assign_r(std::size_t number, double value) {
    r_[number] = {value, true};
    if (saver_) saver_->save_r(number, value);
  }

  /// The rows of the table from which variables have their values, until the program assigns others.
  ig::RowOrigins<std::string> rows;

  /// Gives a value to a system variable: data of the machine, from the user.
  void give(std::string name, double value) { given_[std::move(name)] = value; }
  /// Defines global user data of the machine (GUD), which all programs share. They are found after the variables of the
  /// running program.
  Variable& define_user_data(const std::string& name, Variable variable) {
    return user_data_.insert_or_assign(name, std::move(variable)).first->second;
  }
  /// Each run begins with the user data as they are now.
  void keep_user_data() { user_data_at_start_ = user_data_; }
  Variable* user_data(const std::string& name) { return find_in(user_data_, name); }

  /// Is told what programs assign to user data and R parameters.
  class Saver {
   public:
    virtual void save(const std::string& name, const Value& value) = 0;
    virtual void save_r(std::size_t number, double value) = 0;

   protected:
    ~Saver() = default;
  };
  void save_to(Saver* saver) { saver_ = saver; }

  /// Makes the program with this frame the running one. Programs above it have ended: the values of their VAR
  /// parameters go to the caller.
  void enter(std::uint64_t frame) {
    if (frame != scopes_.back().frame) enter_other(frame);
  }

  /// A variable or an element with a value of its own: of the running program, or of the user data.
  Variable* find(const std::string& name) {
    Variable* const own = find_own(name);
    return own != nullptr ? own : user_data(name);
  }
  /// One that the running program has defined.
  Variable* find_own(const std::string& name) { return find_in(scopes_.back().variables, name); }
  /// The array of an element, A of "A[2]"; null where there is none.
  Variable* array_of(const std::string& element) {
    Variable* const v = find(element.substr(0, element.find('[')));
    return v != nullptr && v->is_array ? v : nullptr;
  }
  /// Like give(), but only up to the end of the run.
  void give_for_run(const std::string& name, double value);
  std::optional<double> given(const std::string& name) const;
  /// Defines a variable of the running program; false where there are too many.
  bool define(const std::string& name, const Declared& type, bool is_array = false);
  /// Assigns a value to a variable or an element, converted to its type.
  Stored assign(const std::string& name, Value value);
  /// Whether `count` elements of the array, from number `first` on, can have values of their own.
  bool may_hold(const std::string& array, std::size_t first, std::size_t count);
  /// Gives every element of the array this value, which fits.
  void fill(const std::string& array, const Value& value);
  /// The elements of an array that have a value of their own.
  std::vector<std::pair<std::string, Value>> elements(const std::string& array);
  /// What the caller's variables get when the running program ends: values of its VAR parameters.
  struct GivenBack {
    std::string name;
    Value value;
    bool is_own;          ///< a variable that the caller has defined, not user data or an R parameter
    std::uint64_t frame;  ///< of the caller
  };
  std::vector<GivenBack> given_back();
  void refer(const std::string& inner, const std::string& outer) { scopes_.back().references[inner] = outer; }

  std::uint64_t pass(std::vector<Argument> arguments) {
    ++tag_;
    pass_again(std::move(arguments));
    return tag_;
  }
  /// Other arguments for the call that pass() has answered last.
  void pass_again(std::vector<Argument> arguments) {
    passed_ = std::move(arguments);
    if (const std::size_t count = given_values(passed_); count > 0) note_unread(count);
  }
  /// How many parameters a program needs for all values that a call gives.
  static std::size_t given_values(const std::vector<Argument>& arguments) {
    std::size_t count = arguments.size();
    while (count > 0 && !arguments[count - 1].value) --count;
    return count;
  }
  /// How many values the call with this tag gives to a program that has no PROC; 0 at each further question.
  std::size_t take_unread(std::uint64_t tag) {
    const auto it = std::find_if(unread_.begin(), unread_.end(), [&](const auto& call) { return call.first == tag; });
    if (it == unread_.end()) return 0;
    const std::size_t count = it->second;
    unread_.erase(it);
    return count;
  }
  /// The arguments of the present program's call, for the first statement that asks.
  const std::vector<Argument>& passed(std::uint64_t tag) {
    if (tag != 0 && tag == tag_) scopes_.back().arguments = passed_;
    take_unread(tag);
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
  using Variables = std::unordered_map<std::string, Variable>;

  void enter_other(std::uint64_t frame);
  void note_unread(std::size_t count) {
    if (unread_.size() >= most_unread) unread_.erase(unread_.begin());  // of a program that was not found
    unread_.emplace_back(tag_, count);
  }
  /// Gives the value to an R parameter, a variable or an element of the present program, where it has such a one.
  void give_back(const std::string& name, const Value& value);
  static Variable* find_in(Variables& variables, const std::string& name) {
    const auto it = variables.find(name);
    return it == variables.end() ? nullptr : &it->second;
  }
  /// The variables among which the name is, or its array; null where it is in none.
  Variables* holder_of(const std::string& name, const std::string& base);

  struct Scope {
    std::uint64_t frame = 0;
    Variables variables;
    std::map<std::string, std::string> references;
    std::vector<Argument> arguments;  // set again for each pass
  };
  std::vector<RParameter> r_;
  std::unordered_map<std::string, double> given_, given_for_run_;
  Variables user_data_, user_data_at_start_;
  Saver* saver_ = nullptr;
  std::vector<Scope> scopes_{1};
  std::vector<Argument> passed_;
  std::uint64_t tag_ = 0;
  static constexpr std::size_t most_unread = 64;
  std::vector<std::pair<std::uint64_t, std::size_t>> unread_;  // calls: tag, number of values that no PROC has read
  std::unordered_map<std::string, bool> said_;
  std::unordered_map<std::string, std::string> macros_;
};

}  // namespace siemens
