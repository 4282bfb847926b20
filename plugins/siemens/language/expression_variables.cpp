/// Variables in an expression: R1, NAME[2,3], $AA_IM[X] with their indices, and the value that each of them has.
#include <charconv>
#include <cmath>
#include <numbers>

#include "language/frame_component.hpp"
#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

bool Expression::indices(std::string& name, std::string& called) {
  const std::size_t open = at_;
  ++at_;
  const Variable* const base = environment_.store().find(name);
  const bool has_components = name[0] == '$' || (base != nullptr && base->value.type == Type::frame);
  const auto add = [&](std::string_view own, std::string_view written) {
    name += own;
    called += written;
  };
  add("[", "[");
  for (;;) {
    skip_blanks();
    const std::size_t begin = at_, end = skip_name(text_, at_);
    const char behind = ig::cnc::at(text_, ig::cnc::skip_blanks(text_, end));
    const std::string word = upper(ig::cnc::piece(text_, begin, end));
    const bool is_whole_index = !word.empty() && (behind == ',' || behind == ']');
    const bool stands_alone = is_whole_index && word.size() <= 2;
    const bool is_variable = environment_.store().find(word) != nullptr;
    const bool names_axis = is_whole_index && !is_variable &&
                            (environment_.axes.find(word) ||
                             (stands_alone && std::string_view("ABCUVWXYZ").find(word[0]) != std::string_view::npos));
    const bool is_axis = names_axis || (stands_alone && has_components && !is_variable && is_letter(word[0]) &&
                                        (word[0] != 'R' || word == "RT"));
    if (is_axis) {  // $AA_IM[X]
      add(environment_.axes.letter_of(word), word);
      at_ = end;
    } else {
      if (++depth_ > deepest) {
        fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
        return false;
      }
      const auto index = level(loosest);
      --depth_;
      if (!index) return false;
      if (index->is_text()) {
        const std::string axis = upper(index->text);
        const std::string_view own = environment_.axes.letter_of(axis);
        add(own == axis ? std::string_view(index->text) : own, index->text);
      } else if (!(std::fabs(index->number) < 1e9)) {
        fail(ig::diag("SIE-0104"), open, name);
        return false;
      } else {
        const std::string number = std::to_string(static_cast<std::int64_t>(std::round(index->number)));
        add(number, number);
      }
    }
    skip_blanks();
    if (peek() == ',') {
      add(",", ",");
      ++at_;
      continue;
    }
    if (peek() != ']') {
      fail(ig::diag("SIE-0102"), open);
      return false;
    }
    ++at_;
    add("]", "]");
    return true;
  }
}

std::optional<Expression::Reference> Expression::reference() {
  Reference out;
  out.begin = at_;
  if (peek() == '$') ++at_;
  at_ = skip_name(text_, at_);
  std::string name = upper(ig::cnc::piece(text_, out.begin, at_));
  if (name.starts_with("$R") && (name.size() == 2 || is_digit(name[2]))) name.erase(0, 1);
  const bool has_number = name.size() > 1 && name[0] == 'R' && skip_digits(name, 1) == name.size();
  if (const std::size_t open = ig::cnc::skip_blanks(text_, at_); ig::cnc::at(text_, open) == '[') {
    at_ = open;
    std::string called = name;
    if (!indices(name, called)) return std::nullopt;
    if (VariableStore& store = environment_.store(); called != name && (store.given(called) || store.find(called)))
      name = std::move(called);
  }
  out.end = at_;
  out.is_r = has_number || name.starts_with("R[");
  if (out.is_r) {
    std::uint32_t number = 0;
    const char* const first = name.data() + (has_number ? 1 : 2);
    const auto [end, error] = std::from_chars(first, name.data() + name.size(), number);
    if (error != std::errc{} || environment_.store().r(number) == nullptr)
      return fail(ig::diag("SIE-0104"), out.begin, std::string_view(name));
    out.r = number;
    name = "R" + std::to_string(number);
  }
  out.name = std::move(name);
  return out;
}

std::optional<Value> Expression::is_variable(std::string_view called, std::size_t begin) {
  environment_.enter(b_);
  VariableStore& store = environment_.store();
  const std::string name = upper(trim(called));
  const std::size_t bracket = std::min(name.find('['), name.size());
  const std::string base = name.substr(0, bracket);
  const std::string_view index = std::string_view(name).substr(bracket);
  const bool is_indexed_r = base == "R" && index.size() > 2;
  if (is_indexed_r || (base.size() > 1 && base[0] == 'R' && skip_digits(base, 1) == base.size())) {
    const std::string_view number = is_indexed_r ? index.substr(1) : std::string_view(base).substr(1);
    const ig::Decimal n = ig::read_decimal(number, 0);
    return Value::truth(n.ok && n.value >= 0 && n.value < static_cast<double>(store.r_count()));
  }
  if (base.empty() || base[0] != '$') {
    const Variable* const v = store.find(base);
    const bool is_element = v != nullptr && (index.empty() || (v->is_array && v->number_of(index)));
    return Value::truth(is_element || store.given(name).has_value());
  }
  if (store.given(name) || environment_.system.read(b_, name)) return Value::truth(true);
  return fail(ig::diag("SIE-0321"), begin, std::string_view("ISVAR"));
}

std::optional<Value> Expression::read(const Reference& r) {
  VariableStore& store = environment_.store();
  environment_.enter(b_);
  environment_.note_row(b_, r.name);
  if (r.is_r) {
    VariableStore::RParameter& p = *store.r(r.r);
    if (!p.is_given && store.is_first_report(r.name))
      b_.report(ig::diag("SIE-0112"), columns(r.begin, r.end), std::string_view(r.name));
    environment_.note_read(b_, r.name, Value::real(p.value));
    return Value::real(p.value);
  }
  if (const Variable* const v = store.find(r.name)) {
    environment_.note_read(b_, r.name, v->value);
    return v->value;
  }
  if (const auto component = FrameComponent::of(store, r.name))
    return Value::real(component->frame.get(component->link, component->axis));
  const std::size_t bracket = r.name.find('[');
  if (bracket != std::string::npos) {
    const std::string base = r.name.substr(0, bracket);
    if (const Variable* const array = store.find(base); array != nullptr && array->is_array) {
      at_ = r.end;
      if (!array->sizes.empty() && !array->number_of(std::string_view(r.name).substr(bracket)))
        return fail(ig::diag("SIE-0304"), r.begin, std::string_view(r.name), std::string_view(array->shown_as(base)));
      environment_.note_read(b_, r.name, array->value);
      return array->value;
    }
  }
  if (const auto n = store.given(r.name)) return Value::real(*n);
  constexpr std::string_view passed = "$P_SUBPAR[";
  if (r.name.starts_with(passed)) {
    std::size_t number = 0;
    std::from_chars(r.name.data() + passed.size(), r.name.data() + r.name.size(), number);
    return Value::truth(store.is_passed(number));
  }
  if (r.name == "$PI") return Value::real(std::numbers::pi);
  if (r.name[0] == '$')
    if (const auto n = environment_.system.read(b_, r.name)) return Value::real(*n);
  if (environment_.axes.find(r.name)) return Value::string(r.name);  // DEF AXIS NAME=X
  at_ = r.end;
  const auto where = columns(r.begin, r.end);
  if (!failed_ && r.name[0] == '$')
    environment_.report_once(b_, ig::diag("SIE-0110"), where, r.begin, std::string_view(r.name));
  else if (!failed_)
    environment_.report_name(b_, ig::diag("SIE-0111"), where, r.name);
  failed_ = true;
  return std::nullopt;
}

}  // namespace siemens
