// What a number without a decimal point means. Conventional controls read it in least input increments (X1000 is 1 mm),
// calculator-type input reads it in units (X1000 is 1000 mm); a parameter of the control selects one. Lengths, angles
// and the time of a dwell's X are concerned, and by an option of its own F, never P and plain counts. A missing point
// gets a warning under both types, since the same program means two things.
#include <cmath>

#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/cnc/cycle_letters.hpp>
#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/sdk.hpp>

#include "reading/owned_words.hpp"
#include "reading/unit_codes.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class Rule { as_written, increment, calculator, parameter };
enum class Resolution { keep, increment };
enum class Feed { units, parameter };
enum class Quantity { other, length, angle, time, feed };

struct DecimalPointSyntax {
  static constexpr auto spec =
      ig::syntax("DecimalPointSyntax", "Reads numbers without a decimal point in the way the control is set.")
          .after("WordSyntax", "ParameterizedFlagSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0115", "{0}{1} has no decimal point: read as {2} {3}"),
  };

  ig::Choice<Rule> rule{"rule", "as-written|increment|calculator|parameter", "as-written",
                        "What a number without a point means: units as written, least increments, units with a "
                        "warning, or what the parameters of the control decide."};
  ig::Choice<Resolution> resolution{"resolution", "keep|increment", "keep",
                                    "Digits finer than the increment: kept, or truncated like on the control."};
  ig::Choice<Feed> feed_rule{"feed", "units|parameter", "units",
                             "What F without a point counts: whole units, or the increments of the parameters."};
  ig::NumberOption length_increment{"length-increment", "0.001", {1e-9, 1}, "mm", "Least input increment, metric."};
  ig::NumberOption inch_increment{"inch-increment", "0.0001", {1e-9, 1}, "in", "Least input increment, inch."};
  ig::NumberOption angle_increment{"angle-increment", "0.001", {1e-9, 1}, "deg", "Least input increment, rotary."};
  ig::Config number_format{"isogloss.number-format/1", ig::Need::optional,
                           "The parameters that decide with rule=\"parameter\"."};

  ig::Signal without_point{"Parsing.~WithoutPoint", ig::read | ig::wake};
  ig::Signal feed_without_point{"Parsing.~FeedWithoutPoint", ig::read | ig::wake};
  ig::Signal fine_digits{"Parsing.~FineDigits", ig::read | ig::wake};
  ig::Signal cuts_digits{"Parsing.~CutsDigits", ig::write, ig::Life::modal};
  UnitCodes units{ig::read};
  ig::In<ig::Symbol> system{"Unit.System"};
  ig::Name inch{"Inch"};
  ig::Codes feed_codes{{"G93", "G94", "G95"}, ig::read};
  ig::In<ig::Symbol> feed_mode{"Feedrate.Term"};
  ig::Name g93{"G93"}, g95{"G95"};
  ig::Fields addresses{"addresses", "Parsing.?", ig::read | ig::write, "The words of the block."};
  ig::Fields codes{"codes", "Parsing.*", ig::read, "The codes that may own words.", IG_CODE};
  ig::Fields words{"words", "Parsing.*.?", ig::read | ig::write, "The words that they own."};

  struct Row {
    ig_field code = IG_NO_FIELD;
    std::vector<ig_field> words;
    std::vector<char> letters;
    std::vector<Quantity> quantities;
    std::vector<std::string> names{};  // of further axes, in place of letters
  };
  AxisNames axes;
  CycleK cycle_k;
  TappingJ tapping_j;
  Row block = measured(row_of_block(addresses));
  Row cycle_block = cycle_k.is_length() ? block : without('K', block);
  Row tapping_block = without('J', cycle_block);
  Row further = row_of_further_axes();
  CycleInForce cycle;
  bool changes_nothing = rule == Rule::as_written && resolution == Resolution::keep && feed_rule == Feed::units;
  std::vector<Row> rows = changes_nothing ? std::vector<Row>() : measured(rows_of(codes, words));

  /// Increments per unit; exact where the increment is a power of ten.
  struct Steps {
    double mm, inch, deg;
  };
  /// What F1 means in each mode.
  struct FeedUnits {
    double per_minute_mm, per_minute_inch, per_revolution_mm, per_revolution_inch, inverse_time;
  };
  Steps steps{steps_of("LengthIncrement_mm", length_increment), steps_of("LengthIncrement_inch", inch_increment),
              steps_of("AngleIncrement_deg", angle_increment)};
  bool counts_increments = rule == Rule::increment ||
                           (rule == Rule::parameter && number_format.number("CalculatorDecimalPoint").value_or(0) == 0);

  FeedUnits feed_units{feed_of("FeedIncrement_mm", 1), feed_of("FeedIncrement_inch", 0.01),
                       feed_of("RevolutionFeedIncrement_mm", 0.01), feed_of("RevolutionFeedIncrement_inch", 0.0001),
                       feed_of("InverseTimeIncrement", counts_increments ? 0.001 : 1)};

  DecimalPointSyntax() {
    if (changes_nothing) ig::stay_idle();
  }

  /// Most controls keep fine digits, and many programs are full of them: where none are cut, the syntax does not wake.
  ig::Status restart(ig::Block& b) const {
    if (resolution == Resolution::keep) return ig::Status::unchanged;
    b.raise(cuts_digits);
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) const {
    if (changes_nothing) return ig::Status::unchanged;
    bool changed = read_row(b, !cycle.is_on(b) ? block : tapping_j.is_ratio(b) ? tapping_block : cycle_block);
    if (!further.words.empty()) changed |= read_row(b, further);
    for (const Row& row : rows) {
      ig_value present;
      if (b.get(row.code, present)) changed |= read_row(b, row);
    }
    return changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  Quantity quantity_of(char letter, std::string_view unit) const {
    const auto axis = axes.find({&letter, 1});
    if (unit == "mm" && axis && is_further_axis(*axis) && axes.is_rotary(*axis)) return Quantity::angle;
    if (letter == 'P') return Quantity::other;  // an integer in every use: milliseconds, a count, a number
    return unit == "mm"                                       ? Quantity::length
           : unit == "deg"                                    ? Quantity::angle
           : unit == "s"                                      ? Quantity::time
           : unit == "mm/min" && feed_rule == Feed::parameter ? Quantity::feed
                                                              : Quantity::other;
  }

  /// Words with the name of an axis, C2=90., have fields of their own.
  Row row_of_further_axes() const {
    Row out;
    for (std::uint32_t axis = first_further_axis; is_further_axis(axis); ++axis) {
      const ig_field field = ig::Field<double>("Parsing.FurtherAxis" + std::to_string(axis - first_further_axis + 1),
                                               ig::read | ig::write, {ig::Life::word, "", ""})
                                 .id();
      if (axes.name(axis).empty()) continue;
      out.words.push_back(field);
      out.quantities.push_back(axes.is_rotary(axis) ? Quantity::angle : Quantity::length);
      out.names.push_back(std::string(axes.name(axis)) + (axes.name(axis).size() > 1 ? "=" : ""));
    }
    return out;
  }

  Row measured(const WordRow& source) const {
    Row out{source.code, {}, {}, {}, {}};
    for (std::size_t i = 0; i < source.words.size(); ++i) {
      const bool is_cycle_k = cycle_k.is_length() && source.letters[i] == 'K' && source.units[i] == "1";
      const Quantity quantity = is_cycle_k ? Quantity::length : quantity_of(source.letters[i], source.units[i]);
      if (quantity == Quantity::other) continue;
      out.words.push_back(source.words[i]);
      out.letters.push_back(source.letters[i]);
      out.quantities.push_back(quantity);
    }
    return out;
  }
  std::vector<Row> measured(const std::vector<WordRow>& source) const {
    std::vector<Row> out;
    for (const WordRow& row : source) {
      Row r = measured(row);
      if (tapping_j.is_ratio() && is_tapping(row.code)) r = without('J', std::move(r));
      if (!r.words.empty()) out.push_back(std::move(r));
    }
    return out;
  }

  bool is_tapping(ig_field code) const {
    for (std::size_t i = 0; i < codes.size(); ++i)
      if (codes.id(i) == code)
        return std::find(TappingJ::cycles.begin(), TappingJ::cycles.end(), ig::word_name(codes.path(i))) !=
               TappingJ::cycles.end();
    return false;
  }

  static Row without(char letter, Row row) {
    const auto found = std::find(row.letters.begin(), row.letters.end(), letter);
    if (found == row.letters.end()) return row;
    const auto at = found - row.letters.begin();
    row.words.erase(row.words.begin() + at);
    row.letters.erase(found);
    row.quantities.erase(row.quantities.begin() + at);
    return row;
  }

  double steps_of(std::string_view name, double fallback) const {
    const double increment = rule == Rule::parameter ? number_format.number(name).value_or(fallback) : fallback;
    return count_of(increment);
  }
  /// How many of them are one unit.
  static double count_of(double increment) {
    const double count = 1 / increment;
    return std::abs(count - std::round(count)) < 1e-6 * count ? std::round(count) : count;
  }

  double feed_of(std::string_view name, double fallback) const { return number_format.number(name).value_or(fallback); }

  bool is_inch(const ig::Block& b) const {
    const auto code = units.find(b);
    return code ? code->is_inch : b.is(system, inch);
  }

  bool read_row(ig::Block& b, const Row& row) const {
    std::array<ig_value, 32> values;
    std::uint32_t present = b.get_many(row.words.data(), static_cast<std::uint32_t>(row.words.size()), values.data());
    bool changed = false;
    for (; present != 0; present &= present - 1) {
      const std::size_t i = static_cast<std::size_t>(std::countr_zero(present));
      ig_word word{};
      b.word(row.words[i], word);  // its mark is needed; it may have no place
      changed |= (word.flags & IG_WORD_WITHOUT_POINT) != 0 ? read_bare(b, row, i, values[i].number)
                                                           : read_pointed(b, row, i, values[i].number);
    }
    return changed;
  }

  double steps_for(const ig::Block& b, Quantity quantity) const {
    if (quantity == Quantity::angle) return steps.deg;
    return quantity == Quantity::length && is_inch(b) ? steps.inch : steps.mm;  // 0.001 mm corresponds to 0.001 s
  }

  bool read_bare(ig::Block& b, const Row& row, std::size_t i, double number) const {
    const Quantity quantity = row.quantities[i];
    if (quantity == Quantity::feed) return read_bare_feed(b, row.words[i], number);
    if (rule == Rule::as_written || number == 0) return false;
    const double value = counts_increments ? number / steps_for(b, quantity) : number;
    const std::string_view unit = quantity == Quantity::angle  ? "deg"
                                  : quantity == Quantity::time ? "s"
                                  : is_inch(b)                 ? "in"
                                                               : "mm";
    const std::string_view name = row.names.empty() ? std::string_view(&row.letters[i], 1) : row.names[i];
    b.report(ig::diag("ISO-0115"), ig::Where::word(row.words[i]), name, number, value, unit);
    b.rewrite(row.words[i], value);
    return value != number;
  }

  bool read_bare_feed(ig::Block& b, ig_field word, double number) const {
    const auto code = b.find(feed_codes);
    const ig::Symbol mode = code ? feed_codes.name(*code) : b.get_or(feed_mode, ig::Symbol{});
    const bool in_inches = is_inch(b), per_revolution = mode == g95;
    const double unit = mode == g93      ? feed_units.inverse_time
                        : per_revolution ? (in_inches ? feed_units.per_revolution_inch : feed_units.per_revolution_mm)
                                         : (in_inches ? feed_units.per_minute_inch : feed_units.per_minute_mm);
    if (unit == 1 || number == 0) return false;
    const double value = number / count_of(unit);
    b.report(ig::diag("ISO-0115"), ig::Where::word(word), std::string_view("F"), number, value,
             std::string_view(mode == g93      ? "1/min"
                              : per_revolution ? (in_inches ? "in/rev" : "mm/rev")
                                               : (in_inches ? "in/min" : "mm/min")));
    b.rewrite(word, value);
    return true;
  }

  /// Cuts off digits below the increment, toward zero.
  bool read_pointed(ig::Block& b, const Row& row, std::size_t i, double number) const {
    if (resolution == Resolution::keep || row.quantities[i] == Quantity::feed) return false;
    const double step = steps_for(b, row.quantities[i]);
    const double count = number * step;
    const double nearest = std::round(count);
    if (std::abs(count - nearest) < 1e-6) return false;
    b.rewrite(row.words[i], std::trunc(count) / step);
    return true;
  }
};

const ig::Register<DecimalPointSyntax> decimal_point_syntax;

}  // namespace
}  // namespace iso
