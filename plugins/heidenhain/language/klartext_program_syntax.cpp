// The frame of a program: BEGIN PGM NAME MM or INCH, END PGM, BLK FORM, and STOP. BEGIN PGM names the program for CALL
// PGM and sets the unit; END PGM ends the program, or returns to the caller. The blank form does not change the path.
#include "language/block_words.hpp"
#include "language/klartext_values.hpp"
#include "language/program_unit.hpp"
#include "motion/m_functions.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextProgram {
  static constexpr auto spec = ig::syntax("KlartextProgramSyntax", "BEGIN PGM, END PGM, BLK FORM and STOP.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("UnitModeSyntax", "ProgramStopSyntax", "ProgramEndSyntax")
                                   .scans("BESbes");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0190",
                     "the program ends here without END PGM, M2 or M30: the file may have been cut off"),
      ig::diagnostic(
          IG_ERROR, "HEI-0395",
          "BEGIN PGM {0} stands inside a program, and its unit counts from here on: close the first program"),
  };

  Values values_;
  MFunctions m_;
  ig::TextField program_{"Source.Program", ig::write};
  ig::Codes units_{{"G20", "G21"}, ig::write};
  ProgramUnit unit_;
  ig::Field<std::int64_t> inch_callers_{
      "KlartextProgram.InchCallers",
      ig::read | ig::write,
      {ig::Life::modal, "", "A bit for each depth at which a program was called from one in inches."}};
  ig::Field<std::int64_t> open_calls_{
      "KlartextProgram.OpenCalls",
      ig::read | ig::write | ig::wake_while,
      {ig::Life::modal, "", "A bit for each depth at which a called program has begun and not ended."}};
  ig::Codes stop_{{"M00"}, ig::write};
  ig::Codes end_codes_{{"M02", "M30"}, ig::read | ig::wake};
  ig::Out<ig::Symbol> end_term_{"ProgramEnd.Term"};
  ig::Name end_pgm_{"END PGM"};
  ig::Signal begun_{"KlartextProgram.~Begun", ig::read | ig::write, ig::Life::modal};
  ig::Signal text_ended_{"Source.~End", ig::read | ig::wake};
  ig::Signal ends_{"KlartextProgram.~Ends", ig::read | ig::write | ig::wake};
  std::string name_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return position;
    if (const std::size_t i = keyword(text, position, "BEGIN PGM"); i != position) return begin(b, text, position, i);
    if (const std::size_t i = keyword(text, position, "END PGM"); i != position) {
      const std::size_t end = statement_end(text, position);
      if (values_.is_indexing()) return end;
      b.raise(ends_);
      give_back_unit(b, position);
      set_open_calls(b, b.get_or(open_calls_, std::int64_t{0}) & ~call_bit(b));
      name_and_unit(b, text.substr(0, end), i, "END PGM");
      return end;
    }
    if (const std::size_t i = keyword(text, position, "BLK FORM"); i != position) {
      const std::size_t end = statement_end(text, position);
      if (!values_.is_indexing()) blank(b, text.substr(0, end), i);
      return end;
    }
    if (const std::size_t i = keyword(text, position, "STOP"); i != position) return stop(b, text, position, i);
    return position;
  }

  ig::Status build(ig::Block& b) {
    const bool any = b.has(open_calls_) && close_deeper_calls(b);
    if (b.is_raised(text_ended_) && b.is_raised(begun_)) b.report(ig::diag("HEI-0190"), ig::Where::block());
    if (!b.is_raised(ends_)) {
      // After M2 and M30 come subprograms, and END PGM.
      if (b.find(end_codes_)) b.flow(IG_FLOW_END_FILE);
      return any ? ig::Status::changed : ig::Status::unchanged;
    }
    if (values_.flow().frame(b).depth > 0) {
      values_.flow().leave(b);
      return ig::Status::changed;
    }
    b.set(end_term_, end_pgm_);
    b.flow(IG_FLOW_END_FILE);
    b.end_program();
    return ig::Status::changed;
  }

 private:
  struct NameAndUnit {
    std::string_view name;
    std::string_view unit;  // MM or INCH; empty where neither is there
  };

  /// NAME MM: text after the unit is reported, unless the name itself looks like a unit.
  NameAndUnit name_and_unit(ig::Block& b, std::string_view text, std::size_t i, std::string_view of) const {
    i = skip(text, i);
    const std::size_t first = i;
    while (i < text.size()) {
      const std::size_t end = skip_while(text, i, [](char c) { return !is_space(c); });
      const std::string_view word = piece(text, i, end);
      const std::size_t next = skip(text, end);
      const bool is_name = i == first && is_unit(piece(text, next, skip_while(text, next, is_letter)));
      if (is_unit(word) && !is_name) {
        if (next < text.size() && !values_.is_indexing()) {
          report_without_meaning(b, text, next, of);
        }
        return {trim(piece(text, first, i)), word};
      }
      i = next;
    }
    return {trim(piece(text, first, text.size())), {}};
  }
  static bool is_unit(std::string_view word) {
    return equals_ignoring_case(word, "MM") || equals_ignoring_case(word, "INCH");
  }

  /// BLK FORM 0.1 Z X+0 Y+0 Z-20, where the first Z is the tool axis; CYLINDER, ROTATION and FILE have words of their
  /// own.
  void blank(ig::Block& b, std::string_view text, std::size_t i) const {
    i = skip(text, i);
    const ig::Decimal corner = read_number(text, i);
    if (!corner.ok || (corner.value != 0.1 && corner.value != 0.2)) {
      const std::string_view shape = piece(text, i, letters_end(text, i));
      const auto is_shape = [&](std::string_view name) { return equals_ignoring_case(shape, name); };
      if (i >= text.size())
        b.report(ig::diag("HEI-0104"), where_of_line(text, 0), std::string_view("BLK FORM"),
                 std::string_view("the corner or the shape"));
      else if (!is_shape("CYLINDER") && !is_shape("ROTATION") && !is_shape("FILE"))
        report_without_meaning(b, text, i, "BLK FORM");
      return;
    }
    const std::size_t tool_axis = corner.value == 0.1 ? skip(text, corner.end) : text.size();
    for (i = skip(text, corner.end); i < text.size(); i = skip(text, i)) {
      const std::size_t letter = to_upper(text[i]) == 'I' ? i + 1 : i;
      const bool is_axis = std::string_view("XYZUVW").find(to_upper(at(text, letter))) != std::string_view::npos;
      if (!is_axis || is_letter(at(text, letter + 1)) != (to_upper(at(text, letter + 1)) == 'Q')) {
        report_without_meaning(b, text, i, "BLK FORM");
        return;
      }
      const Value v = values_.read(b, text, letter + 1);
      if (!v.ok && letter != tool_axis) {
        report_without_meaning(b, text, i, "BLK FORM");
        return;
      }
      i = v.ok ? v.end : letter + 1;
    }
  }

  std::size_t begin(ig::Block& b, std::string_view text, std::size_t position, std::size_t i) {
    const std::size_t end = statement_end(text, position);
    const NameAndUnit found = name_and_unit(b, text.substr(0, end), i, "BEGIN PGM");
    const bool is_inch = equals_ignoring_case(found.unit, "INCH");
    name_ = found.name;
    b.set_text(program_, name_);
    for (char& c : name_) c = to_upper(c);
    if (values_.is_indexing()) {
      values_.flow().label(b, name_, IG_LABEL_PROGRAM);
      return end;
    }
    const bool is_second = is_open(b);
    if (is_second) b.report(ig::diag("HEI-0395"), ig::Where::columns(position, end), found.name);
    b.raise(begun_);
    if (found.unit.empty())
      b.report(ig::diag("HEI-0104"), ig::Where::columns(position, i), std::string_view("BEGIN PGM"),
               std::string_view("MM or INCH"));
    if (!is_second) keep_unit(b);
    put_code(b, units_.id(is_inch ? 0 : 1), position, position + 1);
    return end;
  }

  /// The bit of a called program; 0 in the main program, and where calls are nested too deep for one.
  std::int64_t call_bit(ig::Block& b) const {
    const std::uint32_t depth = values_.flow().frame(b).depth;
    return depth == 0 || depth >= 63 ? 0 : std::int64_t{1} << depth;
  }
  bool is_open(ig::Block& b) const {
    if (values_.flow().frame(b).depth == 0) return b.is_raised(begun_);
    return (b.get_or(open_calls_, std::int64_t{0}) & call_bit(b)) != 0;
  }
  void set_open_calls(ig::Block& b, std::int64_t open) const {
    if (open != 0)
      b.set(open_calls_, open);
    else if (b.has(open_calls_))
      b.erase(open_calls_);
  }
  /// A called program whose file ends without END PGM is open no more in the next block of its caller.
  bool close_deeper_calls(ig::Block& b) const {
    const std::uint32_t depth = values_.flow().frame(b).depth;
    const std::int64_t open = b.get_or(open_calls_, std::int64_t{0});
    const std::int64_t kept = depth >= 62 ? open : open & ((std::int64_t{2} << depth) - 1);
    if (kept != open) set_open_calls(b, kept);
    return kept != open;
  }

  // The unit of a program that is called does not last in the one that calls it.
  void keep_unit(ig::Block& b) const {
    const std::int64_t bit = call_bit(b), kept = b.get_or(inch_callers_, std::int64_t{0});
    if (bit == 0) return;
    set_open_calls(b, b.get_or(open_calls_, std::int64_t{0}) | bit);
    b.set(inch_callers_, unit_.is_inch(b) ? kept | bit : kept & ~bit);
  }
  void give_back_unit(ig::Block& b, std::size_t position) const {
    const std::int64_t bit = call_bit(b);
    if (bit == 0) return;
    const bool is_inch = (b.get_or(inch_callers_, std::int64_t{0}) & bit) != 0;
    if (is_inch != unit_.is_inch(b)) put_code(b, units_.id(is_inch ? 0 : 1), position, position + 1);
  }

  /// STOP, and M functions after it. M6 loads the tool that TOOL CALL named.
  std::size_t stop(ig::Block& b, std::string_view text, std::size_t position, std::size_t i) const {
    const std::size_t end = statement_end(text, position);
    if (values_.is_indexing()) return end;
    put_code(b, stop_.id(0), position, i);
    while ((i = skip(text, i)) < end) {
      if (to_upper(text[i]) != 'M') {
        report_without_meaning(b, text, i, "STOP");
        break;
      }
      i = m_.scan(b, values_, text, i);
    }
    return end;
  }
};

const ig::Register<KlartextProgram> klartext_program_syntax;

}  // namespace
}  // namespace heidenhain
