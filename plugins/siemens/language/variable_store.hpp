/// The variables of a run: R parameters, and the named ones of each running program. The dependency SiemensVariables
/// owns one store; the syntaxes of this plugin reach it through its service.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace siemens {

inline constexpr const char* variable_service = "siemens.variables/1";

enum class Type : std::uint8_t { real, integer, boolean, text };

struct Value {
  double number = 0;
  Type type = Type::real;
  std::string text;

  static Value real(double n) { return {n, Type::real, {}}; }
  static Value integer(double n) { return {n, Type::integer, {}}; }
  static Value truth(bool yes) { return {yes ? 1.0 : 0.0, Type::boolean, {}}; }
  static Value string(std::string t) { return {0, Type::text, std::move(t)}; }
  bool is_text() const { return type == Type::text; }

  /// The value converted to a type: INT rounds, BOOL is 0 or 1. Nothing between text and number.
  std::optional<Value> as(Type wanted) const {
    if (is_text() != (wanted == Type::text)) return std::nullopt;
    if (wanted == Type::integer) return integer(std::round(number));
    if (wanted == Type::boolean) return truth(number != 0);
    Value out = *this;
    out.type = wanted;
    return out;
  }
};

struct Variable {
  Value value;  ///< for an array: the value of elements that were never set
  bool is_array = false;
  std::vector<std::string> elements{};                 ///< [1] and so on: elements with a variable of their own
  std::vector<std::uint32_t> sizes{};                  ///< of an array, by dimension; empty: not known
  std::pair<std::uint64_t, std::size_t> defined_at{};  ///< offset of its block, column

  /// The number of the element with these indices, "[0,3]", where the last index runs fastest; nothing where they are
  /// out of range. Where the sizes are not known there is one index of any size.
  std::optional<std::size_t> number_of(std::string_view indices) const {
    const std::size_t count = std::max<std::size_t>(sizes.size(), 1);
    std::size_t number = 0, next = 1;
    for (std::size_t i = 0; i < count && next < indices.size(); ++i) {
      std::uint32_t index = 0;
      const auto [end, error] = std::from_chars(indices.data() + next, indices.data() + indices.size(), index);
      if (error != std::errc{} || (!sizes.empty() && index >= sizes[i])) return std::nullopt;
      next = static_cast<std::size_t>(end - indices.data());
      if (next >= indices.size() || indices[next] != (i + 1 < count ? ',' : ']')) return std::nullopt;
      ++next;
      number = sizes.empty() ? index : number * sizes[i] + index;
    }
    return next == indices.size() ? std::optional(number) : std::nullopt;
  }
  /// The indices of the element with that number.
  std::string indices_of(std::size_t number) const {
    std::string out = "]";
    for (std::size_t i = sizes.size(); i-- > 0; number /= sizes[i])
      out.insert(0, (i == 0 ? "[" : ",") + std::to_string(number % sizes[i]));
    return sizes.empty() ? "[" + std::to_string(number) + "]" : out;
  }
  std::size_t size() const {
    std::size_t n = 1;
    for (const std::uint32_t s : sizes) n *= s;
    return n;
  }
  /// "A[2,3]", as in its definition.
  std::string shown_as(std::string_view name) const {
    std::string out(name);
    if (sizes.empty()) return out + "[]";
    for (std::size_t i = 0; i < sizes.size(); ++i) out += (i == 0 ? '[' : ',') + std::to_string(sizes[i]);
    return out + ']';
  }
};

/// What a call passes: values, and the names of the caller's variables that VAR parameters change.
struct Argument {
  std::optional<Value> value;
  std::string name;
  std::vector<std::pair<std::string, Value>> elements{};  ///< of an array, where `name` is one
  std::vector<std::uint32_t> sizes{};
};

