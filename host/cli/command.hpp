/// The subcommands: one file each, found by name; nothing of the others is set up when one runs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isogloss::cli {

/// Exit statuses; the highest of several counts.
enum Exit : int { success = 0, input_errors = 1, cannot_start = 2, internal_fault = 3 };

struct Usage;

/// What follows the subcommand's name.
struct Arguments : std::vector<std::string> {
  using std::vector<std::string>::vector;
  /// Where the command describes what it accepts, instead of doing anything; mostly null.
  Usage* describe = nullptr;
};

int apply_command(const Arguments& arguments);
int batch_command(const Arguments& arguments);
int case_command(const Arguments& arguments);
int complete_command(const Arguments& arguments);
int dap_command(const Arguments& arguments);
int dialect_command(const Arguments& arguments);
int diff_command(const Arguments& arguments);
int docs_command(const Arguments& arguments);
int doctor_command(const Arguments& arguments);
int export_command(const Arguments& arguments);
int explain_command(const Arguments& arguments);
int import_command(const Arguments& arguments);
int inspect_command(const Arguments& arguments);
int lint_command(const Arguments& arguments);
int list_command(const Arguments& arguments);
int lsp_command(const Arguments& arguments);
int manual_command(const Arguments& arguments);
int motions_command(const Arguments& arguments);
int new_command(const Arguments& arguments);
int plot_command(const Arguments& arguments);
int run_command(const Arguments& arguments);
int schema_command(const Arguments& arguments);
int state_command(const Arguments& arguments);
int validate_command(const Arguments& arguments);
int version_command(const Arguments& arguments);
int view_command(const Arguments& arguments);

struct Command {
  std::string_view name;
  std::string_view summary;
  int (*run)(const Arguments&);
  bool is_hidden = false;  ///< --help does not list it
};

inline constexpr Command commands[] = {
    {"run", "run programs through a dialect: motions, blocks, a summary", run_command},
    {"explain", "explain why a block did what it did, or a diagnostic", explain_command},
    {"state", "show what is in force at a line, or write blocks that restore it", state_command},
    {"batch", "run many programs on all cores or a cluster, with one result for each", batch_command},
    {"diff", "show where two dialects, machines or programs part, and why", diff_command},
    {"motions", "read a binary motion stream and write it as text", motions_command},
    {"plot", "draw the path of a program as a picture", plot_command},
    {"view", "show the path of a program in a page, in 3D, beside its text", view_command},
    {"lint", "check dialect files", lint_command},
    {"dialect", "a dialect as one file or a graph, one syntax of it, its differences from another", dialect_command},
    {"lsp", "serve editors: diagnostics, hover, completion and more for programs and dialects", lsp_command},
    {"schema", "print schemas: of files of dialects, blocks, motions and other JSON", schema_command},
    {"list", "list plugins, dialects, machines, importers, codes, diagnostics and more", list_command},
    {"inspect", "show the page and declaration of one of them", inspect_command},
    {"dap", "debug part programs from an editor (Debug Adapter Protocol)", dap_command},
    {"docs", "write the reference of all plugins and dialects as linked pages", docs_command},
    {"new", "make the folder of a plugin, a dialect or a machine", new_command},
    {"import", "read files of controls as tables of a machine", import_command},
    {"export", "write tables of a machine as a file of its control", export_command},
    {"doctor", "report what was found where, and what was not loaded and why", doctor_command},
    {"apply", "run one syntax on one block", apply_command},
    {"case", "run the cases of documentation pages", case_command},
    {"validate", "test whether plugins keep the contract", validate_command},
    {"manual", "print manual pages", manual_command, true},
    {"complete", "print what a shell may complete", complete_command, true},
};

/// Everything after the program's name. Exceptions are internal faults.
int run_main(Arguments arguments);

}  // namespace isogloss::cli
