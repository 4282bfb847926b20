/// What a run writes: blocks, motions, a summary. Exporters read finished blocks in program order.
#pragma once

#include <memory>
#include <string>

#include "isogloss/engine/document.hpp"

namespace isogloss {

class Chain;

/// Bytes out, through one buffer. Not copyable; flushes when told, not when destroyed. The exporter of motions calls
/// write() from a thread of its own, one call at a time; none is under way after Exporter::end(). What it throws there
/// comes out of end().
class Output {
 public:
  virtual ~Output() = default;
  virtual bool write(std::string_view bytes) = 0;  ///< false: the reader is gone or the disk is full
};

/// Called for each executed block, in program order.
class Exporter {
 public:
  virtual ~Exporter() = default;
  /// Before the first block; the document holds the initial state.
  virtual void begin(Document& initial, const SymbolTable& symbols) = 0;
  /// False stops the run quietly (closed output).
  virtual bool block(Document& document, const SymbolTable& symbols) = 0;
  virtual bool end() = 0;
};

/// binary: of motions alone, see motion_stream.hpp.
enum class Format { jsonl, csv, text, binary };

struct MotionOptions {
  Format format = Format::jsonl;
  bool header = false;      ///< JSON Lines: a first line with version, dialect, units
  bool zero_moves = false;  ///< keep linear moves that change no machine axis
  bool exact = false;       ///< shortest text that reads back to the same double
  std::string dialect{};
};

std::unique_ptr<Exporter> make_motion_exporter(Output& output, const MotionOptions& options);
/// Blocks as JSON Lines or as text for people; no other format.
std::unique_ptr<Exporter> make_block_exporter(Output& output, Format format);

/// Rapid rates of the axes, for times; mm/s and deg/s, 0: unknown.
struct RapidRates {
  double per_second[6] = {0, 0, 0, 0, 0, 0};  ///< X Y Z A B C
};
/// Those that the tables of a run give.
RapidRates rapid_rates(const Chain& chain);

struct Summary {
  std::uint64_t blocks = 0, events = 0, rapids = 0, feeds = 0, arcs = 0;
  double rapid_length_mm = 0, feed_length_mm = 0;
  double rapid_seconds = 0, feed_seconds = 0, dwell_seconds = 0;
  bool rapid_time_known = true, feed_time_known = true;
  bool any_motion = false;
  double minimum[6] = {}, maximum[6] = {};  ///< machine coordinates; arcs with their bulge
  double program_minimum[3] = {}, program_maximum[3] = {};
  std::uint32_t axes = 0;  ///< bit for each machine axis that has a value
  std::uint64_t tool_changes = 0;
  double turned_deg[3] = {};       ///< how far A, B and C turned, there and back
  std::uint64_t slowed_feeds = 0;  ///< that an axis at its rapid rate holds back
};
/// Adds up into `summary`, which must live as long as the exporter.
std::unique_ptr<Exporter> make_summary_exporter(Summary& summary, const RapidRates& rates);
/// The binary stream, and what make_summary_exporter() adds up, in one pass: a third of the time that the totals take
/// by themselves.
std::unique_ptr<Exporter> make_motion_exporter(Output& output, Summary& summary);

}  // namespace isogloss
