#include "language/declared_value.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

/// Where the bare name of an axis ends, X of AX=X; 0 where something else stands there.
std::size_t axis_name_end(const Environment& environment, std::string_view text, std::size_t position) {
  constexpr std::size_t longest_name = 3;
  const std::size_t end = skip_name(text, position);
  const char behind = at(text, skip_blanks(text, end));
  const std::string axis = upper(piece(text, position, end));
  if (!is_name_start(at(text, position)) || behind == '(' || behind == '[' || behind == '<') return 0;
  if (axis.size() > longest_name && !environment.axes.find(axis)) return 0;
  return environment.store().find(axis) == nullptr ? end : 0;
}

}  // namespace

std::optional<Value> value_of(ig::Block& b, const Environment& environment, std::string_view text,
                              std::size_t& position, const Declared& type) {
  position = skip_blanks(text, position);
  if (type.type == Type::frame) {
    const std::size_t begin = position, last = statement_text_end(text, position);
    FrameExpression e(b, environment, text, position);
    const auto frame = e.value();
    position = frame ? e.position() : last;
    if (frame) return Value::frame(frame->text());
    b.report(ig::diag("SIE-0365"), ig::Where::columns(begin, std::max(last, begin + 1)), piece(text, begin, last));
    return std::nullopt;
  }
  const bool is_axis = type.detail == Declared::Detail::axis;
  if (const std::size_t end = is_axis ? axis_name_end(environment, text, position) : 0; end != 0) {
    const std::string name = upper(piece(text, position, end));
    position = end;
    return Value::string(name);
  }
  Expression e(b, environment, text, position);
  auto v = e.value();
  position = std::max(e.position(), position);
  if (v && is_axis) v->text = upper(v->text);
  return v;
}

}  // namespace siemens
