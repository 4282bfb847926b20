/// The words of a PLANE statement and of CYCL DEF 19. Lengths are in the unit of the program, angles in degrees,
/// positions byte offsets into the text of the block.
#pragma once

#include "five_axis/plane_definition.hpp"
#include "motion/feed_words.hpp"
#include "motion/m_functions.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A plane, and how the rotary axes are positioned for it.
struct PlaneCommand {
  enum class Move { none, stay, turn, move };
  struct Retract {
    std::optional<double> distance;  ///< nothing: MB MAX
    std::size_t begin, end;
  };

  PlaneDefinition plane{};
  std::size_t begin = 0, end = 0;  ///< of the statement
  bool is_cycle = false;           ///< CYCL DEF 19
  Move move = Move::none;
  int sequence = 0;     ///< the sign of SEQ or SYM; 0: none
  double distance = 0;  ///< DIST
  std::optional<ig::Where> distance_word{};
  std::optional<Retract> retract{};
  bool is_rapid = false;
  bool turns_table = false;  ///< TABLE ROT; else COORD ROT

  bool turns_axes() const { return move == Move::turn || move == Move::move; }
  /// As diagnostics name it.
  std::string_view shown() const { return is_cycle ? "CYCL DEF 19" : plane.shown(); }
  ig::Where where() const { return ig::Where::columns(begin, end); }
};

enum class CyclePositions { stays, positions };

/// A member of the syntax that tilts the plane.
class PlaneStatement {
 public:
  /// The position where the words of CYCL DEF 19.1 begin; `position` itself where the statement is another one. 19.0
  /// only names the cycle and is left to KlartextCycleSyntax.
  static std::size_t behind_cycle_19(std::string_view text, std::size_t position);

  /// Reads what follows PLANE; false, with a diagnostic, where it defines no plane. Other words that are not known are
  /// reported.
  bool read(ig::Block& b, std::string_view text, std::size_t position, PlaneCommand& command) const;
  /// Reads the spatial angles of cycle 19; those that are not named keep the values of `in_force`. If all are 0, or
  /// none is given, there is no plane. F and DIST position the axes as MOVE does where the option says so.
  void read_cycle(ig::Block& b, std::string_view text, std::size_t position, const std::optional<ig::Vec3>& in_force,
                  PlaneCommand& command) const;

  const Values& values() const { return values_; }

 private:
  /// The position after DIST50 or ABST50, `position` itself where it is not there.
  std::size_t distance_at(ig::Block& b, std::string_view text, std::size_t position, PlaneCommand& command) const;
  std::size_t word_at(ig::Block& b, std::string_view text, std::size_t position, PlaneCommand& command) const;
  static void report_idle_words(ig::Block& b, const PlaneCommand& command);
  std::size_t angle_or_point(ig::Block& b, std::string_view text, std::size_t position, PlaneDefinition& plane) const;

  Values values_;
  FeedWords feed_;
  MFunctions m_;
  ig::Choice<CyclePositions> cycle_positions_{"cycle-19", "stays|positions", "stays",
                                              "The program positions the rotary axes, or CYCL DEF 19 with F and DIST "
                                              "does: the builder of the machine decides."};
};

}  // namespace heidenhain
