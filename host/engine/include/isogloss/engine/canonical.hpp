/// The motions of a run as plain blocks, which any control and any viewer reads.
#pragma once

#include "isogloss/engine/diagnostic.hpp"
#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/program_text.hpp"

namespace isogloss {

struct CanonicalOptions {
  enum class Frame : std::uint8_t { machine, program };
  Frame frame = Frame::machine;  ///< which coordinates are written
  bool exact = false;            ///< numbers that read back to the same double, in place of 6 decimals
  bool zero_moves = false;       ///< keep linear moves that change no machine axis
  double tolerance_mm = 0.001;   ///< of the lines in place of a path that no block describes
};

/// Writes with the rows of `text`, which must live as long as the exporter, as `sink` must. What no block can say is
/// reported there. Millimetres, degrees and units per minute.
std::unique_ptr<Exporter> make_canonical_exporter(Output& output, const ProgramText& text,
                                                  const CanonicalOptions& options, DiagnosticSink& sink);

}  // namespace isogloss
