// The tables SiemensMacros and SiemensVariables as files of an archive. Definitions come before values.
#include <unordered_map>

#include "archive/variable_rows.hpp"
#include "archive/written_file.hpp"
#include "language/declared_type.hpp"
#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr const char* variables = "SiemensVariables";

class VariableWriter {
 public:
  explicit VariableWriter(ig::Export& out) : out_(out) {
    for (std::uint32_t i = 0; i < out.rows(variables); ++i) {
      const std::string name = upper(out.key(variables, i));
      std::size_t end = 0;
      if (const auto type = type_at(cell(i, "Type"), end)) types_[name] = *type;
    }
  }

  void write_macros() {
    WrittenFile lines(out_, "UMAC_DEF");
    for (std::uint32_t i = 0; i < out_.rows("SiemensMacros"); ++i)
      lines.line("DEFINE " + upper(out_.key("SiemensMacros", i)) + " AS " +
                 std::string(out_.cell("SiemensMacros", i, "Text")));
  }

  /// DEF CHAN REAL LLI 0 ULI 5 STOCK[3]=REP(0.5)
  void write_definitions() {
    WrittenFile lines(out_, "UGUD_DEF");
    for_each_row([&](std::uint32_t i, const std::string& name) {
      if (is_r_name(name) || !is_defined(i)) return;
      std::string line = "DEF CHAN " + type_text(type_of(i, name));
      for (const auto& [column, word] : {std::pair("Lowest", " LLI "), std::pair("Highest", " ULI ")})
        if (const std::string limit = written(cell(i, column), 1); !limit.empty()) line += word + limit;
      line += ' ' + name;
      if (const std::string_view size = cell(i, "Size"); !size.empty()) {
        line += '[' + std::string(size) + ']';
        if (const std::string all = value_of_row(i, name);
            !all.empty() && all != "0" && all != "\"\"" && all != "CTRANS()")
          line += "=REP(" + all + ')';
      }
      lines.line(line);
    });
  }

  void write_values(std::string_view file, bool wants_r) {
    WrittenFile lines(out_, file);
    for_each_row([&](std::uint32_t i, const std::string& name) {
      if (is_r_name(name) != wants_r || !cell(i, "Size").empty()) return;
      const std::string value = value_of_row(i, name);
      if (name.starts_with('$'))
        out_.unused("system variables", "the archive holds R parameters and user data only");
      else if (!value.empty())
        lines.line(name + '=' + value);
    });
  }

 private:
  std::string_view cell(std::uint32_t row, std::string_view column) const { return out_.cell(variables, row, column); }
  template <class Each>
  void for_each_row(Each&& each) {
    for (std::uint32_t i = 0; i < out_.rows(variables); ++i) each(i, upper(out_.key(variables, i)));
  }
  bool is_defined(std::uint32_t row) const {
    for (const char* const column : {"Type", "Size", "Lowest", "Highest"})
      if (!cell(row, column).empty()) return true;
    return false;
  }
  Declared type_of(std::uint32_t row, const std::string& name) const {
    const auto type = types_.find(name.substr(0, name.find('[')));
    if (type != types_.end()) return type->second;
    Declared out;
    if (!cell(row, "Text").empty()) out.type = Type::text;
    return out;
  }

  /// Empty where the file has no form for the value.
  std::string value_of_row(std::uint32_t row, const std::string& name) {
    const Declared type = type_of(row, name);
    std::string text(cell(row, "Text"));
    if (type.type == Type::frame) return text.empty() ? "CTRANS()" : text;
    if (type.detail == Declared::Detail::axis) return text;
    if (type.type != Type::text) {
      const std::string value = written(cell(row, "Value"), 1);
      return value.empty() ? "0" : value;
    }
    if (text.find('"') == std::string::npos) return '"' + text + '"';
    out_.unused("texts with a quotation mark", "a text stands between quotation marks");
    return "";
  }

  ig::Export& out_;
  std::unordered_map<std::string, Declared> types_;
};

}  // namespace

void write_variables(ig::Export& out) {
  VariableWriter writer(out);
  writer.write_macros();
  writer.write_definitions();
  writer.write_values("CH1_RPA_INI", true);
  writer.write_values("CH1_GUD_INI", false);
}

}  // namespace siemens
