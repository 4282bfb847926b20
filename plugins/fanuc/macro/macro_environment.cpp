/// Variables of any number: the stored ones, and where those of the control stand; and why an expression has no value.
#include "macro/macro_environment.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace fanuc {

using namespace ig::cnc;

Fault MacroEnvironment::read(ig::Block& b, std::uint32_t number, MacroValue& out) const {
  if (const double* const stored = store().find(number)) {
    out = std::isnan(*stored) ? MacroValue::null() : MacroValue{*stored, Kind::number};
  } else if (const Fault fault = read_system(b, number, out); fault != Fault::none) {
    return fault;
  }
  if (rows_.is_heard())
    if (const std::string* const row = store().row_of(number)) rows_.add(b, *row);
  if (is_heard()) note_read(b, number, out.number);
  if (number != 0) {
    const std::array<ig_value, 2> shown{ig_value{.number = static_cast<double>(number)}, {.number = out.number}};
    b.append(read_.data(), out.is_null() ? 1 : 2, shown.data());
  }
  return Fault::none;
}

MacroEnvironment::Written MacroEnvironment::write(ig::Block& b, std::uint32_t number, const MacroValue& value) {
  if (number == 0) return Written::read_only;
  if (is_heard()) note_write(b, number, value.is_null() ? MacroStore::null : value.number);
  if (store().set(number, value.is_null() ? MacroStore::null : value.number)) return Written::done;
  return write_system(b, number, value.number);
}

void MacroEnvironment::report(ig::Block& b, const Outcome& o, std::string_view text) const {
  std::size_t end = std::max(o.fault_end, o.fault_begin);
  if (end > text.size()) end = text.size();
  const std::size_t begin = std::min(o.fault_begin, end);
  const auto where = ig::Where::columns(begin, std::max(end, begin + 1));
  if (o.fault == Fault::too_deep) return b.report(diagnostic_of(o.fault), where, static_cast<double>(rules().deepest));
  std::string_view piece = text.substr(begin, end - begin);
  if (piece.empty() || piece.front() == '\r' || piece.front() == '\n') piece = "the end of the block";
  if (o.variable != 0) return b.report(diagnostic_of(o.fault), where, name_of(piece, o.variable));
  b.report(diagnostic_of(o.fault), where, piece);
}

std::string MacroEnvironment::name_of(std::string_view written, std::uint32_t number) {
  std::string name(written);
  if (name.find_first_of("[#", 1) != std::string::npos) name += " (#" + std::to_string(number) + ")";
  return name;
}

ig::DiagnosticCode MacroEnvironment::diagnostic_of(Fault fault) {
  switch (fault) {
    case Fault::not_closed: return ig::diag("FAN-0102");
    case Fault::too_deep: return ig::diag("FAN-0103");
    case Fault::number_too_large: return ig::diag("FAN-0104");
    case Fault::unknown_function: return ig::diag("FAN-0105");
    case Fault::named_variable: return ig::diag("FAN-0106");
    case Fault::double_hash: return ig::diag("FAN-0107");
    case Fault::no_variable: return ig::diag("FAN-0108");
    case Fault::unknown_variable: return ig::diag("FAN-0109");
    case Fault::not_known_here: return ig::diag("FAN-0110");
    case Fault::division_by_zero: return ig::diag("FAN-0111");
    case Fault::out_of_domain: return ig::diag("FAN-0112");
    case Fault::overflow: return ig::diag("FAN-0113");
    case Fault::no_bits: return ig::diag("FAN-0114");
    case Fault::truth_as_number: return ig::diag("FAN-0115");
    case Fault::no_comparison: return ig::diag("FAN-0116");
    default: return ig::diag("FAN-0101");
  }
}

Fault MacroEnvironment::read_system(ig::Block& b, std::uint32_t n, MacroValue& out) const {
  double value = 0;
  const bool is_signal = is_signal_of_machine(n) && store().is_assumed(n) && store().given(n) == nullptr;
  if (is_signal)
    signals_.last = n;
  else
    signals_.others_also = true;
  const Fault fault = system_value(b, n, value);
  out = {value, Kind::number};
  return fault;
}

