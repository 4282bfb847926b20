/// Assignments to data of the control: work offsets, tool data, signals, markers.
#pragma once

#include "language/frame_expression.hpp"

namespace siemens {

using namespace ig::cnc;

/// True for outputs and data of the PLC: $A_OUT[3], $A_DBW[2].
inline bool is_output(std::string_view name) {
  for (const std::string_view known :
       {"$A_OUT[", "$A_OUTA[", "$A_DB", "$A_PBB_OUT", "$A_PBW_OUT", "$A_PBD_OUT", "$A_PBR_OUT"})
    if (name.starts_with(known)) return true;
  return false;
}

class SystemAssignment {
 public:
  struct Outcome {
    std::size_t end;                         ///< of the text that was read
    std::optional<std::uint32_t> code = {};  ///< the G code that the assignment amounts to
    std::optional<FrameValue> frame = {};    ///< the programmable frame that it assigns
    bool is_fault = false;                   ///< the value could not be computed, which was reported
  };

  explicit SystemAssignment(const Environment& environment) : environment_(environment) {}

  /// Executes $P_UIFR[1,X,TR]=5, $P_UIFR[1]=CTRANS(X,5):CROT(Z,30), $TC_DP3[1,1]=120, $A_OUT[3]=1.
  Outcome run(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
              const std::string& name) const {
    const auto refuse = [&](std::size_t end) -> Outcome {
      environment_.report_once(b, ig::diag("SIE-0129"), ig::Where::columns(begin, end), begin, std::string_view(name));
      return {end};
    };
    const std::size_t value_at = ig::cnc::skip_blanks(text, equals + 1);
    const std::size_t last = statement_text_end(text, equals);
    if (ig::cnc::at(text, value_at) == '$' && name == "$P_IFRAME") {
      Expression other(b, environment_, text, value_at);
      const auto reference = other.reference();
      if (const auto code = reference ? SystemData::code_of(reference->name) : std::nullopt)
        return {other.position(), code};
    }
    if (FrameExpression::begins(text, value_at) || names_frame(b, text, value_at, name)) {
      FrameExpression e(b, environment_, text, value_at);
      const auto frame = e.value();
      if (frame && name == "$P_PFRAME") return {e.position(), std::nullopt, frame};
      return frame && environment_.system.write_whole(b, name, *frame) ? Outcome{e.position()} : refuse(last);
    }
    const bool is_part = name.starts_with("$P_PFRAME[");
    if (is_output(name)) return output(b, text, begin, equals, name);
    // Only the value is passed over: words behind it are executed.
    if (environment_.system.write(b, name, std::nullopt) == Written::without_effect)
      return {.end = value_at, .is_fault = true};
    const bool is_store = name.starts_with("$AC_MARKER[") || name.starts_with("$AC_PARAM[");
    if (!is_store && !is_part && !SystemData::takes(name)) {
      refuse(equals);
      return {.end = value_at, .is_fault = true};
    }
    Expression e(b, environment_, text, value_at);
    const auto value = e.value();
    const std::size_t end = std::max(e.position(), equals + 1);
    if (!value) return {.end = end, .is_fault = true};
    if (is_store && !value->is_text()) {
      environment_.store().give_for_run(name, value->number);
      environment_.note_write(b, name, *value);
      return {end};
    }
    if (is_part) {
      const auto frame =
          value->is_text() ? std::nullopt : environment_.system.changed_programmed(b, name, value->number);
      return frame ? Outcome{.end = end, .frame = frame} : refuse(end);
    }
    if (value->is_text() || environment_.system.write(b, name, value->number) == Written::no) return refuse(end);
    return {end};
  }

 private:
  /// True where a whole frame is assigned to a frame: $P_UIFR[1]=$P_UIFR[2], or = a FRAME variable.
  bool names_frame(ig::Block& b, std::string_view text, std::size_t position, const std::string& to) const {
    const bool is_variable = is_name_start(ig::cnc::at(text, position));
    if ((!is_variable && ig::cnc::at(text, position) != '$') || !environment_.system.frame(b, to)) return false;
    if (!is_variable) return true;
    const std::string name = upper(ig::cnc::piece(text, position, skip_name(text, position)));
    const Variable* const v = environment_.store().find(name);
    return v != nullptr && v->value.type == Type::frame;
  }

  /// $A_OUT[3]=1: nothing is switched, and the program reads the value back.
  Outcome output(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                 const std::string& name) const {
    Expression e(b, environment_, text, equals + 1);
    const auto value = e.number();
    const std::size_t end = std::max(e.position(), equals + 1);
    if (!value) return {.end = end, .is_fault = true};
    const bool is_digital = name.starts_with("$A_OUT[");
    const double given = is_digital ? (*value != 0 ? 1 : 0) : *value;
    environment_.store().give_for_run(name, given);
    environment_.note_write(b, name, Value::real(given));
    if (environment_.store().is_first_report("SIE-0364\n" + name))
      b.report(ig::diag("SIE-0364"), ig::Where::columns(begin, end), std::string_view(name));
    return {end};
  }

  const Environment& environment_;
};

}  // namespace siemens
