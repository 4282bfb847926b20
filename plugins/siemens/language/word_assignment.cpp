/// Assignments: R1=5, NAME=3, A[1]=SET(1,2), $P_UIFR[1]=…, G[8]=2, AX[NAME]=10.
#include "language/array_values.hpp"
#include "language/frame_component.hpp"
#include "language/system_assignment.hpp"
#include "language/word_reader.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

/// Z of POS[Z] and POSA[Z].
std::string positioning_axis(std::string_view name, const AxisNames& axes) {
  for (const std::string_view known : {"POS[", "POSA["})
    if (name.starts_with(known) && name.ends_with(']')) {
      const std::string_view axis = name.substr(known.size(), name.size() - known.size() - 1);
      if (axis.size() == 1 || axes.find(axis)) return std::string(axis);
    }
  return {};
}

/// Axes, spindles and codes by index: no variable of a machine has such a name.
bool is_of_control(std::string_view name) {
  const std::string_view base = name.substr(0, name.find('['));
  return base.size() == 1 || base == "AX" || base == "AXIS" || base.starts_with("POS") || base == "MOV" ||
         base == "FDA";
}

/// What is missing where a command of a single axis (FXS[X]=1) is not executed; empty for other names.
std::string_view missing_of_command(std::string_view name) {
  struct Command {
    std::string_view names, missing;
  };
  static constexpr Command commands[] = {
      {" OS OSB OSE OSP1 OSP2 OST1 OST2 OSNSC OSCTRL OSCILL ", "OS[…]=: the axis does not oscillate"},
      {" FXS FXST FXSW ", "FXS[…]=: the axis does not move to a fixed stop"},
      {" FOC ", "FOC[…]=: the force of the axis is not limited"},
      {" MEASA MEAWA MEAC ", "MEASA[…]=: no probe touches; the move goes to its end"},
      {" PO ", "PO[…]=: the polynomial is missing; the block moves with the previous motion code"},
      {" TOFF ", "TOFF[…]=: the tool is that of the table"},
      {" CPLA CPSETTYPE ", "CPLA[…]=: no axis follows another one"}};
  const std::string base = ' ' + std::string(name.substr(0, name.find('['))) + ' ';
  for (const Command& c : commands)
    if (c.names.find(base) != std::string_view::npos) return c.missing;
  return {};
}

/// Speeds and accelerations of single axes.
bool changes_no_position(std::string_view name) {
  for (const std::string_view known : {"FGREF[", "ACC[", "VELOLIM[", "JERKLIM[", "ACCLIMA[", "VELOLIMA[", "JERKLIMA[",
                                       "OVRA[", "FL[", "FA[", "ATOL[", "POLF["})
    if (name.starts_with(known)) return true;
  return false;
}

/// How far and how fast G147 to G348 approach and retract. The code reports that it is not executed.
bool belongs_to_approach(std::string_view name) {
  for (const std::string_view known : {"DISR", "DISRP", "DISCL", "FAD"})
    if (name == known) return true;
  return false;
}

bool belongs_to_spindle(std::string_view name) {
  return name.starts_with("SPOS[") || name.starts_with("SPOSA[") || name.starts_with("LIMS[");
}

/// An AXIS takes the name of an axis, and a FRAME takes links.
bool is_read_by_type(const Declared& type) { return type.type == Type::frame || type.detail == Declared::Detail::axis; }

}  // namespace

/// G[8]=2 is the second code of group 8. Groups whose order the manuals agree on (Programming manual, G functions).
struct WordReader::Group {
  std::string_view name;
  std::array<std::uint32_t, 5> codes;
  std::uint32_t count;
};

