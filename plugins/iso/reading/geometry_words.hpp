/// The words on which polar coordinates, scaling and mirror image act, wherever they are: in the block itself or in its
/// canned cycle.
#pragma once

#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

class GeometryWords {
 public:
  struct Here {
    const ig_field* axes;  ///< X Y Z
    ig_field r;            ///< the R level of a cycle, else the radius of an arc
    bool is_cycle;
  };

  /// Nothing in a block whose axis words are machine coordinates (G53).
  std::optional<Here> find(const ig::Block& b) const {
    if (b.find(machine_select_)) return std::nullopt;
    if (const auto row = b.find(cycles_)) return Here{cycles_.row(*row), cycles_.word(*row, 'R'), true};
    return Here{axes_.ids(), r_.id(), cycle_.is_on(b)};
  }
  /// I, J and K of an arc.
  const std::array<ig_field, 3>& centers() const { return centers_; }

  static std::optional<double> get(const ig::Block& b, ig_field word) {
    ig_value v;
    return b.get(word, v) ? std::optional(v.number) : std::nullopt;
  }
  static void rewrite(ig::Block& b, ig_field word, double value) { b.rewrite(word, value); }

  /// Reports codes that the control forbids while `term` is in force; their words are not changed.
  void report_untouched(ig::Block& b, ig::Symbol term) const {
    const auto code = b.find(untouched_);
    if (code)
      b.report(ig::diag("ISO-0383"), ig::Where::word(untouched_.id(*code)), b.text(untouched_.name(*code)),
               b.text(term));
  }

 private:
  CycleCalls cycles_{"X Y Z R", ig::read | ig::write};
  ig::Xyz axes_{"Parsing", ig::read | ig::write};
  ig::Word r_{"Parsing.R", ig::read | ig::write};
  std::array<ig_field, 3> centers_{ig::Word("Parsing.I", ig::read | ig::write).id(),
                                   ig::Word("Parsing.J", ig::read | ig::write).id(),
                                   ig::Word("Parsing.K", ig::read | ig::write).id()};
  ig::Codes machine_select_{{"G53"}, ig::read};
  ig::Codes untouched_{{"G27", "G28", "G29", "G30", "G52", "G53", "G92"}, ig::read};
  CycleInForce cycle_;
};

}  // namespace iso
