// The frame of a program: BEGIN PGM NAME MM or INCH, END PGM, BLK FORM, and STOP. BEGIN PGM names the program for CALL
// PGM and sets the unit; END PGM ends it, or leads back to the caller. The blank changes no path.
#include "klartext_values.hpp"
#include "m_functions.hpp"

namespace heidenhain {
namespace {

struct KlartextProgram {
  static constexpr auto spec = ig::syntax("KlartextProgramSyntax", "BEGIN PGM, END PGM, BLK FORM and STOP.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("UnitModeSyntax", "ProgramStopSyntax", "ProgramEndSyntax")
                                   .scans("BESbes");

  Values values_;
  MFunctions m_;
  ig::TextField program_{"Source.Program", ig::write};
  ig::Codes units_{{"G20", "G21"}, ig::write};
  ig::Codes stop_{{"M00"}, ig::write};
  ig::Codes end_codes_{{"M02", "M30"}, ig::read | ig::wake};
  ig::Out<ig::Symbol> end_term_{"ProgramEnd.Term"};
  ig::Name end_pgm_{"END PGM"};
  ig::Signal ends_{"KlartextProgram.~Ends", ig::read | ig::write | ig::wake};
  std::string name_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return position;
    if (const std::size_t i = keyword(text, position, "BEGIN PGM"); i != position) return begin(b, text, position, i);
    if (keyword(text, position, "END PGM") != position) {
      if (!values_.is_indexing()) b.raise(ends_);
      return statement_end(text, position);
    }
    if (keyword(text, position, "BLK FORM") != position) return statement_end(text, position);
    if (const std::size_t i = keyword(text, position, "STOP"); i != position) return stop(b, text, position, i);
    return position;
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(ends_)) {
      // What stands behind M2 and M30 are subprograms, and END PGM.
      if (b.find(end_codes_)) b.flow(IG_FLOW_END_FILE);
      return ig::Status::unchanged;
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
  std::size_t begin(ig::Block& b, std::string_view text, std::size_t position, std::size_t i) {
    const std::size_t end = statement_end(text, position);
    const std::string_view rest = rest_of_line(text, i);
    const std::size_t blank = rest.find_last_of(" \t");
    const std::string_view unit = rest.substr(blank == std::string_view::npos ? 0 : blank + 1);
    const bool is_inch = iso::equals_ignoring_case(unit, "INCH");
    const bool has_unit = is_inch || iso::equals_ignoring_case(unit, "MM");
    name_ = trim(has_unit ? rest.substr(0, rest.size() - unit.size()) : rest);
    b.set_text(program_, name_);
    for (char& c : name_) c = to_upper(c);
    if (values_.is_indexing()) {
      values_.flow().label(b, name_, IG_LABEL_PROGRAM);
      return end;
    }
    const ig_word word{units_.id(is_inch ? 0 : 1), iso::column(position), iso::column(position + 1), ig_value{}, 0, 0};
    b.host()->set_words(b.raw(), &word, 1);
    return end;
  }

  /// STOP, and M functions behind it. M6 changes the tool that TOOL CALL named.
  std::size_t stop(ig::Block& b, std::string_view text, std::size_t position, std::size_t i) const {
    const std::size_t end = statement_end(text, position);
    if (values_.is_indexing()) return end;
    const ig_word word{stop_.id(0), iso::column(position), iso::column(i), ig_value{}, 0, 0};
    b.host()->set_words(b.raw(), &word, 1);
    while ((i = skip(text, i)) < end) {
      if (to_upper(text[i]) != 'M') {
        const std::string_view rest = rest_of_line(text, i);
        b.report(hei("HEI-0105"), ig::Where::columns(i, i + rest.size()), rest, std::string_view("STOP"));
        break;
      }
      i = m_.scan(b, values_, text, i);
    }
    return end;
  }
};

const ig::Register<KlartextProgram> registered;

}  // namespace
}  // namespace heidenhain
