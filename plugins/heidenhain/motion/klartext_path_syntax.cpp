// Path functions: L, LP, LN, CC, C, CR, CT, CP, CTP, and RND, CHF, APPR and DEP beside them. The scanner reads the
// block as a whole and writes its words; KlartextMotionSyntax makes a path of them. A block that begins with an axis or
// an M function is read as L.
#include <isogloss/cnc/further_axes.hpp>

#include "language/block_words.hpp"
#include "motion/approach_words.hpp"
#include "motion/contour_side.hpp"
#include "motion/corner_words.hpp"
#include "motion/feed_words.hpp"
#include "motion/m_functions.hpp"
#include "motion/path_function.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPath {
  using enum PathFunction;

  static constexpr auto spec =
      ig::syntax("KlartextPathSyntax", "L, CC, C, CR, CT, polar LP, CP, CTP: words of a path block.")
          .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
          .scans("ABCDILMRUVWXYZabcdilmruvwxyz")
          .scans_ahead();
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
  ig::Signal pole_{"KlartextPath.~Pole", ig::write};  // L and LN alone have nothing to do with it
  ig::Out<bool> is_ccw_{"KlartextPath.IsCcw", {ig::Life::block, "", "DR+ of the block; DR- is false."}};
  std::array<ig_field, 6> axes_{word("X", "mm"),  word("Y", "mm"),  word("Z", "mm"),
                                word("A", "deg"), word("B", "deg"), word("C", "deg")};
  std::array<ig_field, 6> steps_{word("IX", "mm"),  word("IY", "mm"),  word("IZ", "mm"),
                                 word("IA", "deg"), word("IB", "deg"), word("IC", "deg")};
  std::array<ig_field, 2> polar_{word("PR", "mm"), word("PA", "deg")};
  std::array<ig_field, 2> polar_steps_{word("IPR", "mm"), word("IPA", "deg")};
  ig_field radius_ = word("R", "mm");
  std::array<ig_field, 3> vector_{word("TX", ""), word("TY", ""), word("TZ", "")};
  std::array<ig_field, 3> normal_{word("NX", ""), word("NY", ""), word("NZ", "")};
  FurtherAxisWords further_axes_{ig::write, ig::write};
  AxisNames axis_names_;
  ig::Codes motions_{{"G00", "G01", "G02", "G03"}, ig::write};
  ContourSide side_;
  CornerWords corner_;
  ApproachWords approach_;
  std::array<ig::Name, 10> symbols_{ig::Name{"L"},  ig::Name{"LP"}, ig::Name{"LN"}, ig::Name{"C"},   ig::Name{"CC"},
                                    ig::Name{"CR"}, ig::Name{"CT"}, ig::Name{"CP"}, ig::Name{"CTP"}, ig::Name{"RND"}};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!stands_first(text, position)) return position;
    const auto found = path_function_at(text, position);
    if (!found) return position;
    if (values_.is_indexing()) return statement_end(text, position);
    Path path{found->function, found->end, text.size()};
    if (path.function == RND || path.function == CHF) return corner(b, text, position, path);
    return read(b, text, position, path);
  }

 private:
  struct Path {
    PathFunction function;
    std::size_t position;
    std::size_t end;
    bool is_rapid = false, has_axis = false;
    std::optional<bool> is_ccw{};
    ApproachShape approach{};
    std::string_view name() const { return name_of(function); }
  };

  static ig_field word(std::string_view name, const char* unit) {
    return ig::detail::declare_field({{"Parsing.", name}, IG_NUMBER, ig::read | ig::write, {ig::Life::word, unit, ""}});
  }

  // ---- words

  std::size_t read(ig::Block& b, std::string_view text, std::size_t begin, Path& path) const {
    Words words = plain_positions(text, path);
    if (words.end < text.size()) path.end = statement_end(text, words.end);
    for (std::size_t i = skip(text, words.end); i < path.end; i = skip(text, i)) {
      words.give(b);
      const std::size_t next = word_at(b, text, i, path);
      if (next == i) {
        unknown(b, text, i, path);
        break;
      }
      i = next;
    }
    finish(b, begin, path, words);
    return path.end;
  }

  /// Words for one call of the host: an axis each, and the code of the motion.
  struct Words {
    std::array<ig_word, 7> words;
    std::uint32_t count = 0;
    std::size_t end = 0;
    void give(ig::Block& b) {
      if (count > 0) b.set_words(words.data(), count);
      count = 0;
    }
  };
  /// X+12.5 Y-3, with which most blocks begin, up to where a word of another kind begins.
  Words plain_positions(std::string_view text, Path& path) const {
    Words out;
    out.end = path.position;
    unsigned seen = 0;
    const bool has_columns = text.size() <= column(text.size());
    while (path.function < APPR && has_columns) {
      const std::size_t begin = skip_blanks(text, out.end);
      const std::size_t axis = axis_of(at(text, begin));
      if (axis > 5 || (seen >> axis & 1u) != 0) break;
      const ig::Decimal d = ig::read_decimal(text, begin + 1);
      const char behind = at(text, d.end);
      if (!d.ok || !(is_blank(behind) || behind == '\0')) break;
      seen |= 1u << axis;
      out.words[out.count++] = {axes_[axis],
                                static_cast<std::uint16_t>(begin),
                                static_cast<std::uint16_t>(d.end),
                                {.number = d.value + 0.0},
                                0,
                                0};
      out.end = d.end;
    }
    path.has_axis = out.count > 0;
    return out;
  }

  std::size_t word_at(ig::Block& b, std::string_view text, std::size_t i, Path& path) const {
    const char c = to_upper(text[i]), d = to_upper(at(text, i + 1));
    if (path.function >= APPR)
      if (const std::size_t end = approach_.scan(b, values_, text, i, path.function, path.approach); end != i)
        return end;
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
      return p < 2 ? put_polar(b, text, i, i + 3, polar_steps_[p], path, polar_[p]) : i;
    }
    if (const std::size_t axis = axis_of(c); axis < 6) return put(b, text, i, i + 1, axes_[axis], path, steps_[axis]);
    if (path.function == CC && (c == 'F' || c == 'R'))
      if (const std::size_t end = word_of_no_pole(b, text, i); end != i) return foreign(b, text, i, end, path);
    switch (c) {
      case 'P': {
        const std::size_t p = polar_of(d);
        return p < 2 ? put_polar(b, text, i, i + 2, polar_[p], path, polar_steps_[p]) : i;
      }
      case 'F': return feed_.scan(b, values_, text, i, path.is_rapid);
      case 'M': return m_.scan(b, values_, text, i);
      case 'R':
        // No arc has a radius of 0, so R0 ends RL and RR here as well.
        if (path.function == CR && !ContourSide::begins(text, i) && !ContourSide::ends(text, i))
          return put(b, text, i, i + 1, radius_, path);
        return side_.scan(b, text, i, path.approach.is_beside);
      case 'D': {
        const std::size_t sign = skip_blanks(text, i + 2);
        const char s = at(text, sign);
        if (d != 'R' || (s != '+' && s != '-')) return i;
        const bool turns = path.function == C || path.function == CR || path.function == CP;
        if (!turns) return foreign(b, text, i, sign + 1, path);
        if (path.is_ccw) report_repeated(b, text, i, sign + 1);
        path.is_ccw = s == '+';
        return sign + 1;
      }
      case 'N':
      case 'T': {
        if (path.function != LN || axis_of(d) > 2) return i;
        const Value v = values_.read(b, text, i + 2);
        if (v.ok) put_word(b, (c == 'T' ? vector_ : normal_)[axis_of(d)], i, v.end, v.number);
        return v.ok ? v.end : i;
      }
      default: return i;
    }
  }

  /// U, V and W move an axis that the machine's table has. The other words of the block are executed in any case.
  std::size_t parallel_axis(ig::Block& b, std::string_view text, std::size_t i) const {
    const std::size_t letter = to_upper(text[i]) == 'I' ? i + 1 : i;
    const char c = to_upper(at(text, letter));
    if (c != 'U' && c != 'V' && c != 'W') return i;
    const Value v = values_.read(b, text, letter + 1);
    if (!v.ok) return i;
    if (const auto axis = axis_names_.find(std::string_view(&c, 1)); axis && is_further_axis(*axis)) {
      put_word(b, further_axes_.word(*axis).id(), i, v.end, v.number + 0.0);
      b.set(further_axes_.mode(*axis), b.symbol(letter == i ? "AC" : "IC"));
      return v.end;
    }
    b.report(ig::diag("HEI-0122"), ig::Where::columns(i, v.end), trim(piece(text, i, v.end)),
             std::string_view("parallel axes are not known"));
    return v.end;
  }

  /// 0 to 5: X Y Z A B C; 6: another character.
  static std::size_t axis_of(char c) {
    static constexpr auto axes = [] {
      std::array<std::uint8_t, 256> out{};
      out.fill(6);
      for (std::size_t axis = 0; axis < axis_letters.size(); ++axis)
        for (const char letter : {axis_letters[axis], static_cast<char>(axis_letters[axis] - 'A' + 'a')})
          out[static_cast<unsigned char>(letter)] = static_cast<std::uint8_t>(axis);
      return out;
    }();
    return axes[static_cast<unsigned char>(c)];
  }
  static std::size_t polar_of(char c) { return std::min<std::size_t>(std::string_view("RA").find(to_upper(c)), 2); }

  /// `other` is the same axis as an increment or as a position.
  std::size_t put(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value, ig_field field, Path& path,
                  ig_field other = IG_NO_FIELD) const {
    const Value v = values_.read(b, text, value);
    if (!v.ok) {
      b.report(ig::diag("HEI-0104"), ig::Where::columns(begin, value), path.name(), piece(text, begin, value));
      return value;
    }
    if (b.has(field) || b.has(other)) report_repeated(b, text, begin, v.end);
    if (b.has(other)) b.erase(other);
    put_word(b, field, begin, v.end, v.number + 0.0);
    path.has_axis = true;
    return v.end;
  }

  /// The same for PR, PA, IPR and IPA, which polar functions alone have.
  std::size_t put_polar(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value, ig_field field,
                        Path& path, ig_field other) const {
    const bool is_polar = path.function == LP || path.function == CP || path.function == CTP;
    const bool leads = path.function == APPR || (path.function == DEP && path.approach.is_at_named_point());
    if (is_polar || leads) return put(b, text, begin, value, field, path, other);
    const Value v = values_.read(b, text, value);
    return foreign(b, text, begin, v.ok ? v.end : value, path);
  }

  /// The end of F100, FMAX, RL, RR or R0 at `i`, which CC does not have; `i` where none of them is there.
  std::size_t word_of_no_pole(ig::Block& b, std::string_view text, std::size_t i) const {
    if (to_upper(text[i]) == 'R') return ContourSide::begins(text, i) || ContourSide::ends(text, i) ? i + 2 : i;
    if (const Value v = values_.read(b, text, i + 1); v.ok) return v.end;
    const std::size_t letters = letters_end(text, i);
    return letters == i + 1 ? i : letters;
  }

  /// A word of other functions alone: the rest of the block is executed.
  std::size_t foreign(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, const Path& path) const {
    b.report(ig::diag("HEI-0103"), ig::Where::columns(begin, end), trim(piece(text, begin, end)), path.name());
    return end;
  }

  void unknown(ig::Block& b, std::string_view text, std::size_t i, const Path& path) const {
    const std::string_view line = rest_of_line(text, i), rest = trim(line.substr(0, statement_end(line, 0)));
    if (at(text, i) == '(') return values_.report_brackets(b, ig::Where::columns(i, i + rest.size()));
    b.report(ig::diag("HEI-0103"), ig::Where::columns(i, i + rest.size()), rest, path.name());
  }

  void finish(ig::Block& b, std::size_t begin, const Path& path, Words& words) const {
    const bool is_approach = path.function >= APPR;
    const PathFunction function = is_approach ? straight_function(b) : path.function;
    b.set(function_, symbols_[static_cast<std::size_t>(function)]);
    if (function != L && function != LN) b.raise(pole_);
    const std::size_t end = std::max(path.position, begin + 1);
    const auto code = [&](std::size_t motion) {
      words.words[words.count++] = {motions_.id(motion), column(begin), column(end), {}, 0, 0};
    };
    const auto where = ig::Where::columns(begin, end);
    if (path.function == DEP) side_.end(b, begin, end);
    if (is_approach) approach_.set(b, side_, path.function, path.approach, where);
    if (path.function <= LN || is_approach) {
      code(path.is_rapid || (!path.has_axis && m_.retracts(b)) ? 0 : 1);
    } else if (path.function != CC) {
      if (path.is_rapid) b.report(ig::diag("HEI-0135"), where, path.name());
      if (path.is_ccw) {
        b.set(is_ccw_, *path.is_ccw);
        code(*path.is_ccw ? 3 : 2);
      } else if (path.function != CT && path.function != CTP) {
        b.report(ig::diag("HEI-0133"), where, path.name());
        b.erase(radius_);
        code(1);
      }
    }
    words.give(b);
  }

  PathFunction straight_function(const ig::Block& b) const {
    ig_value unused;
    for (const ig_field word : {polar_[0], polar_[1], polar_steps_[0], polar_steps_[1]})
      if (b.get(word, unused)) return LP;
    return L;
  }

  /// RND R5, CHF 2: between two moves, with an F of their own.
  std::size_t corner(ig::Block& b, std::string_view text, std::size_t begin, Path& path) const {
    path.end = statement_end(text, begin);
    const Value v = corner_.size(b, values_, text.substr(0, path.end), path.position, path.function);
    const auto where = ig::Where::columns(begin, std::max(path.position, v.end));
    if (!v.ok) {
      b.report(ig::diag("HEI-0104"), where, path.name(), std::string_view(path.function == RND ? "R" : "the length"));
      return path.end;
    }
    for (std::size_t i = skip(text, v.end); i < path.end; i = skip(text, i)) {
      const char c = to_upper(text[i]);
      std::size_t next = c == 'M' ? m_.scan(b, values_, text, i) : i;
      if (c == 'F') next = corner_.feed(b, values_, feed_, text, i, path.function);
      if (next == i) {
        unknown(b, text, i, path);
        break;
      }
      i = next;
    }
    corner_.set(b, path.function, v.number, where);
    return path.end;
  }
};

const ig::Register<KlartextPath> klartext_path_syntax;

}  // namespace
}  // namespace heidenhain
