/// The binary motion stream: `isogloss run --emit motions --format binary` writes it, and these functions read it. The
/// format is described in host/engine/export/motion_stream.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"
#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/motion.hpp"
#include "isogloss/engine/runner.hpp"

namespace isogloss {

inline constexpr std::string_view motion_stream_magic = "\x93IGMOTN\n";
inline constexpr std::uint32_t motion_stream_version = 1;
/// Eight records long, so that an array of records may begin at either.
inline constexpr std::size_t motion_stream_header_bytes = 960;

/// One record, little-endian. Its meaning for each kind of event stands in motion_stream.md.
struct MotionRecord {
  enum Kind : std::uint8_t { first_side_record = 128, text_record = 128, circle_record = 129 };
  enum Flag : std::uint8_t {
    manual = 1,
    led = 2,
    has_feed = 4,
    has_value = 8,
    ccw = 16,
    has_center = 32,
    goes_on = 64
  };
  static constexpr std::uint32_t no_text = 0xffffffff;

  std::uint32_t line;
  std::uint32_t file;   ///< number of a text
  std::uint8_t event;   ///< a Motion::Event, or one of Kind
  std::uint8_t flags;   ///< of Flag
  std::uint16_t known;  ///< bits 0 to 2: X Y Z of program; bits 3 to 8: X Y Z A B C of machine
  std::uint32_t text;   ///< number of a text, or no_text
  double program[3];
  double machine[6];
  double feed;
  double value;
  std::int64_t count;
  double seconds;
};
static_assert(sizeof(MotionRecord) == 120);

/// The header with its field table, motion_stream_header_bytes long.
const std::string& motion_stream_header();

/// Takes a stream apart that comes in pieces of any size. Belongs to one thread at a time.
class MotionStreamReader {
 public:
  /// Gets each event with the circle of an arc whose centre is known, else null; both are borrowed until it returns.
  /// False ends the reading quietly.
  using OnRecord = std::function<bool(const MotionRecord& event, const MotionRecord* circle)>;

  /// `name` is the stream's in diagnostics.
  MotionStreamReader(std::string name, OnRecord on_record, DiagnosticSink& sink);

  /// False at the first damage, which is reported, and when on_record wants no more.
  bool take(std::string_view bytes);
  /// False, and reported, when the stream ends in the middle.
  bool end();
  /// File names and terms by their numbers; it grows while records come in.
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  bool take_header();
  bool is_line(const MotionRecord& record) const;
  bool take_line(const MotionRecord& record);
  bool take_record(const MotionRecord& record);
  bool take_text(const MotionRecord& record);
  bool take_event(const MotionRecord& record);
  bool fail(std::string_view code, std::initializer_list<std::string> arguments);

  std::string name_;
  OnRecord on_record_;
  DiagnosticSink& sink_;
  std::string waiting_;  // the beginning of the header or of a record
  std::vector<std::string> texts_;
  std::size_t text_bytes_ = 0;
  bool text_goes_on_ = false, has_circle_ = false, has_header_ = false, ended_ = false;
  MotionRecord circle_{};
  std::uint64_t records_ = 0;
};

/// Reads a whole stream; false, and reported, when it is damaged. The listener gets the events as from
/// make_motion_listener(), except that a stream does not hold MotionArc::program_start (zeros), and that
/// Motion::machine_start is where the moves before have ended.
bool read_motions(Source& stream, const std::string& name, const MotionListener& listener, DiagnosticSink& sink);

/// Writes a whole stream as text: the bytes that the run would have written itself. False, and reported, when the
/// stream is damaged: what came before the damage is written. Throws std::invalid_argument for Format::binary.
bool convert_motions(Source& stream, const std::string& name, Output& output, const MotionOptions& options,
                     DiagnosticSink& sink);

}  // namespace isogloss
