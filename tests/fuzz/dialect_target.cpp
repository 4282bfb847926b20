// Files of dialects and machines: refused with a diagnostic, or they link and run a program.
#include "isogloss/engine/runner.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

constexpr const char* dialect_file = "/fuzz/dialect.xml";
constexpr std::string_view program_of_dialect = "G21 G90 G54\nG0 X1. Y2. Z3.\nG1 X5. F100.\nG2 X6. Y3. I1.\nM30\n";

class DialectTarget : public Target {
 public:
  void run(std::string_view bytes) override {
    DiagnosticList said;
    workspace().reader().give(dialect_file, std::string(bytes));
    const std::unique_ptr<LinkedDialect> linked = workspace().link(dialect_file, {}, said);
    workspace().reader().forget(dialect_file);
    if (linked == nullptr) {
      if (!said.has_errors()) fail("a dialect that does not link is reported");
      return;
    }
    accept();
    RunOptions options;
    options.maximum_blocks = 100;
    const std::unique_ptr<Source> source = memory_source(program_of_dialect);
    DiagnosticList of_run;
    try {
      isogloss::run(*linked, *source, "program", options, {}, of_run);
    } catch (const std::runtime_error&) {  // a syntax refuses its options when it is created
      if (!of_run.has_errors()) fail("a run that does not start is reported");
    }
    for (const Diagnostic& d : of_run.all)
      if (d.code == "IG-0402") fail("no dialect makes a plugin break the contract: " + d.message);
  }
  std::vector<std::string> words() const override { return declared_names(); }
  std::vector<std::string> samples() const override {
    std::vector<std::string> out = texts_of_files("dialects", ".xml");
    for (std::string& text : texts_of_files("tests", ".dialect.xml")) out.push_back(std::move(text));
    return out;
  }
};

}  // namespace

std::unique_ptr<Target> make_dialect_target() { return std::make_unique<DialectTarget>(); }

}  // namespace isogloss::fuzz
