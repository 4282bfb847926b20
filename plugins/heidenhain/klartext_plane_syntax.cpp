// PLANE SPATIAL, EULER, VECTOR, RELATIV and RESET: the tilted working plane. The plane becomes a G68.2 with three
// spatial angles, its positioning a G53.1 (TURN) or G53.6 (MOVE) with the angles that are found here; they go to Q120
// to Q122 as well, for the block that positions the axes after STAY.
#include <numbers>

#include "feed_words.hpp"
#include "m_functions.hpp"
#include "program_xyz_util.hpp"
#include "tool_kinematics.hpp"

namespace heidenhain {
namespace {

enum class Choice { sum, farthest };

struct KlartextPlane {
  static constexpr auto spec =
      ig::syntax("KlartextPlaneSyntax", "PLANE, CYCL DEF 19 and FUNCTION TCPM: tilted planes and tip control.")
          .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
          .before("KlartextCycleSyntax", "IsoG68p2TiltSyntax", "G53p1RotaryPositionSyntax", "ToolCenterPointSyntax",
                  "KlartextMotionSyntax", "McAbcSyntax")
          .scans("CFPcfp");

  Values values_;
  FeedWords feed_;
  MFunctions m_;
  ig::Signal statement_{"Parsing.~KlartextPlane", ig::read | ig::write | ig::wake};
  ig::Call plane_{{"G68.2"}, "X Y Z I[deg] J[deg] K[deg] P[] Q[]", ig::write};
  ig::Codes end_{{"G69"}, ig::write};
  ig::Call turn_{{"G53.1", "G53.6"}, "P[] H[] R", ig::write};
  ig::Codes motions_{{"G00", "G01"}, ig::write};
  ig::Call tip_{{"G43.4"}, "", ig::write};
  ig::Call length_{{"G43"}, "", ig::write};
  std::array<ig_field, 3> rotary_{rotary("Parsing.A"), rotary("Parsing.B"), rotary("Parsing.C")};
  std::array<ig::Previous<double>, 3> present_{ig::Previous<double>{"MachineCoordinate.A"},
                                               ig::Previous<double>{"MachineCoordinate.B"},
                                               ig::Previous<double>{"MachineCoordinate.C"}};
  ig::Out<ig::Symbol> term_{"TiltTransform.Term"};
  std::array<ig::In<double>, 3> angles_{ig::In<double>{"TiltTransform.I"}, ig::In<double>{"TiltTransform.J"},
                                        ig::In<double>{"TiltTransform.K"}};
  ig::Out<bool> stay_{"KlartextPlane.IsStaying",
                      {ig::Life::block, "", "PLANE ... STAY: the program positions the axes itself."}};
  ig::Out<ig::Symbol> length_term_{"ToolHeightCompensation.Term"};
  ig::Name g69_{"G69"}, g68_2_{"G68.2"}, g43_4_{"G43.4"}, g43_{"G43"};
  iso::ToolKinematics machine_;
  iso::RotarySolver solver_;
  ig::Choice<Choice> choice_{"choice", "sum|farthest", "sum",
                             "Which solution is taken without SEQ: the shorter way of both axes together, or of the "
                             "one that goes farther."};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return position;
    const std::size_t i = keyword(text, position, "PLANE"), cycle = behind_cycle_19(text, position);
    const std::size_t tcpm = keyword(text, position, "FUNCTION TCPM");
    const std::size_t no_tcpm = keyword(text, position, "FUNCTION RESET TCPM");
    if (i == position && cycle == position && tcpm == position && no_tcpm == position) return position;
    const std::size_t end = statement_end(text, position);
    if (values_.is_indexing()) return end;
    if (tcpm != position || no_tcpm != position) {
      lead_tip(b, text.substr(0, end), position, std::max(tcpm, no_tcpm), tcpm != position);
      return end;
    }
    command_ = {};
    command_.begin = position;
    const std::string_view whole = trim(piece(text, position, end));
    command_.end = position + whole.size();
    if (i != position ? read(b, text.substr(0, end), i) : read_cycle(b, text.substr(0, end), cycle))
      b.raise(statement_);
    return end;
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(statement_)) return ig::Status::unchanged;
    if (command_.kind == reset)
      end_plane(b);
    else
      tilt(b);
    return ig::Status::changed;
  }

