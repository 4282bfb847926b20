/// G54 to G59.9 and G54.1 P: which work offset of the table is the program's origin. The external offset of the table
/// (EXT) is added to each, for rotary axes too. The table is read when a code selects an offset and after G10 has
/// written into it.
#include <isogloss/cnc/coordinate_offset.hpp>
#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/work_offset_id.hpp>
#include <isogloss/cnc/work_origin.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

enum class DecimalSets { available, absent };
enum class FurtherSets { absent, g110_g154 };
enum class G54P { additional, all_sets };

struct IsoCoordinateOffset {
  static constexpr auto spec =
      ig::syntax("IsoCoordinateOffsetSyntax", "G54-G59.9 and G54.1 P select the work coordinate system.")
          .after("ParameterizedFlagSyntax", "IsoLocalCoordinateOffsetSyntax")
          .before("CannedCycleResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0226", "there is no work offset {0}: {1} stays in force"),
      ig::diagnostic(IG_NOTE, "ISO-0356", "{0} without P: P1 is assumed"),
      ig::diagnostic(IG_ERROR, "ISO-0367", "this control has no work offset {0}: {1} stays in force"),
      ig::diagnostic(IG_NOTE, "ISO-0368", "G54.1 without P: P1 is assumed"),
  };

  ig::Codes sets_{"G54",   "G55",   "G56",   "G57",   "G58",   "G59",   "G59.1", "G59.2",
                  "G59.3", "G59.4", "G59.5", "G59.6", "G59.7", "G59.8", "G59.9", "G54.1"};
  ig::Codes further_{"G110", "G111", "G112", "G113", "G114", "G115", "G116", "G117", "G118", "G119", "G120",
                     "G121", "G122", "G123", "G124", "G125", "G126", "G127", "G128", "G129", "G154"};
  ig::Call additional_{{"G54.1"}, "P[]"};
  ig::Call by_p_{{"G154"}, "P[]"};
  ig::Word p_{"Parsing.P", ig::read, ""};
  CycleInForce cycle_;
  ig::Out<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  ig::Field<ig::Symbol> further_term_{
      "CoordinateOffset.Term",
      ig::read | ig::write,
      {ig::Life::modal, "", "The code that selected a set of G154: G154, or G110 to G129. Absent under other codes."}};
  OffsetSection offset_{"CoordinateOffset"};
  RotaryOffsetSection rotary_{"CoordinateOffset"};
  ig::Signal table_changed_{"CoordinateOffset.~TableChanged", ig::read | ig::wake};
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::required, "The origins."};
  ig::Name g54_{"G54"};
  ig::Choice<DecimalSets> decimal_sets_{"decimal-sets", "available|absent", "available",
                                        "Whether the control has G59.1 to G59.9; if not, they are errors."};

  ig::Choice<FurtherSets> further_sets_{"further-sets", "absent|G110-G154", "absent",
                                        "Whether the control has G154 P1 and up, with G110 to G129 as P1 to P20; if "
                                        "not, this syntax does not read them."};

  ig::Choice<G54P> g54_p_{
      "g54-p", "additional|all-sets", "additional",
      "What P of G54 counts: the sets of G54.1, or all sets, from P1 (G54 itself) to P7 (G59.1) and on."};

  ig::Status restart(ig::Block& b) {
    select(b, b.text(selected(b)), ig::Where::block());
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    if (const auto code = take_modal(b, sets_)) {
      const ig::Symbol name = sets_.name(*code);
      const auto where = ig::Where::word(sets_.id(*code));
      if (decimal_sets_ == DecimalSets::absent && *code >= first_decimal && *code <= last_decimal) {
        b.report(ig::diag("ISO-0367"), where, b.text(name), b.text(selected(b)));
        return ig::Status::changed;
      }
      const auto number = set_number(b, *code);
      const bool is_of_all = number && *code == plain && g54_p_ == G54P::all_sets && *number != 0;
      const WorkOffsetId id = is_of_all ? WorkOffsetId::of_all(*number) : WorkOffsetId::additional(number.value_or(0));
      if (select(b, number ? id.text() : b.text(name), where) && b.has(further_term_)) b.erase(further_term_);
      return ig::Status::changed;
    }
    if (further_sets_ == FurtherSets::g110_g154)
      if (const auto code = take_modal(b, further_)) {
        if (select(b, WorkOffsetId::additional(further_number(b, *code)).text(), ig::Where::word(further_.id(*code))))
          b.set(further_term_, further_.name(*code));
        return ig::Status::changed;
      }
    if (!b.is_raised(table_changed_)) return ig::Status::unchanged;
    select(b, b.text(selected(b)), ig::Where::block());
    return ig::Status::changed;
  }

 private:
  static constexpr std::size_t first_decimal = 6, last_decimal = 14, plain = 0, g54_1 = 15;  // of sets_
  static constexpr std::size_t g154 = 20;                                                    // of further_

  ig::Symbol selected(const ig::Block& b) const { return b.get_or(id_, static_cast<ig::Symbol>(g54_)); }

  /// G110 to G129 are P1 to P20 of G154. G154 without P is P1.
  double further_number(ig::Block& b, std::size_t code) const {
    if (code != g154) return static_cast<double>(code + 1);
    const auto words = b.take(by_p_);
    const auto p = words ? (*words)['P'] : std::nullopt;
    if (!p) b.report(ig::diag("ISO-0356"), ig::Where::word(by_p_.code(0)), b.text(by_p_.name(0)));
    return p.value_or(1);
  }

  /// G54.1 without P is P1. G54 P2 is G54.1 P2 (or, by option, G55), unless the P belongs to a canned cycle.
  std::optional<double> set_number(ig::Block& b, std::size_t code) const {
    if (code == g54_1) {
      const auto words = b.take(additional_);
      const auto p = words ? (*words)['P'] : std::nullopt;
      if (!p) b.report(ig::diag("ISO-0368"), ig::Where::word(additional_.code(0)));
      return p.value_or(1);
    }
    if (code == plain && !cycle_.is_on(b)) return b.take(p_);
    return std::nullopt;
  }

  /// False where the table has no such set.
  bool select(ig::Block& b, std::string_view id, ig::Where where) const {
    const auto origin = id.empty() ? std::nullopt : linear_program_origin(table_, id);
    if (!origin) {
      b.report(ig::diag("ISO-0226"), where, id.empty() ? std::string_view("of that number") : id, b.text(selected(b)));
      return false;
    }
    rotary_.set(b, rotary_program_origin(table_, id));
    b.set(id_, b.symbol(id));
    offset_.set(b, *origin);
    return true;
  }
};

const ig::Register<IsoCoordinateOffset> iso_coordinate_offset_syntax;

}  // namespace
}  // namespace iso
