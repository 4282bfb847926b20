#include "run/explain_records.hpp"

#include <map>

namespace isogloss {

std::vector<ExplainedChange> changes_of(const Leaves& before, const Leaves& after) {
  std::vector<ExplainedChange> out;
  std::map<std::string_view, std::string_view> old(before.begin(), before.end());
  for (const auto& [path, value] : after) {
    const auto was = old.find(path);
    if (was == old.end())
      out.push_back({path, "", value});
    else if (was->second != value)
      out.push_back({path, std::string(was->second), value});
    if (was != old.end()) old.erase(was);
  }
  for (const auto& [path, value] : before)
    if (old.contains(path)) out.push_back({path, value, ""});
  return out;
}

ExplainedGo go_of(const FlowHost::Request& request) {
  ExplainedGo out;
  switch (request.kind) {
    case FlowHost::Request::Kind::none: return out;
    case FlowHost::Request::Kind::call: out.kind = ExplainedGo::Kind::call; break;
    case FlowHost::Request::Kind::leave: out.kind = ExplainedGo::Kind::leave; break;
    case FlowHost::Request::Kind::again: out.kind = ExplainedGo::Kind::again; break;
    case FlowHost::Request::Kind::jump: out.kind = ExplainedGo::Kind::jump; break;
  }
  out.program = request.program;
  out.to = {request.file, request.line, 1};
  out.is_behind = request.is_behind;
  out.call_line = request.call_line;
  out.pass = request.pass;
  out.passes = request.passes;
  return out;
}

std::vector<ExplainedFrame> frames_of(const FlowHost& flow) {
  std::vector<ExplainedFrame> out;
  ig_frame f{};
  f.struct_size = sizeof f;
  for (std::uint32_t level = 0; flow.frame(level, f); ++level)
    out.push_back({std::string(f.file.data, f.file.size), std::string(f.program.data, f.program.size), f.call_line,
                   f.pass, f.passes, f.id});
  return out;
}

}  // namespace isogloss
