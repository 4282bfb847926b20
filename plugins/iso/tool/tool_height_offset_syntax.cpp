/// G43, G44, G49 and H: tool length compensation, between the programmed point and the machine coordinates. G43 adds
/// the length of row H (geometry and wear) along the tool axis, G44 subtracts it, G49 and H0 end it. H is modal: a new
/// H under G43 is a new length.
#include <algorithm>

#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/sdk.hpp>

#include "tool/tool_length.hpp"
#include "tool/untravelled_length.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class RotatedAxis { follow, keep };
enum class LengthUnderG91 { position, travel };

struct ToolHeightOffset {
  static constexpr auto spec =
      ig::syntax("ToolHeightOffsetSyntax", "G43/G44/G49 and H: tool length compensation.")
          .after("ParameterizedFlagSyntax")
          .before("IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "ISO-0512",
                     "H{0} without G43 or G44: the number is kept, but no tool length is in force"),
  };

  ig::Call codes_{{"G43", "G44", "G49"}, "H[]"};
  ig::Word h_{"Parsing.H", ig::wake, ""};
  ig::Out<ig::Symbol> term_{"ToolHeightCompensation.Term"};
  ig::Out<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Out<double> offset_{"ToolHeightCompensation.Offset_mm"};
  ig::Xyz orientation_{"ToolOrientation", ig::read | ig::wake};
  ig::Transform tilt_{"TiltTransform", ig::read | ig::wake};
  ig::Transform frame_{"ToolHeightCompensation"};
  ig::Signal table_changed_{"ToolHeightCompensation.~TableChanged", ig::read | ig::wake};
  ig::In<double> delta_{"ToolHeightCompensation.Delta_mm",
                        ig::read,
                        {ig::Life::modal, "mm", "What the tool call adds to the length of the table."}};
  ToolLengths lengths_{ig::Need::required};
  /// Lengths put in force by blocks without Z: the next Z word under G91 travels them too.
  ig::Field<double> untravelled_ = untravelled_length(ig::read | ig::write | ig::wake_while);
  ig::Word z_{"Parsing.Z", ig::read};
  ig::Call returns_{{"G27", "G28", "G29", "G30"}, "Z", ig::read};
  CycleCalls cycles_{"X Y Z R", ig::read};
  CycleInForce cycle_;
  std::array<ig::Word, 6> places_{ig::Word{"Parsing.X", ig::read},        ig::Word{"Parsing.Y", ig::read},
                                  ig::Word{"Parsing.R", ig::read},        ig::Word{"Parsing.A", ig::read, "deg"},
                                  ig::Word{"Parsing.B", ig::read, "deg"}, ig::Word{"Parsing.C", ig::read, "deg"}};
  DistanceMode distance_;
  ig::Name g43_{"G43"}, g44_{"G44"}, g49_{"G49"};

  ig::Choice<RotatedAxis> rotated_axis_{
      "rotated-axis", "follow|keep", "follow",
      "Direction of the length in a rotated or tilted system before G53.1: along its Z, or along Z of the workpiece."};
  ig::Choice<LengthUnderG91> under_g91_{
      "under-g91", "position|travel", "position",
      "A new length under G91: a new position of the resting tool, or a move that is added "
      "to the next increment of Z."};

  ig::Status restart(ig::Block& b) {
    if (is_active(b)) {
      compensate(b, ig::Where::block());
    } else {
      b.set_translation(frame_, {});
    }
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const auto call = b.take(codes_);
    auto h = b.take(h_);
    if (call && (*call)['H']) h = (*call)['H'];
    if (call) b.set(term_, call->code);
    const auto where = call ? ig::Where::word(codes_.code(call->row))
                       : h  ? ig::Where::word(h_.id())
                            : ig::Where::block();
    if (h) set_offset_id(b, *h, where);
    if (h && !call && *h > 0 && !is_active(b) && b.has(offset_id_)) b.report(ig::diag("ISO-0512"), where, *h);
    const double before = b.get_or(offset_, 0.0);

    if (call && call->code == g49_) {
      b.set(offset_, 0.0);
      b.set_translation(frame_, {});
      travel(b, -before);
      return ig::Status::changed;
    }
    if (call && !b.has(offset_id_)) {
      b.report(ig::diag("ISO-0224"), where, b.text(call->code));
      b.set(offset_id_, std::int64_t{0});
    }
    const bool axis_moved = b.is_fresh(orientation_) || b.is_fresh(tilt_);
    const bool compensates = is_active(b) && (call || h || axis_moved || b.is_raised(table_changed_));
    if (compensates) compensate(b, where);
    const bool travels = travel(b, call || h ? b.get_or(offset_, 0.0) - before : 0);
    return call || h || compensates || travels ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool is_active(const ig::Block& b) const { return b.is(term_, g43_) || b.is(term_, g44_); }

  void set_offset_id(ig::Block& b, double h, ig::Where where) const {
    if (const auto row = ToolLengths::row(b, h, where)) b.set(offset_id_, *row);
  }

  void compensate(ig::Block& b, ig::Where where) const {
    const double length = lengths_.length(b, b.get_or(offset_id_, std::int64_t{0}), where) + b.get_or(delta_, 0.0);
    const double signed_length = b.is(term_, g44_) ? -length : length;
    b.set(offset_, signed_length);
    b.set_translation(frame_, signed_length * tool_axis(b));
  }

  /// Example of the manual: with H1 = -4, `G91 G43 H1 Z-32.` moves by -36. IncrementalResolveSyntax adds to the words
  /// what is pending; a move to a position has no use for it. True when something was written.
  bool travel(ig::Block& b, double change) const {
    if (under_g91_ == LengthUnderG91::position) return false;
    const double pending = b.get_or(untravelled_, 0.0) + change;
    if (pending == 0 && !b.has(untravelled_)) return false;
    const bool goes_to_position = (b.has(z_) && !distance_.is_incremental(b)) || drills(b) || returns_along_z(b);
    if (pending != 0 && !goes_to_position && tool_axis(b) == ig::Vec3{0, 0, 1})
      b.set(untravelled_, pending);
    else
      b.erase(untravelled_);
    return true;
  }

  bool returns_along_z(const ig::Block& b) const {
    const auto row = b.find(returns_);
    ig_value unused;
    return row && b.get(returns_.word(*row, 'Z'), unused);
  }
  /// The tool goes to the levels of a hole, in its new length.
  bool drills(const ig::Block& b) const {
    const auto row = b.find(cycles_);
    ig_value unused[4];
    if (row && b.get_many(cycles_.row(*row), 4, unused) != 0) return true;
    const auto is_named = [&](const ig::Word& word) { return b.has(word); };
    return (row || cycle_.is_on(b)) && (b.has(z_) || std::any_of(places_.begin(), places_.end(), is_named));
  }

  /// The tool axis: ToolOrientation where G53.1 has turned the tool, else Z of the rotated system or of the machine.
  ig::Vec3 tool_axis(const ig::Block& b) const {
    const ig::PartialVec3 orientation = b.get(orientation_);
    if (orientation.complete()) return orientation.value;
    if (rotated_axis_ == RotatedAxis::keep) return {0, 0, 1};
    double m[16];
    if (b.get(tilt_, m)) return {m[8], m[9], m[10]};
    return {0, 0, 1};
  }
};

const ig::Register<ToolHeightOffset> tool_height_offset_syntax;

}  // namespace
}  // namespace iso
