/// G54 to G57, G505 to G599 and G500: which of the settable work offsets the program counts from. The base frame of the
/// table (BASE) is added to each; under G500 it is alone.
#include "coordinate_offset_util.hpp"
#include "rotary_offset_util.hpp"
#include "siemens_diagnostics.hpp"

namespace siemens {
namespace {

struct SiemensCoordinateOffset {
  static constexpr auto spec =
      ig::syntax("SiemensCoordinateOffsetSyntax", "G54-G57, G505-G599 and G500 select the work offset.")
          .after("SiemensToolOffsetSyntax")
          .before("SiemensCycleSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  static constexpr std::size_t further = 95;  // G505 to G599
  std::vector<ig_field> codes_ = declared_codes();
  std::vector<ig::Symbol> names_ = code_names();
  ig::Out<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  iso::OffsetSection offset_{"CoordinateOffset"};
  ig::Signal table_changed_{"CoordinateOffset.~TableChanged", ig::read | ig::wake};
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::required, "The origins."};
  ig::Name g500_{"G500"};

  ig::Status restart(ig::Block& b) {
    select(b, b.get_or(id_, static_cast<ig::Symbol>(g500_)), ig::Where::block());
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    std::uint32_t found = 0;
    const std::int32_t code =
        b.host()->take_code(b.raw(), codes_.data(), static_cast<std::uint32_t>(codes_.size()), &found);
    if (code >= 0) {
      select(b, names_[static_cast<std::size_t>(code)], ig::Where::word(codes_[static_cast<std::size_t>(code)]));
      return ig::Status::changed;
    }
    if (!b.is_raised(table_changed_)) return ig::Status::unchanged;
    select(b, b.get_or(id_, static_cast<ig::Symbol>(g500_)), ig::Where::block());
    return ig::Status::changed;
  }

 private:
  static std::string name_of(std::size_t i) {
    static constexpr std::array<std::string_view, 5> first{"G500", "G54", "G55", "G56", "G57"};
    return i < first.size() ? std::string(first[i]) : "G" + std::to_string(505 + i - first.size());
  }
  static std::vector<ig_field> declared_codes() {
    std::vector<ig_field> out;
    for (std::size_t i = 0; i < 5 + further; ++i) {
      const std::string name = name_of(i);
      out.push_back(ig::Codes({std::string_view(name)}).id(0));
    }
    return out;
  }
  static std::vector<ig::Symbol> code_names() {
    std::vector<ig::Symbol> out;
    for (std::size_t i = 0; i < 5 + further; ++i) out.push_back(ig::Name(name_of(i)));
    return out;
  }

  void select(ig::Block& b, ig::Symbol id, ig::Where where) const {
    double own[3] = {0, 0, 0}, base[3] = {0, 0, 0};
    if (id != g500_ && table_->get(table_->self, ig::to_text(b.text(id)), own) == 0) {
      b.report(diag("SIE-0211"), where, b.text(id));
      return;
    }
    if (table_->get(table_->self, ig::to_text("BASE"), base) == 0) base[0] = base[1] = base[2] = 0;
    for (const std::string_view row : {b.text(id), std::string_view("BASE")})
      if (const auto turned = iso::rotary_origin(table_, row); turned && *turned != iso::Angles{})
        b.report(diag("SIE-0300"), where, row);
    b.set(id_, id);
    offset_.set(b, {own[0] + base[0], own[1] + base[1], own[2] + base[2]});
  }
};

const ig::Register<SiemensCoordinateOffset> siemens_coordinate_offset_syntax;

}  // namespace
}  // namespace siemens
