#include "dialect/lint.hpp"

#include <stdexcept>

#include "dialect/declared_names.hpp"
#include "dialect/dropped_words.hpp"
#include "dialect/idle_rows.hpp"
#include "isogloss/engine/chain.hpp"

namespace isogloss::cli {

namespace {

/// False when a dependency or a syntax rejects what the dialect gives it; it reports the reason.
bool starts(const LinkedDialect& linked, DiagnosticSink& diagnostics, DiagnosticSink& notes) {
  try {
    const Chain chain(linked, {}, diagnostics);
    for (Diagnostic& d : idle_rows(linked, chain)) notes.add(std::move(d));
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Notes on a shipped dialect are not for those who set up a machine that stands on it.
class OwnNotes : public DiagnosticSink {
 public:
  OwnNotes(DiagnosticSink& sink, const Dialect& dialect) : sink_(sink), dialect_(dialect) {}
  void add(Diagnostic d) override {
    if (dialect_.is_machine && d.severity == Severity::note && !is_of_machine(d.where.file)) return;
    sink_.add(std::move(d));
  }

 private:
  bool is_of_machine(const std::string& file) const {
    const std::filesystem::path folder = dialect_.file.parent_path();
    return file.empty() || folder.empty() || file.starts_with((folder / "").string());
  }
  DiagnosticSink& sink_;
  const Dialect& dialect_;
};

}  // namespace

Linted lint_dialect(const std::string& name, Session& session, DiagnosticSink& sink) {
  Linted out;
  out.dialect = session.read(name, sink);
  if (!out.dialect) return out;
  OwnNotes notes(sink, *out.dialect);
  out.linked = link(*out.dialect, session.library(), notes);
  if (out.linked == nullptr) return out;
  for (Diagnostic& d : review(*out.linked)) notes.add(std::move(d));
  for (Diagnostic& d : dropped_words(*out.linked, session)) notes.add(std::move(d));
  for (Diagnostic& d : unanswered_names(*out.linked, session.library())) notes.add(std::move(d));
  out.starts = starts(*out.linked, sink, notes);
  return out;
}

}  // namespace isogloss::cli
