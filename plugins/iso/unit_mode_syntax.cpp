/// G20/G21: inch or metric input. Stands first in the logic: in inch blocks it turns the lengths and feeds that the
/// block programs into mm, in place, so that nothing after it knows of inches.
#include <algorithm>
#include <cmath>

#include "cycle_codes.hpp"
#include "modal_group.hpp"
#include "repeat_count.hpp"

namespace iso {
namespace {

constexpr double mm_per_inch = 25.4;

struct UnitMode {
  static constexpr auto spec = ig::syntax("UnitModeSyntax", "G20/G21 inch or metric input; lengths become mm.")
                                   .after("ParameterizedFlagSyntax", "DecimalPointSyntax")
                                   .before("FeedrateSyntax", "CannedCycleResolveSyntax", "ProgramXyzSyntax");

  ig::Codes modes_{"G20", "G21"};
  ig::Fields lengths_{"lengths", "Parsing.**{mm} Parsing.**{mm/min}", ig::read | ig::write,
                      "The words that are lengths or feeds."};
  ig::Out<ig::Symbol> term_{"Unit.Term"};
  ig::InWhile<ig::Symbol> system_{"Unit.System", "Inch", ig::write};

  // F under G93 is a time, K of a repeated canned cycle a count: no lengths.
  ig::Codes feed_modes_{{"G93", "G94", "G95"}, ig::read};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  RepeatCount repeat_count_;
  CycleK cycle_k_;
  ig::Call cycle_ks_{cycle_codes, "K[1]", ig::read | ig::write};
  ig::Name inch_{"Inch"}, metric_{"Metric"}, g93_{"G93"};

  UnitMode() {
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      if (lengths_.unit(i) == "mm/min") feeds_.push_back(lengths_.id(i));
      if (lengths_.path(i) == "Parsing.K") k_ = lengths_.id(i);
    }
  }

  ig::Status build(ig::Block& b) {
    const auto mode = take_modal(b, modes_);
    if (mode) {
      b.set(term_, modes_.name(*mode));
      b.set(system_, *mode == 0 ? inch_ : metric_);
    }
    const bool converted = b.is(system_, inch_) && to_metric(b);
    return mode || converted ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool to_metric(ig::Block& b) const {
    const bool inverse_time = is_inverse_time(b);
    const bool k_is_count = !cycle_k_.is_length() && repeat_count_.is_k(b);
    bool any = false;
    for (std::uint32_t row = 0; row < cycle_ks_.code_count() && cycle_k_.is_length(); ++row) {
      const ig_field k = cycle_ks_.word(row, 'K');
      ig_value value;
      if (b.host()->get(b.raw(), k, &value) == 0) continue;
      any = true;
      if (const double mm = value.number * mm_per_inch; std::isfinite(mm))
        b.host()->rewrite(b.raw(), k, {.number = mm});
    }
    ig_value values[32];
    for (std::size_t at = 0; at < lengths_.size(); at += 32) {
      const auto n = static_cast<std::uint32_t>(std::min<std::size_t>(32, lengths_.size() - at));
      const ig_field* const ids = lengths_.ids() + at;
      const std::uint32_t found = b.host()->get_many(b.raw(), ids, n, values);
      for (std::uint32_t i = 0; i < n; ++i) {
        if ((found >> i & 1u) == 0) continue;
        if (k_is_count && ids[i] == k_) continue;
        if (inverse_time && std::find(feeds_.begin(), feeds_.end(), ids[i]) != feeds_.end()) continue;
        any = true;
        const double mm = values[i].number * mm_per_inch;
        if (std::isfinite(mm)) {
          b.host()->rewrite(b.raw(), ids[i], {.number = mm});
        } else {
          b.report(diag("ISO-0117"), ig::Where::word(ids[i]), lengths_.path(at + i).substr(8));  // "Parsing."
          b.host()->erase(b.raw(), ids[i]);
        }
      }
    }
    return any;
  }

  bool is_inverse_time(const ig::Block& b) const {
    const auto mode = b.find(feed_modes_);
    return mode ? feed_modes_.name(*mode) == g93_ : b.is(feed_mode_, g93_);
  }

  std::vector<ig_field> feeds_;
  ig_field k_ = IG_NO_FIELD;
};

const ig::Register<UnitMode> registered;

}  // namespace
}  // namespace iso
