/// Shows a page from a port of this machine that no other machine reaches.
#pragma once

#include "view/viewer.hpp"

namespace isogloss::cli::viewing {

/// Serves until a signal ends it; cannot_start, and reported, where the port is not free.
int serve(Viewer& viewer, std::uint16_t port, Session& session);

}  // namespace isogloss::cli::viewing
