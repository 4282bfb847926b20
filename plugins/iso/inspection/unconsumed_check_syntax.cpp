/// No part of a program is ignored silently: what is left of a block after every syntax has run is reported here, each
/// leftover with its columns. A leftover that can move the tool elsewhere is an error, plain text a note, any other one
/// a warning.
#include <isogloss/cnc/leftovers.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

/// Words whose loss moves the tool elsewhere: axes, arc centres, cycle depths, and all words that a code owns
/// ("G81.Q").
bool is_geometric(std::string_view word) {
  return word.size() > 1 || std::string_view("ABCIJKQRUVWXYZ").find(word) != std::string_view::npos;
}

struct UnconsumedCheck {
  static constexpr auto spec =
      ig::syntax("UnconsumedCheckSyntax", "Reports everything in a block that no syntax has used.")
          .inspects_leftovers();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0280", "{0} is not supported in this dialect and is not executed"),
      ig::diagnostic(IG_WARNING, "ISO-0281", "{0} is not supported in this dialect and is not executed"),
      ig::diagnostic(IG_ERROR, "ISO-0282", "{0} and its words are not executed in this block"),
      ig::diagnostic(IG_WARNING, "ISO-0283", "{0} is not executed in this block"),
      ig::diagnostic(IG_ERROR, "ISO-0284", "nothing in this block uses {0}: check the spelling, or remove it"),
      ig::diagnostic(IG_WARNING, "ISO-0285", "nothing in this block uses {0}: check the spelling, or remove it"),
      ig::diagnostic(IG_ERROR, "ISO-0286", "{0} cannot be evaluated, so the word has no value and is not executed"),
      ig::diagnostic(IG_ERROR, "ISO-0287", "'{0}' is not executed"),
      ig::diagnostic(IG_NOTE, "ISO-0288", "'{0}' is not part of a program in this dialect and is ignored"),
      ig::diagnostic(IG_ERROR, "ISO-0545", "{0} moves nothing, because the machine has no axis {1}"),
  };

  ig::Signal said_{"Source.~UnknownCodeSaid", ig::read};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Name arc_{"McArc"};

  ig::Status build(ig::Block& b) {
    bool is_reported = b.is_raised(said_);  // the first unknown G code was reported with its words
    for (std::uint32_t i = 0; const auto left = leftover(b, i); ++i) {
      if (is_reported && left->kind == IG_LEFT_UNKNOWN && left->name.starts_with('G'))
        is_reported = false;
      else if (!belongs_to_leftover_code(b, *left) && !(b.is(form_, arc_) && is_idle_center(b, *left)))
        report(b, *left);
    }
    return ig::Status::unchanged;
  }

 private:
  /// "G84.Q" where G84 itself is left over: the report of the code covers its words.
  static bool belongs_to_leftover_code(const ig::Block& b, const Leftover& word) {
    const std::size_t dot = word.name.rfind('.');
    if (word.kind != IG_LEFT_WORD || dot == std::string::npos) return false;
    for (std::uint32_t i = 0; const auto left = leftover(b, i); ++i)
      if (left->kind == IG_LEFT_CODE && word.name.compare(0, dot, left->name) == 0) return true;
    return false;
  }

  /// K0 of an arc in the XY plane, which some post-processors write.
  static bool is_idle_center(const ig::Block& b, const Leftover& word) {
    const std::string_view source = b.source();
    return word.kind == IG_LEFT_WORD && (word.name == "I" || word.name == "J" || word.name == "K") &&
           word.begin < word.end && word.end <= source.size() &&
           source.substr(word.begin, word.end - word.begin).find_first_not_of("IJKijk+-.0 ") == std::string_view::npos;
  }
  static bool is_further_axis(std::string_view name) { return name == "U" || name == "V" || name == "W"; }

  static void report(ig::Block& b, const Leftover& left) {
    const auto where = ig::Where::columns(left.begin, left.end);
    const std::string_view name = left.name;
    const std::string_view source = b.source();
    const bool has_place = left.begin < left.end && left.end <= source.size();
    const std::string_view written = has_place ? source.substr(left.begin, left.end - left.begin) : name;
    const bool is_machine_function = name.starts_with('M');
    switch (left.kind) {
      case IG_LEFT_UNKNOWN:
        b.report(is_machine_function ? ig::diag("ISO-0281") : ig::diag("ISO-0280"), where, name);
        break;
      case IG_LEFT_CODE:
        b.report(is_machine_function ? ig::diag("ISO-0283") : ig::diag("ISO-0282"), where, name);
        break;
      case IG_LEFT_WORD:
        if (is_further_axis(name))
          b.report(ig::diag("ISO-0545"), where, written, name);
        else
          b.report(is_geometric(name) ? ig::diag("ISO-0284") : ig::diag("ISO-0285"), where, written);
        break;
      case IG_LEFT_EXPRESSION: b.report(ig::diag("ISO-0286"), where, written); break;
      case IG_LEFT_STATEMENT: b.report(ig::diag("ISO-0287"), where, written); break;
      default: b.report(ig::diag("ISO-0288"), where, written);
    }
  }
};

const ig::Register<UnconsumedCheck> unconsumed_check_syntax;

}  // namespace
}  // namespace iso