std::size_t WordReader::assignment(ig::Block& b, std::string_view text, std::size_t begin, Run& run) {
  if (environment_.flow.is_indexing()) return block_end(text, begin);
  if (!b.is_in_turn()) return begin;
  give(b, run);
  Expression target(b, environment_, text, begin);
  const auto reference = target.reference();
  if (!reference) return line_end_of_fault(text, std::max(target.position(), begin + 1));
  const std::size_t equals = skip_blanks(text, target.position());
  if (at(text, equals) != '=') {
    b.report(ig::diag("SIE-0127"), columns(begin, target.position()), piece(text, begin, target.position()));
    return target.position();
  }
  environment_.enter(b);
  if (reference->name.starts_with("AX[") && reference->name.ends_with(']'))  // AX[NAME], NAME of type AXIS
    if (const std::string axis = reference->name.substr(3, reference->name.size() - 4);
        axis.size() == 1 || environment_.axes.find(axis))
      return valued_as(b, text, begin, equals, axis, run);
  if (const std::string axis = positioning_axis(reference->name, environment_.axes); !axis.empty()) {
    if (environment_.store().is_first_report("POS"))
      b.report(ig::diag("SIE-0292"), columns(begin, target.position()), std::string_view(reference->name));
    return valued_as(b, text, begin, equals, axis, run);
  }
  if (const auto end = assign_declared(b, text, begin, equals, *reference)) return *end;
  if (const std::string name = extended_name(reference->name); !name.empty()) {
    const Assigned a = assigned(b, text, equals);
    return a.value ? extended(b, text, begin, a.end, name, *a.value, run) : a.end;
  }
  if (belongs_to_spindle(reference->name)) return of_spindle(b, text, begin, equals, reference->name, run);
  if (reference->name[0] == '$' && !environment_.store().given(reference->name)) {
    const auto done = SystemAssignment(environment_).run(b, text, begin, equals, reference->name);
    if (done.frame) frame_.set(b, *done.frame);
    if (done.code) set_code(b, run, 'G', *done.code, begin, done.end);
    return done.is_fault ? line_end_of_fault(text, done.end) : done.end;
  }
  if (const Group* const group = group_named(reference->name)) return of_group(b, text, begin, equals, *group, run);
  if (const Variable* const array = environment_.store().array_of(reference->name);
      array != nullptr && ArrayValues::begin(text, skip_blanks(text, equals + 1), false))
    return assign_elements(b, text, begin, equals, *reference, *array);
  const bool is_unknown_array = reference->name.find('[') != std::string::npos &&
                                environment_.store().find(reference->name) == nullptr &&
                                !environment_.store().array_of(reference->name);
  if (!reference->is_r && is_unknown_array && !environment_.store().given(reference->name) &&
      !changes_no_position(reference->name)) {
    const std::size_t end = line_end_of_fault(text, skip_blanks(text, equals + 1));  // words behind it are executed
    if (defines_curve()) return end;                                                 // PO[X]=
    if (const std::string_view missing = missing_of_command(reference->name); !missing.empty())
      environment_.report_once(b, ig::diag("SIE-0262"), columns(begin, end), begin, missing);
    else if (is_of_control(reference->name))
      environment_.report_once(b, ig::diag("SIE-0131"), columns(begin, end), begin, std::string_view(reference->name));
    else
      environment_.report_name(b, ig::diag("SIE-0124"), columns(begin, target.position()), reference->name);
    return end;
  }
  if (const ig::Symbol mode = take_mode(b, text, skip_blanks(text, equals + 1)); mode != ig::Symbol{}) {
    const std::size_t end = skip_call(text, at_bracket_);  // ROTX=DC(10): an axis that the chain does not know
    environment_.report_once(b, ig::diag("SIE-0124"), columns(begin, end), begin, std::string_view(reference->name));
    return end;
  }
  Expression e(b, environment_, text, equals + 1);
  const auto value = e.value();
  const std::size_t end = std::max(e.position(), equals + 1);
  if (!value) return line_end_of_fault(text, end);
  if (is_unknown_array && changes_no_position(reference->name)) return end;
  if (belongs_to_approach(reference->name)) return end;
  assign(b, *reference, *value, begin, end);
  return end;
}

