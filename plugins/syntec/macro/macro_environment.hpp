/// What expressions read: variables, arguments, and those system variables whose values the run knows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/cnc/frame_tag.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/provenance.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_store.hpp"

namespace syntec {

/// Parameters of the control, as SyntecParameterTable provides them to this plugin.
inline constexpr const char* parameter_service = "syntec.parameter/1";

/// The text of a statement, with blanks for its comments. Lines before its last one stand in front of the text of the
/// block: `offset` is the length of what they gave.
struct MacroText {
  std::string_view text;
  std::size_t offset = 0;

  ig::Where where(std::size_t begin, std::size_t end) const {
    if (begin < offset) return ig::Where::columns(0, std::max<std::size_t>(end, offset + 1) - offset);
    return ig::Where::columns(begin - offset, std::max(end, begin + 1) - offset);
  }
  ig::Where from(std::size_t begin) const { return where(begin, text.size()); }
};

/// A member of each syntax that evaluates.
class MacroEnvironment {
 public:
  ig::Flow flow;

  MacroStore& store() const { return *store_; }
  /// Before the first expression of a block: the local variables are those of its call.
  void enter(const ig::Block& b) const;

  /// Nothing, and said, where the value is not known.
  std::optional<MacroValue> read(ig::Block& b, const MacroStore::Variable& v, ig::Where where) const;
  /// False, and said, where the variable cannot be written.
  bool write(ig::Block& b, const MacroStore::Variable& v, MacroValue value, ig::Where where) const;
  /// Are there so many variables from the first one on, in one range, that may be written if that one may?
  static bool has_room(const MacroStore::Variable& first, std::size_t count);
  std::optional<double> parameter(double number) const;

  /// #1600: the least input unit of lengths, in the unit of the program.
  double length_unit(const ig::Block& b) const;
  double angle_unit() const { return format_.number("AngleIncrement_deg").value_or(0.001); }
  bool whole_numbers_are_mm() const { return format_.number("CalculatorDecimalPoint").value_or(0) != 0; }
  /// #1: an argument that the macro has read is not left to its block.
  void note_letter(std::uint32_t variable) const;

  void note_condition(ig::Block& b, std::string_view text, bool holds) const { examined_.add(b, text, holds); }

 private:
  std::optional<MacroValue> system(const ig::Block& b, std::uint32_t n) const;
  static bool is_writable(const MacroStore::Variable& v);
  double code(const ig::Block& b, const ig::Field<ig::Symbol>& field, double otherwise) const;

  StoreMember store_;
  ig::Config format_{"isogloss.number-format/1", ig::Need::optional, "The increments that STD counts."};
  ig::Service<ig_config_1> parameters_{parameter_service, ig::Need::optional, "PARAM, #4001 and up."};
  ig::AnsweredRows rows_{macro_store_service};
  ig::UsedVariables used_;
  ig::ExaminedConditions examined_;
  ig::In<ig::Symbol> motion_{"MotionState.Term"}, positioning_{"PositioningMode.Term"},
      radius_{"RadiusCompensation.Term"}, length_{"ToolHeightCompensation.Term"}, unit_{"Unit.System"};
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  ig::Name inch_{"Inch"};
};

}  // namespace syntec
