/// What the syntaxes of the language share: the variables, the place in the program, and what of the machine is known.
#pragma once

#include <array>
#include <string>

#include <isogloss/flow.hpp>

#include "scan_util.hpp"
#include "siemens_diagnostics.hpp"
#include "variable_store.hpp"

namespace siemens {

class Environment {
 public:
  ig::Flow flow;

  VariableStore& store() const { return const_cast<VariableStore&>(*store_.operator->()); }

  /// Before variables are read or written in a block.
  void enter(ig::Block& b) const { store().enter(flow.frame(b).id); }

  /// What a loop or a subprogram meets again at the same place of the text is said once for that place.
  template <class... Args>
  void report_once(ig::Block& b, std::uint32_t diagnostic, const ig::Where& where, std::size_t column,
                   const Args&... args) const {
    const ig_frame f = flow.frame(b);
    const ig_place here = flow.here(b);
    std::string place(ig::to_view(f.file));
    for (const std::uint64_t n : {std::uint64_t{diagnostic}, here.offset, std::uint64_t{here.line},
                                  static_cast<std::uint64_t>(column)})
      place.append(1, '\n').append(std::to_string(n));
    if (store().say_once(place)) b.report(diagnostic, where, args...);
  }

  /// $AA_IW[X], $AA_IM[X], $P_EP[X]: where the block before has ended.
  std::optional<double> position(const ig::Block& b, std::string_view variable, char axis) const {
    const std::size_t at = std::string_view("XYZABC").find(axis);
    if (at == std::string_view::npos) return std::nullopt;
    const bool of_machine = variable == "$AA_IM" || variable == "$AA_MW";
    if (!of_machine && variable != "$AA_IW" && variable != "$P_EP" && variable != "$AA_WCS") return std::nullopt;
    return b.get(of_machine || at > 2 ? machine_[at] : program_[at]);
  }
  std::optional<double> known(const ig::Block& b, std::string_view variable) const {
    if (variable == "$P_TOOLNO" || variable == "$TC_MPP6")
      if (const auto tool = b.get(tool_)) return static_cast<double>(*tool);
    if (variable == "$P_F" || variable == "$AC_F") return b.get(feed_);
    if (variable == "$P_S") return b.get(speed_);
    // The program runs at the machine from its beginning: no block search, no simulation, no test.
    for (const std::string_view off : {"$P_SEARCH", "$P_SIM", "$P_ISTEST", "$P_DRYRUN"})
      if (variable == off) return 0;
    return std::nullopt;
  }

 private:
  ig::Service<VariableStore> store_{variable_service, ig::Need::required, "The variables."};
  std::array<ig::In<double>, 6> machine_{ig::In<double>{"MachineCoordinate.X"}, ig::In<double>{"MachineCoordinate.Y"},
                                         ig::In<double>{"MachineCoordinate.Z"}, ig::In<double>{"MachineCoordinate.A"},
                                         ig::In<double>{"MachineCoordinate.B"}, ig::In<double>{"MachineCoordinate.C"}};
  std::array<ig::In<double>, 3> program_{ig::In<double>{"ProgramXyz.X"}, ig::In<double>{"ProgramXyz.Y"},
                                         ig::In<double>{"ProgramXyz.Z"}};
  ig::In<std::int64_t> tool_{"ToolChange.SpindleToolId"};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
};

constexpr bool is_name_start(char c) { return iso::is_letter(c) || c == '_'; }
constexpr bool is_name_part(char c) { return iso::is_letter(c) || iso::is_digit(c) || c == '_'; }
constexpr std::size_t skip_name(std::string_view text, std::size_t position) {
  return iso::skip_while(text, position, is_name_part);
}
inline std::string upper(std::string_view name) {
  std::string out(name);
  for (char& c : out) c = iso::to_upper(c);
  return out;
}

/// Where the statement ends: at a comment, which a string may look like, or at the end of the block.
constexpr std::size_t statement_end(std::string_view text, std::size_t position) {
  bool quoted = false;
  for (; position < text.size() && text[position] != '\r' && text[position] != '\n'; ++position) {
    if (text[position] == '"') quoted = !quoted;
    if (text[position] == ';' && !quoted) break;
  }
  return position;
}
/// Without the blanks before it.
constexpr std::size_t statement_text_end(std::string_view text, std::size_t position) {
  std::size_t end = statement_end(text, position);
  while (end > position && iso::is_blank(text[end - 1])) --end;
  return end;
}

/// Past the round bracket that closes the one at `position`; strings may hold brackets. The end of the statement where
/// none does.
constexpr std::size_t skip_call(std::string_view text, std::size_t position) {
  std::size_t depth = 0;
  bool quoted = false;
  for (; position < text.size() && text[position] != '\r' && text[position] != '\n'; ++position) {
    const char c = text[position];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ';') return position;
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) return position + 1;
  }
  return position;
}

}  // namespace siemens
