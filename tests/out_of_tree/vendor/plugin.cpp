#include <isogloss/sdk.hpp>

namespace {
constexpr std::array<ig_diagnostic_decl, 1> diagnostics{
    ig::diagnostic(IG_WARNING, "ACME-0001", "M171 and M172 stand in one block; the last one counts.",
                   "The vacuum cannot be switched on and off at once.", "M171 M172")};
}  // namespace

ISOGLOSS_PLUGIN("acme", "1.0.0", "Acme Clamping", diagnostics)