Fault MacroEnvironment::system_value(ig::Block& b, std::uint32_t n, double& out) const {
  if (n == 3001 || n == 3002) return clock(n, out);
  if (const double* const given = store().given(n)) {
    out = *given;
    return Fault::none;
  }
  if (n == 3011 || n == 3012) return calendar(n, out);
  if (within(n, 4001, 4030) || within(n, 4101, 4130)) return modal(b, n, out);
  if (within(n, 4201, 4230) || within(n, 4301, 4330)) return modal(b, n - 200, out);
  if (within(n, 4401, 4430) || within(n, 4501, 4530)) return Fault::not_known_here;
  if (within(n, 5001, 5100)) return position(b, (n - 5001) / 20, (n - 5001) % 20, out);
  if (n == store().settings.tool_variable) return modal(b, 4120, out);
  if (n == store().settings.speed_variable) return modal(b, 4119, out);
  if (is_local_shift(n)) return local_shift(b, n - 5201, out);
  if (const OffsetCell cell = offset_cell(n); cell.exists) return read_offset(b, cell, out);
  if (const ToolCell cell = tool_cell(n); cell.row != 0) return read_tool(b, cell, out);
  if (store().is_assumed(n)) {
    report_assumed(b, n);
    return Fault::none;
  }
  return within(n, 1000, 99'999) && is_of_control(n) ? Fault::not_known_here : Fault::unknown_variable;
}

bool MacroEnvironment::is_of_control(std::uint32_t n) {
  return within(n, 1000, 1199) || within(n, 3000, 3999) || within(n, 5101, 5200) || within(n, 5401, 6999);
}

Fault MacroEnvironment::clock(std::uint32_t n, double& out) const {
  const double* const given = store().given(n);
  const double step_ms = store().settings.clock_step_ms;
  const double step = n == 3001 ? step_ms : step_ms / 3.6e6;
  out = (given != nullptr ? *given : 0) + step;
  store().give(n, out);
  return Fault::none;
}

Fault MacroEnvironment::calendar(std::uint32_t n, double& out) {
  const std::time_t now = std::time(nullptr);
  std::tm t{};
  if (localtime_r(&now, &t) == nullptr) return Fault::not_known_here;
  out = n == 3011 ? (t.tm_year + 1900) * 10000.0 + (t.tm_mon + 1) * 100.0 + t.tm_mday
                  : t.tm_hour * 10000.0 + t.tm_min * 100.0 + t.tm_sec;
  return Fault::none;
}

void MacroEnvironment::report_assumed(ig::Block& b, std::uint32_t n) const {
  if (is_first(assumed_, n)) b.report(ig::diag("FAN-0118"), ig::Where::block(), static_cast<double>(n), 0.0);
}

void MacroEnvironment::report_signal(ig::Block& b, std::uint32_t n) const {
  if (!is_first(written_, n)) return;
  b.report(n < 1100 ? ig::diag("FAN-0271") : ig::diag("FAN-0270"), ig::Where::block(), static_cast<double>(n));
}

bool MacroEnvironment::is_first(std::vector<std::uint32_t>& seen, std::uint32_t n) {
  const auto it = std::lower_bound(seen.begin(), seen.end(), n);
  if (it != seen.end() && *it == n) return false;
  seen.insert(it, n);
  return true;
}

MacroEnvironment::Written MacroEnvironment::write_system(ig::Block& b, std::uint32_t n, double value) {
  const double mm = is_inch(b) ? value * mm_per_inch : value;
  if (is_local_shift(n)) return Written::read_only;
  if (const OffsetCell cell = offset_cell(n); cell.exists) return write_offset(b, cell, value);
  if (const ToolCell cell = tool_cell(n); cell.row != 0) {
    if (!tools_ || !std::isfinite(mm) || tools_->set(tools_->self, cell.row, cell.column, mm) == 0)
      return Written::no_row;
    b.raise(tools_changed_);
    return Written::done;
  }
  if (within(n, 4001, 4530) || within(n, 5001, 5100) || n == 3011 || n == 3012) return Written::read_only;
  if (n == store().settings.tool_variable || n == store().settings.speed_variable) return Written::read_only;
  if (n != 3001 && n != 3002 && !store().is_assumed(n) && store().given(n) == nullptr) return Written::no_variable;
  if (is_signal_of_machine(n)) report_signal(b, n);
  store().give(n, value);
  return Written::done;
}

Fault MacroEnvironment::read_parameter(const ig::Block& b, std::uint32_t number, std::uint32_t axis,
                                       MacroValue& out) const {
  std::string name = std::to_string(number);
  if (axis != 0) {
    const std::size_t index = axis_of(b, axis - 1);
    if (index == no_axis) return Fault::not_known_here;
    name += '.';
    name += "XYZABC"[index];
  }
  const auto value = parameters_.number(name);
  if (!value) return Fault::not_known_here;
  out = {*value, Kind::number};
  return Fault::none;
}

}  // namespace fanuc
