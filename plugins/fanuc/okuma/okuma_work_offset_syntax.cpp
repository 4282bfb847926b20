/// G15 H and G16 H of an Okuma: which work offset of the table is the program's origin, from now on or for one block.
#include <isogloss/cnc/coordinate_offset.hpp>
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/work_offset_id.hpp>
#include <isogloss/cnc/work_origin.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct OkumaWorkOffset {
  static constexpr auto spec =
      ig::syntax("OkumaWorkOffsetSyntax", "G15 H and G16 H of an Okuma select the work offset.")
          .after("ParameterizedFlagSyntax", "ToolHeightOffsetSyntax")
          .before("CannedCycleResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax", "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0250",
                     "{0} names no work offset of the table by its H, so the previous one stays in force"),
  };

  ig::Call codes_{{"G15", "G16"}, "H[]"};
  ig::Out<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  ig::Field<ig::Symbol> modal_id_{
      "CoordinateOffset.ModalId",
      ig::read | ig::write | ig::wake_while,
      {ig::Life::modal, "", "Under G16, the work offset that comes back with the next block."}};
  OffsetSection offset_{"CoordinateOffset"};
  RotaryOffsetSection rotary_{"CoordinateOffset"};
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::required, "The origins."};
  ig::Name none_{"G15"};

  ig::Status restart(ig::Block& b) {
    offset_.restore(b);
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const auto previous = b.get(modal_id_);
    if (previous) {
      b.erase(modal_id_);
      put_in_force(b, *previous);
    }
    const auto call = b.take(codes_);
    if (!call) return previous ? ig::Status::changed : ig::Status::unchanged;
    const ig::Symbol before = b.get_or(id_, static_cast<ig::Symbol>(none_));
    const auto h = (*call)['H'];
    const WorkOffsetId id = WorkOffsetId::additional(h.value_or(0));
    if (id.text().empty() || !linear_origin(table_, id.text())) {
      b.report(ig::diag("FAN-0250"), ig::Where::word(codes_.code(call->row)), b.text(call->code));
      return ig::Status::changed;
    }
    if (call->row == for_one_block) b.set(modal_id_, before);
    put_in_force(b, b.symbol(id.text()));
    return ig::Status::changed;
  }

 private:
  static constexpr std::size_t for_one_block = 1;  // of codes_

  /// Before the first G15 no work offset is in force; the name of the code stands for it.
  void put_in_force(ig::Block& b, ig::Symbol id) const {
    if (id == static_cast<ig::Symbol>(none_)) {
      b.erase(id_);
      offset_.set(b, {});
      rotary_.set(b, {});
      return;
    }
    const std::string_view name = b.text(id);
    b.set(id_, id);
    offset_.set(b, linear_program_origin(table_, name).value_or(ig::Vec3{}));
    rotary_.set(b, rotary_program_origin(table_, name));
  }
};

const ig::Register<OkumaWorkOffset> okuma_work_offset_syntax;

}  // namespace
}  // namespace fanuc
