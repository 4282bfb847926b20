/// What plugins declare, as JSON: list and inspect print it, or a text made from it.
#pragma once

#include <nlohmann/json.hpp>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/linker.hpp"
#include "isogloss/engine/machine.hpp"
#include "isogloss/engine/needs.hpp"
#include "known_codes.hpp"

namespace isogloss::cli {

using Json = nlohmann::ordered_json;

Json describe(const LoadedPlugin& loaded);
Json describe(const KnownCode& known);
Json describe(const ig_syntax& syntax, const ig_plugin& plugin);
Json describe(const ig_dependency& dependency, const ig_plugin& plugin);
Json describe(const ig_importer& importer, const ig_plugin& plugin);
Json describe(const Dialect& dialect);
Json describe(const FoundMachine& machine);
/// What the machine has, by table and file; and what it lacks: services that its dialect asks for and no table answers.
Json describe_machine(const LinkedDialect& linked, const Library& library);
/// Which of a program's needs a machine answers, by row of a table and by program; and what it does not: the errors and
/// warnings of its run. Files in the machine's folder are named from there.
Json describe_needs(const std::string& program, const Dialect& machine, const ProgramNeeds& needs,
                    const std::vector<Diagnostic>& diagnostics);
/// Which dependency answers for each service, and which others offer it.
Json describe_services(const LinkedDialect& linked);
/// Every field that the standard sections or a syntax declare, by path, with who reads, writes and takes it.
Json describe_fields(const Library& library);
/// Each code and word of a dialect with each syntax that acts on it, in the order of the chain: plugin and page of the
/// syntax, the code's own words.
Json describe_codes(const LinkedDialect& linked);
/// The order of codes in a list: G2 before G10, G54.1 before G54.2.
struct ByNumber {
  bool operator()(const std::string& a, const std::string& b) const;
};
/// What a dialect makes of a syntax: its option values and the fields that its patterns stand for.
Json describe_link(const LinkedSyntax& syntax, const Layout& layout);

std::string_view type_name(ig_type type);

}  // namespace isogloss::cli
