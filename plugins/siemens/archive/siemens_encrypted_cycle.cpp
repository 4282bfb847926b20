// Encrypted cycles of a SINUMERIK, *.CPF: their text cannot be read outside the control. They are recognised so that a
// backup with them is explained. SINUMERIK 840D sl commissioning manual, "Cycle protection".
#include <algorithm>
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensEncryptedCycle {
  static constexpr auto spec =
      ig::importer("SiemensEncryptedCycle", "An encrypted cycle of a SINUMERIK, of which nothing is read.")
          .files("*.cpf")
          .fills("SiemensVariables");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "SIE-0380",
                     "this cycle is encrypted and cannot be read: a row of MachineCodes can tell what its call does"),
  };

  /// The content has no sign of its own; a readable text with this ending is no encrypted one.
  static unsigned recognise(std::string_view text, std::string_view file_name) {
    const bool is_one_file = text.find(head, head.size()) == std::string_view::npos;
    if (!ends_as_cycle(file_name) && !(is_one_file && ends_as_cycle(head_of(text)))) return 0;
    return is_readable(text) ? 0 : 100;
  }

  void read(ig::Import& file) const { file.report(ig::diag("SIE-0380"), 0, file.text().size()); }

 private:
  static constexpr std::string_view head = "%_N_";

  static bool ends_as_cycle(std::string_view name) {
    const std::string end = in_capitals(name.substr(name.size() - std::min<std::size_t>(name.size(), 4)));
    return end == ".CPF" || end == "_CPF";
  }
  /// The name in a first line %_N_NAME_CPF.
  static std::string_view head_of(std::string_view text) {
    if (!text.starts_with(head)) return {};
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    return line.substr(0, line.find_last_not_of(" \t") + 1);
  }

  /// Blocks of a program are short lines of ASCII; comments may have a few other letters.
  static bool is_readable(std::string_view text) {
    constexpr std::size_t looked_at = 4096, most_of_a_hundred = 10;
    const std::size_t behind_head = head_of(text).empty() ? 0 : std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view part = text.substr(behind_head, looked_at);
    const auto is_plain = [](char c) { return (c >= ' ' && c <= '~') || c == '\t' || c == '\r' || c == '\n'; };
    const auto others = part.size() - static_cast<std::size_t>(std::count_if(part.begin(), part.end(), is_plain));
    return others * 100 <= part.size() * most_of_a_hundred && !part.empty();
  }
};

const ig::Register<SiemensEncryptedCycle> siemens_encrypted_cycle;

}  // namespace
}  // namespace siemens
