/// G91, IC and AC: distances become positions, in place, so that no later syntax has to know of them; I=AC(50) becomes
/// a distance from the start of the arc. SiemensRotaryWordsSyntax handles A, B and C, except for their distances.
#include <cmath>
#include <span>

#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/sdk.hpp>

#include "modes/axis_modes.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensPosition {
  static constexpr auto spec = ig::syntax("SiemensPositionSyntax", "G91, AC and IC: words become positions.")
                                   .after("SiemensUnitSyntax", "PositioningModeSyntax", "SiemensCoordinateOffsetSyntax",
                                          "SiemensRotaryWordsSyntax")
                                   .before("SiemensArcSyntax", "ProgramXyzSyntax", "McAbcSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0213",
                     "{0} is for rotary axes only: the word is executed as if {0} were not there"),
  };

  ig::InWhile<ig::Symbol> mode_{"PositioningMode.Term", "G91", ig::wake};
  std::vector<ig::Word> words_ = declared_words();
  AxisModes modes_{ig::read | ig::wake};
  std::array<ig::Previous<double>, 3> angles_{ig::Previous<double>{"MachineCoordinate.A"},
                                              ig::Previous<double>{"MachineCoordinate.B"},
                                              ig::Previous<double>{"MachineCoordinate.C"}};
  LastProgramXyz last_;
  ig::Name g91_{"G91"}, ac_{"AC"}, ic_{"IC"};

  enum class Whole { counted, circle };
  ig::Status build(ig::Block& b) {
    const bool g91 = b.is(mode_, g91_);
    bool any = false;
    std::optional<ig::Vec3> last;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const auto v = b.get(words_[i]);
      if (!v) continue;
      const auto mode = modes_.get(b, i);
      const bool is_centre = i >= 6;
      if (!mode && (!g91 || (is_centre && i < 9))) continue;
      if (i < 3 || is_centre) {
        if (!last) last = last_(b);
        any |= linear(b, i, *v, mode, g91, (*last)[i % 3]);
      } else {
        any |= turn(b, i, *v, mode);
      }
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static std::vector<ig::Word> declared_words() {
    std::vector<ig::Word> out;
    for (const std::string_view name : std::span(AxisModes::words).first(AxisModes::ap)) {
      const bool is_angle = name == "A" || name == "B" || name == "C";
      out.emplace_back(std::string("Parsing.").append(name), ig::read | ig::write, is_angle ? "deg" : "mm");
    }
    return out;
  }
  void rewrite(ig::Block& b, std::size_t word, double value) const { b.rewrite(words_[word].id(), value); }

  bool linear(ig::Block& b, std::size_t word, double value, const std::optional<ig::Symbol>& mode, bool g91,
              double start) const {
    if (mode && *mode != ac_ && *mode != ic_) {
      b.report(ig::diag("SIE-0213"), ig::Where::word(words_[word].id()), b.text(*mode));
      return false;
    }
    const bool is_distance = word < 6 || word >= 9 ? (mode ? *mode == ic_ : g91) : !mode || *mode == ic_;
    const bool wants_distance = word >= 6 && word < 9;  // I J K are distances from the start
    if (is_distance == wants_distance) return false;
    rewrite(b, word, wants_distance ? value - start : value + start);
    return true;
  }

  bool turn(ig::Block& b, std::size_t word, double value, const std::optional<ig::Symbol>& mode) const {
    if (mode && *mode != ic_) return false;
    rewrite(b, word, b.get_or(angles_[word - 3], 0.0) + value);
    return true;
  }
};

const ig::Register<SiemensPosition> siemens_position_syntax;

}  // namespace
}  // namespace siemens
