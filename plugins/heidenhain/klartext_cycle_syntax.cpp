// CYCL DEF and CYCL CALL. The number of a cycle decides what it is, since its name comes in the language of the
// control. A definition is kept in CycleDefinition, and its Q parameters get their values; cycles that act where they
// are defined act here, or are handed to the syntax that executes them.
#include <vector>

#include "cycle_parameters.hpp"
#include "feed_words.hpp"
#include "m_functions.hpp"

namespace heidenhain {
namespace {

struct KlartextCycle {
  static constexpr auto spec = ig::syntax("KlartextCycleSyntax", "CYCL DEF, CYCL CALL and TRANS DATUM.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("HeidenhainCoordinateOffsetSyntax", "KlartextDrillingCycleSyntax")
                                   .scans("CQTcqt");

  Values values_;
  FeedWords feed_;
  MFunctions m_;
  CycleDefinition definition_{ig::read | ig::write};
  ig::Out<std::int64_t> number_{"CycleDefinition.Number", {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  ig::Signal said_{"CycleDefinition.~Said", ig::write, ig::Life::modal};
  ig::Signal is_open_{"CycleDefinition.~Open", ig::read | ig::write, ig::Life::modal};
  ig::In<std::int64_t> n_{"Source.N"};
  ig::Out<bool> call_{"KlartextCycle.IsCalled",
                      {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::Out<bool> at_position_{"KlartextCycle.IsAtPosition",
                             {ig::Life::block, "", "CYCL CALL POS: the block goes to the point first."}};
  ig::Out<bool> modal_call_{"KlartextCycle.IsModal",
                            {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::Field<double> preset_number_{"Parsing.DATUM_PRESET", ig::write, {ig::Life::word, "", ""}};
  ig::Call datum_{{"DATUM", "IDATUM"}, "X Y Z A B C", ig::write};
  ig::Call rotation_{{"G68"}, "X Y Z R[deg]", ig::write};
  ig::Codes rotation_end_{{"G69"}, ig::write};
  ig::Call mirror_{{"G50.1", "G51.1"}, "X Y Z", ig::write};
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  ig::Xyz mirror_image_{"MirrorImage", ig::read};
  ig::In<ig::Symbol> tilt_{"TiltTransform.Term"};
  ig::In<double> turned_{"TiltTransform.R"};
  ig::In<ig::Symbol> plane_{"PlaneSelect.Term"};
  ig::Out<double> dwell_{"Dwell.Time"};
  ig::Xyz axes_{"Parsing", ig::write};
  ig::Codes motions_{{"G00", "G01"}, ig::write};
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"}, g68_{"G68"}, g68_2_{"G68.2"}, g18_{"G18"}, g19_{"G19"};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return position;
    const bool is_open = b.is_raised(is_open_);
    const std::size_t end = statement_end(text, position);
    const std::size_t definition = behind_def(text, position), call = keyword(text, position, "CYCL CALL");
    if (const std::size_t datum = keyword(text, position, "TRANS DATUM"); datum != position)
      return trans_datum(b, text.substr(0, end), position, datum);
    // Listings show the parameters of a cycle on lines of their own, without a number.
    if (to_upper(text[position]) == 'Q') {
      if (!is_open || position != iso::skip_blanks(text, 0) || values_.is_indexing() || b.has(n_)) return position;
      if (!is_parameter_alone(text.substr(0, end), position)) {
        b.erase(is_open_);
        return position;
      }
      const std::size_t next = parameters(b, text.substr(0, end), position, true);
      return next == position ? position : end;
    }
    if (definition == position && call == position) return position;
    if (values_.is_indexing()) return end;
    if (is_open) b.erase(is_open_);
    if (call != position)
      read_call(b, text.substr(0, end), position, call);
    else
      define(b, text.substr(0, end), position, definition);
    return end;
  }

 private:
  struct Number {
    std::uint32_t cycle = 0;
    std::optional<std::uint32_t> part;
    std::size_t end = 0;
  };

  /// The number may follow without a blank: CYCL DEF9 .0
  static std::size_t behind_def(std::string_view text, std::size_t position) {
    return keyword(text, position, "CYCL DEF");
  }

  static std::optional<Number> number_at(std::string_view text, std::size_t i) {
    Number out;
    const auto read = [&](std::size_t from, std::uint32_t& value) {
      const std::size_t end = iso::skip_digits(text, from);
      if (end == from || std::from_chars(text.data() + from, text.data() + end, value).ec != std::errc{}) return from;
      return end;
    };
    const std::size_t end = read(i, out.cycle);
    if (end == i) return std::nullopt;
    out.end = end;
    const std::size_t point = iso::skip_blanks(text, end);
    std::uint32_t part = 0;
    const std::size_t digits = iso::skip_blanks(text, point + 1);
    if (at(text, point) != '.') return out;
    if (const std::size_t part_end = read(digits, part); part_end != digits) {
      out.part = part;
      out.end = part_end;
    }
    return out;
  }

  void define(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) {
    i = skip(text, i);
    const auto number = number_at(text, i);
    const std::string_view whole = rest_of_line(text, begin);
    const auto where = ig::Where::columns(begin, begin + std::min(whole.size(), line_end(whole, 0)));
    if (!number) {
      b.report(hei("HEI-0168"), where, whole.substr(0, line_end(whole, 0)));
      return;
    }
    const bool is_first = !number->part || *number->part == 0;
    if (acts_where_defined(number->cycle)) {
      if (!number->part) parameters(b, text, number->end, false);
      act(b, text, *number, where);
      return;
    }
    if (is_first) {
      definition_.clear(b);
      b.set(number_, static_cast<std::int64_t>(number->cycle));
      b.erase(said_);
      b.erase(modal_call_);
      if (!number->part) b.raise(is_open_);
    }
    if (!number->part) parameters(b, text, number->end, true);
  }

  static bool acts_where_defined(std::uint32_t cycle) {
    static constexpr std::array<std::uint32_t, 17> all{7,  8,  9,  10,  11,  13,  14,  19, 20,
                                                       26, 30, 32, 220, 221, 224, 239, 247};
    return std::find(all.begin(), all.end(), cycle) != all.end();
  }

  /// Q200=2 with nothing behind it; else the line is a formula.
  static bool is_parameter_alone(std::string_view text, std::size_t position) {
    std::size_t end = position;
    const bool is_q = Values::q_at(text, position, end).has_value();
    const std::size_t equals = skip(text, end);
    if (!is_q || at(text, equals) != '=') return false;
    const std::size_t first = skip(text, equals + 1), word = letters_end(text, first);
    const std::string_view name = piece(text, first, word);
    if (iso::equals_ignoring_case(name, "FAUTO") || iso::equals_ignoring_case(name, "FMAX"))
      return skip(text, word) >= text.size();
    std::size_t i = iso::skip_while(text, first, [](char c) { return c == '+' || c == '-' || iso::is_blank(c); });
    std::size_t q_end = i;
    if (Values::q_at(text, i, q_end))
      i = q_end;
    else if (const ig::Decimal d = read_number(text, i); d.ok)
      i = d.end;
    else
      return false;
    return skip(text, i) >= text.size();
  }

  /// Q200=2 and so on, between the words of the cycle's name; behind the last of them. `position` where there is none.
  std::size_t parameters(ig::Block& b, std::string_view text, std::size_t position, bool defines) {
    std::size_t done = position;
    bool is_said = false;
    for (std::size_t i = skip(text, position); i < text.size(); i = skip(text, i)) {
      std::size_t end = i;
      const auto q = Values::q_at(text, i, end);
      const std::size_t equals = q ? skip(text, end) : i;
      if (!q || at(text, equals) != '=') {
        const std::size_t next = std::max(i + 1, iso::skip_while(text, i, [](char c) { return !is_space(c); }));
        if (done != position && !is_said)
          b.report(hei("HEI-0105"), ig::Where::columns(i, next), piece(text, i, next),
                   std::string_view("a parameter of CYCL DEF"));
        is_said = is_said || done != position;
        i = std::max(i + 1, iso::skip_while(text, i, [](char c) { return !is_space(c) && c != ';'; }));
        continue;
      }
      const std::size_t first = skip(text, equals + 1);
      const std::string_view name = piece(text, i, end);
      const auto where = ig::Where::columns(i, end);
      const std::size_t word = letters_end(text, first);
      Value v = values_.read(b, text, first);
      if (!v.ok && iso::equals_ignoring_case(piece(text, first, word), "FAUTO")) {
        v = {feed_.as_written(b, feed_.of_tool_call(b).value_or(0)), word, feed_.of_tool_call(b).has_value()};
      } else if (!v.ok && iso::equals_ignoring_case(piece(text, first, word), "FMAX")) {
        v = {fastest, word, true};
      }
      if (!v.ok) {
        b.report(hei("HEI-0104"), where, std::string_view("CYCL DEF"), name);
        done = i = std::max(first, end + 1);
        continue;
      }
      values_.set(b, *q, name, where, v.number);
      if (q->kind == QKind::q) note(b, q->number, v.number, defines);
      done = i = v.end;
    }
    return done;
  }

  void note(ig::Block& b, std::uint32_t q, double value, bool defines) {
    const std::size_t i = index_of_parameter(q);
    if (defines && i < cycle_parameters.size()) {
      const std::string_view unit = cycle_parameters[i].unit;
      const bool is_feed = unit == "mm/min" && value < fastest;
      const bool is_inch = (unit == "mm" || is_feed) && b.is(system_, inch_);
      const double mm = is_inch ? 25.4 * (is_feed ? feed_.in_unit(b, value) : value) : value;
      if (std::isfinite(mm)) definition_.set(b, q, mm);
    }
    if (q == 339 && !defines) preset_value_ = value;
  }

  // ---- cycles that act where they are defined

  void act(ig::Block& b, std::string_view text, const Number& number, ig::Where where) {
    const auto part = number.part.value_or(1);
    const auto say = [&](const char* effect) {
      b.report(hei("HEI-0161"), where, static_cast<double>(number.cycle), std::string_view(effect));
    };
    switch (number.cycle) {
      case 7:
        if (part > 0) datum(b, text, number.end);
        return;
      case 8:
        if (part > 0) mirror(b, text, number.end, where, part == 1);
        return;
      case 9:
        if (part > 0) dwell(b, text, number.end);
        return;
      case 10:
        if (part > 0) rotate(b, text, number.end, where);
        return;
      case 11:
      case 26:
        if (part > 0 && scales(b, text, number.end)) say("positions are not scaled");
        return;
      case 13:
        if (part > 0) say("the spindle is not oriented");
        return;
      case 30:
        if (part > 0) say("the points of the file are not run");
        return;
      case 220:
      case 221:
      case 224: say("the pattern of holes is missing"); return;
      case 239: say("the load is not learned"); return;
      case 247:
        if (!preset_value_) {
          b.report(hei("HEI-0163"), where, 247.0, std::string_view("Q339"));
          return;
        }
        word(b, preset_number_.id(), where.begin, where.end, *preset_value_);
        preset_value_.reset();
        return;
      default: return;  // 14, 20: contours, said where they are machined; 32: how exactly the path is kept
    }
  }

  static bool has_letter(std::string_view text, std::size_t i) { return skip(text, i) < text.size(); }

  static void word(ig::Block& b, ig_field field, std::size_t begin, std::size_t end, double value) {
    const ig_word w{field, iso::column(begin), iso::column(end), {.number = value}, 0, 0};
    b.host()->set_words(b.raw(), &w, 1);
  }
  static void code(ig::Block& b, ig_field field, std::size_t begin, std::size_t end) {
    const ig_word w{field, iso::column(begin), iso::column(end), ig_value{}, 0, 0};
    b.host()->set_words(b.raw(), &w, 1);
  }

  /// CYCL DEF 7.1 X+60, IX+5, #5
  void datum(ig::Block& b, std::string_view text, std::size_t i) const {
    while ((i = skip(text, i)) < text.size()) {
      const bool is_step = to_upper(text[i]) == 'I';
      const std::size_t letter = is_step ? i + 1 : i;
      const std::size_t axis = std::string_view("XYZABC").find(to_upper(at(text, letter)));
      if (text[i] == '#') {
        const Value n = values_.read(b, text, i + 1);
        b.report(hei("HEI-0173"), ig::Where::columns(i, std::max(n.end, i + 1)), n.number);
        return;
      }
      const Value v = axis < 6 ? values_.read(b, text, letter + 1) : Value{};
      if (!v.ok) {
        const std::string_view rest = rest_of_line(text, i);
        b.report(hei("HEI-0103"), ig::Where::columns(i, i + rest.size()), rest, std::string_view("CYCL DEF 7"));
        return;
      }
      const std::size_t row = is_step ? 1 : 0;
      code(b, datum_.code(row), i, v.end);
      word(b, datum_.row(row)[axis], i, v.end, v.number);
      i = v.end;
    }
  }

  /// CYCL DEF 8.1 X Y: the axes that are mirrored about the datum; none: no mirror image.
  void mirror(ig::Block& b, std::string_view text, std::size_t i, ig::Where where, bool is_anew) const {
    if (is_anew && b.has(mirror_term_)) code(b, mirror_.code(0), where.begin, where.end);
    // A rotation that was defined in a mirror image has been turned the other way round.
    if (b.is(tilt_, g68_) && b.has(mirror_term_) && mirrored_axes_in_plane(b) == 1)
      b.report(hei("HEI-0161"), where, 8.0, std::string_view("the rotation in force keeps its sense"));
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t axis = std::string_view("XYZ").find(to_upper(text[i]));
      const std::size_t tool = b.is(plane_, g18_) ? 1 : b.is(plane_, g19_) ? 0 : 2;
      if (axis > 2 || axis == tool) {
        b.report(hei("HEI-0161"), ig::Where::columns(i, i + 1), 8.0,
                 std::string_view(axis > 2 ? "only X, Y and Z can be mirrored here" : "the tool axis is not mirrored"));
      } else {
        code(b, mirror_.code(1), i, i + 1);
        word(b, mirror_.row(1)[axis], i, i + 1, 0);
      }
      ++i;
    }
  }

  /// The number behind the word, which is in any language: V.ZEIT 1.5
  Value number_behind(ig::Block& b, std::string_view text, std::size_t i) const {
    i = skip(text, i);
    if (const Value v = values_.read(b, text, i); v.ok) return v;
    while (i < text.size()) {
      const char c = text[i];
      std::size_t end = i;
      if (is_digit(c) || c == '+' || c == '-' || (c == '.' && is_digit(at(text, i + 1))) || Values::q_at(text, i, end))
        break;
      ++i;
    }
    return values_.read(b, text, i);
  }

  void dwell(ig::Block& b, std::string_view text, std::size_t i) const {
    const Value v = number_behind(b, text, i);
    if (!v.ok || v.number < 0)
      b.report(hei("HEI-0104"), ig::Where::columns(i, std::max(i + 1, text.size())), std::string_view("CYCL DEF 9"),
               std::string_view("the time"));
    else
      b.set(dwell_, v.number);
  }

  int mirrored_axes_in_plane(const ig::Block& b) const {
    const std::size_t tool = b.is(plane_, g18_) ? 1 : b.is(plane_, g19_) ? 0 : 2;
    const ig::PartialVec3 mirror = b.get(mirror_image_);
    int count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) count += axis != tool && mirror.has(axis) ? 1 : 0;
    return count;
  }

  bool scales(ig::Block& b, std::string_view text, std::size_t i) const {
    const Value v = number_behind(b, text, i);
    return !v.ok || v.number != 1;
  }

  /// CYCL DEF 10.1 ROT+35, IROT+10: about the datum, in the plane.
  void rotate(ig::Block& b, std::string_view text, std::size_t i, ig::Where where) const {
    const std::size_t first = skip(text, i);
    const bool is_step = to_upper(at(text, first)) == 'I';
    const Value v = number_behind(b, text, first);
    if (!v.ok) {
      b.report(hei("HEI-0104"), where, std::string_view("CYCL DEF 10"), std::string_view("ROT"));
      return;
    }
    const bool is_rotated = b.is(tilt_, g68_);
    // IsoG68RotationSyntax turns the other way in a mirrored system, and keeps the angle that it turns.
    const bool is_mirrored = b.has(mirror_term_) && mirrored_axes_in_plane(b) == 1;
    const double in_force = is_rotated ? b.get_or(turned_, 0.0) : 0;
    const double angle = v.number + (is_step ? (is_mirrored ? -in_force : in_force) : 0);
    if (b.is(tilt_, g68_2_)) {
      if (angle != 0)
        b.report(hei("HEI-0161"), where, 10.0, std::string_view("positions in the tilted plane are not rotated"));
      return;
    }
    if (angle == 0) {
      if (is_rotated) code(b, rotation_end_.id(0), where.begin, where.end);
      return;
    }
    code(b, rotation_.code(0), where.begin, where.end);
    const bool is_zx = b.is(plane_, g18_), is_yz = b.is(plane_, g19_);
    word(b, rotation_.word(0, is_zx ? 'Z' : is_yz ? 'Y' : 'X'), where.begin, where.end, 0);
    word(b, rotation_.word(0, is_zx ? 'X' : is_yz ? 'Z' : 'Y'), where.begin, where.end, 0);
    word(b, rotation_.word(0, 'R'), where.begin, where.end, angle);
  }

  /// TRANS DATUM AXIS X+10, TABLE TABLINE 5, RESET: what cycle 7 does.
  std::size_t trans_datum(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    if (values_.is_indexing()) return text.size();
    i = skip(text, i);
    const std::size_t axis = keyword(text, i, "AXIS"), reset = keyword(text, i, "RESET");
    if (axis != i) {
      datum(b, text, axis);
    } else if (reset != i) {
      code(b, datum_.code(0), begin, reset);
      for (std::size_t k = 0; k < 3; ++k) word(b, datum_.row(0)[k], begin, reset, 0);
    } else {
      const std::string_view whole = rest_of_line(text, begin);
      b.report(hei("HEI-0122"), ig::Where::columns(begin, begin + whole.size()), whole,
               std::string_view("the datum table is not known, the shift stays"));
    }
    return text.size();
  }

  // ---- CYCL CALL

  void read_call(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    i = skip(text, i);
    const std::size_t pattern = keyword(text, i, "PAT"), position = keyword(text, i, "POS");
    if (pattern != i) {
      const std::string_view whole = rest_of_line(text, begin);
      b.report(hei("HEI-0122"), ig::Where::columns(begin, begin + whole.size()), whole,
               std::string_view("the holes of the pattern are missing"));
      return;
    }
    b.set(call_, true);
    bool is_rapid = false;
    const bool is_positioned = position != i;
    if (is_positioned) b.set(at_position_, true);
    i = position;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t next = call_word(b, text, i, is_rapid);
      if (next == i) {
        const std::string_view rest = rest_of_line(text, i);
        b.report(hei("HEI-0103"), ig::Where::columns(i, i + rest.size()), rest, std::string_view("CYCL CALL"));
        break;
      }
      i = next;
    }
    if (is_positioned) code(b, motions_.id(is_rapid ? 0 : 1), begin, begin + 9);
  }

  std::size_t call_word(ig::Block& b, std::string_view text, std::size_t i, bool& is_rapid) const {
    const char c = to_upper(text[i]);
    if (c == 'M') return m_.scan(b, values_, text, i);
    if (c == 'F') return feed_.scan(b, values_, text, i, is_rapid);
    const std::size_t axis = std::string_view("XYZ").find(c);
    if (axis > 2) return i;
    const Value v = values_.read(b, text, i + 1);
    if (!v.ok) return i;
    word(b, axes_.id(axis), i, v.end, v.number);
    return v.end;
  }

  static constexpr double fastest = 99'999;
  std::optional<double> preset_value_;
};

const ig::Register<KlartextCycle> registered;

}  // namespace
}  // namespace heidenhain
