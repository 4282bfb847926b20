/// The resolved motions of both sides, one by one: where they go, and how fast; not why.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diff/runs.hpp"
#include "diff/snapshot.hpp"

namespace isogloss::cli::parting {

struct Tolerance {
  double mm = 1e-6, degrees = 1e-6;
};

/// A row of the motion stream.
struct Motion {
  enum Column {
    px,
    py,
    pz,
    mx,
    my,
    mz,
    a,
    b,
    c,
    feed,
    cx,
    cy,
    cz,
    ccw,
    circles,
    mcx,
    mcy,
    mcz,
    nx,
    ny,
    nz,
    sweep,
    value,
    columns
  };
  std::string event, words;  ///< plane and term
  double at[columns] = {};
  std::uint32_t known = 0;  ///< a bit for each column
};

/// The motions of a block, or of passes over its line that follow each other.
struct MotionBlock {
  Key key;
  std::string file, fault;
  std::uint32_t line = 0;
  bool is_end = false;
  std::vector<Motion> motions;
};

struct Deviation {
  double size = 0;  ///< 0 where it is no length, no angle and no number
  std::string file_a, file_b;
  std::uint32_t line_a = 0, line_b = 0;
  std::string event, a, b;
};

/// What differs in one way: "machine position", "feed".
struct DeviationKind {
  std::string unit;
  std::uint64_t motions = 0;
  Deviation first, greatest;
};

struct MotionReport {
  std::string name_a, name_b, program_a, program_b;
  Tolerance tolerance;
  std::uint64_t motions_a = 0, motions_b = 0, parted = 0;
  std::vector<std::pair<std::string, DeviationKind>> kinds;  ///< in the order in which they were found
  std::vector<std::pair<std::string, Deviation>> all;        ///< with --all
  std::array<std::string, 2> faults;
  std::array<std::vector<Diagnostic>, 2> reported_by_fault;
  std::array<bool, 2> is_cut{};  ///< ended by its errors
  std::array<std::uint64_t, 2> errors{};
  std::array<std::optional<Diagnostic>, 2> first_error;
};

MotionReport compare_motions(const RunOfSide& a, const RunOfSide& b, const LineOrder* order, const Tolerance& tolerance,
                             bool keeps_all, Session& session);

}  // namespace isogloss::cli::parting
