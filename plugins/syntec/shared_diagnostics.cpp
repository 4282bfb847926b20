// Diagnostics that several syntaxes of the plugin raise, or a header that they share: they belong to no page.
#include <isogloss/sdk.hpp>

namespace syntec {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "SYN-0003", "{0} is not executed: {1}",
                   "The control has this function, but it is recognised here only. The words that belong to it go with "
                   "it, so that they are not taken for a move.",
                   "G134 X0. Y0. I20. J0. K6"),
};

}  // namespace
}  // namespace syntec
