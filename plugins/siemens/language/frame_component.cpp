#include "language/frame_component.hpp"

namespace siemens {

std::optional<FrameComponent> FrameComponent::of(VariableStore& store, const std::string& name) {
  const std::size_t open = name.find('['), last = name.rfind(',');
  if (open == std::string::npos || last == std::string::npos || name.back() != ']') return std::nullopt;
  const std::size_t before = name.rfind(',', last - 1);
  const bool is_element = before != std::string::npos && before > open;
  const std::size_t begin = is_element ? before + 1 : open + 1;
  const auto link = frame_component_link(std::string_view(name).substr(last + 1, name.size() - last - 2));
  const std::size_t axis = last == begin + 1 ? std::string_view("XYZABC").find(name[begin]) : std::string_view::npos;
  if (!link || axis == std::string_view::npos) return std::nullopt;
  std::string variable = is_element ? name.substr(0, before) + ']' : name.substr(0, open);
  const Variable* v = store.find(variable);
  if (v == nullptr && is_element) v = store.array_of(variable);
  if (v == nullptr || v->value.type != Type::frame || (v->is_array && !is_element)) return std::nullopt;
  auto frame = FrameValue::read(v->value.text);
  return frame ? std::optional(FrameComponent{std::move(variable), *link, axis, *frame}) : std::nullopt;
}

std::optional<std::string> FrameComponent::changed(double value) const {
  FrameValue out = frame;
  if (link == FrameLink::fine && axis > 2) return std::nullopt;
  return out.set(link, axis, value) ? std::optional(out.text()) : std::nullopt;
}

}  // namespace siemens
