/// `isogloss explain PROGRAM --field NAME`: each change of a field with its line, its value and who set it.
#pragma once

#include "explain/explain_target.hpp"
#include "isogloss/engine/follow.hpp"
#include "session.hpp"

namespace isogloss::cli {

struct FollowRequest {
  std::string field;  ///< a field or a section, as the user writes it
  std::string in;     ///< the file of a called program; empty: all files
  NamedLines lines;
  bool json = false;
};

int follow_field(const FollowRequest& request, const LinkedDialect& linked, Source& source, const RunOptions& options,
                 Session& session);

}  // namespace isogloss::cli
