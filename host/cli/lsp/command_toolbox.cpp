#include "lsp/command_toolbox.hpp"

#include "catalogue.hpp"
#include "dialect/lint.hpp"
#include "dialect_guess.hpp"
#include "explain/block_text.hpp"
#include "explain/explain_target.hpp"
#include "program_options.hpp"

namespace isogloss::cli {

namespace {

ProgramOptions options_of(const editors::Settings& settings) {
  ProgramOptions out;
  out.dialect = settings.dialect;
  out.machine = settings.machine;
  out.offsets = settings.offsets;
  out.tools = settings.tools;
  out.variables = settings.variables;
  out.set = settings.set;
  out.block_skip = settings.block_skip;
  out.optional_stop = settings.optional_stop;
  out.program = settings.program;
  out.subprograms = settings.subprograms;
  return out;
}

}  // namespace

std::shared_ptr<const editors::Setup> CommandToolbox::setup(const std::string& path, std::string_view text,
                                                            const editors::Settings& settings, DiagnosticSink& sink) {
  if (!linked_for_ || *linked_for_ != settings) forget_dialects();
  linked_for_ = settings;
  ProgramOptions program = options_of(settings);
  std::optional<RunOptions> options = program.make(session_);
  if (!options) {
    sink.add(host_diagnostic("IG-0660", {path, 1, 1}, {"a setting is wrong; the log of the server names it"}));
    return nullptr;
  }
  auto out = std::make_shared<editors::Setup>();
  std::string dialect = program.dialect;
  if (dialect.empty()) {
    const std::optional<Guess> guess = guess_dialect(path, text.substr(0, guessed_head_bytes), session_);
    if (!guess) {
      sink.add(host_diagnostic("IG-0512", {path, 1, 1}, {}));
      return nullptr;
    }
    dialect = guess->dialect;
    out->why = guess->why;
  }
  out->linked = link(dialect, *options, sink);
  if (out->linked == nullptr) return nullptr;
  out->dialect = out->linked->dialect.name;
  if (path.starts_with('/')) add_program_places(path, out->linked->dialect, *options);
  out->options = std::move(*options);
  return out;
}

std::shared_ptr<const LinkedDialect> CommandToolbox::link(const std::string& dialect, const RunOptions& options,
                                                          DiagnosticSink& sink) {
  const auto found = linked_.find(dialect);
  if (found != linked_.end()) return found->second;
  std::shared_ptr<const LinkedDialect> linked = session_.link(dialect, options.chain.dependencies, sink);
  if (linked != nullptr) linked_[dialect] = linked;
  return linked;
}

void CommandToolbox::forget_dialects() {
  linked_.clear();
  codes_.clear();
}

std::string CommandToolbox::sentence(const ExplainedBlock& block, const std::string& path, const std::string& text) {
  LineTexts lines;
  lines.give(path, text);
  return text_of(block, Amount::sentence, lines);
}

std::string CommandToolbox::why_no_block(const ExplainReach& reach, const ExplainTarget& target,
                                         const std::string& path) {
  return cli::why_no_block(reach, target, path);
}

std::vector<editors::CodeInfo> CommandToolbox::codes(const LinkedDialect& linked) {
  const auto found = codes_.find(&linked);
  if (found != codes_.end()) return found->second;
  std::vector<editors::CodeInfo> out;
  for (const Json& row : describe_codes(linked)) {
    editors::CodeInfo info{row["Code"], row["Kind"] == "code", row["Syntax"], row.value("Unit", std::string()), {}};
    if (row.contains("Words")) info.words = row["Words"].get<std::vector<std::string>>();
    out.push_back(std::move(info));
  }
  return codes_[&linked] = std::move(out);
}

const DiagnosticInfo* CommandToolbox::diagnostic(const std::string& code) {
  const auto find = [&]() -> const DiagnosticInfo* {
    const auto found = diagnostics_.find(code);
    return found == diagnostics_.end() ? nullptr : &found->second;
  };
  if (const DiagnosticInfo* const known = find()) return known;
  for (KnownCode& known : known_codes(session_.library()))
    diagnostics_.insert_or_assign(std::string(known.info.code), known.info);
  return find();
}

std::vector<Diagnostic> CommandToolbox::lint(const std::string& path, const std::string& text) {
  DiagnosticList list;
  session_.reader().give(path, text);
  lint_dialect(path, session_, list);
  session_.reader().forget(path);
  return std::move(list.all);
}

const Library& CommandToolbox::library() {
  session_.library().load_all();
  return session_.library();
}

}  // namespace isogloss::cli
