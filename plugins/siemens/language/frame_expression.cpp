// Frames that programs compute. The links and frames are chained from left to right.
#include "language/frame_expression.hpp"

namespace siemens {

using namespace ig::cnc;

bool FrameExpression::begins(std::string_view text, std::size_t position) {
  const std::size_t end = skip_name(text, position);
  return frame_link(upper(ig::cnc::piece(text, position, end))) &&
         ig::cnc::at(text, ig::cnc::skip_blanks(text, end)) == '(';
}

std::optional<FrameValue> FrameExpression::value() {
  FrameValue out;
  for (bool is_first = true;; is_first = false) {
    const auto next = element();
    const auto both = next && !is_first ? chained(out, *next) : next;
    if (!both) return std::nullopt;
    out = *both;
    const std::size_t colon = ig::cnc::skip_blanks(text_, at_);
    if (ig::cnc::at(text_, colon) != ':') return out;
    at_ = colon + 1;
  }
}

std::optional<FrameValue> FrameExpression::element() {
  at_ = ig::cnc::skip_blanks(text_, at_);
  if (begins(text_, at_)) {
    const std::size_t end = skip_name(text_, at_);
    const FrameLink kind = *frame_link(upper(ig::cnc::piece(text_, at_, end)));
    at_ = ig::cnc::skip_blanks(text_, end);
    return link(kind);
  }
  if (!is_name_start(ig::cnc::at(text_, at_)) && ig::cnc::at(text_, at_) != '$') return std::nullopt;
  Expression e(b_, environment_, text_, at_);
  const auto reference = e.reference();
  if (!reference) return std::nullopt;
  at_ = e.position();
  if (reference->name[0] == '$') return environment_.system.frame(b_, reference->name);
  environment_.enter(b_);
  VariableStore& store = environment_.store();
  const Variable* const v = store.find(reference->name) ? store.find(reference->name) : store.array_of(reference->name);
  return v != nullptr && v->value.type == Type::frame ? FrameValue::read(v->value.text) : std::nullopt;
}

std::optional<FrameValue> FrameExpression::link(FrameLink kind) {
  FrameValue out;
  at_ = ig::cnc::skip_blanks(text_, at_ + 1);
  while (ig::cnc::at(text_, at_) != ')') {
    const std::size_t on = axis();
    double number = 1;
    if (on == std::string_view::npos) return std::nullopt;
    if (kind != FrameLink::mirror) {
      if (ig::cnc::at(text_, at_) != ',') return std::nullopt;
      Expression e(b_, environment_, text_, ig::cnc::skip_blanks(text_, at_ + 1));
      const auto value = e.number();
      if (!value) return std::nullopt;
      number = *value;
      at_ = ig::cnc::skip_blanks(text_, e.position());
    }
    if (!out.set(kind, on, number)) return std::nullopt;
    const char behind = ig::cnc::at(text_, at_);
    if (behind != ',' && behind != ')') return std::nullopt;
    if (behind == ',') at_ = ig::cnc::skip_blanks(text_, at_ + 1);
    if (behind == ',' && ig::cnc::at(text_, at_) == ')') return std::nullopt;
  }
  ++at_;
  return out;
}

std::size_t FrameExpression::axis() {
  const std::size_t end = skip_name(text_, at_);
  std::string name = upper(ig::cnc::piece(text_, at_, end));
  if (const Variable* const v = name.size() > 1 ? environment_.store().find(name) : nullptr;
      v != nullptr && v->value.type == Type::text)
    name = v->value.text;
  at_ = ig::cnc::skip_blanks(text_, end);
  const auto axis = environment_.axes.find(name);
  return axis && *axis < axis_letters.size() ? *axis : std::string_view::npos;
}

}  // namespace siemens