 private:
  enum Kind : std::size_t { spatial, euler, vector, relative, reset, kind_count };
  enum class Move { none, stay, turn, move };
  struct Command {
    Kind kind = kind_count;
    std::size_t begin = 0, end = 0;
    std::array<std::optional<double>, 9> words{};
    Move move = Move::none;
    int sequence = 0;
    double distance = 0;
    bool is_rapid = false;
  };
  ig::Where where() const { return ig::Where::columns(command_.begin, command_.end); }

  static ig_field rotary(const char* path) {
    return ig::Field<double>(path, ig::read | ig::write, {ig::Life::standard, "deg", ""}).id();
  }

  static constexpr std::array<std::string_view, kind_count> names{"SPATIAL", "EULER", "VECTOR", "RELATIV", "RESET"};
  std::string_view shown() const {
    static constexpr std::array<std::string_view, kind_count> all{"PLANE SPATIAL", "PLANE EULER", "PLANE VECTOR",
                                                                  "PLANE RELATIV", "PLANE RESET"};
    return all[command_.kind];
  }
  static constexpr std::array<std::string_view, 3> spatial_words{"SPA", "SPB", "SPC"};
  static constexpr std::array<std::string_view, 3> euler_words{"EULPR", "EULNUT", "EULROT"};
  static constexpr std::array<std::string_view, 6> vector_words{"BX", "BY", "BZ", "NX", "NY", "NZ"};

  // ---- text

  /// CYCL DEF 19.1: where its words begin; 19.0 only names the cycle and is left to KlartextCycleSyntax.
  static std::size_t behind_cycle_19(std::string_view text, std::size_t position) {
    const std::size_t definition = keyword(text, position, "CYCL DEF");
    if (definition == position) return position;
    std::size_t i = skip(text, definition);
    if (text.substr(std::min(i, text.size())).substr(0, 2) != "19") return position;
    i = iso::skip_blanks(text, i + 2);
    if (at(text, i) != '.') return position;
    i = iso::skip_blanks(text, i + 1);
    return at(text, i) == '1' && !is_digit(at(text, i + 1)) ? i + 1 : position;
  }

