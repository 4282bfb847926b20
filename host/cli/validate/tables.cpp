// Dependencies: options and cells at their bounds, rows that mean nothing, and services that are asked odd questions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "markup.hpp"
#include "validate/guarded_texts.hpp"
#include "validate/option_values.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

constexpr double odd_angles[] = {
    0, 1, -1, 90, 1e308, -1e308, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};

/// The numbers of the standard services that answer by name.
constexpr const char* known_numbers[] = {"PeckRetractionDistance_mm",
                                         "HighSpeedPeckRetraction_mm",
                                         "BoringReturnOverride_percent",
                                         "ShiftDirectionX",
                                         "ShiftDirectionY",
                                         "ShiftDirectionZ",
                                         "RigidTapping",
                                         "TappingSpindleStop",
                                         "PeckTappingToR",
                                         "PeckTappingRetraction_mm",
                                         "TappingExtractionOverride_percent",
                                         "RotationAngle_deg",
                                         "RotationIsIncremental",
                                         "ResetCancelsLocalCoordinate",
                                         "CalculatorDecimalPoint",
                                         "LengthIncrement_mm",
                                         "LengthIncrement_inch",
                                         "AngleIncrement_deg",
                                         "ArcRadiusTolerance_mm",
                                         "ScalingUnit",
                                         "ScalingFactor",
                                         "UnidirectionalOverrunX_mm",
                                         "UnidirectionalOverrunZ_mm"};

/// Asks one service, and tells what is wrong with its answers.
class ServiceQuestions {
 public:
  ServiceQuestions(Examination& e, std::string where) : e_(e), where_(std::move(where)) {}

  void ask(std::string_view id, const void* service) {
    e_.attempt(where_ + ", service " + std::string(id));
    if (!id.starts_with("isogloss.")) return;  // what is of a vendor, only he knows
    std::uint32_t size = 0;
    std::memcpy(&size, service, sizeof size);
    if (size < sizeof size || size > 1u << 16) return tell(id, fmt::format("has the struct_size {}", size));
    if (id == "isogloss.work-offset/1") ask_work_offset(id, *static_cast<const ig_work_offset_1*>(service));
    if (id == "isogloss.tool-offset/1") ask_tool_offset(id, *static_cast<const ig_tool_offset_1*>(service));
    if (id == "isogloss.machine-axis/1") ask_machine_axis(id, *static_cast<const ig_machine_axis_1*>(service));
    if (id == "isogloss.machine-kinematics/1")
      ask_kinematics(id, *static_cast<const ig_machine_kinematics_1*>(service));
    for (const char* const config :
         {"isogloss.canned-cycle/1", "isogloss.coordinate-system/1", "isogloss.number-format/1", "isogloss.motion/1"})
      if (id == config) ask_config(id, *static_cast<const ig_config_1*>(service));
  }

 private:
  void tell(std::string_view id, const std::string& what) {
    e_.find(where_, fmt::format("its service {} {}", id, what));
  }

