#include "cycles/cycle_mode.hpp"

namespace iso {

namespace {

/// The place of a code among those of its block; 0 where the block does not hold it.
std::int64_t ordinal_of_code(const ig::Block& b, ig_field code) {
  ig_value v;
  return b.get(code, v) ? v.integer : 0;
}

}  // namespace

ActiveCycle CycleMode::enter_or_cancel(ig::Block& b, const CycleBlock& block, const CycleData& data) const {
  const CycleCalls& calls = block.calls();
  ActiveCycle out;
  const ig::Symbol before = data.term(b);
  if (before == data.cancelled()) {
    data.hide_cancelled(b);
    out.changed = true;
  }
  const bool was_on = before != ig::Symbol{} && before != data.cancelled();
  const auto called = b.find(calls);
  if (was_on && called) out.before = block.row_of(before);
  const auto motion = b.find(group01_);
  const bool has_g80 = b.take(g80_).has_value();
  const std::int64_t at_motion = motion ? ordinal_of_code(b, group01_.id(*motion)) : 0;
  const std::int64_t at_end = std::max(at_motion, has_g80 ? ordinal_of_code(b, g80_.id(0)) : 0);
  const std::int64_t at_call = called ? ordinal_of_code(b, calls.code(*called)) : 0;

  if (called && motion)
    b.report(ig::diag("ISO-0310"), ig::Where::word(calls.code(*called)), b.text(calls.name(*called)),
             b.text(group01_.name(*motion)), b.text(at_call > at_end ? calls.name(*called) : group01_.name(*motion)));
  if (has_g80 || (motion && was_on)) {
    data.cancel(b);
    out.changed = true;
  }
  if (called && at_call > at_end) {
    out.cycle = called;
    out.is_called = true;
    out.is_entry = !was_on || at_end > 0;
  } else if (called) {
    block.give_back(b, *called);
    out.changed = true;
  } else if (was_on && at_end == 0) {
    out.cycle = block.row_of(before);
  }
  return out;
}

}  // namespace iso
