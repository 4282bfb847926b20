/// Assignments to data of the control: work offsets, tool data, signals, markers.
#pragma once

#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

class SystemAssignment {
 public:
  struct Outcome {
    std::size_t end;                         ///< of the text that was read
    std::optional<std::uint32_t> code = {};  ///< the G code that the assignment amounts to
    bool is_fault = false;                   ///< the value could not be computed, which was reported
  };

  explicit SystemAssignment(const Environment& environment) : environment_(environment) {}

  /// Executes $P_UIFR[1,X,TR]=5, $P_UIFR[1]=CTRANS(X,5,Y,3), $TC_DP3[1,1]=120.
  Outcome run(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
              const std::string& name) const {
    const auto refuse = [&](std::size_t end) -> Outcome {
      environment_.report_once(b, ig::diag("SIE-0129"), ig::Where::columns(begin, end), begin, std::string_view(name));
      return {end};
    };
    const std::size_t value_at = ig::cnc::skip_blanks(text, equals + 1), end_of_name = skip_name(text, value_at);
    const std::size_t last = statement_text_end(text, equals);
    if (ig::cnc::at(text, ig::cnc::skip_blanks(text, end_of_name)) == '(' &&
        equals_ignoring_case(ig::cnc::piece(text, value_at, end_of_name), "CTRANS")) {
      std::size_t next = ig::cnc::skip_blanks(text, end_of_name);
      const auto shift = shift_at(b, text, next);
      if (!shift || !passes_idle_links(b, text, next) || !environment_.system.write_shift(b, name, *shift))
        return refuse(last);
      return {next};
    }
    if (ig::cnc::at(text, value_at) == '$') {
      Expression other(b, environment_, text, value_at);
      const auto reference = other.reference();
      if (const auto code = reference && name == "$P_IFRAME" ? SystemData::code_of(reference->name) : std::nullopt) {
        return {other.position(), code};
      }
      const auto shift =
          reference && other.position() == last ? environment_.system.shift_of(b, reference->name) : std::nullopt;
      if (shift && environment_.system.write_shift(
                       b, name, *shift, environment_.system.shape_of(b, reference->name).value_or(SettableShape{})))
        return {last};
    }
    if (name.starts_with("$A_OUT") || name.starts_with("$A_DB")) {  // signals of the machine, like M codes
      b.report(ig::diag("SIE-0126"), ig::Where::columns(begin, last), ig::cnc::piece(text, begin, last));
      return {last};
    }
    if (environment_.system.write(b, name, std::nullopt) == Written::without_effect) return {last};
    const bool is_store = name.starts_with("$AC_MARKER[") || name.starts_with("$AC_PARAM[");
    if (!is_store && !SystemData::takes(name)) return refuse(last);
    Expression e(b, environment_, text, value_at);
    const auto value = e.value();
    const std::size_t end = std::max(e.position(), equals + 1);
    if (!value) return {end, std::nullopt, true};
    if (is_store && !value->is_text()) {
      environment_.store().give_for_run(name, value->number);
      return {end};
    }
    if (value->is_text() || environment_.system.write(b, name, value->number) == Written::no) return refuse(end);
    return {end};
  }

 private:
  /// Passes :CROT(X,0,Y,0,Z,0) after CTRANS, as post-processors and the control write it. False where a link changes
  /// the frame.
  bool passes_idle_links(ig::Block& b, std::string_view text, std::size_t& next) const {
    while (ig::cnc::at(text, ig::cnc::skip_blanks(text, next)) == ':') {
      const std::size_t link = ig::cnc::skip_blanks(text, ig::cnc::skip_blanks(text, next) + 1),
                        end = skip_name(text, link);
      const std::string name = upper(ig::cnc::piece(text, link, end));
      const bool scales = name == "CSCALE";
      if (!scales && name != "CROT" && name != "CFINE") return false;
      next = ig::cnc::skip_blanks(text, end);
      const double idle = scales ? 1 : 0;
      const auto values = ig::cnc::at(text, next) == '(' ? shift_at(b, text, next, idle) : std::nullopt;
      if (!values || *values != uniform(idle)) return false;
    }
    return true;
  }

  static SystemData::Shift uniform(double value) {
    SystemData::Shift shift;
    shift.fill(value);
    return shift;
  }

  /// Reads (X,5,Y,3); nothing where it holds another axis, or no value.
  std::optional<SystemData::Shift> shift_at(ig::Block& b, std::string_view text, std::size_t& next,
                                            double unnamed = 0) const {
    SystemData::Shift shift = uniform(unnamed);
    do {
      next = ig::cnc::skip_blanks(text, next + 1);
      const std::size_t end = skip_name(text, next), comma = ig::cnc::skip_blanks(text, end);
      const std::size_t axis = environment_.axes.find(upper(ig::cnc::piece(text, next, end))).value_or(6);
      if (axis > 5 || ig::cnc::at(text, comma) != ',') return std::nullopt;
      Expression e(b, environment_, text, comma + 1);
      const auto value = e.number();
      if (!value) return std::nullopt;
      shift[axis] = *value;
      next = ig::cnc::skip_blanks(text, e.position());
    } while (ig::cnc::at(text, next) == ',');
    if (ig::cnc::at(text, next) != ')') return std::nullopt;
    ++next;
    return shift;
  }

  const Environment& environment_;
};

}  // namespace siemens
