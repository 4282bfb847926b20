// The ranges of INT and CHAR come from the manual Job planning, "Definition of user variables (DEF)".
#include "language/declared_type.hpp"

#include <algorithm>
#include <charconv>

#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

std::optional<Declared> type_at(std::string_view text, std::size_t& position) {
  const std::size_t end = skip_name(text, position);
  const std::string name = upper(piece(text, position, end));
  Declared out;
  if (name == "INT") {
    out.type = Type::integer;
    out.lowest = -2147483648.0, out.highest = 2147483647.0;
  } else if (name == "CHAR") {
    out.type = Type::integer;
    out.detail = Declared::Detail::character;
    out.lowest = 0, out.highest = 255;
  } else if (name == "BOOL") {
    out.type = Type::boolean;
  } else if (name == "STRING" || name == "AXIS") {
    out.type = Type::text;
    if (name == "AXIS") out.detail = Declared::Detail::axis;
  } else if (name == "FRAME") {
    out.type = Type::frame;
  } else if (name != "REAL") {
    return std::nullopt;
  }
  position = skip_blanks(text, end);
  if (name != "STRING" || at(text, position) != '[') return out;
  const std::size_t close = std::min(text.find(']', position), text.size());
  const std::string_view digits = trim(piece(text, position + 1, close));
  const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out.length);
  const bool is_length = error == std::errc{} && last == digits.data() + digits.size() && out.length >= 1;
  if (!is_length || out.length > longest_string || close == text.size()) return std::nullopt;
  position = skip_blanks(text, close + 1);
  return out;
}

std::string type_text(const Declared& type) {
  switch (type.type) {
    case Type::real: return "REAL";
    case Type::integer: return type.detail == Declared::Detail::character ? "CHAR" : "INT";
    case Type::boolean: return "BOOL";
    case Type::frame: return "FRAME";
    case Type::text: break;
  }
  if (type.detail == Declared::Detail::axis) return "AXIS";
  return type.length > 0 ? "STRING[" + std::to_string(type.length) + "]" : "STRING";
}

}  // namespace siemens
