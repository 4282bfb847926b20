/// Parts of an explained block, from what the chain and the flow of the run show.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "contract/flow_host.hpp"
#include "isogloss/engine/explain.hpp"

namespace isogloss {

/// The values of a document: path, and JSON text.
using Leaves = std::vector<std::pair<std::string, std::string>>;

std::vector<ExplainedChange> changes_of(const Leaves& before, const Leaves& after);
ExplainedGo go_of(const FlowHost::Request& request);
std::vector<ExplainedFrame> frames_of(const FlowHost& flow);

}  // namespace isogloss
