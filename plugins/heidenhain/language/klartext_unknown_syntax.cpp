// Text that no other scanner of Klartext has read: statements that are known by name but not executed, programs in
// DIN/ISO format, and anything else that begins a block. Each is one diagnostic.
#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

/// What the run misses: positions or values, something that no position depends on, or nothing.
enum class Kind { path, machine, silent };

struct Known {
  const char* words;
  const char* effect;
  Kind kind = Kind::path;
};

struct KlartextUnknown {
  static constexpr auto spec =
      ig::syntax("KlartextUnknownSyntax", "Statements that are recognised but not executed; DIN/ISO programs.")
          .after("KlartextProgramSyntax", "KlartextParameterSyntax", "KlartextLabelSyntax", "KlartextToolCallSyntax",
                 "KlartextCycleSyntax", "KlartextPlaneSyntax", "KlartextPathSyntax")
          .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz%+-.,:=\"'()[]{}<>#$&@!?_\\|^*/0123456789");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0101",
                     "'{0}' is not understood, so the block is not executed: positions after it may be wrong"),
      ig::diagnostic(IG_ERROR, "HEI-0102",
                     "this is a DIN/ISO program of a TNC, and nothing of it is executed: this dialect reads Klartext"),
  };

  Values values_;
  ig::Signal begun_{"KlartextProgram.~Begun", ig::read, ig::Life::modal};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t end = statement_end(text, position);
    if (values_.is_indexing()) return end;
    // A block of several lines is named by its first line.
    const std::string_view whole = trim(piece(text, position, std::min(end, line_end(text, position))));
    const auto where = ig::Where::columns(position, position + whole.size());
    if (!b.is_raised(begun_) && is_din(text, position)) {
      b.report(ig::diag("HEI-0102"), where);
      b.flow(IG_FLOW_END_FILE);
      if (values_.flow().frame(b).depth == 0) b.end_program();
      return text.size();
    }
    if (text[position] == '(') {
      values_.report_brackets(b, where);
      return end;
    }
    if (is_part_of_probing(text, position) || is_mill_mode(text, position, end)) return end;
    for (const Known& known : statements)
      if (keyword(text, position, known.words) != position) {
        if (known.kind != Kind::silent)
          b.report(known.kind == Kind::path ? ig::diag("HEI-0122") : ig::diag("HEI-0374"), where, whole,
                   std::string_view(known.effect));
        return end;
      }
    b.report(ig::diag("HEI-0101"), where, whole);
    return end;
  }

 private:
  static constexpr const char* probing = "nothing is probed, and results keep their values";
  static constexpr const char* contour = "what is machined along this contour is missing";
  static constexpr const char* program = "the program that it names is not run";
  static constexpr const char* path =
      "the path is missing; positions are unreliable up to the next block with all axes";
  static constexpr const char* monitored = "nothing is monitored";
  // Longer statements stand before those that they begin with.
  static constexpr std::array statements{
      Known{"TCH PROBE", probing},
      Known{"FUNCTION PARAXCOMP DISPLAY", "", Kind::silent},
      Known{"FUNCTION PARAXCOMP OFF", "", Kind::silent},
      Known{"FUNCTION PARAXMODE OFF", "", Kind::silent},
      Known{"FUNCTION POLARKIN OFF", "", Kind::silent},
      Known{"FUNCTION FEED DWELL RESET", "", Kind::silent},
      Known{"FUNCTION S-PULSE RESET", "", Kind::silent},
      Known{"FUNCTION LIFTOFF RESET", "", Kind::silent},
      Known{"FUNCTION CORRDATA RESET", "", Kind::silent},
      Known{"FUNCTION PROG PATH OFF", "", Kind::silent},
      Known{"FUNCTION DCM OFF", "", Kind::silent},
      Known{"FUNCTION AFC CUT END", "", Kind::silent},
      Known{"FUNCTION FEED DWELL", "the axes do not pause", Kind::machine},
      Known{"FUNCTION DWELL REV", "the axes do not pause", Kind::machine},
      Known{"FUNCTION S-PULSE", "the speed of the spindle stays as programmed", Kind::machine},
      Known{"FUNCTION LIFTOFF", "no stop of the control happens here, after which the tool would lift off",
            Kind::machine},
      Known{"FUNCTION COUNT REPEAT", "the part that it would repeat is not run again"},
      Known{"FUNCTION COUNT", "nothing is counted", Kind::machine},
      Known{"FUNCTION FILE", "no file is opened, copied or deleted", Kind::machine},
      Known{"FUNCTION DCM", monitored, Kind::machine},
      Known{"FUNCTION AFC", "the feed stays as programmed", Kind::machine},
      Known{"FUNCTION PARAXCOMP", "parallel axes are not known"},
      Known{"FUNCTION PARAXMODE", "parallel axes are not known"},
      Known{"FUNCTION MODE", "the kinematics stay"},
      Known{"FUNCTION", "what it switches on is not executed"},
      Known{"GLOBAL DEF", "cycles do not take its values"},
      Known{"PRESET SELECT", "the preset stays"},
      Known{"PRESET COPY", "the table of presets stays"},
      Known{"PRESET CORR", "the table of presets stays"},
      Known{"SQL", "tables of the control are not read and not written"},
      Known{"AFC", "the feed stays as programmed", Kind::machine},
      Known{"SEL CORR-TABLE", "offsets of the table do not count"},
      Known{"CALL TABLE", "offsets of the table do not count"},
      Known{"SEL CONTOUR", contour},
      Known{"SEL CYCLE", program},
      Known{"CALL SELECTED CYCLE", program},
      Known{"DECLARE CONTOUR", contour},
      Known{"CONTOUR DEF", contour},
      Known{"SPL", path},
      Known{"FPOL", path},
      Known{"FLT", path},
      Known{"FCT", path},
      Known{"FL", path},
      Known{"FC", path},
      Known{"FSELECT", path},
      Known{"FIXED TABLE", "the table is not read"},
      Known{"OPEN TABLE", "the table is not read"},
      Known{"TABDATA", "the table is not read"},
      Known{"SECTION MONITORING", monitored, Kind::machine},
      Known{"MONITORING", monitored, Kind::machine},
      Known{"INIT", "the value stays"},
      Known{"CUTTER", "the path is that of the program"},
      Known{"POLARKIN", "the kinematics stay"},
  };

  /// TCH PROBE 1.1: its first part, 1.0, has been reported.
  static bool is_part_of_probing(std::string_view text, std::size_t position) {
    const std::size_t behind = keyword(text, position, "TCH PROBE");
    if (behind == position) return false;
    const std::size_t point = skip_digits(text, skip(text, behind));
    return at(text, point) == '.' && is_digit(at(text, point + 1)) && at(text, point + 1) != '0';
  }

  /// FUNCTION MODE MILL without a name of kinematics has no effect here, because TURN is not executed.
  static bool is_mill_mode(std::string_view text, std::size_t position, std::size_t end) {
    const std::size_t behind = keyword(text, position, "FUNCTION MODE MILL");
    return behind != position && skip(text, behind) >= end;
  }

  /// %NAME G71 *, and N10 G00 …: unlike these, a Klartext block begins with a bare number.
  static bool is_din(std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return false;
    if (text[position] == '%') return true;
    if (to_upper(text[position]) != 'N' && to_upper(text[position]) != 'G') return false;
    std::size_t i = skip_digits(text, position + 1);
    if (i == position + 1) return false;
    if (to_upper(text[position]) == 'G') return true;
    i = skip_blanks(text, i);
    return to_upper(at(text, i)) == 'G' && is_digit(at(text, i + 1));
  }
};

const ig::Register<KlartextUnknown> klartext_unknown_syntax;

}  // namespace
}  // namespace heidenhain
