#include "product.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>

namespace isogloss::product {

namespace fs = std::filesystem;

namespace {

class Unheard : public DiagnosticSink {
 public:
  void add(Diagnostic) override {}
};

}  // namespace

Workspace& workspace() {
  static Unheard unheard;
  static Workspace& all = *std::make_unique<Workspace>(NamedFolders{}, ISOGLOSS_HOME, unheard).release();
  return all;
}

const LinkedDialect& dialect(const std::string& name) {
  static auto& linked = *std::make_unique<std::map<std::string, std::unique_ptr<LinkedDialect>>>().release();
  std::unique_ptr<LinkedDialect>& out = linked[name];
  DiagnosticList said;
  if (out == nullptr) out = workspace().link(name, {}, said);
  if (out == nullptr)
    throw std::runtime_error("the dialect " + name + " does not link" +
                             (said.all.empty() ? "" : ": " + said.all[0].message));
  return *out;
}

std::vector<std::string> texts_of_files(const std::string& below, const std::string& ending) {
  constexpr std::uintmax_t most_bytes = 1u << 16;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ISOGLOSS_SOURCE) / below)) {
    if (!entry.is_regular_file() || entry.file_size() > most_bytes) continue;
    if (entry.path().filename().string().ends_with(ending)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> out;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    out.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return out;
}

std::vector<std::string> programs_of(const std::string& dialect) {
  std::vector<std::string> out;
  for (const char* const ending : {".nc", ".mpf", ".spf", ".h", ".tap"})
    for (std::string& text : texts_of_files("tests/programs/" + dialect, ending)) out.push_back(std::move(text));
  return out;
}

}  // namespace isogloss::product
