// The parameters that a Fanuc control puts out (CNC-PARA.TXT): a number in each block, then its values, each behind its
// axis (A), path (L) or spindle (S). P is a plain value, M one in mm, I one in inches. Fanuc parameter manual,
// "Parameter output".
#include <map>
#include <utility>

#include <isogloss/cnc/work_offset_id.hpp>
#include <isogloss/sdk.hpp>

#include "punch_out/punched_block.hpp"
#include "punch_out/punched_parameters.hpp"
#include "punch_out/written_parameters.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

enum class ParameterUnit { parameters, mm, inch };

struct FanucParameters {
  static constexpr const char* parameter_rows = "FanucParameterTable";
  static constexpr auto spec = ig::importer("FanucParameters", "Parameters that a Fanuc control puts out.")
                                   .files("CNC-PARA.* *.prm *.par")
                                   .fills(parameter_rows, "IsoCoordinateTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0236", "this block begins with no number of a parameter, so it is left out"),
      ig::diagnostic(IG_WARNING, "FAN-0237",
                     "parameter {0} has eight binary digits, and '{1}' is none of them, so the value is left out"),
      ig::diagnostic(IG_WARNING, "FAN-0238",
                     "parameter {0} differs between axes; the table has one value, that of the first axis"),
  };

  ig::Choice<ParameterUnit> unit{
      "unit", "parameters|mm|inch", "parameters",
      "The unit of lengths without M or I; parameters: as 0000 bit 2 and 1001 bit 0 in the file say, else mm."};
  ig::TextOption axes{"axes", "XYZ", "Letters of the axes 1, 2, 3 and so on, where the file has no parameter 1020."};
  ig::IntegerOption path{"path", "1", {1, 99}, "The path of the control whose values are read."};

  static unsigned recognise(std::string_view text, std::string_view) {
    ig::EntryCount parameters;
    std::size_t with_q = 0;
    PunchedBlock block;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      block.read(line);
      if (block.is_empty()) continue;
      parameters.add(is_parameter(block));
      with_q += is_parameter(block) && block.find('Q') != nullptr ? 1 : 0;
    }
    return parameters.confidence(with_q == parameters.own ? 95 : 75);
  }

  void read(ig::Import& file) const {
    Machine machine = machine_of(file);
    PunchedBlock block;
    std::map<std::int64_t, double> values;
    for (const ig::TextLine& line : file.lines()) {
      block.read(line);
      if (block.is_empty()) continue;
      if (!block.is_sound())
        block.report_fault(file);
      else if (block.words()[0].letter != 'N' || !block.words()[0].whole())
        file.report(ig::diag("FAN-0236"), block.begin(), block.end());
      else
        read_parameter(file, machine, block, values);
    }
  }

  void write(ig::Export& out) const { write_parameters(out, {axes.text(), path, unit == ParameterUnit::inch}); }

 private:
  static constexpr const char* no_place = "no table has a place for it";

  /// What the file itself tells about the machine.
  struct Machine {
    bool machine_is_inch = false, input_is_inch = false;
    bool knows_machine_unit = false, knows_input_unit = false, is_unit_reported = false;
    double counts_per_mm = 1000;
    std::map<std::int64_t, char> letters;  // of the controlled axes
  };
  struct Value {
    char kind = 'P';
    std::int64_t axis = 0, path = 0, spindle = 0, group = 0;  // 0: of none
    const PunchedWord* word = nullptr;
  };

  /// N with four or five digits, perhaps Q, then values. Without Q only P is a value: N0010 M5 is a block of a program.
  static bool is_parameter(const PunchedBlock& block) {
    const std::vector<PunchedWord>& words = block.words();
    if (!block.is_sound() || words.size() < 2 || words[0].letter != 'N') return false;
    if (words[0].digits.size() < 4 || words[0].digits.size() > 5 || words[0].number.has_point) return false;
    const std::string_view values = words[1].letter == 'Q' ? "PMI" : "P";
    const auto is_value = [&](const PunchedWord& w) { return values.find(w.letter) != std::string_view::npos; };
    const auto is_known = [&](const PunchedWord& w) {
      return is_value(w) || std::string_view("QALST").find(w.letter) != std::string_view::npos;
    };
    return std::all_of(words.begin() + 1, words.end(), is_known) && is_value(words.back());
  }

  /// Calls `use` for each value of the block. What stands before a value belongs to that value only.
  template <class Use>
  static void for_values(const PunchedBlock& block, Use&& use) {
    Value value;
    for (const PunchedWord& w : block.words()) {
      const std::int64_t n = w.whole().value_or(0);
      switch (w.letter) {
        case 'A': value.axis = n; break;
        case 'L': value.path = n; break;
        case 'S': value.spindle = n; break;
        case 'T': value.group = n; break;
        case 'P':
        case 'M':
        case 'I':
          value.kind = w.letter;
          value.word = &w;
          use(value);
          value = {};
          break;
        default: break;
      }
    }
  }
  bool is_of_path(const Value& value) const { return value.path == 0 || value.path == path; }

  Machine machine_of(ig::Import& file) const {
    Machine out;
    bool has_increment = false;
    PunchedBlock block;
    for (const ig::TextLine& line : file.lines()) {
      block.read(line);
      if (!block.is_sound() || block.words().empty() || block.words()[0].letter != 'N' || block.has('Q', 0)) continue;
      const std::int64_t number = block.words()[0].whole().value_or(-1);
      if (number != 0 && number != 1001 && number != 1013 && number != 1020) continue;
      for_values(block, [&](const Value& v) {
        if ((!is_of_path(v) || v.group > 1) && number != 1020) return;
        const unsigned bits = bits_of(v.word->digits).value_or(0);
        if (number == 0) {
          out.input_is_inch = (bits & 4u) != 0;
          out.knows_input_unit = true;
        }
        if (number == 1001) {
          out.machine_is_inch = (bits & 1u) != 0;
          out.knows_machine_unit = true;
        }
        if (number == 1013 && !std::exchange(has_increment, true))
          out.counts_per_mm = (bits & 1u) != 0 ? 100 : (bits & 2u) != 0 ? 10000 : 1000;
        if (number == 1020) add_letter(out, v);
      });
    }
    if (unit != ParameterUnit::parameters) {
      out.input_is_inch = out.machine_is_inch = unit == ParameterUnit::inch;
      out.knows_input_unit = out.knows_machine_unit = true;
    }
    if (out.letters.empty())
      for (const char letter : axes.text())
        out.letters.emplace(static_cast<std::int64_t>(out.letters.size()) + 1, letter);
    return out;
  }
  /// Two paths may each have an X; the first one is that of the table.
  static void add_letter(Machine& machine, const Value& value) {
    const std::int64_t code = value.word->whole().value_or(0);
    if (code < 'A' || code > 'Z') return;
    const char letter = static_cast<char>(code);
    const bool is_taken = std::any_of(machine.letters.begin(), machine.letters.end(),
                                      [&](const auto& known) { return known.second == letter; });
    if (!is_taken) machine.letters.emplace(value.axis, letter);
  }

  void read_parameter(ig::Import& file, Machine& machine, const PunchedBlock& block,
                      std::map<std::int64_t, double>& values) const {
    const std::int64_t number = *block.words()[0].whole();
    const KnownParameter* const known = known_parameter(number);
    if (block.has('Q', 0)) return file.unused("pitch error data (Q0)", no_place, block.begin(), block.end());
    if (is_settled_here(number)) return;
    if (known == nullptr) return file.unused("parameter", "no syntax uses it", block.begin(), block.end());
    for (const PunchedWord& w : block.words())
      if (std::string_view("NQALSTPMI").find(w.letter) == std::string_view::npos)
        file.unused(std::string("word ") + w.letter, no_place, w.begin, w.end);
    for_values(block, [&](const Value& v) {
      const std::size_t begin = v.word->begin, end = v.word->end;
      if (!is_of_path(v)) return file.unused("value of another path", "option path names the path", begin, end);
      if (v.spindle > 1) return file.unused("value of another spindle", no_place, begin, end);
      if (v.group > 1) return file.unused("value of another machine group", no_place, begin, end);
      const auto axis = machine.letters.find(v.axis);
      const char letter = axis == machine.letters.end() ? '?' : axis->second;
      if (known->has_axes && v.axis == 0) return file.unused("value without an axis", no_place, begin, end);
      if (known->has_axes && letter == '?')
        return file.unused("value of axis " + std::to_string(v.axis), "no letter of it is known", begin, end);
      if (known->has_axes && std::string_view("XYZABC").find(letter) == std::string_view::npos)
        return file.unused(std::string("value of axis ") + letter, no_place, begin, end);
      const std::optional<double> value = value_of(machine, *known, v, letter);
      if (value && assumes_unit(machine, *known, v, letter) && !std::exchange(machine.is_unit_reported, true))
        file.report(ig::diag("FAN-0241"), begin, end);
      if (!value)
        return file.report(ig::diag("FAN-0237"), begin, end, std::to_string(number), shown_part(v.word->digits));
      if (known->kind == ParameterKind::work_offset)
        return put_offset(file, WorkOffsetId::basic(static_cast<double>(number - 1220)).text(), letter, *value,
                          *v.word);
      file.row(parameter_rows, number, begin);
      if (known->has_axes) return file.cell({&letter, 1}, *value, begin);
      const auto [first, is_first] = values.emplace(number, *value);
      if (is_first || v.axis == 0) return file.cell("Value", *value, begin);
      if (first->second != *value) file.report(ig::diag("FAN-0238"), begin, end, std::to_string(number));
    });
  }
  /// Parameters that tell how the others are read.
  static bool is_settled_here(std::int64_t number) { return number == 0 || number == 1001 || number == 1020; }

  /// A length without M or I, in a file without the parameter that names its unit.
  static bool assumes_unit(const Machine& machine, const KnownParameter& known, const Value& value, char letter) {
    const bool is_known = known.system == LengthSystem::input ? machine.knows_input_unit : machine.knows_machine_unit;
    if (is_known || value.kind != 'P' || value.word->number.value == 0) return false;
    return known.is_length(is_rotary(letter), value.word->number.has_point);
  }

  static std::optional<double> value_of(const Machine& machine, const KnownParameter& known, const Value& value,
                                        char letter) {
    const ig::Decimal& n = value.word->number;
    bool is_inch = known.system == LengthSystem::input ? machine.input_is_inch : machine.machine_is_inch;
    if (value.kind != 'P') is_inch = value.kind == 'I';
    PunchedUnit unit{is_inch, value.kind == 'P', machine.counts_per_mm};
    switch (known.kind) {
      case ParameterKind::bits:
        if (const auto bits = bits_of(value.word->digits)) return *bits;
        return std::nullopt;
      case ParameterKind::number: return n.value;
      case ParameterKind::counted:
        if (value.kind == 'P' && !n.has_point && !is_inch) return n.value;
        return unit.mm(n) * machine.counts_per_mm;
      case ParameterKind::counted_angle:
        return value.kind == 'P' && !n.has_point ? n.value : n.value * machine.counts_per_mm;
      case ParameterKind::position:
      case ParameterKind::work_offset: return is_rotary(letter) ? unit.degrees(n) : unit.mm(n);
      // Without a point 1 mm/min, 0.1 inch/min or 1 degree/min.
      case ParameterKind::rate:
        if (is_rotary(letter)) return n.value;
        return length_in_mm(n.value, is_inch ? mm_per_inch : 1) /
               (is_inch && value.kind == 'P' && !n.has_point ? 10 : 1);
    }
    return std::nullopt;
  }
};

const ig::Register<FanucParameters> fanuc_parameters;

}  // namespace
}  // namespace fanuc
