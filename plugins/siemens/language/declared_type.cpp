// CHAR counts as a whole number, and the length of a STRING is not kept.
#include "language/declared_type.hpp"

#include <algorithm>

#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

std::optional<Type> type_at(std::string_view text, std::size_t& position) {
  const std::size_t end = skip_name(text, position);
  const std::string name = upper(piece(text, position, end));
  std::optional<Type> type;
  if (name == "REAL") type = Type::real;
  if (name == "INT" || name == "CHAR") type = Type::integer;
  if (name == "BOOL") type = Type::boolean;
  if (name == "STRING" || name == "AXIS") type = Type::text;
  if (!type) return type;
  position = skip_blanks(text, end);
  if (at(text, position) == '[') position = skip_blanks(text, std::min(text.find(']', position), text.size() - 1) + 1);
  return type;
}

}  // namespace siemens
