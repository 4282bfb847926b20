/// The call of a program by its name or path: TNC:\FOLDER\NAME.H.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <isogloss/flow.hpp>

#include "language/klartext_text.hpp"
#include "language/q_store.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// NAME of TNC:\FOLDER\NAME.H, in capitals.
inline std::string program_name(std::string_view path) {
  const std::size_t slash = path.find_last_of("\\/:");
  const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
  return in_capitals(file.substr(0, file.rfind('.')));
}

/// Calls the program after this block. Of a path only the name is used.
inline ig::Flow::Answer ask_program(ig::Block& b, const ig::Flow& flow, std::string_view path,
                                    CallTag tag = called_program) {
  const std::size_t slash = path.find_last_of("\\/:");
  const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::string name = program_name(path);
  const std::array<ig_text, 2> files{ig::to_text(file), ig::to_text(name)};
  return flow.call(b, {.program = name, .files = files, .tag = tag});
}

}  // namespace heidenhain
