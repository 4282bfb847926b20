/// #4001 to #4330: the codes and the words that are in force.
#include "macro/macro_environment.hpp"

namespace fanuc {

using namespace ig::cnc;

Fault MacroEnvironment::modal(const ig::Block& b, std::uint32_t n, double& out) const {
  const auto of = [&](double value) {
    out = value;
    return Fault::none;
  };
  switch (n) {
    case 4001: return of(code(b, motion_, 0));
    case 4002: return of(code(b, plane_, 17));
    case 4003: return of(code(b, positioning_, 90));
    case 4004: return of(23);
    case 4005: return of(code(b, feed_mode_, 94));
    case 4006: return of(code(b, unit_, 21));
    case 4007: return of(code(b, radius_term_, 40));
    case 4008: return of(code(b, length_term_, 49));
    case 4009: return of(code(b, cycle_, 80));
    case 4010: return of(code(b, return_mode_, 98));
    case 4011: return of(code(b, scaling_, 50));
    case 4012: return of(store().settings.offset_in_12 ? work_offset_code(b) : modal_call());
    case 4013: return of(code(b, surface_speed_, 97));
    case 4014: return of(work_offset_code(b));
    case 4015: return of(code(b, path_mode_, 64));
    case 4016: return of(code(b, tilt_, 69));
    case 4017: return of(code(b, polar_, 15));
    case 4022: return of(code(b, mirror_, 50.1));
    case 4107: return of(static_cast<double>(b.get_or(radius_row_, std::int64_t{0})));
    case 4109: return of(in_program_unit(b, b.get_or(feed_, 0.0)));
    case 4111: return of(static_cast<double>(b.get_or(length_row_, std::int64_t{0})));
    case 4113: return passed(b, PassedCodes::m, out);
    case 4114: return passed(b, PassedCodes::n, out);
    case 4115: return program_in_force(b, out);
    case 4119: return of(b.get_or(speed_, 0.0));
    case 4120: return of(static_cast<double>(b.get_or(tool_, std::int64_t{0})));
    case 4130: return of(additional_set(b));
    default: return Fault::not_known_here;
  }
}

double MacroEnvironment::code(const ig::Block& b, const ig::Field<ig::Symbol>& field, double otherwise) const {
  const auto symbol = b.get(field);
  if (!symbol) return otherwise;
  const std::string_view text = b.text(*symbol);
  if (text.size() < 2) return otherwise;
  const ig::Decimal d = ig::read_decimal(text, 1);
  return d.ok ? d.value : otherwise;
}

/// 54 to 59 and 54.1, or the code that selected the set in another way: 110 to 129 and 154 of a Haas.
double MacroEnvironment::work_offset_code(const ig::Block& b) const {
  return b.has(work_offset_code_) ? code(b, work_offset_code_, 54) : code(b, work_offset_, 54);
}

double MacroEnvironment::modal_call() const {
  const std::vector<MacroStore::ModalCall>& calls = store().modal_calls();
  if (calls.empty()) return 67;
  return calls.back().each_block ? 66.1 : 66;
}

Fault MacroEnvironment::passed(const ig::Block& b, PassedCodes::Which which, double& out) const {
  const auto number = passed_.of_blocks_before(b, store(), which);
  out = number.value_or(0);
  return number ? Fault::none : Fault::not_known_here;
}

Fault MacroEnvironment::program_in_force(const ig::Block& b, double& out) const {
  const ig_frame frame = flow.frame(b);
  const auto number = frame.depth == 0 ? store().main_program : program_number(ig::to_view(frame.program));
  out = number.value_or(0);
  return number ? Fault::none : Fault::not_known_here;
}

double MacroEnvironment::additional_set(const ig::Block& b) const {
  const auto symbol = b.get(work_offset_);
  if (!symbol) return 0;
  const std::string_view text = b.text(*symbol);
  if (!text.starts_with("G54.1P")) return 0;
  return ig::read_decimal(text, 6).value;
}

}  // namespace fanuc
