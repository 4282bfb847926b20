#include "run/frame_history.hpp"

#include <algorithm>
#include <cmath>

namespace isogloss {

namespace {

constexpr std::string_view section_of_transforms = "ProgramToMcTransform.";
constexpr std::size_t most_parts = 100;

bool is_near(const Frame& a, const Frame& b) {
  for (std::size_t i = 0; i < 16; ++i)
    if (std::abs(a.matrix[i] - b.matrix[i]) > 1e-9 * std::max(1.0, std::abs(b.matrix[i]))) return false;
  return true;
}

}  // namespace

FrameHistory::FrameHistory(const Layout& layout) {
  for (const ig_field f : layout.transforms) {
    const std::string name = layout.fields[f].path.substr(section_of_transforms.size());
    // Without the switch no transform of the section has parts.
    if (const ig_field adds = layout.id(name + ".~Adds"); adds != IG_NO_FIELD)
      sections_.push_back({f, adds, name, {}, {}});
  }
}

void FrameHistory::look(const Document& document, const Label& label) {
  for (Section& section : sections_) {
    const Frame now = document.present(section.transform) ? document.frame(section.transform) : Frame();
    if (is_near(now, section.frame)) continue;
    Part part{now, label(section.name), {std::string(document.source.file), document.source.line}};
    const std::optional<Frame> back =
        document.fresh(section.adds) && section.parts.size() < most_parts ? section.frame.inverse() : std::nullopt;
    if (back) {
      part.frame = now * *back;
      section.parts.insert(section.parts.begin(), std::move(part));
    } else {
      section.parts.clear();
      if (now.kind != Frame::Kind::identity) section.parts.push_back(std::move(part));
    }
    section.frame = now;
  }
}

const std::vector<FrameHistory::Part>& FrameHistory::parts(ig_field transform) const {
  static const std::vector<Part> none;
  for (const Section& section : sections_)
    if (section.transform == transform) return section.parts;
  return none;
}

}  // namespace isogloss
