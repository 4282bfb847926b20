// The host as a library: one dialect, one program held in memory, its motions as CSV on stdout.
#include <cstdio>
#include <filesystem>
#include <isogloss/engine/runner.hpp>

namespace {

class Stdout : public isogloss::Output {
 public:
  bool write(std::string_view bytes) override {
    return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size();
  }
};

int print(const isogloss::DiagnosticList& problems) {
  for (const auto& problem : problems.all) {
    std::fprintf(stderr, "%s:%u:%u: %s [%s]\n", problem.where.file.c_str(), problem.where.line, problem.where.column,
                 problem.message.c_str(), problem.code.c_str());
  }
  return problems.has_errors() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: embed PREFIX DIALECT\n", stderr);
    return 2;
  }
  const std::filesystem::path prefix = argv[1];
  constexpr std::string_view program =
      "G21 G90 G54 G17\n"
      "G0 X10. Y20. Z5.\n"
      "G1 Z-1. F600.\n"
      "G3 X20. Y30. I0. J10.\n"
      "M30\n";

  isogloss::DiagnosticList problems;
  isogloss::Library library({prefix / "lib/isogloss/plugins"});
  const isogloss::DialectReader dialects({prefix / "share/isogloss/dialects"});
  const auto dialect = dialects.read(argv[2], problems);
  const auto linked = dialect ? isogloss::link(*dialect, library, problems) : nullptr;
  if (!linked) return print(problems) | 1;

  Stdout output;
  const auto motions = isogloss::make_motion_exporter(output, {.format = isogloss::Format::csv});
  const auto source = isogloss::memory_source(program);
  isogloss::run(*linked, *source, "in memory", {}, {motions.get()}, problems);
  return print(problems);
}
