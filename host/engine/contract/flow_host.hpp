/// Implements the service isogloss.flow/1: for a run that its blocks direct, or while an index is made.
#pragma once

#include "isogloss/engine/document.hpp"
#include "isogloss_flow.h"
#include "isogloss_provenance.h"

namespace isogloss {

class FlowHost {
 public:
  FlowHost() = default;
  virtual ~FlowHost() = default;
  FlowHost(const FlowHost&) = delete;
  FlowHost& operator=(const FlowHost&) = delete;

  virtual void label(std::string_view name, ig_label_kind kind) = 0;
  virtual std::int32_t go(const Document& document, ig_go& request) = 0;
  virtual bool frame(std::uint32_t level, ig_frame& out) const = 0;
  virtual ig_place here() const = 0;
  /// Bytes of the main program's text; 0: there are none.
  virtual std::size_t text(std::uint64_t, char*, std::size_t) const { return 0; }
  /// Where the block has asked the run to go on; none: behind the block.
  struct Request {
    enum class Kind : std::uint8_t { none, call, leave, again, jump };
    Kind kind = Kind::none;
    std::string program;                 ///< that is called, left or repeated
    std::string file;                    ///< where the run goes on
    std::uint32_t line = 0;              ///< there
    bool is_behind = false;              ///< not with the block of that line: with the one behind it
    std::uint32_t call_line = 0;         ///< leave: the line of the call, in that file
    std::uint32_t pass = 1, passes = 1;  ///< again: the one that begins; call: the number of passes
  };
  virtual Request requested() const { return {}; }
  /// Is this the file that a user means by `wanted`, with or without its folder? Empty: the main program's.
  virtual bool is_file(std::string_view name, std::string_view wanted) const = 0;
};

/// The service's functions, for a chain that runs.
ig_flow_1 flow_service();
/// Rows that answer are kept in Chain::answered_rows.
ig_provenance_1 provenance_service();

}  // namespace isogloss