  /// 1 with finite numbers, or 0.
  void judge(std::string_view id, const std::string& question, std::int32_t answer, std::span<const double> numbers) {
    if (answer != 0 && answer != 1)
      return tell(id, fmt::format("answers {} to {}, while it is 0 or 1", answer, question));
    if (answer == 1 && !std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); }))
      tell(id, fmt::format("gives {} a value that is not a number", question));
  }

  ig_text guarded(std::string_view text) { return texts_.copy({text.data(), text.size()}); }

  void ask_work_offset(std::string_view id, const ig_work_offset_1& s) {
    if (s.get == nullptr || s.set == nullptr) return tell(id, "lacks a function");
    std::vector<std::string> names{"",
                                   "G54",
                                   "G59",
                                   "G54.1P0",
                                   "G54.1P1",
                                   "G54.1P999999999999999999",
                                   "EXT",
                                   "g54",
                                   "G",
                                   "9",
                                   std::string(5000, 'G')};
    names.insert(names.end(), odd_texts().begin(), odd_texts().end());
    for (const std::string& name : names) {
      double out[3] = {0, 0, 0};
      judge(id, fmt::format("get({:.20})", name), s.get(s.self, guarded(name), out), out);
      if (s.struct_size >= sizeof s && s.get_rotary != nullptr)
        judge(id, fmt::format("get_rotary({:.20})", name), s.get_rotary(s.self, guarded(name), out), out);
      texts_.end_call();
    }
  }

  void ask_tool_offset(std::string_view id, const ig_tool_offset_1& s) {
    if (s.get == nullptr || s.set == nullptr) return tell(id, "lacks a function");
    for (const std::int64_t tool : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, std::int64_t{99},
                                    std::int64_t{1} << 32, INT64_MAX, INT64_MIN})
      for (const std::uint32_t column : {0u, 1u, 2u, 3u, 4u, 1000u, UINT32_MAX}) {
        double out = 0;
        judge(id, fmt::format("get({}, {})", tool, column), s.get(s.self, tool, column, &out), {&out, 1});
      }
  }

  void ask_machine_axis(std::string_view id, const ig_machine_axis_1& s) {
    if (s.home == nullptr || s.reference == nullptr || s.travel == nullptr || s.rapid_rate == nullptr)
      return tell(id, "lacks a function");
    for (int c = 0; c < 256; ++c) {
      const char axis = static_cast<char>(c);
      double out[2] = {0, 0};
      judge(id, fmt::format("home({})", c), s.home(s.self, axis, out), out);
      for (const std::uint32_t which : {0u, 1u, 2u, 4u, 5u, UINT32_MAX})
        judge(id, fmt::format("reference({}, {})", c, which), s.reference(s.self, axis, which, out), out);
      s.travel(s.self, axis, out, out + 1);  // a limit may be infinite
      s.rapid_rate(s.self, axis, out);       // as a speed may be
    }
  }

  void ask_kinematics(std::string_view id, const ig_machine_kinematics_1& s) {
    if (s.axes == nullptr || s.tool_axis == nullptr || s.pivot == nullptr || s.solve == nullptr)
      return tell(id, "lacks a function");
    char names[2] = {};
    if (const std::uint32_t axes = s.axes(s.self, names); axes > 2)
      tell(id, fmt::format("has {} rotary axes, at most 2 are known", axes));
    for (const double a : odd_angles)
      for (const double b : odd_angles) {
        const double angles[3] = {a, b, a};
        double direction[3] = {}, matrix[16] = {};
        const bool is_everyday = std::abs(a) <= 360 && std::abs(b) <= 360;
        const std::int32_t axis = s.tool_axis(s.self, angles, direction), pivot = s.pivot(s.self, angles, matrix);
        ig_rotary_solution solutions[2] = {};
        if (const std::uint32_t count = s.solve(s.self, angles, angles, solutions); count > 2)
          tell(id, fmt::format("gives {} solutions, at most 2 have room", count));
        if (!is_everyday) continue;
        judge(id, "tool_axis()", axis, direction);
        judge(id, "pivot()", pivot, matrix);
      }
  }

  void ask_config(std::string_view id, const ig_config_1& s) {
    if (s.number == nullptr) return tell(id, "lacks a function");
    std::vector<std::string> names{"", "NoSuchName", std::string(5000, 'N')};
    names.insert(names.end(), std::begin(known_numbers), std::end(known_numbers));
    names.insert(names.end(), odd_texts().begin(), odd_texts().end());
    for (const std::string& name : names) {
      double out = 0;
      judge(id, fmt::format("number({:.20})", name), s.number(s.self, guarded(name), &out), {&out, 1});
      texts_.end_call();
    }
    double out = 0;
    if (s.number(s.self, guarded("NoSuchName"), &out) != 0) tell(id, "answers for a name that does not exist");
  }

  Examination& e_;
  std::string where_;
  GuardedTexts texts_;
};

// A text that row_fault() has left on its stack looks right until the stack is used again.
ig_text (*watched_row_fault)(void*, ig_text) = nullptr;
bool is_on_stack = false;

[[gnu::noinline]] void use_stack() {
  volatile unsigned char other[16384];
  for (volatile unsigned char& byte : other) byte = 0xA5;
}

ig_text noting_row_fault(void* self, ig_text row) {
  constexpr std::size_t most = 512;
  const ig_text out = watched_row_fault(self, row);
  const std::size_t size = out.data == nullptr ? 0 : std::min<std::size_t>(out.size, most);
  unsigned char first[most];
  const volatile char* const begin = out.data;
  for (std::size_t i = 0; i < size; ++i) first[i] = static_cast<unsigned char>(begin[i]);  // without a call
  use_stack();
  is_on_stack = is_on_stack || (size > 0 && std::memcmp(first, out.data, size) != 0);
  return out;
}

/// While it lives, the texts of the table's row_fault() are watched.
class RowFaultWatch {
 public:
  // The descriptor is the host's copy, in this process of the check alone.
  explicit RowFaultWatch(const ig_dependency& d) : dependency_(const_cast<ig_dependency&>(d)), before_(d.row_fault) {
    watched_row_fault = before_;
    is_on_stack = false;
    if (before_ != nullptr) dependency_.row_fault = noting_row_fault;
  }
  ~RowFaultWatch() { dependency_.row_fault = before_; }
  RowFaultWatch(const RowFaultWatch&) = delete;
  RowFaultWatch& operator=(const RowFaultWatch&) = delete;

 private:
  ig_dependency& dependency_;
  ig_text (*before_)(void*, ig_text);
};

/// A syntax beside which a dependency stands: one of the plugin, or the first of the dialect.
const ig_syntax* any_syntax(Subject& subject, const ig_plugin*& owner) {
  owner = &subject.plugin();
  if (!subject.syntaxes().empty()) return subject.syntaxes().front();
  for (const LoadedPlugin& p : subject.library().plugins())
    if (p.plugin->syntax_count > 0) return owner = p.plugin, p.plugin->syntaxes[0];
  return nullptr;
}

