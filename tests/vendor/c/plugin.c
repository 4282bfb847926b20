/* The entry of the plugin: its name, by which dialects load it, its syntaxes, its table and its diagnostics. */
#include "acme.h"

static const ig_diagnostic_decl diagnostics[] = {
    [ACME_ON_AND_OFF] = {.struct_size = sizeof(ig_diagnostic_decl),
                         .severity = IG_WARNING,
                         .code = "ACME-0001",
                         .text = "M171 and M172 stand in one block: the last one counts",
                         .explanation = "The vacuum cannot be switched on and off at once.",
                         .example = "M171 M172"},
    [ACME_NO_CLAMP] = {.struct_size = sizeof(ig_diagnostic_decl),
                       .severity = IG_ERROR,
                       .code = "ACME-0002",
                       .text = "E{0}: there is no such clamp, so the previous force stays in force",
                       .explanation = "AcmeClampTable has no row of this number.",
                       .example = "E99"},
};

static const ig_syntax* const syntaxes[] = {&acme_clamp_syntax, &acme_vacuum_syntax};
static const ig_dependency* const dependencies[] = {&acme_clamp_table};

static const ig_plugin plugin = {
    .struct_size = sizeof(ig_plugin),
    .abi_major = IG_ABI_MAJOR,
    .abi_minor = IG_ABI_MINOR,
    .name = "acme",
    .version = "1.0.0",
    .vendor = "Acme Clamping",
    .built_with = "C",
    .syntaxes = syntaxes,
    .syntax_count = sizeof syntaxes / sizeof syntaxes[0],
    .dependencies = dependencies,
    .dependency_count = sizeof dependencies / sizeof dependencies[0],
    .diagnostics = diagnostics,
    .diagnostic_count = sizeof diagnostics / sizeof diagnostics[0],
};

const ig_plugin* ig_plugin_v1(void) { return &plugin; }
