// A syntax that sleeps through every program. instructions.py puts many of them into a chain.
#include <isogloss/sdk.hpp>

namespace {

struct Idle {
  static constexpr auto spec = ig::syntax("IdleSyntax", "Wakes on G9999, which no program holds.");

  ig::Codes code_{{"G9999"}, ig::wake};

  ig::Status build(ig::Block&) { return ig::Status::unchanged; }
};

const ig::Register<Idle> idle_syntax;

}  // namespace

const char* ig::embedded_page(const char*) noexcept { return nullptr; }
const char* ig::embedded_folder(const char*) noexcept { return nullptr; }
const ig::EmbeddedDiagnostic* ig::embedded_diagnostic(const char*) noexcept { return nullptr; }

ISOGLOSS_PLUGIN("idle", "1.0.0", "Isogloss")
