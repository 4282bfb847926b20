// DEF, DEFINE, PROC, EXTERN: variables of the program, names for texts, and the parameters that a call passes.
#include <algorithm>

#include "language/array_values.hpp"
#include "language/declared_type.hpp"
#include "language/declared_value.hpp"
#include "language/program_parameters.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

using ig::cnc::at;
using ig::cnc::piece;
using ig::cnc::skip_blanks;

struct SiemensDeclaration {
  static constexpr auto spec = ig::syntax("SiemensDeclarationSyntax", "DEF, DEFINE, PROC and EXTERN.")
                                   .after("SiemensFlowSyntax")
                                   .before("SiemensWordSyntax")
                                   .scans("DPERdper")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0161", "'{0}' is not executed: this declaration is not supported"),
      ig::diagnostic(IG_ERROR, "SIE-0162", "'{0}' does not belong in a declaration: write DEF REAL A=1, B, C[3]"),
      ig::diagnostic(IG_WARNING, "SIE-0164",
                     "{0} gets no value from a call, so 0 is assumed: give it in a table of variables"),
      ig::diagnostic(IG_ERROR, "SIE-0301",
                     "{0}{1} is not a size of an array, so the array is not defined: use whole numbers from 1"),
      ig::diagnostic(IG_ERROR, "SIE-0310", "'{0}' behind EXTERN is not executed: write EXTERN in a block of its own"),
      ig::diagnostic(IG_ERROR, "SIE-0302",
                     "{0} is defined already, so this second definition is ignored: use another name"),
  };

  Environment environment_;
  OtherMeaning other_meaning_{ig::write};
  ig::Signal saves_{"SiemensSave.~Begins", ig::write};
  ig::Signal statement_{"Parsing.~Declaration", ig::read | ig::write | ig::wake};
  ig::TextField program_{"Source.Program", ig::write};
  ig::Signal begun_{"Source.~Program", ig::read | ig::write, ig::Life::frame};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t end = skip_short_name(text, position);
    if (end - position < 3) return position;
    const Word word = word_of(piece(text, position, end));
    if (word == Word::none || at(text, skip_blanks(text, end)) == '=' || !b.is_in_turn()) return position;
    if (word == Word::proc && environment_.flow.is_indexing() && !b.is_raised(begun_)) {
      const std::size_t name = skip_blanks(text, end);
      environment_.flow.label(b, upper(piece(text, name, skip_name(text, name))), IG_LABEL_PROGRAM);
      b.raise(begun_);
    }
    word_ = word;
    begin_ = position;
    behind_ = end;
    end_statement_ = statement_text_end(text, position);
    b.raise(statement_);
    return statement_end(text, position);
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(statement_) || end_statement_ > b.source().size()) return ig::Status::unchanged;
    environment_.enter(b);
    const std::string_view text = b.source().substr(0, end_statement_);
    if (word_ == Word::def) define(b, text, behind_);
    if (word_ == Word::define) define_macro(b, text);
    if (word_ == Word::proc) begin_program(b, text);
    if (word_ == Word::external) announce(b, text);
    if (word_ == Word::other) b.report(ig::diag("SIE-0161"), columns(text, begin_), text.substr(begin_));
    return ig::Status::changed;
  }

 private:
  enum class Word : std::uint8_t { none, def, define, proc, external, other };
  static Word word_of(std::string_view name) {
    if (equals_ignoring_case(name, "DEF")) return Word::def;
    if (equals_ignoring_case(name, "PROC")) return Word::proc;
    if (equals_ignoring_case(name, "EXTERN") || equals_ignoring_case(name, "EXTERNAL")) return Word::external;
    if (equals_ignoring_case(name, "DEFINE")) return Word::define;
    if (equals_ignoring_case(name, "REDEF")) return Word::other;
    return Word::none;
  }

  // ---- EXTERN NAME(REAL, INT), which changes nothing here

  void announce(ig::Block& b, std::string_view text) const {
    std::size_t next = skip_blanks(text, skip_name(text, skip_blanks(text, behind_)));
    if (at(text, next) == '(') next = skip_blanks(text, skip_call(text, next));
    if (next < text.size()) b.report(ig::diag("SIE-0310"), columns(text, next), text.substr(next));
  }

  // ---- DEFINE NAME AS TEXT

  void define_macro(ig::Block& b, std::string_view text) const {
    const std::size_t name = skip_blanks(text, behind_), end = skip_name(text, name);
    const std::size_t as = skip_blanks(text, end), by = skip_blanks(text, skip_name(text, as));
    if (end == name || !is_word(text, as, "AS") || by >= text.size()) {
      b.report(ig::diag("SIE-0162"), columns(text, name), text.substr(std::min(name, text.size())));
      return;
    }
    other_meaning_.raise(b);
    environment_.store().define_macro(upper(piece(text, name, end)), std::string(text.substr(by)));
  }

  // ---- DEF REAL A=1, B[3], C

  void define(ig::Block& b, std::string_view text, std::size_t position) {
    std::size_t next = skip_blanks(text, position);
    for (const std::string_view scope : {"NCK", "CHAN", "SYNR", "SYNW", "SYNRW", "PHU", "PHUI"})
      if (is_word(text, next, scope)) next = skip_blanks(text, skip_name(text, next));
    auto type = next < text.size() ? type_at(text, next) : std::nullopt;
    if (!type) {
      b.report(ig::diag("SIE-0161"), columns(text, begin_), text.substr(begin_));
      return;
    }
    type->cuts = environment_.store().cuts_texts;
    while (next < text.size()) {
      const std::size_t begin = next, end = skip_name(text, next);
      const std::string name = upper(piece(text, begin, end));
      if (name.empty()) {
        b.report(ig::diag("SIE-0162"), columns(text, begin), text.substr(begin));
        return;
      }
      next = skip_blanks(text, end);
      std::vector<std::uint32_t> sizes;
      if (at(text, next) == '[' && !read_sizes(b, text, next, name, sizes)) return;
      const std::pair place(environment_.flow.here(b).offset, begin);
      if (const Variable* const known = environment_.store().find_own(name);
          known != nullptr && known->defined_at != place) {
        b.report(ig::diag("SIE-0302"), ig::Where::columns(begin, end), std::string_view(name));
        return;
      }
      if (!environment_.store().define(name, *type, !sizes.empty())) {
        b.report(ig::diag("SIE-0114"), columns(text, begin), std::string_view(name));
        return;
      }
      Variable& defined = *environment_.store().find_own(name);
      defined.defined_at = place;
      defined.sizes = std::move(sizes);
      environment_.note_fill(b, name, defined.value);
      if (at(text, next) == '=' && !initial(b, text, next, name)) return;
      next = skip_blanks(text, next);
      if (next >= text.size()) return;
      if (text[next] != ',') {
        b.report(ig::diag("SIE-0162"), columns(text, next), text.substr(next));
        return;
      }
      next = skip_blanks(text, next + 1);
    }
  }

  /// [5] and [2,3]: the number of elements in each dimension.
  bool read_sizes(ig::Block& b, std::string_view text, std::size_t& next, const std::string& name,
                  std::vector<std::uint32_t>& sizes) {
    constexpr double most = 1e6;
    constexpr std::size_t most_dimensions = 3;
    const std::size_t open = next;
    do {
      Expression e(b, environment_, text, skip_blanks(text, next + 1));
      const auto size = e.number();
      if (!size) return false;
      next = skip_blanks(text, e.position());
      if (!(*size >= 1 && *size <= most) || *size != std::floor(*size) || sizes.size() == most_dimensions) {
        b.report(ig::diag("SIE-0301"), ig::Where::columns(open, std::max(next, open + 1)), std::string_view(name),
                 piece(text, open, std::min(next + 1, text.size())));
        return false;
      }
      sizes.push_back(static_cast<std::uint32_t>(*size));
    } while (at(text, next) == ',');
    if (at(text, next) != ']') {
      b.report(ig::diag("SIE-0102"), columns(text, open));
      return false;
    }
    next = skip_blanks(text, next + 1);
    return true;
  }

  /// Reads =value; for an array, what ArrayValues reads, or one value for all elements.
  bool initial(ig::Block& b, std::string_view text, std::size_t& next, const std::string& name) {
    const Variable& defined = *environment_.store().find_own(name);
    const std::size_t first = skip_blanks(text, next + 1);
    if (defined.is_array && ArrayValues::begin(text, first, true)) {
      next = first;
      return ArrayValues(b, environment_, text).read(next, name, 0);
    }
    std::size_t end = first;
    const auto v = value_of(b, environment_, text, end, defined.declared);
    if (!v) return false;
    environment_.note_write(b, name, *v);
    if (const Stored outcome = environment_.store().assign(name, *v); outcome != Stored::yes) {
      environment_.report_not_stored(b, columns(text, begin_), name, *v, outcome);
      return false;
    }
    next = end;
    return true;
  }

  // ---- PROC NAME(REAL A, INT B=2, VAR REAL C) SAVE DISPLOF

  void begin_program(ig::Block& b, std::string_view text) {
    const std::size_t name = skip_blanks(text, behind_), end = skip_name(text, name);
    b.set_text(program_, piece(text, name, end));
    const std::size_t open = skip_blanks(text, end);
    if (!parameters_.define(b, text, open)) return;
    std::size_t next = at(text, open) == '(' ? skip_bracketed(text, open) : open;
    while ((next = skip_blanks(text, next)) < text.size()) {
      const std::size_t begin = next;
      next = skip_name(text, begin);
      const std::string_view word = piece(text, begin, next);
      if (equals_ignoring_case(word, "SAVE")) {
        b.raise(saves_);
      } else if (!is_attribute(word)) {
        b.report(ig::diag("SIE-0162"), columns(text, begin), text.substr(begin));
        return;
      }
    }
  }

  /// Of a program: what the control shows and where it may stop, which changes no motion.
  static bool is_attribute(std::string_view word) {
    constexpr std::string_view known[] = {"ACTBLOCNO", "DISPLOF", "DISPLON", "ICYCOF",
                                          "ICYCON",    "PREPRO",  "SBLOF",   "SBLON"};
    return std::any_of(std::begin(known), std::end(known),
                       [&](std::string_view name) { return equals_ignoring_case(word, name); });
  }

  ProgramParameters parameters_{environment_};
  Word word_ = Word::none;  // the word that scan() has found
  std::size_t begin_ = 0, behind_ = 0, end_statement_ = 0;
};

const ig::Register<SiemensDeclaration> siemens_declaration_syntax;

}  // namespace
}  // namespace siemens
