// Linking: find the parts, type the options, collect the fields, give them dense ids, check, make the wake masks. Each
// step stands in a file of its own; link_steps.hpp lists them.
#include "isogloss/engine/linker.hpp"

#include "isogloss/engine/machine.hpp"
#include "link/link_checks.hpp"
#include "link/link_steps.hpp"

namespace isogloss {

namespace {

void report_fault(Linking& linking, const LinkFault& fault) {
  Diagnostic d = host_diagnostic(fault.code, fault.where, {}, fault.hint);
  if (fault.code == "IG-0211") d.hint = providers(linking, fault.arguments[1]);
  if (fault.code == "IG-0208") d.hint = writers(linking, fault.arguments[1]);
  for (const DiagnosticInfo& info : host_diagnostics())
    if (info.code == fault.code) d.message = fill_in(info.text, fault.arguments);
  linking.add(std::move(d));
}

/// What can be said before the chain is complete, so that nobody has to mend one fault to hear of the next one.
void check_found(Linking& linking) {
  if (linking.mode != LinkMode::whole) return;
  for (const LinkFault& fault : check_places(linking.out)) report_fault(linking, fault);
}

void check(Linking& linking) {
  const bool is_whole = linking.mode == LinkMode::whole;
  for (const LinkFault& fault : is_whole ? check_links(linking.out) : check_services(linking.out))
    report_fault(linking, fault);
}

}  // namespace

void Linking::report(std::string_view code, const Location& where, std::initializer_list<std::string> arguments,
                     std::string hint) {
  add(host_diagnostic(code, where, arguments, std::move(hint)));
}

void Linking::add(Diagnostic d) {
  const auto severity = out.dialect.severities.find(d.code);
  if (severity != out.dialect.severities.end() && d.severity != Severity::error) d.severity = severity->second.severity;
  has_failed = has_failed || d.severity == Severity::error;
  sink.add(std::move(d));
}

std::string did_you_mean(const std::string& near) { return near.empty() ? near : "did you mean " + near + "?"; }

std::optional<std::uint32_t> LinkedDialect::position(std::string_view alias) const {
  for (std::uint32_t i = 0; i < chain.size(); ++i)
    if (chain[i].element.alias == alias) return i;
  return std::nullopt;
}

std::unique_ptr<LinkedDialect> link(Dialect dialect, Library& library, DiagnosticSink& sink, LinkMode mode) {
  auto out = std::make_unique<LinkedDialect>();
  out->dialect = std::move(dialect);
  if (is_incomplete(out->dialect) && !complete_machine(out->dialect, library, sink)) return nullptr;
  Linking linking{*out, library, sink, mode};
  find_parts(linking);
  FieldDrafts drafts(linking);
  drafts.collect();
  if (linking.has_failed) {
    check_found(linking);
    return nullptr;
  }
  const FieldIds ids = order_fields(linking, drafts);
  resolve_fields(linking, drafts, ids);
  set_initial_state(linking, drafts);
  check(linking);
  make_wake_masks(*out);
  find_look_ahead(*out);
  return linking.has_failed ? nullptr : std::move(out);
}

}  // namespace isogloss
