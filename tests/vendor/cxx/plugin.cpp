// The plugin of ../c as a vendor wrote it with the first SDK.
#include <isogloss/sdk.hpp>

namespace {
constexpr std::array<ig_diagnostic_decl, 2> diagnostics{
    ig::diagnostic(IG_WARNING, "ACME-0001", "M171 and M172 stand in one block: the last one counts",
                   "The vacuum cannot be switched on and off at once.", "M171 M172"),
    ig::diagnostic(IG_ERROR, "ACME-0002", "E{0}: there is no such clamp, so the previous force stays in force",
                   "AcmeClampTable has no row of this number.", "E99")};
}  // namespace

ISOGLOSS_PLUGIN("acme", "1.0.0", "Acme Clamping", diagnostics)
