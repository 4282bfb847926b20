// Diagnostics that several syntaxes of the plugin raise, or a header of theirs: they belong to no single page.
#include <isogloss/sdk.hpp>

namespace syntec {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_ERROR, "SYN-0003", "{0} is not executed: {1}",
                   "The control has this function; this dialect only recognises it. The words of the function are "
                   "removed with it, so that they do not act as a move.",
                   "G134 X0. Y0. I20. J0. K6"),
};

}  // namespace
}  // namespace syntec
