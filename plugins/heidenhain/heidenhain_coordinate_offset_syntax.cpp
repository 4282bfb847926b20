// The origin of the program: CYCL DEF 247 selects a preset of the table, CYCL DEF 7 shifts the datum from there. Both
// act where they are defined; an axis that cycle 7 does not name keeps its shift.
#include <charconv>

#include "coordinate_offset_util.hpp"
#include "klartext_diagnostics.hpp"

namespace heidenhain {
namespace {

struct HeidenhainCoordinateOffset {
  static constexpr auto spec =
      ig::syntax("HeidenhainCoordinateOffsetSyntax", "CYCL DEF 247 presets and CYCL DEF 7 datum shifts.")
          .after("KlartextCycleSyntax", "UnitModeSyntax", "ToolHeightOffsetSyntax")
          .before("KlartextMotionSyntax", "KlartextDrillingCycleSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  ig::Word number_{"Parsing.DATUM_PRESET", ig::wake, ""};
  ig::Call datum_{{"DATUM", "IDATUM"}, "X Y Z A B C"};
  ig::Out<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  iso::OffsetSection local_{"LocalCoordinateOffset"};
  iso::OffsetSection offset_{"CoordinateOffset"};
  ig::In<ig::Symbol> tilt_{"TiltTransform.Term"};
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::required, "The presets."};
  ig::Name g68_2_{"G68.2"};

  ig::Status restart(ig::Block& b) {
    double origin[3] = {};
    const std::string_view id = b.text(b.get_or(id_, ig::Symbol{}));
    if (!id.empty()) table_->get(table_->self, ig::to_text(id), origin);
    offset_.set(b, {origin[0], origin[1], origin[2]});
    local_.restore(b);
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const bool selects = b.has(number_);
    if (selects) select(b);
    const bool shifts = b.find(datum_).has_value();
    if (shifts) shift(b);
    return shifts || selects ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void select(ig::Block& b) const {
    const auto where = ig::Where::word(number_.id());
    const double number = b.take(number_).value_or(0);
    std::array<char, 40> name{};
    constexpr std::string_view prefix = "DATUM_PRESET_";
    prefix.copy(name.data(), prefix.size());
    const bool is_number = number >= 0 && number < 1e9 && number == std::floor(number);
    char* const end = std::to_chars(name.data() + prefix.size(), name.data() + name.size(),
                                    is_number ? static_cast<std::int64_t>(number) : -1)
                          .ptr;
    const std::string_view id(name.data(), static_cast<std::size_t>(end - name.data()));
    double origin[3] = {};
    const ig::Symbol preset = b.symbol(id);
    if (table_->get(table_->self, ig::to_text(id), origin) == 0 && !b.is(id_, preset))
      b.report(hei("HEI-0174"), where, number);
    b.set(id_, preset);
    offset_.set(b, {origin[0], origin[1], origin[2]});
    local_.set(b, {});  // a preset cancels the shift
  }

  void shift(ig::Block& b) const {
    const ig::Vec3 old = local_.get(b);
    ig::Vec3 now = old;
    bool is_reset = true;
    for (std::size_t row = 0; row < 2; ++row) {
      ig_value v[6];
      const std::uint32_t named = b.host()->take_many(b.raw(), datum_.row(row), 6, v);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((named >> axis & 1u) != 0) {
          now[axis] = v[axis].number + (row == 1 ? old[axis] : 0);
          is_reset = is_reset && now[axis] == 0;
        }
      const bool turns = (named >> 3) != 0 && (v[3].number != 0 || v[4].number != 0 || v[5].number != 0);
      if (turns)
        b.report(hei("HEI-0161"), ig::Where::word(datum_.code(row)), 7.0,
                 std::string_view("the datum of a rotary axis stays"));
    }
    std::uint32_t found = 0;
    b.host()->take_code(b.raw(), datum_.codes(), datum_.code_count(), &found);
    if (b.is(tilt_, g68_2_) && !is_reset && now != old) {
      b.report(hei("HEI-0161"), ig::Where::block(), 7.0, std::string_view("in a tilted plane the datum stays"));
      return;
    }
    local_.set(b, now);
  }
};

const ig::Register<HeidenhainCoordinateOffset> registered;

}  // namespace
}  // namespace heidenhain
