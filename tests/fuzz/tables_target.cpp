// Tables of the user in XML: refused with a diagnostic, or a program runs with them.
#include "isogloss/engine/runner.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

constexpr const char* tables_file = "/fuzz/tables.xml";
constexpr std::string_view program_with_tables =
    "G21 G90 G54\nT1 M6\nG43 H1 Z50.\nG55 G0 X1. Y2.\nG41 D1 G1 X5. F100.\nY9.\nG40 X0\n#100=#5221\nG10 L2 P1 "
    "X1.\nM30\n";

class TablesTarget : public Target {
 public:
  void run(std::string_view bytes) override {
    DiagnosticList said;
    workspace().reader().give(tables_file, std::string(bytes));
    const std::vector<DependencyElement> tables = workspace().reader().read_dependencies(tables_file, said);
    workspace().reader().forget(tables_file);
    const std::unique_ptr<LinkedDialect> linked = workspace().link("fanuc", tables, said);
    if (linked == nullptr) {
      if (!said.has_errors()) fail("tables that do not link are reported");
      return;
    }
    if (!tables.empty()) accept();
    RunOptions options;
    options.maximum_blocks = 100;
    options.chain.dependencies = tables;
    const std::unique_ptr<Source> source = memory_source(program_with_tables);
    DiagnosticList of_run;
    try {
      isogloss::run(*linked, *source, "program", options, {}, of_run);
    } catch (const std::runtime_error&) {  // a table refuses a row
      if (!of_run.has_errors()) fail("a run that does not start is reported");
    }
    expect_no_internal_fault(of_run.all);
  }
  std::vector<std::string> words() const override { return declared_names(); }
  std::vector<std::string> samples() const override { return texts_of_files("tests/programs", ".xml"); }
};

}  // namespace

std::unique_ptr<Target> make_tables_target() { return std::make_unique<TablesTarget>(); }

}  // namespace isogloss::fuzz