void WordReader::assign(ig::Block& b, const Expression::Reference& to, const Value& value, std::size_t begin,
                        std::size_t end) const {
  VariableStore& store = environment_.store();
  b.raise(macro_statement_);
  environment_.note_write(b, to.name, value);
  if (to.is_r) {
    if (value.is_text())
      b.report(ig::diag("SIE-0130"), columns(begin, end), std::string_view(to.name));
    else
      store.assign_r(to.r, value.number);
    return;
  }
  const Stored outcome = store.assign(to.name, value);
  if (outcome == Stored::unknown && store.given(to.name)) {
    if (!value.is_text()) return store.give_for_run(to.name, value.number);
    b.report(ig::diag("SIE-0130"), columns(begin, end), std::string_view(to.name));
    return;
  }
  const std::size_t last = outcome == Stored::outside_array ? to.end : end;
  environment_.report_not_stored(b, columns(begin, last), to.name, value, outcome);
}

std::optional<std::size_t> WordReader::assign_declared(ig::Block& b, std::string_view text, std::size_t begin,
                                                       std::size_t equals, const Expression::Reference& to) const {
  VariableStore& store = environment_.store();
  if (const auto component = FrameComponent::of(store, to.name)) {
    Expression e(b, environment_, text, equals + 1);
    const auto number = e.number();
    const std::size_t end = std::max(e.position(), equals + 1);
    if (!number) return line_end_of_fault(text, end);
    if (const auto changed = component->changed(*number))
      assign(b, {component->variable, to.begin, to.end}, Value::frame(*changed), begin, end);
    else
      b.report(ig::diag("SIE-0365"), columns(begin, end), piece(text, begin, end));
    return end;
  }
  const Variable* const present = store.find(to.name);
  const Variable* const model = present != nullptr ? present : store.array_of(to.name);
  const bool is_list = ArrayValues::begin(text, skip_blanks(text, equals + 1), false);
  if (model == nullptr || is_list || (present != nullptr && present->is_array) || !is_read_by_type(model->declared))
    return std::nullopt;
  std::size_t end = equals + 1;
  const auto value = value_of(b, environment_, text, end, model->declared);
  if (!value) return line_end_of_fault(text, end);
  assign(b, to, *value, begin, end);
  return end;
}

std::size_t WordReader::assign_elements(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                                        const Expression::Reference& to, const Variable& array) const {
  const std::size_t bracket = to.name.find('[');
  const std::string base = to.name.substr(0, bracket);
  const auto first = array.number_of(std::string_view(to.name).substr(std::min(bracket, to.name.size())));
  const std::size_t end = skip_call(text, skip_name(text, skip_blanks(text, equals + 1)));
  if (bracket == std::string::npos || !first) {
    b.report(ig::diag("SIE-0304"), columns(begin, to.end), std::string_view(to.name),
             std::string_view(array.shown_as(base)));
    return end;
  }
  std::size_t next = skip_blanks(text, equals + 1);
  return ArrayValues(b, environment_, text).read(next, base, *first) ? next : end;
}

const WordReader::Group* WordReader::group_named(std::string_view name) {
  static constexpr std::array groups{Group{"G[1]", {0, 1, 2, 3}, 4},         Group{"G[6]", {17, 18, 19}, 3},
                                     Group{"G[7]", {40, 41, 42}, 3},         Group{"G[8]", {500, 54, 55, 56, 57}, 5},
                                     Group{"G[13]", {70, 71, 700, 710}, 4},  Group{"G[14]", {90, 91}, 2},
                                     Group{"G[15]", {93, 94, 95, 96, 97}, 5}};
  for (const Group& g : groups)
    if (g.name == name) return &g;
  return nullptr;
}

std::size_t WordReader::of_group(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                                 const Group& group, Run& run) {
  const Assigned a = assigned(b, text, equals);
  if (!a.value) return a.end;
  const double n = *a.value;
  if (group.name == "G[8]" && n > 5 && n <= 100 && n == std::floor(n))  // G505 and on
    set_code(b, run, 'G', 499 + static_cast<std::uint32_t>(n), begin, a.end);
  else if (n >= 1 && n <= group.count && n == std::floor(n))
    set_code(b, run, 'G', group.codes[static_cast<std::size_t>(n) - 1], begin, a.end);
  else
    b.report(ig::diag("SIE-0125"), columns(begin, a.end), piece(text, begin, a.end));
  return a.end;
}

}  // namespace siemens
