#include "outputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "isogloss/engine/import.hpp"
#include "output_file.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

bool write_file(const std::string& path, std::string_view text, Session& session) {
  std::string error;
  const std::unique_ptr<OutputFile> file = OutputFile::open(path, error);
  if (file != nullptr) {
    file->write(text);
    if (file->commit() || file->reader_is_gone()) return true;
    error = file->error();
  }
  session.report("IG-0511", {path}, {error});
  return false;
}

bool is_name_of_svg(const std::string& path, Session& session) {
  static constexpr std::array others{"png",  "pdf", "jpg", "jpeg", "gif",  "bmp",  "tif", "tiff",
                                     "webp", "eps", "ps",  "dxf",  "svgz", "html", "ico", "emf"};
  std::string extension = fs::path(path).extension().string();
  if (extension.empty()) return true;
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (std::find(others.begin(), others.end(), extension.substr(1)) == others.end()) return true;
  session.report(
      "IG-0653", {path}, {extension.substr(1)},
      "name it " + fs::path(path).replace_extension(".svg").string() + "; rsvg-convert turns SVG into PNG and PDF");
  return false;
}

bool are_apart(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs, Session& session) {
  std::error_code code;
  const auto is_replaced = [&](const std::string& file) {
    const fs::file_status status = fs::status(file, code);
    return !file.empty() && file != "-" && (!fs::exists(status) || fs::is_regular_file(status));
  };
  const auto are_one = [&](const std::string& a, const std::string& b) { return fs::equivalent(a, b, code); };
  // Both outputs may not exist yet.
  const auto have_one_name = [&](const std::string& a, const std::string& b) {
    return are_one(a, b) || fs::weakly_canonical(fs::absolute(a), code) == fs::weakly_canonical(fs::absolute(b), code);
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!is_replaced(outputs[i])) continue;
    for (const std::string& input : inputs)
      if (!input.empty() && input != "-" && are_one(input, outputs[i])) {
        session.report_to_stderr();
        session.report("IG-0530", {outputs[i]}, {input});
        return false;
      }
    for (std::size_t k = 0; k < i; ++k)
      if (is_replaced(outputs[k]) && have_one_name(outputs[k], outputs[i])) {
        session.report_to_stderr();
        session.report("IG-0531", {outputs[i]}, {outputs[k]});
        return false;
      }
  }
  return true;
}

std::vector<std::string> files_of_machine(const std::string& machine_file) {
  if (fs::path(machine_file).filename() != "machine.xml") return {machine_file};
  DiagnosticList unheard;  // what cannot be read there is reported by those who read it
  const fs::path folder = fs::absolute(machine_file).parent_path();
  std::vector<std::string> out;
  for (const fs::path& file : files_of({folder, {}, {}, {}}, unheard)) out.push_back(file.string());
  return out;
}

}  // namespace isogloss::cli