struct TableAttempt {
  std::string what, xml;
  bool may_be_refused = true;
};

std::string table_element(const ig_dependency& d, const std::string& options, const std::string& rows) {
  std::string all = options;
  for (std::uint32_t i = 0; i < d.option_count; ++i)
    if (d.options[i].fallback == nullptr && options.find(fmt::format(" {}=", d.options[i].name)) == std::string::npos)
      all += fmt::format(" {}=\"{}\"", d.options[i].name, escaped_xml(any_value(d.options[i])));
  return fmt::format("<{}{}>{}</{}>", d.id, all, rows, d.id);
}

std::vector<TableAttempt> attempts_of(const ig_dependency& d) {
  std::vector<TableAttempt> out{{"its defaults", table_element(d, "", ""), true}};
  for (std::uint32_t i = 0; i < d.option_count; ++i)
    for (const Candidate& c : candidates(d.options[i]))
      if (c.is_allowed)
        out.push_back({fmt::format("{}=\"{:.40}\"", d.options[i].name, c.value),
                       table_element(d, fmt::format(" {}=\"{}\"", d.options[i].name, escaped_xml(c.value)), ""),
                       c.may_be_refused});
  if (d.row_element == nullptr) return out;
  const auto row = [&](const std::string& key, const std::string& cells) {
    return fmt::format("<{} {}=\"{}\"{}/>", d.row_element, d.row_key, escaped_xml(key), cells);
  };
  std::string shipped = "1";
  if (d.default_row_count > 0)
    shipped = std::string(d.default_rows[0]).substr(0, std::string_view(d.default_rows[0]).find('|'));
  for (const std::string& key :
       {std::string("1"), std::string("A"), std::string("-1"), std::string("99999999999999999999"), std::string("1.5"),
        std::string("%s%n"), std::string("é"), std::string(3000, 'K')})
    out.push_back({fmt::format("a row '{:.20}'", key), table_element(d, "", row(key, ""))});
  for (std::uint32_t i = 0; i < d.column_count; ++i) {
    const ig_column_decl& column = d.columns[i];
    std::vector<std::string> values{"", "A", std::string(3000, 'V')};
    if (column.is_text == 0) {
      ig_option_decl as_option{};
      as_option.type = IG_OPTION_NUMBER;
      as_option.minimum = column.minimum;
      as_option.maximum = column.maximum;
      values = {"0", "1", "-1"};
      for (const Candidate& c : candidates(as_option))
        if (c.is_allowed) values.push_back(c.value);
    }
    for (const std::string& value : values)
      out.push_back({fmt::format("a row '{:.20}' with {}=\"{:.40}\"", shipped, column.name, value),
                     table_element(d, "", row(shipped, fmt::format(" {}=\"{}\"", column.name, escaped_xml(value))))});
  }
  return out;
}

void check_table(Examination& e, Subject& subject, const ig_dependency& d) {
  const ig_plugin* owner = nullptr;
  const ig_syntax* const beside = any_syntax(subject, owner);
  if (beside == nullptr)
    return e.remark(fmt::format("not looked at: no syntax is there beside which {} could stand", d.id));
  const RowFaultWatch watch(d);
  for (const TableAttempt& one : attempts_of(d)) {
    const std::string where = fmt::format("{}, {}", d.id, one.what);
    e.attempt(where);
    DiagnosticList said;
    const LinkedAlone alone = link_alone(*beside, *owner, subject.surroundings(), one.xml, subject.library(), said);
    const std::string creation = alone.linked != nullptr ? creation_fault(alone, in_mode(Mode::checked)) : "";
    if (is_on_stack)
      return e.find(where, "the text that its row_fault() returns is gone before the next call: it is on the stack");
    if (alone.linked == nullptr) {
      if (!one.may_be_refused) e.find(where, said.all.empty() ? "it does not link" : said.all.back().message);
      continue;
    }
    if (!creation.empty()) {
      const bool has_reason = creation.find("gives no reason") == std::string::npos;
      if (!has_reason || !one.may_be_refused) e.find(where, creation);
      continue;
    }
    Chain chain(*alone.linked, in_mode(Mode::checked), said);
    const std::size_t before = e.findings();
    ServiceQuestions questions(e, where);
    for (const char* const* id = d.provides; id != nullptr && *id != nullptr; ++id)
      if (const void* const service = chain.service(*id)) questions.ask(*id, service);
    if (e.findings() > before) return;
  }
}

}  // namespace

void check_tables(Examination& e) {
  Subject subject(e);
  for (std::uint32_t i = 0; i < subject.plugin().dependency_count; ++i)
    check_table(e, subject, *subject.plugin().dependencies[i]);
}

}  // namespace isogloss::cli
