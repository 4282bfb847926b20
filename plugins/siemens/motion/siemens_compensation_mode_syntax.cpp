/// How cutter radius compensation passes outer corners, comes to the contour and leaves it, and where F holds on arcs:
/// G groups 16, 17 and 18. RadiusCompensationPathSyntax makes the path from this state.
#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensCompensationMode {
  static constexpr auto spec =
      ig::syntax("SiemensCompensationModeSyntax", "G450, G451, NORM, KONT, CFC, CFTCP and CFIN under G41 and G42.")
          .after("SiemensWordSyntax", "ParameterizedFlagSyntax")
          .before("RadiusCompensationSyntax", "RadiusCompensationPathSyntax", "InertCodeSyntax");

  ig::Codes corners_{"G450", "G451"};
  ig::Codes ends_{"NORM", "KONT", "KONTT", "KONTC"};
  ig::Codes feeds_{"CFC", "CFTCP", "CFIN"};
  ig::Field<double> limit_{
      "RadiusCompensation.CornerLimit_deg",
      ig::read | ig::write,
      {ig::Life::modal, "deg", "Outer corners that bend by at most this are passed where the offsets cross."}};
  ig::Field<bool> goes_round_{
      "RadiusCompensation.GoesRoundEnds",
      ig::read | ig::write,
      {ig::Life::modal, "", "A tool behind the contour goes round its first and last point, not straight to it."}};
  ig::Field<ig::Symbol> feed_{"RadiusCompensation.FeedOnArcs",
                              ig::read | ig::write,
                              {ig::Life::modal, "", "Center, Contour or ContourInside: where F holds on an arc."}};
  ig::Name center_{"Center"}, inside_{"ContourInside"};
  ig::NumberOption corner_limit_{"corner-limit",
                                 "100",
                                 {0, 180},
                                 "deg",
                                 "Up to which bend G451 passes an outer corner where the offsets cross (MD 20210)."};

  ig::Status build(ig::Block& b) const {
    if (const auto corner = take_modal(b, corners_)) {
      if (*corner == 1)
        b.set(limit_, static_cast<double>(corner_limit_));
      else if (b.has(limit_))
        b.erase(limit_);
    }
    if (const auto end = take_modal(b, ends_)) set_ends(b, *end);
    if (const auto feed = take_modal(b, feeds_)) {
      if (*feed == 0 && b.has(feed_)) b.erase(feed_);
      if (*feed > 0) b.set(feed_, *feed == 1 ? center_ : inside_);
    }
    return ig::Status::changed;
  }

 private:
  void set_ends(ig::Block& b, std::size_t code) const {
    constexpr std::size_t kont = 1;
    if (code == kont)
      b.set(goes_round_, true);
    else if (b.has(goes_round_))
      b.erase(goes_round_);
    if (code > kont)
      b.report(ig::diag("SIE-0261"), ig::Where::word(ends_.id(code)), b.text(ends_.name(code)),
               std::string_view("the tool comes to the contour and leaves it on straight lines, as under NORM"));
  }
};

const ig::Register<SiemensCompensationMode> siemens_compensation_mode_syntax;

}  // namespace
}  // namespace siemens