/// MCALL NAME(…): a call after each block of that program that moves.
struct ModalCall {
  std::string program;
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
    if (frame == scopes_.back().frame) return;
    while (scopes_.size() > 1 && scopes_.back().frame > frame) {
      const Scope ended = std::move(scopes_.back());
      scopes_.pop_back();
      for (const auto& [inner, outer] : ended.references)
        if (const auto it = ended.variables.find(inner); it != ended.variables.end()) {
          if (!it->second.is_array) set(outer, it->second.value);
          for (const std::string& element : it->second.elements)
            if (const auto own = ended.variables.find(inner + element); own != ended.variables.end())
              set(outer + element, own->second.value);
        }
    }
    if (scopes_.back().frame != frame) scopes_.push_back({frame, {}, {}, {}});
  }

  Variable* find(const std::string& name) {
    Scope& scope = scopes_.back();
    const auto it = scope.variables.find(name);
    return it == scope.variables.end() ? nullptr : &it->second;
  }
  /// Like give(), but only up to the end of the run.
  void give_for_run(const std::string& name, double value) {
    if (given_for_run_.size() < most_names) given_for_run_[name] = value;
  }
  std::optional<double> given(const std::string& name) const {
    if (const auto it = given_for_run_.find(name); it != given_for_run_.end()) return it->second;
    const auto it = given_.find(name);
    return it == given_.end() ? std::nullopt : std::optional(it->second);
  }
  /// Defines a variable; false where there are too many.
  bool define(const std::string& name, Value value, bool is_array = false) {
    auto& variables = scopes_.back().variables;
    if (is_array)
      for (const auto& [element, own] : elements(name)) variables.erase(name + element);
    if (variables.size() >= most_names) return false;
    const auto [it, is_new] = variables.insert_or_assign(name, Variable{std::move(value), is_array});
    const std::size_t bracket = name.find('[');
    if (!is_new || bracket == std::string::npos) return true;
    if (const auto array = variables.find(name.substr(0, bracket)); array != variables.end())
      array->second.elements.push_back(name.substr(bracket));
    return true;
  }
  /// Gives every element of the array this value.
  void fill(const std::string& array, Value value) {
    auto& variables = scopes_.back().variables;
    for (const auto& [element, own] : elements(array)) variables.erase(array + element);
    Variable& all = variables.at(array);
    all.elements.clear();
    all.value = std::move(value);
  }
  /// The elements of an array that have a value of their own.
  std::vector<std::pair<std::string, Value>> elements(const std::string& array) {
    std::vector<std::pair<std::string, Value>> out;
    if (const Variable* const v = find(array))
      for (const std::string& element : v->elements)
        if (const Variable* const own = find(array + element)) out.emplace_back(element, own->value);
    return out;
  }
  void refer(const std::string& inner, const std::string& outer) { scopes_.back().references[inner] = outer; }

  std::uint64_t pass(std::vector<Argument> arguments) {
    passed_ = std::move(arguments);
    return ++tag_;
  }
  /// The arguments of the present program's call, for the first statement that asks.
  const std::vector<Argument>& passed(std::uint64_t tag) {
    if (tag != 0 && tag == tag_) scopes_.back().arguments = passed_;
    return scopes_.back().arguments;
  }

  /// DEFINE NAME AS TEXT.
  void define_macro(const std::string& name, std::string text) { macros_[name] = std::move(text); }
  bool has_macros() const { return !macros_.empty(); }
  const std::string* macro(const std::string& name) const {
    const auto it = macros_.find(name);
    return it == macros_.end() ? nullptr : &it->second;
  }

  bool say_once(const std::string& what) { return said_.emplace(what, true).second; }

  void restart() {
    scopes_.assign(1, {});
    passed_.clear();
    said_.clear();
    macros_.clear();
    given_for_run_.clear();
    patterns.clear();
    master_spindle.reset();
    curve_begins = 0;
  }

 private:
  void set(const std::string& name, const Value& value) {
    if (name.size() > 1 && name[0] == 'R' && name.find_first_not_of("0123456789", 1) == std::string::npos) {
      if (name.size() < 8)
        if (RParameter* const p = r(static_cast<std::size_t>(std::stoul(name.substr(1))))) *p = {value.number, true};
      return;
    }
    if (Variable* const v = find(name)) {
      if (const auto fitting = value.as(v->value.type)) v->value = *fitting;
      return;
    }
    const Variable* const array = find(name.substr(0, name.find('[')));
    if (array == nullptr || !array->is_array) return;
    if (auto fitting = value.as(array->value.type)) define(name, std::move(*fitting));
  }

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
