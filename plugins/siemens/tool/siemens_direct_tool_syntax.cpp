/// On machines where T alone changes the tool, programs hold no M6. The first move with an offset shows that there is
/// none: until then M6 may still come.

#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

enum class WithoutM6 { changed, waits };

struct SiemensDirectTool {
  static constexpr auto spec =
      ig::syntax("SiemensDirectToolSyntax", "T changes the tool where no M6 does.")
          .after("ToolChangeSyntax", "SiemensToolNameSyntax")
          .before("SiemensToolOffsetSyntax", "SiemensMachineCoordinatesSyntax", "SiemensPositionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SIE-0234", "the block uses D{0}, but no M6 has put T{1} into the spindle: {2}"),
  };

  ig::Choice<WithoutM6> without_m6_{"without-m6", "changed|waits", "changed",
                                    "A move with the offset of a tool that no M6 brought: T has changed the tool "
                                    "(machine data 22550 = 0), or the tool waits, and its offset is 0."};
  ig::In<std::int64_t> named_{"ToolChange.ToolId", ig::wake};
  ig::Out<std::int64_t> in_spindle_{"ToolChange.SpindleToolId"};
  ig::Out<bool> is_change_{"ToolChange.IsChange"};
  ig::In<bool> wakes_{"ToolChange.IsChange", ig::wake};
  ig::Out<ig::Symbol> term_{"ToolChange.Term"};
  ig::Signal waits_{"ToolChange.~Waits", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Signal by_t_{"ToolChange.~ByT", ig::read | ig::write, ig::Life::modal};
  ig::Field<double> d_{"Parsing.D", ig::read | ig::write, {ig::Life::word, "", ""}};
  ig::Field<std::int64_t> edge_{
      "ToolHeightCompensation.Edge", ig::previous, {ig::Life::modal, "", "D: the cutting edge in force; 0: none."}};
  ig::Codes machine_{{"G53", "G153", "SUPA"}, ig::read};
  ig::Call cycles_{
      {"CYCLE81", "CYCLE82", "CYCLE83", "CYCLE84", "CYCLE840", "CYCLE85", "CYCLE86", "CYCLE87", "CYCLE88", "CYCLE89"},
      "",
      ig::read};
  ig::Codes motions_{{"G00", "G01", "G02", "G03", "CIP"}, ig::read};
  ig::In<ig::Symbol> motion_{"MotionState.Term"};
  ig::Xyz words_{"Parsing", ig::read};
  ig::Name t_{"T"}, g00_{"G00"};

  ig::Status build(ig::Block& b) {
    if (b.is_fresh(is_change_)) {  // M6
      b.erase(waits_);
      b.erase(by_t_);
      return ig::Status::changed;
    }
    if (b.is_raised(by_t_)) return b.is_fresh(named_) ? change(b) : ig::Status::unchanged;
    if (b.is_fresh(named_) && !b.has(in_spindle_)) b.raise(waits_);
    const bool moves = b.find(cycles_) || b.get(words_).mask != 0;
    if (!b.is_raised(waits_) || !moves || b.find(machine_) || b.get_or(named_, std::int64_t{0}) == 0)
      return ig::Status::changed;
    const double edge = edge_of(b);
    if (edge == 0) return ig::Status::changed;
    b.report(ig::diag("SIE-0234"), ig::Where::block(), edge, static_cast<double>(b.get_or(named_, std::int64_t{0})),
             std::string_view(without_m6_ == WithoutM6::changed ? "T is assumed to change the tool, here and later"
                                                                : "length and radius are assumed to be 0"));
    b.erase(waits_);
    if (without_m6_ == WithoutM6::waits) return ig::Status::changed;
    b.raise(by_t_);
    b.set(d_, edge);
    return change(b);
  }

 private:
  /// The edge that a move needs; 0: the tool change can still wait. Without any D, a rapid may still go to the place of
  /// the tool change; a feed move or a cycle uses D1, which becomes active with the tool.
  double edge_of(const ig::Block& b) const {
    if (const auto d = b.get(d_)) return *d;
    if (const auto edge = b.get(edge_)) return static_cast<double>(*edge);
    if (b.find(cycles_)) return 1;
    const auto code = b.find(motions_);
    const bool is_rapid = code ? *code == 0 : b.is(motion_, g00_);
    return is_rapid ? 0 : 1;
  }
  ig::Status change(ig::Block& b) const {
    b.set(in_spindle_, b.get_or(named_, std::int64_t{0}));
    b.set(is_change_, true);
    b.set(term_, t_);
    return ig::Status::changed;
  }
};

const ig::Register<SiemensDirectTool> siemens_direct_tool_syntax;

}  // namespace
}  // namespace siemens
