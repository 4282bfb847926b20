/// Memory for the start of a command.
#pragma once

namespace isogloss::cli {

/// A start takes two megabytes in small parts. The kernel gives them in one piece here: page by page, as each is
/// touched, is an eighth of the time of a start.
void prepare_heap();

}  // namespace isogloss::cli