  /// Spatial angles; those that are not named keep their value. All 0, or none at all: no plane.
  bool read_cycle(ig::Block& b, std::string_view text, std::size_t i) {
    bool any = false, is_tilted = false;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t axis = std::string_view("ABC").find(to_upper(text[i]));
      const Value v = axis < 3 ? values_.read(b, text, i + 1) : Value{};
      if (axis < 3 && v.ok) {
        command_.words[axis] = v.number;
        any = true;
        i = v.end;
      } else if (to_upper(text[i]) == 'F') {
        i = feed_.scan(b, values_, text, i, command_.is_rapid);
      } else {
        const std::string_view rest = rest_of_line(text, i);
        b.report(hei("HEI-0103"), ig::Where::columns(i, i + rest.size()), rest, std::string_view("CYCL DEF 19"));
        break;
      }
    }
    for (std::size_t axis = 0; axis < 3 && any; ++axis) {
      if (!command_.words[axis]) command_.words[axis] = b.is(term_, g68_2_) ? b.get_or(angles_[axis], 0.0) : 0;
      is_tilted = is_tilted || *command_.words[axis] != 0;
    }
    command_.kind = is_tilted ? spatial : reset;
    command_.move = Move::stay;
    return true;
  }

  /// The tip of the tool is led while the rotary axes turn: as M128.
  void lead_tip(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i, bool starts) const {
    const auto word = [&](ig_field field) {
      const ig_word w{field, iso::column(begin), iso::column(i), ig_value{}, 0, 0};
      b.host()->set_words(b.raw(), &w, 1);
    };
    if (starts || b.is(length_term_, g43_4_)) word(starts ? tip_.code(0) : length_.code(0));
    const std::size_t after = i;
    for (const std::string_view words : {"F TCP", "F CONT", "AXIS POS", "PATHCTRL AXIS", "REFPNT TIP-TIP"})
      if (const std::size_t next = skip(text, i), behind = keyword(text, next, words); behind != next) i = behind;
    i = skip(text, i);
    if (!starts || i >= text.size()) {
      if (!starts && i < text.size())
        b.report(hei("HEI-0105"), ig::Where::columns(after, text.size()), trim(text.substr(after)),
                 std::string_view("FUNCTION RESET TCPM"));
      return;
    }
    const std::string_view rest = rest_of_line(text, i);
    b.report(hei("HEI-0171"), ig::Where::columns(i, i + rest.size()), rest,
             std::string_view("the words of rotary axes are positions of the axes, as after M128"));
  }

  bool read(ig::Block& b, std::string_view text, std::size_t i) {
    i = skip(text, i);
    const std::size_t letters = letters_end(text, i);
    for (std::size_t k = 0; k < kind_count; ++k)
      if (iso::equals_ignoring_case(piece(text, i, letters), names[k])) command_.kind = static_cast<Kind>(k);
    if (command_.kind == kind_count) {
      const std::string_view whole = rest_of_line(text, command_.begin);
      b.report(hei("HEI-0171"), where(), whole.substr(0, line_end(whole, 0)),
               std::string_view("the plane stays as it was"));
      return false;
    }
    i = letters;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t next = word_at(b, text, i);
      if (next == i) {
        const std::string_view rest = rest_of_line(text, i);
        b.report(hei("HEI-0103"), ig::Where::columns(i, i + rest.size()), rest, std::string_view("PLANE"));
        break;
      }
      i = next;
    }
    return is_complete(b);
  }

  std::span<const std::string_view> words() const {
    if (command_.kind == euler) return euler_words;
    if (command_.kind == vector) return vector_words;
    return spatial_words;
  }

  std::size_t word_at(ig::Block& b, std::string_view text, std::size_t i) {
    const std::size_t letters = letters_end(text, i);
    // A Q behind the letters begins the value: SPAQ1
    const std::string_view word = piece(text, i, letters);
    const auto is = [&](std::string_view name) { return iso::equals_ignoring_case(word, name); };
    for (std::size_t k = 0; k < words().size() && command_.kind != reset; ++k) {
      const std::string_view name = words()[k];
      if (!iso::equals_ignoring_case(word.substr(0, name.size()), name)) continue;
      const Value v = values_.read(b, text, i + name.size());
      if (!v.ok) continue;
      command_.words[k] = v.number;
      return v.end;
    }
    if (is("STAY")) return set(Move::stay, letters);
    if (is("TURN")) return set(Move::turn, letters);
    if (is("MOVE")) return set(Move::move, letters);
    if (is("SEQ") || is("SYM")) {
      const std::size_t sign = iso::skip_blanks(text, letters);
      if (at(text, sign) != '+' && at(text, sign) != '-') return i;
      command_.sequence = at(text, sign) == '+' ? 1 : -1;
      return sign + 1;
    }
    if (is("TABLE") || is("COORD")) {
      const std::size_t rot = keyword(text, skip(text, letters), "ROT");
      return rot == skip(text, letters) ? i : rot;
    }
    if (is("DIST") || is("ABST") || is("MB")) {
      const Value v = values_.read(b, text, letters);
      if (!v.ok) return is("MB") ? std::max(i, keyword(text, skip(text, letters), "MAX")) : i;
      if (is("MB") && v.number != 0)
        b.report(hei("HEI-0171"), ig::Where::columns(i, v.end), trim(piece(text, i, v.end)),
                 std::string_view("the tool does not retract before it turns"));
      if (!is("MB")) command_.distance = v.number;
      return v.end;
    }
    if (to_upper(text[i]) == 'F') return feed_.scan(b, values_, text, i, command_.is_rapid);
    if (to_upper(text[i]) == 'M') return m_.scan(b, values_, text, i);
    return i;
  }
  std::size_t set(Move move, std::size_t next) {
    command_.move = move;
    return next;
  }

  bool is_complete(ig::Block& b) const {
    if (command_.kind == reset) return true;
    bool any = false;
    for (std::size_t k = 0; k < words().size(); ++k) {
      any = any || command_.words[k];
      if (command_.words[k] || command_.kind == relative) continue;
      b.report(hei("HEI-0170"), where(), shown(), words()[k]);
      return false;
    }
    if (!any) b.report(hei("HEI-0170"), where(), shown(), std::string_view("SPA, SPB or SPC"));
    return any;
  }

  // ---- the plane

  iso::Mat4 present_plane(const ig::Block& b) const {
    if (!b.is(term_, g68_2_)) return iso::identity_frame;
    return spatial_plane({b.get_or(angles_[0], 0.0), b.get_or(angles_[1], 0.0), b.get_or(angles_[2], 0.0)});
  }
  static iso::Mat4 spatial_plane(const ig::Vec3& angles) {
    return iso::roll_pitch_yaw(angles, {0, 1, 2}, iso::TurnedAxes::fixed);
  }

  /// Its rows are the axes of the plane; nothing where the words give none.
  std::optional<iso::Mat4> plane(const ig::Block& b) const {
    const auto w = [&](std::size_t i) { return command_.words[i].value_or(0); };
    switch (command_.kind) {
      case euler: return iso::euler_zxz({w(0), w(1), w(2)});
      case vector: return iso::from_z_and_x({w(3), w(4), w(5)}, {w(0), w(1), w(2)});
      case relative: return iso::product(spatial_plane({w(0), w(1), w(2)}), present_plane(b));
      default: return spatial_plane({w(0), w(1), w(2)});
    }
  }

  static ig::Vec3 spatial_angles(const iso::Mat4& m) {
    constexpr double degree = std::numbers::pi / 180;
    const double b = std::asin(std::fmax(-1, std::fmin(1, -m[2])));
    if (std::fabs(m[0]) < 1e-12 && std::fabs(m[1]) < 1e-12) return {std::atan2(-m[9], m[5]) / degree, b / degree, 0};
    return {std::atan2(m[6], m[10]) / degree, b / degree, std::atan2(m[1], m[0]) / degree};
  }

  void tilt(ig::Block& b) {
    const auto m = plane(b);
    if (!m || !iso::is_finite(*m)) {
      b.report(hei("HEI-0170"), where(), shown(), std::string_view("a direction"));
      return;
    }
    const bool is_spatial = command_.kind == spatial;
    const ig::Vec3 angles =
        is_spatial ? ig::Vec3{*command_.words[0], *command_.words[1], *command_.words[2]} : spatial_angles(*m);
    // PLANE ends tip control.
    if (b.is(length_term_, g43_4_)) {
      b.set(length_term_, g43_);
      b.set_call(length_, 0);
    }
    // One plane may follow another: each counts from the workpiece.
    if (b.is(term_, g68_2_)) b.set(term_, g69_);
    b.set_call(plane_, 0);
    for (const char axis : {'X', 'Y', 'Z'}) b.set_word(plane_, 0, axis, 0);
    for (std::size_t i = 0; i < 3; ++i) b.set_word(plane_, 0, "IJK"[i], angles[i]);
    b.set_word(plane_, 0, 'P', 1);
    b.set_word(plane_, 0, 'Q', 123);
    position(b, {(*m)[8], (*m)[9], (*m)[10]});
  }

  void position(ig::Block& b, const ig::Vec3& normal) {
    if (!machine_) {
      // They are 0 from here on: what reads them says nothing of the same cause.
      QStore* const store = values_.store();
      for (std::uint32_t q = 120; q <= 122 && store != nullptr; ++q)
        if (std::isnan(store->get({QKind::q, q}, 0))) store->set({QKind::q, q}, 0, 0);
      b.report(hei("HEI-0172"), where(), shown(),
               std::string_view(command_.move == Move::stay || command_.move == Move::none
                                    ? "Q120 to Q122 are not known: 0 is taken where nothing else gave them a value"
                                    : "they do not turn, and Q120 to Q122 are not known"));
      return;
    }
    iso::Angles now{};
    for (std::size_t axis = 0; axis < 3; ++axis) now[axis] = b.get_or(present_[axis], 0.0);
    const auto angles = choose(normal, now);
    if (!angles) {
      b.report(hei("HEI-0176"), where(),
               std::string_view(command_.sequence > 0   ? " with SEQ+"
                                : command_.sequence < 0 ? " with SEQ-"
                                                        : ""));
      b.alarm();
      b.set(stay_, true);
      return;
    }
    if (QStore* const store = values_.store())
      for (std::size_t axis = 0; axis < 3; ++axis)
        store->set({QKind::q, static_cast<std::uint32_t>(120 + axis)}, 0,
                   machine_.has(axis) ? iso::rounded((*angles)[axis]) : 0);
    if (command_.move != Move::turn && command_.move != Move::move) {
      b.set(stay_, true);
      return;
    }
    const std::size_t row = command_.move == Move::turn ? 0 : 1;
    b.set_call(turn_, row);
    if (row == 1 && command_.distance != 0) b.set_word(turn_, row, 'R', command_.distance);
    turn_axes(b, *angles);
  }

  void turn_axes(ig::Block& b, const iso::Angles& angles) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (machine_.has(axis)) b.host()->set(b.raw(), rotary_[axis], {.number = iso::rounded(angles[axis])});
    ig_value v;
    v.integer = 1;
    b.host()->set(b.raw(), motions_.id(command_.is_rapid ? 0 : 1), v);
  }

  /// SEQ is the sign of the master axis: the first one counted from the tool, or the last one counted from the table.
  std::size_t master() const {
    const bool is_head = machine_.count() == 2 && !machine_.is_table(1) && !machine_.is_table(0);
    const bool second_is_head = machine_.count() == 2 && !machine_.is_table(1);
    return machine_.axis(is_head || second_is_head ? 1 : 0);
  }

  std::optional<iso::Angles> choose(const ig::Vec3& normal, const iso::Angles& now) const {
    const iso::RotaryCandidates found = solver_.candidates(machine_, normal, now);
    std::optional<iso::Angles> best;
    double best_way = 0;
    for (std::size_t i = 0; i < found.count; ++i) {
      constexpr double same = 1e-6;
      const double angle = std::remainder(found.angles[i][master()], 360.0) * command_.sequence;
      if (angle < -same) continue;
      double sum = 0, farthest = 0;
      for (std::size_t k = 0; k < machine_.count(); ++k) {
        const double way = std::fabs(found.angles[i][machine_.axis(k)] - now[machine_.axis(k)]);
        sum += way;
        farthest = std::fmax(farthest, way);
      }
      const double way = choice_ == Choice::sum ? sum : farthest;
      const bool is_better =
          !best || way < best_way - same || (way < best_way + same && found.angles[i][master()] > (*best)[master()]);
      if (!is_better) continue;
      best = found.angles[i];
      best_way = way;
    }
    return best;
  }

  void end_plane(ig::Block& b) {
    ig_value v;
    v.integer = 1;
    if (b.is(term_, g68_2_)) b.host()->set(b.raw(), end_.id(0), v);
    if (command_.move != Move::turn && command_.move != Move::move) return;
    if (!machine_) {
      b.report(hei("HEI-0172"), where(), shown(), std::string_view("they do not turn"));
      return;
    }
    if (command_.move == Move::move)
      b.report(hei("HEI-0171"), where(), std::string_view("MOVE of PLANE RESET"),
               std::string_view("the axes turn as with TURN, and the tip of the tool is not led"));
    turn_axes(b, {});
  }

  Command command_;
};

const ig::Register<KlartextPlane> registered;

}  // namespace
}  // namespace heidenhain
