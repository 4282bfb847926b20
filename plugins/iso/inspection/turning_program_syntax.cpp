/// Detects a lathe program: executed as milling, its diameters would be positions and its offsets tools. Before the
/// first block the text is searched for the signs of one; where they are found, one error reports it and nothing is
/// executed.
#include <isogloss/sdk.hpp>

#include "inspection/turning_signs.hpp"

#include <isogloss/flow.hpp>

namespace iso {
namespace {

struct TurningProgram {
  static constexpr auto spec =
      ig::syntax("TurningProgramSyntax", "Refuses the text of a turning program before its first block.");
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_ERROR, "ISO-0540",
          "{0} in line {1} belongs to a turning program, but this is a milling dialect: nothing is executed"),
  };

  ig::TextOption signs_{"signs", "",
                        "Words that only a turning program has: + joins words of one block, ? is any digit."};
  ig::TextOption tool_change_{
      "tool-change", "M06",
      "The code that changes tools on mills: in a text with this code, signs with ? are ignored."};
  ig::Flow flow_;

  ig::Status restart(ig::Block& b) const {
    if (flow_.is_indexing() || signs_.text().empty()) return ig::Status::unchanged;
    TurningSigns signs(signs_.text(), tool_change_.text(), mill_axis, most_of_it);
    std::array<char, 4096> buffer;
    for (std::uint64_t offset = 0; offset < most_bytes;) {
      const std::string_view piece = flow_.text(b, offset, buffer);
      if (piece.empty()) break;
      if (!signs.read(piece)) return ig::Status::unchanged;
      offset += piece.size();
    }
    const auto found = signs.result();
    if (!found) return ig::Status::unchanged;
    b.report(ig::diag("ISO-0540"), ig::Where::columns(found->begin, found->end), found->words,
             static_cast<std::int64_t>(found->line));
    b.flow(IG_FLOW_END_FILE);
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block&) const { return ig::Status::unchanged; }

 private:
  static constexpr std::uint64_t most_bytes = 256 * 1024;
  static constexpr char mill_axis = 'Y';         // which most lathes do not have
  static constexpr std::int64_t most_of_it = 2;  // as many words of it a turning program may hold
};

const ig::Register<TurningProgram> turning_program_syntax;

}  // namespace
}  // namespace iso
