/// What a client sees where a run stands: frames, scopes and variables of the protocol.
#pragma once

#include "dap/debuggee.hpp"
#include "protocol/framing.hpp"

namespace isogloss::dap {

using editors::Json;

/// References count from 1 and are good until the run moves.
class StateView {
 public:
  /// The run has moved: references of before mean nothing any more.
  void forget() { nodes_.clear(); }

  static Json frames(const Standing& standing);
  /// Of the frame with this id; empty with a reason.
  Json scopes(const Standing& standing, std::int64_t frame, std::string& fault);
  Json variables(const Standing& standing, const ProgramVariables& variables, std::int64_t reference,
                 std::string& fault);
  /// Does the reference list variables of the program, which can be set?
  bool is_settable(std::int64_t reference) const;

 private:
  enum class Kind : std::uint8_t {
    positions,
    modal,
    section,
    program,
    block,
    words,
    motions,
    motion,
    written,
    tables,
    table,
    row
  };
  struct Node {
    Kind kind;
    std::size_t index = 0;  ///< frame, stroke, dependency
    std::string name{};     ///< section or row
  };
  std::int64_t add(Node node);
  Json scope(const char* name, Node node, const char* hint = nullptr);
  void add_positions(const Standing& standing, Json& out) const;
  void add_sections(const Standing& standing, Json& out);
  void add_fields(const Standing& standing, const std::string& section, Json& out) const;
  void add_program(const Standing& standing, const ProgramVariables& variables, std::size_t frame, Json& out) const;
  void add_block(const Standing& standing, Json& out);
  void add_words(const Standing& standing, Json& out) const;
  void add_motions(const Standing& standing, Json& out);
  void add_motion(const Standing& standing, std::size_t index, Json& out) const;
  void add_written(const Standing& standing, Json& out) const;
  void add_tables(const Standing& standing, Json& out);
  void add_rows(const Standing& standing, std::size_t dependency, Json& out);
  void add_cells(const Standing& standing, std::size_t dependency, const std::string& row, Json& out) const;
  std::vector<Node> nodes_;
};

}  // namespace isogloss::dap
