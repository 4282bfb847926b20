// The tool file of an Acme control: "ACME TOOLS", then a number, a length and a radius on each line.
#include <isogloss/sdk.hpp>

namespace {

struct AcmeToolFile {
  static constexpr auto spec =
      ig::importer("AcmeToolFile", "The tools of an Acme control.").files("*.acmetools").fills("ToolOffsetTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ACM-0010", "'{0}' is not number, length and radius of a tool: the line is left out"),
  };

  static unsigned recognise(std::string_view text, std::string_view) {
    return text.starts_with("ACME TOOLS") ? 100 : 0;
  }

  void read(ig::Import& file) const {
    for (const ig::TextLine& line : file.lines()) {
      if (line.begin == 0 || line.text.empty()) continue;
      const ig::Decimal number = ig::read_decimal(line.text, 0), length = behind(line.text, number),
                        radius = behind(line.text, length);
      if (!radius.ok || number.has_point || number.value < 1 || number.value > 400) {
        file.report(ig::diag("ACM-0010"), line.begin, line.begin + line.text.size(), line.text);
        continue;
      }
      file.row("ToolOffsetTable", static_cast<std::int64_t>(number.value), line.begin);
      file.cell("H", length.value, line.begin + number.end + 1);
      file.cell("D", radius.value, line.begin + length.end + 1);
    }
  }

 private:
  /// The number behind another one and a blank.
  static ig::Decimal behind(std::string_view text, const ig::Decimal& first) {
    return first.ok && first.end < text.size() ? ig::read_decimal(text, first.end + 1) : ig::Decimal();
  }
};

const ig::Register<AcmeToolFile> acme_tool_file;

}  // namespace
