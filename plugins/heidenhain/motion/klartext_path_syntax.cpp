// Path functions: L, LP, LN, CC, C, CR, CT, CP, CTP, and RND, CHF, APPR and DEP beside them. The scanner reads the
// block as a whole and writes its words; KlartextMotionSyntax makes a path of them. A block that begins with an axis or
// an M function is read as L.
#include <isogloss/cnc/contour_approach.hpp>
#include <isogloss/cnc/units.hpp>

#include "motion/feed_words.hpp"
#include "motion/klartext_departure.hpp"
#include "motion/m_functions.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

enum Function : std::size_t { L, LP, LN, C, CC, CR, CT, CP, CTP, RND, CHF, APPR, DEP, function_count };

constexpr std::array<std::string_view, function_count> function_names{"L",  "LP",  "LN",  "C",   "CC",   "CR", "CT",
                                                                      "CP", "CTP", "RND", "CHF", "APPR", "DEP"};

struct KlartextPath {
  static constexpr auto spec =
      ig::syntax("KlartextPathSyntax", "L, CC, C, CR, CT, polar LP, CP, CTP: words of a path block.")
          .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
          .scans("ABCDILMRUVWXYZabcdilmruvwxyz");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0131", "{0} is not executed: the block moves to its point without the tool radius"),
      ig::diagnostic(IG_ERROR, "HEI-0133",
                     "{0} has no sense of rotation, so the block moves in a straight line: add DR+ or DR-"),
      ig::diagnostic(IG_ERROR, "HEI-0135", "FMAX of {0} is ignored: an arc moves with the feed rate in force"),
      ig::diagnostic(IG_WARNING, "HEI-0181",
                     "{0} of {1} is not executed: the corner has the feed rate of the move before it"),
  };

  Values values_;
  FeedWords feed_;
  MFunctions m_;
  ig::Out<ig::Symbol> function_{"KlartextPath.Function", {ig::Life::block, "", "The path function of the block."}};
  ig::Out<bool> is_ccw_{"KlartextPath.IsCcw", {ig::Life::block, "", "DR+ of the block; DR- is false."}};
  std::array<ig_field, 6> axes_{word("X", "mm"),  word("Y", "mm"),  word("Z", "mm"),
                                word("A", "deg"), word("B", "deg"), word("C", "deg")};
  std::array<ig_field, 6> steps_{word("IX", "mm"),  word("IY", "mm"),  word("IZ", "mm"),
                                 word("IA", "deg"), word("IB", "deg"), word("IC", "deg")};
  std::array<ig_field, 2> polar_{word("PR", "mm"), word("PA", "deg")};
  std::array<ig_field, 2> polar_steps_{word("IPR", "mm"), word("IPA", "deg")};
  ig_field radius_ = word("R", "mm");
  ig::Codes motions_{{"G00", "G01", "G02", "G03"}, ig::write};
  ig::Codes sides_{{"G40", "G41", "G42"}, ig::write};
  ig::Field<double> offset_word_{"Parsing.D", ig::write, {ig::Life::word, "", ""}};
  ig::In<ig::Symbol> side_in_force_{"RadiusCompensation.Term"};
  ig::In<std::int64_t> offset_in_force_{"RadiusCompensation.OffsetId"};
  ig::In<std::int64_t> tool_{"ToolHeightCompensation.OffsetId"};
  ig::Name g41_{"G41"}, g42_{"G42"};
  ig::Out<double> corner_radius_{"KlartextCorner.Radius_mm", {ig::Life::block, "mm", "RND R"}};
  ig::Out<double> chamfer_{"KlartextCorner.Chamfer_mm", {ig::Life::block, "mm", "CHF"}};
  ContourApproach approach_{ig::write};
  KlartextDeparture departure_{ig::write};
  ig::In<ig::Symbol> motion_in_force_{"MotionState.Term"};
  ig::In<ig::Symbol> feed_term_{"Feedrate.Term"};
  ig::In<double> feed_in_force_{"Feedrate.FeedrateValue"};
  ig::Name g00_{"G00"}, g94_{"G94"};
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"};
  std::array<ig::Name, CHF> symbols_{ig::Name{"L"},  ig::Name{"LP"}, ig::Name{"LN"}, ig::Name{"C"},   ig::Name{"CC"},
                                     ig::Name{"CR"}, ig::Name{"CT"}, ig::Name{"CP"}, ig::Name{"CTP"}, ig::Name{"RND"}};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!stands_first(text, position)) return position;
    const auto found = function_at(text, position);
    if (!found) return position;
    if (values_.is_indexing()) return statement_end(text, position);
    Path path{found->function, found->end,
              found->end == position ? std::string_view("L") : function_names[found->function]};
    path.end = statement_end(text, position);
    if (path.function == RND || path.function == CHF) return corner(b, text, position, path);
    return read(b, text, position, path);
  }

 private:
  struct Found {
    Function function;
    std::size_t end;
  };
  struct Path {
    Function function;
    std::size_t position;
    std::string_view name;
    std::size_t end = 0;
    bool is_rapid = false, has_axis = false, has_tool_vector = false;
    std::optional<bool> is_ccw{};
    std::optional<ContourApproach::Shape> shape{};  ///< of APPR and DEP
    std::optional<double> length{}, radius{}, angle{};
    bool is_beside = false;  ///< the block holds RL or RR
  };

  static ig_field word(std::string_view name, const char* unit) {
    return ig::detail::declare_field({{"Parsing.", name}, IG_NUMBER, ig::read | ig::write, {ig::Life::word, unit, ""}});
  }

  static std::optional<Found> function_at(std::string_view text, std::size_t position) {
    const std::size_t end = letters_end(text, position);
    const std::string_view letters = piece(text, position, end);
    const char next = at(text, end);
    const bool is_word = next == '+' || next == '-' || is_digit(next) || next == '.';
    for (std::size_t i = 0; i < function_count; ++i)
      if (equals_ignoring_case(letters, function_names[i]) && (i != C || !is_word))
        return Found{static_cast<Function>(i), end};
    // L, C and CC with their first word attached: LX+10, CCX+5, LIX+5
    for (const Function f : {LP, LN, CC, CR, CT, CP, L, C}) {
      const std::size_t size = function_names[f].size();
      if (letters.size() <= size || letters.size() > size + 3 || !is_word) continue;
      if (equals_ignoring_case(letters.substr(0, size), function_names[f]) && is_axis_word(letters.substr(size)))
        return Found{f, position + size};
    }
    if (letters.size() == 1 && to_upper(letters[0]) == 'M' && is_digit(at(text, skip_blanks(text, end))))
      return Found{L, position};
    const bool has_value = is_word || to_upper(next) == 'Q' || (letters.size() > 1 && to_upper(letters.back()) == 'Q');
    const std::string_view axis =
        letters.size() > 1 && to_upper(letters.back()) == 'Q' ? letters.substr(0, letters.size() - 1) : letters;
    if (has_value && is_axis_word(axis)) return Found{L, position};
    return std::nullopt;
  }
  static bool is_axis_word(std::string_view letters) {
    if (letters.size() == 2 && to_upper(letters[0]) == 'I') letters.remove_prefix(1);
    return letters.size() == 1 && std::string_view("XYZABCUVW").find(to_upper(letters[0])) != std::string_view::npos;
  }

  // ---- words

  std::size_t read(ig::Block& b, std::string_view text, std::size_t begin, Path& path) const {
    std::size_t i = path.position;
    while (true) {
      i = skip(text, i);
      if (i >= path.end) break;
      const std::size_t next = word_at(b, text, i, path);
      if (next == i) {
        unknown(b, text, i, path);
        break;
      }
      i = next;
    }
    finish(b, begin, path);
    return path.end;
  }

  std::size_t word_at(ig::Block& b, std::string_view text, std::size_t i, Path& path) const {
    const char c = to_upper(text[i]), d = to_upper(at(text, i + 1));
    if (path.function >= APPR)
      if (const std::size_t end = shape_at(b, text, i, path); end != i) return end;
    // LIN_Z-5, LIN_IZ-5: on newer controls, the axis that an arc moves along a straight line.
    if (path.function >= C && path.function <= CTP && path.function != CC &&
        equals_ignoring_case(piece(text, i, std::min(i + 4, text.size())), "LIN_")) {
      const std::size_t axis_word = i + 4;
      if (axis_of(at(text, axis_word + (to_upper(at(text, axis_word)) == 'I' ? 1 : 0))) > 5) return i;
      const std::size_t end = word_at(b, text, axis_word, path);
      return end == axis_word ? i : end;
    }
    if (const std::size_t end = parallel_axis(b, text, i); end != i) return end;
    if (c == 'I') {
      if (const std::size_t axis = axis_of(d); axis < 6) return put(b, text, i, i + 2, steps_[axis], path, axes_[axis]);
      const std::size_t p = d == 'P' ? polar_of(at(text, i + 2)) : 2;
      return p < 2 ? put(b, text, i, i + 3, polar_steps_[p], path, polar_[p]) : i;
    }
    if (const std::size_t axis = axis_of(c); axis < 6) return put(b, text, i, i + 1, axes_[axis], path, steps_[axis]);
    switch (c) {
      case 'P': {
        const std::size_t p = polar_of(d);
        return p < 2 ? put(b, text, i, i + 2, polar_[p], path, polar_steps_[p]) : i;
      }
      case 'F': return feed_.scan(b, values_, text, i, path.is_rapid);
      case 'M': return m_.scan(b, values_, text, i);
      case 'R': return radius(b, text, i, path);
      case 'D': {
        const std::size_t sign = skip_blanks(text, i + 2);
        const char s = at(text, sign);
        if (d != 'R' || (s != '+' && s != '-')) return i;
        if (path.is_ccw) b.report(ig::diag("HEI-0106"), ig::Where::columns(i, sign + 1), piece(text, i, sign + 1));
        path.is_ccw = s == '+';
        return sign + 1;
      }
      case 'N':
      case 'T': {
        if (path.function != LN || axis_of(d) > 2) return i;
        const Value v = values_.read(b, text, i + 2);
        path.has_tool_vector = path.has_tool_vector || c == 'T';
        return v.ok ? v.end : i;
      }
      default: return i;
    }
  }

  /// U, V and W move no axis here; the other words of the block are executed, above all M91 and FMAX.
  std::size_t parallel_axis(ig::Block& b, std::string_view text, std::size_t i) const {
    const std::size_t letter = to_upper(text[i]) == 'I' ? i + 1 : i;
    const char c = to_upper(at(text, letter));
    if (c != 'U' && c != 'V' && c != 'W') return i;
    const Value v = values_.read(b, text, letter + 1);
    if (!v.ok) return i;
    b.report(ig::diag("HEI-0122"), ig::Where::columns(i, v.end), trim(piece(text, i, v.end)),
             std::string_view("parallel axes are not known"));
    return v.end;
  }

  /// LT, LN, CT, LCT, in polar coordinates PLT and so on, and LEN, CCA and R with a value: the shape of an approach or
  /// a departure.
  std::size_t shape_at(ig::Block& b, std::string_view text, std::size_t i, Path& path) const {
    const std::size_t end = letters_end(text, i);
    const std::string_view letters = piece(text, i, end);
    const auto is = [&](std::string_view name) { return equals_ignoring_case(letters, name); };
    static constexpr std::array<std::string_view, 8> shapes{"LT", "LN", "CT", "LCT", "PLT", "PLN", "PCT", "PLCT"};
    for (std::size_t k = 0; k < shapes.size(); ++k)
      if (is(shapes[k])) {
        path.shape = static_cast<ContourApproach::Shape>(k % 4);
        return end;
      }
    const bool is_radius = is("R") && at(text, end) != '0';
    if (!is("LEN") && !is("CCA") && !is_radius) return i;
    const Value v = values_.read(b, text, end);
    if (!v.ok) b.report(ig::diag("HEI-0104"), ig::Where::columns(i, end), path.name, letters);
    if (v.ok) (is("LEN") ? path.length : is("CCA") ? path.angle : path.radius) = v.number;
    return v.ok ? v.end : end;
  }

  static std::size_t axis_of(char c) { return std::min<std::size_t>(std::string_view("XYZABC").find(to_upper(c)), 6); }
  static std::size_t polar_of(char c) { return std::min<std::size_t>(std::string_view("RA").find(to_upper(c)), 2); }

  /// `other` is the same axis as an increment or as a position.
  std::size_t put(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value, ig_field field, Path& path,
                  ig_field other = IG_NO_FIELD) const {
    const Value v = values_.read(b, text, value);
    if (!v.ok) {
      b.report(ig::diag("HEI-0104"), ig::Where::columns(begin, value), path.name, piece(text, begin, value));
      return value;
    }
    if (b.has(field) || b.has(other))
      b.report(ig::diag("HEI-0106"), ig::Where::columns(begin, v.end), trim(piece(text, begin, v.end)));
    if (b.has(other)) b.erase(other);
    const ig_word word{field, column(begin), column(v.end), {.number = v.number + 0.0}, 0, 0};
    b.set_word(word);
    path.has_axis = true;
    return v.end;
  }

  /// R0, RL, RR; R alone, a prompt that was not answered; R with a number, of CR.
  std::size_t radius(ig::Block& b, std::string_view text, std::size_t i, Path& path) const {
    const char d = to_upper(at(text, i + 1));
    const bool is_alone = !is_digit(at(text, i + 2)) && at(text, i + 2) != '.' && at(text, i + 2) != ',';
    if ((d == 'L' || d == 'R') && is_alone) {
      path.is_beside = true;
      compensate(b, d == 'L' ? 1 : 2, i, i + 2);
      return i + 2;
    }
    if (path.function == CR) return put(b, text, i, i + 1, radius_, path);
    if (d == '0' && is_alone) {
      uncompensate(b, i, i + 2);
      return i + 2;
    }
    // R+ and R- lengthen or shorten a paraxial block by the radius
    if (d == '+' || d == '-') {
      b.report(ig::diag("HEI-0131"), ig::Where::columns(i, i + 2), piece(text, i, i + 2));
      return i + 2;
    }
    return is_letter(d) || is_digit(d) ? i : i + 1;
  }

  /// Sets the side of the contour and the tool in the spindle, where they are not in force already.
  void compensate(ig::Block& b, std::size_t side, std::size_t begin, std::size_t end) const {
    const std::int64_t tool = b.get_or(tool_, std::int64_t{0});
    if (b.is(side_in_force_, side == 1 ? g41_ : g42_) && b.get_or(offset_in_force_, std::int64_t{0}) == tool) return;
    const ig_word words[] = {
        {sides_.id(side), column(begin), column(end), ig_value{}, 0, 0},
        {offset_word_.id(), column(begin), column(end), {.number = static_cast<double>(tool)}, 0, 0}};
    b.set_words(words, 2);
  }
  void uncompensate(ig::Block& b, std::size_t begin, std::size_t end) const {
    if (!b.is(side_in_force_, g41_) && !b.is(side_in_force_, g42_)) return;
    const ig_word word{sides_.id(0), column(begin), column(end), ig_value{}, 0, 0};
    b.set_word(word);
  }

  void unknown(ig::Block& b, std::string_view text, std::size_t i, const Path& path) const {
    const std::string_view line = rest_of_line(text, i), rest = trim(line.substr(0, statement_end(line, 0)));
    if (at(text, i) == '(') return values_.say_brackets(b, ig::Where::columns(i, i + rest.size()));
    b.report(ig::diag("HEI-0103"), ig::Where::columns(i, i + rest.size()), rest, path.name);
  }

  void finish(ig::Block& b, std::size_t begin, const Path& path) const {
    const bool is_approach = path.function >= APPR;
    b.set(function_, symbols_[is_approach ? straight_function(b) : path.function]);
    const auto code = [&](std::size_t motion) {
      const ig_word word{
          motions_.id(motion), column(begin), column(std::max(path.position, begin + 1)), ig_value{}, 0, 0};
      b.set_word(word);
    };
    const auto where = ig::Where::columns(begin, std::max(path.position, begin + 1));
    if (path.function == LN && path.has_tool_vector)
      b.report(ig::diag("HEI-0130"), where, std::string_view("the tool vector TX TY TZ of LN"),
               std::string_view("the rotary axes stay"));
    if (path.function == DEP) uncompensate(b, where.begin, where.end);
    if (is_approach && !shape_path(b, path))
      b.report(
          ig::diag("HEI-0130"), where, path.name,
          std::string_view(path.function == APPR ? "the tool goes straight to the first point of the contour"
                                                 : "the tool goes straight to the point that is named, if one is"));
    if (path.function <= LN || is_approach) {
      code(path.is_rapid || (m_.retracts(b) && !path.has_axis) ? 0 : 1);
    } else if (path.function != CC) {
      if (path.is_rapid) b.report(ig::diag("HEI-0135"), where, path.name);
      if (path.is_ccw) {
        b.set(is_ccw_, *path.is_ccw);
        code(*path.is_ccw ? 3 : 2);
      } else if (path.function != CT && path.function != CTP) {
        b.report(ig::diag("HEI-0133"), where, path.name);
        b.erase(radius_);
        code(1);
      }
    }
  }

  /// The path to the contour or away from it; false where it has none: without RL or RR, or where one of its words is
  /// missing.
  bool shape_path(ig::Block& b, const Path& path) const {
    using Shape = ContourApproach::Shape;
    if (!path.shape) return false;
    const Shape shape = *path.shape;
    const bool is_line = shape == Shape::line || shape == Shape::normal;
    const bool is_complete =
        is_line ? path.length && *path.length >= 0
                : path.radius && *path.radius != 0 && (shape != Shape::arc || (path.angle && *path.angle > 0));
    const bool has_side = b.is(side_in_force_, g41_) || b.is(side_in_force_, g42_);
    if (!is_complete || (path.function == APPR && (!path.is_beside || has_side))) return false;
    const double unit = b.is(system_, inch_) ? mm_per_inch : 1;
    ContourApproach::Way way{
        shape,       path.length.value_or(0) * unit, path.radius.value_or(0) * unit, path.angle.value_or(0), false,
        std::nullopt};
    if (path.function == DEP) {
      if (!has_side && shape != Shape::line) return false;
      departure_.set(b, way);
      return true;
    }
    // Up to the start of the approach the tool moves as in the block before; LCT has one feed throughout.
    if (shape != Shape::line_and_arc) {
      way.is_rapid = b.is(motion_in_force_, g00_);
      if (const auto feed = b.get(feed_in_force_); feed && b.is(feed_term_, g94_)) way.feed_mmds = *feed / 60;
    }
    approach_.set(b, way);
    return true;
  }

  Function straight_function(const ig::Block& b) const {
    ig_value unused;
    for (const ig_field word : {polar_[0], polar_[1], polar_steps_[0], polar_steps_[1]})
      if (b.get(word, unused)) return LP;
    return L;
  }

  /// F of a corner with its value: F100, F 100, F MAX. Without a value it has no effect.
  std::size_t corner_feed(ig::Block& b, std::string_view text, std::size_t i, const Path& path) const {
    const auto word_end = [&](std::size_t from) {
      return skip_while(text, from, [](char x) { return !is_space(x) && x != ';'; });
    };
    std::size_t end = std::max(i + 1, word_end(i));
    if (end == i + 1) {
      const std::size_t value = skip_blanks(text, end);
      const char c = to_upper(at(text, value));
      const bool has_value = is_digit(c) || c == '.' || c == '+' || c == 'Q' || keyword(text, value, "MAX") != value ||
                             keyword(text, value, "AUTO") != value;
      if (!has_value) return end;
      end = word_end(value);
    }
    b.report(ig::diag("HEI-0181"), ig::Where::columns(i, end), piece(text, i, end), path.name);
    return end;
  }

  /// RND R5, CHF 2: between two moves, with an F of their own.
  std::size_t corner(ig::Block& b, std::string_view text, std::size_t begin, Path& path) const {
    std::size_t i = skip(text, path.position);
    if (path.function == RND && to_upper(at(text, i)) == 'R') i = skip(text, i + 1);
    const Value v = i < path.end ? values_.read(b, text, i) : Value{};
    const auto where = ig::Where::columns(begin, std::max(path.position, v.end));
    if (!v.ok) {
      b.report(ig::diag("HEI-0104"), where, path.name, std::string_view(path.function == RND ? "R" : "the length"));
      return path.end;
    }
    for (i = skip(text, v.end); i < path.end; i = skip(text, i)) {
      const char c = to_upper(text[i]);
      std::size_t next = c == 'M' ? m_.scan(b, values_, text, i) : i;
      if (c == 'F') next = corner_feed(b, text, i, path);
      if (next == i) {
        unknown(b, text, i, path);
        break;
      }
      i = next;
    }
    if (v.number < 0) {
      b.report(ig::diag("HEI-0130"), where, path.name, std::string_view("it is less than 0, the corner stays sharp"));
    } else if (v.number > 0) {
      b.set(path.function == RND ? corner_radius_ : chamfer_, b.is(system_, inch_) ? v.number * mm_per_inch : v.number);
    }
    return path.end;
  }
};

const ig::Register<KlartextPath> klartext_path_syntax;

}  // namespace
}  // namespace heidenhain
