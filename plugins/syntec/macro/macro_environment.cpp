/// Variables of any number, and why one has no value here.
#include "macro/macro_environment.hpp"

#include <cmath>

namespace syntec {

using namespace ig::cnc;
using Area = MacroStore::Area;

namespace {

bool within(std::uint32_t n, std::uint32_t first, std::uint32_t last) { return n >= first && n <= last; }
bool is_parameter(std::uint32_t n) { return within(n, 4001, 4200) || within(n, 5001, 5500); }
/// Variables that programs own: those of the axis group, and the modal ones.
bool is_of_program(std::uint32_t n) {
  return n <= 999 || within(n, 1080, 1099) || within(n, 2001, 2200) || within(n, 3001, 3100);
}

}  // namespace

void MacroEnvironment::enter(const ig::Block& b) const {
  const ig_frame frame = flow.frame(b);
  if (!store_->is_new_frame(frame.id, frame.pass)) return;
  const auto has_locals = [](const ig_frame& f) { return (f.tag & ~begins_inside) != 0; };
  ig_frame at = frame;
  for (std::uint32_t level = frame.depth; level > 0 && !has_locals(at);) {
    const auto below = flow.frame(b, --level);
    if (!below) break;
    at = *below;
  }
  if (at.depth > 0 && store_->is_foreign(at.tag)) {
    std::vector<ig_frame> callers;
    for (std::uint32_t level = 0; level < at.depth; ++level)
      if (const auto caller = flow.frame(b, level)) callers.push_back(*caller);
    store_->enter_foreign(callers, at.call_line);
  }
  store_->select(at.depth == 0 ? 0 : at.tag, at.depth == 0 ? 1 : at.pass);
}

std::optional<MacroValue> MacroEnvironment::read(ig::Block& b, const MacroStore::Variable& v, ig::Where where) const {
  std::optional<MacroValue> out;
  const MacroValue& stored = store_->read(v);
  if (v.area == Area::number && stored.is_vacant() && !is_of_program(v.number))
    out = system(b, v.number);
  else if (store_->is_known(v))
    out = stored;
  if (!out) {
    if (v.area == Area::number && is_parameter(v.number))
      b.report(ig::diag("SYN-0034"), where, static_cast<double>(v.number));
    else
      b.report(ig::diag("SYN-0024"), where, name_of(v));
    return std::nullopt;
  }
  if (v.area == Area::local) note_letter(v.number);
  if (rows_.is_heard() && v.area != Area::local) rows_.add(b, name_of(v));
  if (used_.is_heard() && v.number != 0) {
    const std::uint64_t scope = v.area == Area::local ? store_->level().tag : 0;
    if (out->is_text())
      used_.read(b, name_of(v), out->text, scope);
    else
      used_.read(b, name_of(v), out->shown(), scope);
  }
  return out;
}

bool MacroEnvironment::is_writable(const MacroStore::Variable& v) {
  if (v.area == Area::reg) return true;
  if (v.number == 0) return false;
  // Switches of the control that change no motion here: single block, override, reloading of files.
  return v.area != Area::number || is_of_program(v.number) || v.number == 1502 || v.number == 1504 || v.number == 1510;
}

bool MacroEnvironment::has_room(const MacroStore::Variable& first, std::size_t count) {
  MacroStore::Variable v = first;
  for (std::size_t i = 1; i < count; ++i) {
    ++v.number;
    if (v.area == Area::reg && v.number > last_register) return false;
    if (v.area == Area::number && !is_writable(v)) return false;
    if (v.area != Area::at) continue;
    const auto next = at_variable(v.number);
    if (!next || next->area != Area::at) return false;
  }
  return true;
}

bool MacroEnvironment::write(ig::Block& b, const MacroStore::Variable& v, MacroValue value, ig::Where where) const {
  if (!is_writable(v)) {
    b.report(ig::diag("SYN-0040"), where, name_of(v));
    return false;
  }
  if (holds_integers(v) && value.is_number()) {
    const double whole = std::trunc(value.number);
    if (!is_of_32_bits(whole)) {
      b.report(ig::diag("SYN-0033"), where, value.number);
      return false;
    }
    if (whole != value.number) b.report(ig::diag("SYN-0056"), where, name_of(v), value.number, whole);
    value = MacroValue::whole(whole);
  }
  if (used_.is_heard()) {
    const std::uint64_t scope = v.area == Area::local ? store_->level().tag : 0;
    if (value.is_text())
      used_.wrote(b, name_of(v), value.text, scope);
    else
      used_.wrote(b, name_of(v), value.shown(), scope);
  }
  store_->write(v, std::move(value));
  return true;
}

void MacroEnvironment::note_letter(std::uint32_t variable) const {
  if (variable != 0 && variable <= 26) store_->level().read_letters |= 1u << variable;
}

std::optional<double> MacroEnvironment::parameter(double number) const {
  if (!parameters_ || !(number >= 0 && number <= 1e6) || number != std::floor(number)) return std::nullopt;
  const std::string name = std::to_string(static_cast<std::uint32_t>(number));
  double value = 0;
  if (parameters_->number(parameters_->self, ig::to_text(name), &value) == 0) return std::nullopt;
  return value;
}

double MacroEnvironment::length_unit(const ig::Block& b) const {
  return b.is(unit_, inch_) ? format_.number("LengthIncrement_inch").value_or(0.0001)
                            : format_.number("LengthIncrement_mm").value_or(0.001);
}

double MacroEnvironment::code(const ig::Block& b, const ig::Field<ig::Symbol>& field, double otherwise) const {
  const auto symbol = b.get(field);
  if (!symbol) return otherwise;
  const std::string_view text = b.text(*symbol);
  const ig::Decimal d = text.size() > 1 ? ig::read_decimal(text, 1) : ig::Decimal{};
  return d.ok ? d.value : otherwise;
}

std::optional<MacroValue> MacroEnvironment::system(const ig::Block& b, std::uint32_t n) const {
  switch (n) {
    case 1000: return MacroValue::whole(code(b, motion_, 0));
    case 1004: return MacroValue::whole(code(b, positioning_, 90));
    case 1015: return MacroValue::whole(code(b, radius_, 40));
    case 1016: return MacroValue::whole(code(b, length_, 49));
    case 1600: return MacroValue::real(length_unit(b));
    default: break;
  }
  if (within(n, 1321, 1323)) {
    const ig::PartialVec3 position = b.get(machine_);
    const std::size_t axis = n - 1321;
    if (!position.has(axis)) return std::nullopt;
    return MacroValue::real(b.is(unit_, inch_) ? position.value[axis] / mm_per_inch : position.value[axis]);
  }
  if (is_parameter(n))
    if (const auto value = parameter(n)) return MacroValue::of_number(*value);
  return std::nullopt;
}

}  // namespace syntec
