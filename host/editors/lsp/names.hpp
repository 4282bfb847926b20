/// Names of a program's text: variables, labels and programs, and where each stands.
#pragma once

#include <optional>

#include "lsp/open_program.hpp"

namespace isogloss::editors {

/// Bytes of the document.
struct Span {
  std::size_t begin = 0, end = 0;
  bool operator==(const Span&) const = default;
};

struct NameAt {
  enum class Kind : std::uint8_t { variable, label } kind = Kind::variable;
  std::string name;                   ///< of a variable as the program writes it, of a label in the form of NamedPlace
  Span span;                          ///< what a new name replaces
  const NamedPlace* place = nullptr;  ///< of a label
};

/// The places of a name in the text: those of a label without `declaration` are references to it.
struct Occurrence {
  Span span;
  bool declares = false;  ///< the label itself; of a variable: a line that writes it
};

std::optional<NameAt> name_at(OpenProgram& program, std::size_t offset);
std::vector<Occurrence> occurrences(OpenProgram& program, const NameAt& name);

/// The part of a label's text that references repeat: "5" of LBL 5, "10" of N10, "START" of START:
Span core_of(const TextDocument& text, const NamedPlace& place);

}  // namespace isogloss::editors
