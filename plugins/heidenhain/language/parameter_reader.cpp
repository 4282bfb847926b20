#include "language/parameter_reader.hpp"

#include "language/block_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

std::optional<ParameterReader::Target> ParameterReader::target(std::size_t position) const {
  std::size_t end = position;
  const auto q = Values::q_at(text, position, end);
  if (!q) {
    if (is_string_parameter(text, position))
      refuse_text();
    else
      missing("the Q parameter");
    return std::nullopt;
  }
  const std::size_t equals = skip(text, end);
  if (at(text, equals) != '=') {
    missing("=");
    return std::nullopt;
  }
  return Target{*q, piece(text, position, end), position, equals + 1};
}

std::optional<double> ParameterReader::value(std::size_t& position) const {
  position = skip(text, position);
  const Value v = values.read(block, text, position);
  if (v.ok) {
    position = v.end;
    return v.number;
  }
  const std::size_t end = skip_while(text, position, [](char c) { return !is_space(c); });
  if (position >= text.size())
    missing("a value");
  else
    block.report(ig::diag("HEI-0110"), ig::Where::columns(position, end), piece(text, position, end));
  return std::nullopt;
}

bool ParameterReader::ends(std::size_t position) const {
  const std::size_t next = skip(text, position);
  if (next >= text.size()) return true;
  block.report(ig::diag("HEI-0110"), where_of_line(text, next), rest_of_line(text, next));
  return false;
}

}  // namespace heidenhain
