/// G05.1, G05 and G08: look-ahead, contour and high-speed control. They change speeds and round corners within a
/// tolerance that the machine builder has set; the programmed path does not change, and the mode in force is recorded.

#include <cmath>

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct PathSmoothing {
  static constexpr auto spec = ig::syntax("PathSmoothingSyntax", "G05.1, G05 and G08: contour control, as a record.")
                                   .after("ParameterizedFlagSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0393",
                     "{0} {1}{2} is not executed, because the meaning of this value is not known"),
      ig::diagnostic(IG_WARNING, "ISO-0394", "{0} without {1}: the mode does not change"),
      ig::diagnostic(IG_WARNING, "ISO-0397",
                     "{0}: {1}{2} only selects an axis and does not move it: program the move in its own block"),
      ig::diagnostic(IG_WARNING, "ISO-0589", "R{0} beside G05.1 Q0 has no effect: Q0 ends the mode"),
  };

  // X0 Y0 Z0 beside G05.1 name axes and do not move them.
  ig::Call contour_{{"G05.1"}, "Q[] R[] X Y Z A B C"};
  ig::Call high_speed_{{"G05"}, "P[]"};
  ig::Call look_ahead_{{"G08"}, "P[]"};
  ig::Out<bool> is_enabled_{"PathSmoothing.IsEnabled"};
  ig::Out<ig::Symbol> term_{"PathSmoothing.Term"};
  ig::Out<double> level_{"PathSmoothing.Level"};

  ig::Status build(ig::Block& b) {
    bool any = false;
    if (const auto words = b.take(contour_)) {
      const auto q = (*words)['Q'];
      any = true;
      report_moves(b, *words);
      if (!q || !(*q >= 0 && *q <= 3 && *q == std::floor(*q)))
        refuse(b, contour_, "Q", q);
      else
        record(b, words->code, *q > 0, *q > 0 ? (*words)['R'] : std::nullopt);
      if (const auto level = (*words)['R']; level && q && *q == 0)
        b.report(ig::diag("ISO-0589"), ig::Where::word(contour_.word(0, 'R')), *level);
    }
    if (const auto words = b.take(high_speed_)) {
      const auto p = (*words)['P'];
      any = true;
      if (p && (*p == 0 || *p == 10000))
        record(b, words->code, *p > 0, std::nullopt);
      else
        refuse(b, high_speed_, "P", p);
    }
    if (const auto words = b.take(look_ahead_)) {
      const auto p = (*words)['P'];
      any = true;
      if (p && (*p == 0 || *p == 1))
        record(b, words->code, *p > 0, std::nullopt);
      else
        refuse(b, look_ahead_, "P", p);
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void record(ig::Block& b, ig::Symbol code, bool is_enabled, std::optional<double> level) const {
    b.set(is_enabled_, is_enabled);
    b.set(term_, code);
    b.erase(level_);
    if (level) b.set(level_, *level);
  }
  /// Words beside the code name axes, and manuals write them with 0: another value looks like a move.
  void report_moves(ig::Block& b, const ig::Words& words) const {
    for (const char axis : std::string_view("XYZABC"))
      if (const auto value = words[axis]; value && *value != 0)
        b.report(ig::diag("ISO-0397"), ig::Where::word(contour_.word(0, axis)), b.text(words.code),
                 std::string_view(&axis, 1), *value);
  }
  static void refuse(ig::Block& b, const ig::Call& call, std::string_view address, std::optional<double> value) {
    const auto where = ig::Where::word(call.code(0));
    if (value)
      b.report(ig::diag("ISO-0393"), where, b.text(call.name(0)), address, *value);
    else
      b.report(ig::diag("ISO-0394"), where, b.text(call.name(0)), address);
  }
};

const ig::Register<PathSmoothing> path_smoothing_syntax;

}  // namespace
}  // namespace iso
