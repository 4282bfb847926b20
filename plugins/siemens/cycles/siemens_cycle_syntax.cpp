/// MCALL: a drilling cycle after each block that moves. The call is kept and raised again in each block that programs
/// an axis or a pattern of holes; MCALL alone ends it. A call without MCALL is executed by the cycles themselves, at
/// the position of the tool.
#include <isogloss/sdk.hpp>

#include "cycles/hole_pattern.hpp"

namespace siemens {
namespace {

struct SiemensCycle {
  static constexpr auto spec =
      ig::syntax("SiemensCycleSyntax", "MCALL: the cycle that runs after each block that moves.")
          .after("SiemensUnitSyntax", "SiemensPositionSyntax")
          .before("SiemensDrillingCycleSyntax", "SiemensDeepHoleCycleSyntax", "SiemensReamingCycleSyntax",
                  "SiemensBoringCycleSyntax", "SiemensTappingCycleSyntax", "ProgramXyzSyntax");

  std::vector<CycleFields> cycles_ = all_cycles();
  ig::Codes modal_{"MCALL"};
  ig::InWhile<ig::Symbol> term_{"CannedCycle.Term", nullptr, ig::write};
  std::vector<std::vector<ig::Field<double>>> kept_ = all_kept();
  ig::Xyz words_{"Parsing", ig::read};
  std::array<ig::Word, 3> angles_{ig::Word{"Parsing.A", ig::read, "deg"}, ig::Word{"Parsing.B", ig::read, "deg"},
                                  ig::Word{"Parsing.C", ig::read, "deg"}};
  HolePattern pattern_{ig::take | ig::wake};
  ig::Signal subprogram_{"ModalCall.~InForce", ig::read, ig::Life::modal};

  ig::Status build(ig::Block& b) {
    const bool is_modal = b.take(modal_).has_value();
    const bool has_pattern = pattern_.stands_in(b);
    const bool is_called = has_pattern && !is_modal && b.is_raised(subprogram_);
    if (has_pattern && !is_called && (is_modal || !b.has(term_))) pattern_.refuse(b);
    if (!is_modal)
      return (b.has(term_) && repeat(b, has_pattern)) || has_pattern ? ig::Status::changed : ig::Status::unchanged;
    forget(b);
    for (std::size_t i = 0; i < cycles_.size(); ++i)
      if (keep(b, i)) break;
    return ig::Status::changed;
  }

 private:
  static std::vector<CycleFields> all_cycles() {
    std::vector<CycleFields> out;
    for (const CycleSignature& s : drilling_signatures) out.emplace_back(s, ig::read | ig::write | ig::take | ig::wake);
    return out;
  }
  std::vector<std::vector<ig::Field<double>>> all_kept() const {
    std::vector<std::vector<ig::Field<double>>> out;
    for (const CycleFields& cycle : cycles_) {
      std::vector<ig::Field<double>>& row = out.emplace_back();
      for (std::size_t i = 0; i < cycle.size(); ++i)
        row.emplace_back(std::string("CannedCycle.Params.").append(cycle.parameter(i)), ig::read | ig::write,
                         ig::About{ig::Life::modal, "", "A parameter of the cycle, as called."});
    }
    return out;
  }

  void forget(ig::Block& b) const {
    if (!b.has(term_)) return;
    b.erase(term_);
    for (const auto& row : kept_)
      for (const auto& field : row) b.erase(field);
  }

  bool keep(ig::Block& b, std::size_t i) const {
    CycleFields::Values values;
    if (!cycles_[i].take(b, values)) return false;
    for (std::size_t k = 0; k < cycles_[i].size(); ++k)
      if (const auto& v = values[k]) b.set(kept_[i][k], *v);
    b.erase(cycles_[i].code().code(0));  // no cycle drills in this block
    b.set(term_, cycles_[i].code().name(0));
    return true;
  }

  /// A rotary axis alone is a move as well: a table turns the next hole under the tool.
  bool moves(const ig::Block& b) const {
    return b.get(words_).mask != 0 || b.has(angles_[0]) || b.has(angles_[1]) || b.has(angles_[2]);
  }

  bool repeat(ig::Block& b, bool has_pattern) const {
    if (!has_pattern && !moves(b)) return false;
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
      if (!b.is(term_, cycles_[i].code().name(0))) continue;
      b.set_call(cycles_[i].code(), 0);
      for (std::size_t k = 0; k < cycles_[i].size(); ++k)
        if (const auto v = b.get(kept_[i][k])) b.set(cycles_[i].field(k), *v);
      return true;
    }
    return false;
  }
};

const ig::Register<SiemensCycle> siemens_cycle_syntax;

}  // namespace
}  // namespace siemens
