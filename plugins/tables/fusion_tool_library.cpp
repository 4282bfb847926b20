// A tool library that Fusion exports as JSON. The lengths are those of the CAM system: a library that was not measured
// holds stick-outs, which are no tool lengths.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <isogloss/cnc/file_length.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

#include "json_text.hpp"
#include "tool_rows.hpp"

namespace tables {

namespace {

struct FusionToolLibrary {
  enum class LengthUnit { mm, inch };
  enum class Rows { tool, offsets };

  static constexpr auto spec =
      ig::importer("FusionToolLibrary", "A tool library of Autodesk Fusion.").files("*.json").fills("ToolOffsetTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "TAB-0109",
                     "this text is no JSON with a list of tools, or too large, so nothing of it is read"),
      ig::diagnostic(IG_WARNING, "TAB-0110",
                     "tool {0} names no unit, and neither does its library: option unit is used for it"),
  };

  ig::Choice<LengthUnit> unit{"unit", "mm|inch", "mm", "The unit of tools for which the library names none."};
  ig::Choice<Rows> rows{"rows", "tool|offsets", "tool",
                        "Whether both values stand in the row of the tool number, or the length in that of its length "
                        "offset and the radius in that of its diameter offset."};

  static unsigned recognise(std::string_view text, std::string_view) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '{') return 0;
    const auto has = [&](std::string_view name) { return text.find(name) != std::string_view::npos; };
    if (!has("\"data\"")) return 0;
    if (has("\"geometry\"") && (has("\"DC\"") || has("\"post-process\""))) return 90;
    return has("\"version\"") && text.size() < 200 ? 30 : 0;
  }

  void read(ig::Import& file) const {
    JsonReader reader(file.text());
    const std::optional<JsonValue> library = reader.read();
    const JsonValue* const data = library ? library->find("data") : nullptr;
    if (!library || data == nullptr || !data->is(JsonValue::Kind::list)) {
      const std::size_t place = library ? 0 : reader.place();
      return file.report(ig::diag("TAB-0109"), place, file.text().size());
    }
    for (const auto& [name, value] : library->members)
      if (name != "data" && name != "version" && name != "unit") unused(file, "key " + name, value);
    ToolRows table(file);
    for (const auto& [none, tool] : data->members)
      if (is_holder(tool))
        file.unused("holder", "no table has a place for it", tool.begin, tool.end);
      else
        read_tool(file, table, tool, text_of(*library, "unit"));
    table.finish();
  }

 private:
  struct Cell {
    std::string row;
    const char* column;
    double mm;
    const JsonValue* source;
  };

  static void unused(ig::Import& file, const std::string& what, const JsonValue& value) {
    file.unused(what, "no table has a place for it", value.begin, value.end);
  }
  static std::string text_of(const JsonValue& object, std::string_view name) {
    const JsonValue* const value = object.find(name);
    return value != nullptr && value->is(JsonValue::Kind::text) ? value->text : std::string();
  }
  static const JsonValue* number_of(const JsonValue* object, std::string_view name) {
    const JsonValue* const value = object == nullptr ? nullptr : object->find(name);
    return value != nullptr && value->is(JsonValue::Kind::number) ? value : nullptr;
  }
  static bool is_holder(const JsonValue& tool) { return text_of(tool, "type") == "holder"; }

  /// "millimeters", "mm", "inches", "in"; nothing for other texts.
  static std::optional<LengthUnit> unit_in(std::string_view text) {
    if (text.find("mm") != std::string_view::npos || text.find("millim") != std::string_view::npos)
      return LengthUnit::mm;
    return text.find("in") != std::string_view::npos ? std::optional(LengthUnit::inch) : std::nullopt;
  }

  /// The tool's own unit, else that of its expressions, else that of the library.
  static std::optional<LengthUnit> unit_of(const JsonValue& tool, const std::string& of_library) {
    if (const auto own = unit_in(text_of(tool, "unit"))) return own;
    const JsonValue* const expressions = tool.find("expressions");
    if (expressions != nullptr)
      if (const auto own = unit_in(text_of(*expressions, "tool_unit"))) return own;
    return unit_in(of_library);
  }

  void read_tool(ig::Import& file, ToolRows& table, const JsonValue& tool, const std::string& of_library) const {
    const JsonValue* const numbers = tool.find("post-process");
    const auto row_of = [&](std::string_view name) {
      const JsonValue* const n = number_of(numbers, name);
      const auto whole = n == nullptr ? std::nullopt : ig::cnc::whole_number(n->number);
      return whole ? ToolRows::key_of(std::to_string(*whole)) : std::string();
    };
    const std::string number = row_of("number");
    if (number.empty()) {
      const JsonValue* const n = number_of(numbers, "number");
      return file.report(ig::diag("TAB-0104"), tool.begin, tool.end, n == nullptr ? "nothing" : short_text(n->number));
    }
    const auto own_row = [&](const char* name) {
      const std::string row = row_of(name);
      const bool is_other = !row.empty() && row != number;
      if (is_other && rows != Rows::offsets)
        file.unused(std::string("another number as ") + name, "option rows=offsets reads it", tool.begin, tool.end);
      return is_other && rows == Rows::offsets ? row : number;
    };
    const std::string length_row = own_row("length-offset"), radius_row = own_row("diameter-offset");
    const std::optional<LengthUnit> known_unit = unit_of(tool, of_library);
    if (!known_unit) file.report(ig::diag("TAB-0110"), tool.begin, tool.end, number);
    const double mm = known_unit.value_or(unit) == LengthUnit::inch ? ig::cnc::mm_per_inch : 1;
    table.begin(number, tool.begin, tool.end);
    if (const std::string name = text_of(tool, "description"); !name.empty()) file.cell("Name", name, tool.begin);
    const JsonValue* const geometry = tool.find("geometry");
    const JsonValue* length = number_of(geometry, "assemblyGaugeLength");
    if (length == nullptr) length = number_of(&tool, "assemblyGaugeLength");
    if (length == nullptr)
      file.unused("tool without assemblyGaugeLength", "its length is not known", tool.begin, tool.end);
    else
      put(file, table, {length_row, "H", ig::cnc::length_in_mm(length->number, mm), &tool});
    if (const std::optional<double> diameter = diameter_of(tool, mm))
      put(file, table, {radius_row, "D", *diameter / 2, &tool});
    else
      file.unused("tool without DC", "its radius is not known", tool.begin, tool.end);
    read_numbers(file, tool, mm);
    read_rest(file, tool);
  }
  /// Corner radius, angle at the tip, flutes.
  static void read_numbers(ig::Import& file, const JsonValue& tool, double mm) {
    const JsonValue* const geometry = tool.find("geometry");
    const auto give = [&](const char* key, const char* column, double factor, double most) {
      const JsonValue* const n = number_of(geometry, key);
      if (n == nullptr) return;
      if (!(n->number >= 0 && n->number * factor <= most)) return unused(file, std::string("geometry ") + key, *n);
      file.cell(column, factor == 1 ? n->number : ig::cnc::length_in_mm(n->number, factor), tool.begin);
    };
    give("RE", "CornerRadius", mm, 1e9);
    give("SIG", "TipAngle", 1, 180);
    give("NOF", "Teeth", 1, 1000);
  }
  static void put(ig::Import& file, ToolRows& table, const Cell& cell) {
    if (!std::isfinite(cell.mm)) return;
    table.add(cell.row, cell.source->begin);
    file.cell(cell.column, cell.mm, cell.source->begin);
  }

  /// In mm. The number of the geometry, else the text of an expression such as "10 mm".
  static std::optional<double> diameter_of(const JsonValue& tool, double mm) {
    if (const JsonValue* const diameter = number_of(tool.find("geometry"), "DC"))
      return ig::cnc::length_in_mm(diameter->number, mm);
    const JsonValue* const expressions = tool.find("expressions");
    const std::string text = expressions == nullptr ? std::string() : text_of(*expressions, "tool_diameter");
    const ig::Decimal n = ig::read_decimal(text, 0);
    const std::size_t behind = n.ok ? text.find_first_not_of(' ', n.end) : 0;
    if (!n.ok) return std::nullopt;
    if (behind == std::string::npos) return ig::cnc::length_in_mm(n.value, mm);
    const std::string_view written = std::string_view(text).substr(behind);
    if (written == "mm") return n.value;
    return written == "in" ? std::optional(ig::cnc::length_in_mm(n.value, ig::cnc::mm_per_inch)) : std::nullopt;
  }

  static std::string short_text(double value) {
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
  }

  static void read_rest(ig::Import& file, const JsonValue& tool) {
    static constexpr std::array read{
        "DC", "RE", "SIG", "NOF", "assemblyGaugeLength", "number", "length-offset", "diameter-offset"};
    for (const auto& [name, value] : tool.members) {
      if (name == "geometry" || name == "post-process")
        for (const auto& [key, inner] : value.members) {
          if (std::find(read.begin(), read.end(), key) == read.end()) unused(file, name + ' ' + key, inner);
        }
      else if (name != "description" && name != "unit" && name != "expressions" && name != "assemblyGaugeLength")
        unused(file, "key " + name, value);
    }
  }
};

const ig::Register<FusionToolLibrary> fusion_tool_library;

}  // namespace
}  // namespace tables
