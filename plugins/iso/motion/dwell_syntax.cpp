/// G04: dwell. The X, U or P of G04 is a time and belongs to G04, never to a move or to a hole. G04 alone is an exact
/// stop at the end of the block and takes no time.

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

enum class TimeUnit { seconds, milliseconds, by_point };

struct Dwell {
  static constexpr auto spec = ig::syntax("DwellSyntax", "G04 dwell.").after("ParameterizedFlagSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0215", "G04: a dwell of {0} s is negative, so the block does not dwell"),
      ig::diagnostic(IG_WARNING, "ISO-0216", "G04 has more than one dwell time: {0} is used, so remove the others"),
      ig::diagnostic(IG_WARNING, "ISO-0511",
                     "G04 has no dwell time, because F of this block is the feed rate: program X, U or P"),
      ig::diagnostic(IG_ERROR, "ISO-0543",
                     "X of this block belongs to {0} and moves nothing: program the dwell in a block of its own"),
  };

  ig::Call g04_{{"G04"}, "X[s] U[s] P[]"};
  ig::Codes motions_{{"G00", "G01", "G02", "G03"}, ig::read};
  ig::Out<double> time_{"Dwell.Time"};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  ig::Choice<TimeUnit> p_unit_{"p-unit", "s|ms|by-point", "s",
                               "The unit of P: seconds, milliseconds, or milliseconds only without a decimal point."};

  ig::Status build(ig::Block& b) {
    const double p_per_second = p_unit_ == TimeUnit::milliseconds || is_bare(b) ? 1000 : 1;
    const auto words = b.take(g04_);
    if (!words) return ig::Status::unchanged;
    const auto x = (*words)['X'], u = (*words)['U'], p = (*words)['P'];
    const double seconds = x ? *x : u ? *u : p ? *p / p_per_second : 0;
    if (x.has_value() + u.has_value() + p.has_value() > 1)
      b.report(ig::diag("ISO-0216"), ig::Where::word(g04_.code(0)), std::string_view(x ? "X" : "U"));
    if (x && p && b.find(motions_))
      b.report(ig::diag("ISO-0543"), ig::Where::word(g04_.word(0, 'X')), b.text(words->code));
    if (seconds < 0) {
      b.report(ig::diag("ISO-0215"), ig::Where::word(g04_.code(0)), seconds);
    } else if (x || u || p) {
      b.set(time_, seconds);
    } else if (b.is_fresh(feed_)) {
      b.report(ig::diag("ISO-0511"), ig::Where::word(g04_.code(0)));
    }
    return ig::Status::changed;
  }

 private:
  bool is_bare(const ig::Block& b) const {
    if (p_unit_ != TimeUnit::by_point) return false;
    ig_word word{};
    b.word(g04_.word(0, 'P'), word);
    return (word.flags & IG_WORD_WITHOUT_POINT) != 0;
  }
};

const ig::Register<Dwell> dwell_syntax;

}  // namespace
}  // namespace iso
