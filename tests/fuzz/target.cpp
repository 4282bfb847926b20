#include "target.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>

namespace isogloss::fuzz {

namespace fs = std::filesystem;

namespace {

using Make = std::function<std::unique_ptr<Target>()>;

const std::map<std::string, Make>& targets() {
  static const std::map<std::string, Make> all = [] {
    std::map<std::string, Make> out{{"dialect", make_dialect_target}, {"tables", make_tables_target},
                                    {"import", make_import_target},   {"page", make_page_target},
                                    {"block", make_block_target},     {"descriptor", make_descriptor_target},
                                    {"stream", make_stream_target},   {"messages", make_messages_target}};
    for (const char* const name : {"fanuc", "haas", "okuma", "syntec", "siemens", "heidenhain"})
      out["program." + std::string(name)] = [name] { return make_program_target(name, "", ""); };
    out["expression.fanuc"] = [] {
      return make_program_target("fanuc", "G21 G90\n#1=1\n#2=2.5\n#3=", "\nG0 X#3\nM30\n");
    };
    out["expression.siemens"] = [] {
      return make_program_target("siemens", "G71 G90\nR1=1 R2=2.5\nR3=", "\nG0 X=R3\nM30\n");
    };
    out["expression.heidenhain"] = [] {
      return make_program_target("heidenhain",
                                 "BEGIN PGM A MM\nQ1 = 1\nQ2 = 2.5\nQ3 = ", "\nL X+Q3 R0 FMAX\nEND PGM A MM\n");
    };
    return out;
  }();
  return all;
}

class Unheard : public DiagnosticSink {
 public:
  void add(Diagnostic) override {}
};

}  // namespace

std::unique_ptr<Target> make_target(const std::string& name) {
  const auto found = targets().find(name);
  return found == targets().end() ? nullptr : found->second();
}

std::vector<std::string> target_names() {
  std::vector<std::string> out;
  for (const auto& [name, make] : targets()) out.push_back(name);
  return out;
}

void fail(const std::string& promise) {
  std::fprintf(stderr, "a promise is broken: %s\n", promise.c_str());
  std::abort();
}

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
  if (out == nullptr) fail("the dialect " + name + " links" + (said.all.empty() ? "" : ": " + said.all[0].message));
  return *out;
}

std::vector<std::string> texts_of_files(const std::string& below, const std::string& ending) {
  constexpr std::uintmax_t most_bytes = 1u << 16;
  std::vector<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ISOGLOSS_SOURCE) / below)) {
    if (!entry.is_regular_file() || entry.file_size() > most_bytes) continue;
    if (!entry.path().filename().string().ends_with(ending)) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    out.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return out;
}

void expect_no_internal_fault(const std::vector<Diagnostic>& said) {
  for (const Diagnostic& d : said)
    if (is_internal_fault(d.code)) fail("no input makes a plugin or the host fail: " + d.message + " [" + d.code + "]");
}

}  // namespace isogloss::fuzz
