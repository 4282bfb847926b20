// The profile of a Mach3 machine, an XML file (Mach3Mill.xml). How it holds tools and fixtures is not published, so
// that it is recognised and named, and nothing of it is read.
#include <array>

#include <isogloss/sdk.hpp>

namespace tables {

namespace {

struct Mach3Profile {
  static constexpr auto spec = ig::importer("Mach3Profile", "The XML profile of a Mach3, of which nothing is read.")
                                   .files("Mach3*.xml")
                                   .fills("ToolOffsetTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "TAB-0120",
                     "a Mach3 profile is not read: export its tools as CSV, and enter its fixtures as work offsets"),
  };

  static unsigned recognise(std::string_view text, std::string_view) {
    text = behind_blanks(text);
    if (text.starts_with("<?")) text = behind_blanks(text.substr(std::min(text.find("?>"), text.size() - 2) + 2));
    if (!text.starts_with(root)) return 0;
    return behind_blanks(text.substr(root.size())).starts_with("<Preferences") ? 90 : 0;
  }

  void read(ig::Import& file) const {
    const std::size_t size = file.text().size(), begin = std::min(file.text().find(root), size);
    file.report(ig::diag("TAB-0120"), begin, std::min(begin + root.size(), size));
  }

 private:
  static constexpr std::string_view root = "<profile>";

  static std::string_view behind_blanks(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  }
};

const ig::Register<Mach3Profile> mach3_profile;

}  // namespace
}  // namespace tables
