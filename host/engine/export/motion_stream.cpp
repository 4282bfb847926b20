// The binary motion stream, read: header, texts and circles are checked before an event may use them.
#include "isogloss/engine/motion_stream.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "export/motion_lines.hpp"
#include "export/motion_teller.hpp"
#include "export/record_writer.hpp"

namespace isogloss {

namespace {

/// All texts of a stream together: file names and terms. A stream that repeats one text record would fill the memory.
constexpr std::size_t most_text_bytes = std::size_t{64} << 20;
constexpr std::uint16_t all_axes = (1u << 9) - 1;

struct HeaderNumbers {
  std::uint32_t version, header_bytes, record_bytes, reserved;
};

constexpr std::string_view header_text =
    R"({"Isogloss":1,"Units":"mm, deg, s, mm/s",)"
    R"("Events":["rapid","feed","arc","dwell","spindle","orient","tool","coolant","stop","end"],)"
    R"("SideRecords":{"text":128,"circle":129},)"
    R"("Flags":{"manual":1,"led":2,"has_feed":4,"has_value":8,"ccw":16,"has_center":32,"goes_on":64},)"
    R"("Fields":[["line","<u4"],["file","<u4"],["event","u1"],["flags","u1"],["known","<u2"],["text","<u4"],)"
    R"(["program","<f8",3],["machine","<f8",6],["feed","<f8"],["value","<f8"],["count","<i8"],["seconds","<f8"]]})";
static_assert(motion_stream_magic.size() + sizeof(HeaderNumbers) + header_text.size() < motion_stream_header_bytes);

Motion::Event event_of(const MotionRecord& r) { return static_cast<Motion::Event>(r.event); }
bool has(const MotionRecord& r, MotionRecord::Flag flag) { return (r.flags & flag) != 0; }

/// An event that has a text: the plane, the direction, the mode, the code.
bool needs_text(Motion::Event event) {
  using E = Motion::Event;
  return event == E::arc || event == E::spindle || event == E::coolant || event == E::stop || event == E::end;
}

/// Gives the records of a stream to what takes the events of a run.
class Replay {
 public:
  void use(const std::vector<std::string>& texts) { texts_ = &texts; }

  template <class Events>
  void event(const MotionRecord& r, const MotionRecord* circle, Events& events) {
    if (r.file != file_) {
      // A text is named by its number: its address may change when further texts come in.
      file_ = r.file;
      name_ = (*texts_)[r.file];
      if constexpr (requires { events.forget_file(); }) events.forget_file();
    }
    source_.file = name_;
    source_.line = r.line;
    events.block(source_);
    switch (event_of(r)) {
      case Motion::Event::dwell: events.dwell(r.value); break;
      case Motion::Event::orient: events.orient(r.value); break;
      case Motion::Event::tool: events.tool(r.count); break;
      case Motion::Event::spindle: {
        const bool has_speed = has(r, MotionRecord::has_value);
        events.spindle(text(r), has_speed, has_speed ? r.value : 0);
        break;
      }
      case Motion::Event::coolant: events.coolant(text(r)); break;
      case Motion::Event::stop: events.stop(text(r)); break;
      case Motion::Event::end: events.end(text(r)); break;
      default: move(r, circle, events);
    }
  }

 private:
  std::string_view text(const MotionRecord& r) const { return (*texts_)[r.text]; }

  template <class Events>
  void move(const MotionRecord& r, const MotionRecord* circle, Events& events) {
    constexpr Move::Kind kinds[] = {Move::Kind::rapid, Move::Kind::feed, Move::Kind::arc};
    move_.kind = kinds[r.event];
    move_.is_manual = has(r, MotionRecord::manual);
    move_.is_led = has(r, MotionRecord::led);
    move_.has_feed = has(r, MotionRecord::has_feed);
    move_.feed_mmds = r.feed;
    move_.from = position_;
    move_.program.known = r.known & 7u;
    std::copy_n(r.program, 3, move_.program.at);
    move_.machine.known = static_cast<std::uint32_t>(r.known) >> 3;
    std::copy_n(r.machine, 6, move_.machine.at);
    if (move_.kind == Move::Kind::arc) arc(r, circle);
    for (unsigned i = 0; i < 6; ++i)
      if (move_.machine.has(i)) position_.at[i] = r.machine[i];
    position_.known |= move_.machine.known;
    events.move(move_);
  }

  void arc(const MotionRecord& r, const MotionRecord* circle) {
    move_.arc = {};
    move_.arc.plane = text(r);
    move_.arc.is_ccw = has(r, MotionRecord::ccw);
    move_.arc.additional_circles = r.count;
    move_.arc.has_center = circle != nullptr;
    if (circle == nullptr) return;
    std::copy_n(circle->program, 3, move_.arc.center);
    std::copy_n(circle->machine, 3, move_.arc.machine_center);
    std::copy_n(circle->machine + 3, 3, move_.arc.normal);
    move_.arc.sweep = circle->value;
  }

  const std::vector<std::string>* texts_ = nullptr;
  std::uint32_t file_ = MotionRecord::no_text;
  std::string name_;
  BlockSource source_{};
  Move move_;
  AxisPoint position_;
};

template <class Events, class GoesOn>
bool replay(Source& stream, const std::string& name, Events& events, const GoesOn& goes_on, DiagnosticSink& sink) {
  Replay records;
  MotionStreamReader reader(
      name,
      [&](const MotionRecord& event, const MotionRecord* circle) {
        records.event(event, circle, events);
        return goes_on();
      },
      sink);
  records.use(reader.texts());
  const auto buffer = std::make_unique_for_overwrite<char[]>(std::size_t{1} << 16);
  while (const std::size_t n = stream.read(buffer.get(), std::size_t{1} << 16))
    if (!reader.take({buffer.get(), n})) return !goes_on();
  if (const std::string failure = stream.failure(); !failure.empty()) {
    sink.add(host_diagnostic("IG-0510", {name, 0, 0}, {failure}));
    return false;
  }
  return reader.end();
}

template <class Lines>
bool convert(Source& stream, const std::string& name, Lines lines, const MotionOptions& options, DiagnosticSink& sink) {
  MotionOptions plain = options;
  plain.header = false;  // which JSON Lines have with the name of the dialect, and a stream has no name
  lines.header(plain);
  const bool is_whole = replay(
      stream, name, lines, [&] { return lines.buffer().ok(); }, sink);
  lines.buffer().flush();
  return is_whole;
}

}  // namespace

const std::string& motion_stream_header() {
  static const std::string header = [] {
    const HeaderNumbers numbers{motion_stream_version, motion_stream_header_bytes, sizeof(MotionRecord), 0};
    const auto bytes = std::bit_cast<std::array<char, sizeof numbers>>(numbers);
    std::string out(motion_stream_magic);
    out.append(bytes.data(), bytes.size());
    out += header_text;
    out.resize(motion_stream_header_bytes - 1, ' ');
    return out + '\n';
  }();
  return header;
}

MotionStreamReader::MotionStreamReader(std::string name, OnRecord on_record, DiagnosticSink& sink)
    : name_(std::move(name)), on_record_(std::move(on_record)), sink_(sink) {}

bool MotionStreamReader::fail(std::string_view code, std::initializer_list<std::string> arguments) {
  sink_.add(host_diagnostic(code, {name_, 0, 0}, arguments));
  ended_ = true;
  return false;
}

bool MotionStreamReader::take(std::string_view bytes) {
  const auto take_piece = [&](std::size_t size) {
    const std::size_t more = std::min(size - waiting_.size(), bytes.size());
    waiting_.append(bytes.substr(0, more));
    bytes.remove_prefix(more);
    return waiting_.size() == size;
  };
  if (ended_) return false;
  if (!has_header_) {
    if (!take_piece(motion_stream_header_bytes)) return true;
    if (!take_header()) return false;
  }
  MotionRecord record;
  if (!waiting_.empty()) {
    if (!take_piece(sizeof record)) return true;
    std::memcpy(&record, waiting_.data(), sizeof record);
    waiting_.clear();
    if (!take_record(record)) return false;
  }
  // Where it stands, if it may: a copy of each record would cost more than its check.
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(MotionRecord) == 0;
  for (; bytes.size() >= sizeof record; bytes.remove_prefix(sizeof record)) {
    if (!is_aligned) std::memcpy(&record, bytes.data(), sizeof record);
    const MotionRecord& next = is_aligned ? *reinterpret_cast<const MotionRecord*>(bytes.data()) : record;
    if (!(is_line(next) ? take_line(next) : take_record(next))) return false;
  }
  waiting_ = bytes;
  return true;
}

bool MotionStreamReader::end() {
  if (ended_) return false;
  ended_ = true;
  if (!has_header_) {
    const bool begins_well = waiting_.size() >= motion_stream_magic.size() && waiting_.starts_with(motion_stream_magic);
    return begins_well ? fail("IG-0642", {"its header"}) : fail("IG-0640", {});
  }
  if (!waiting_.empty() || text_goes_on_ || has_circle_)
    return fail("IG-0642", {"record " + std::to_string(records_ + (waiting_.empty() ? 0 : 1))});
  return true;
}

bool MotionStreamReader::take_header() {
  if (!waiting_.starts_with(motion_stream_magic)) return fail("IG-0640", {});
  HeaderNumbers numbers;
  std::memcpy(&numbers, waiting_.data() + motion_stream_magic.size(), sizeof numbers);
  if (numbers.version != motion_stream_version || numbers.header_bytes != motion_stream_header_bytes ||
      numbers.record_bytes != sizeof(MotionRecord))
    return fail("IG-0641", {std::to_string(numbers.version), std::to_string(numbers.record_bytes),
                            std::to_string(motion_stream_version), std::to_string(sizeof(MotionRecord))});
  has_header_ = true;
  waiting_.clear();
  return true;
}

/// A sound record of a rapid or a feed move, as nearly all are: one question in place of many.
bool MotionStreamReader::is_line(const MotionRecord& record) const {
  return record.event <= static_cast<unsigned>(Motion::Event::feed) && record.text == MotionRecord::no_text &&
         record.known <= all_axes && record.file < texts_.size() && !has_circle_ && !text_goes_on_;
}

bool MotionStreamReader::take_line(const MotionRecord& record) {
  ++records_;
  ended_ = !on_record_(record, nullptr);
  return !ended_;
}

bool MotionStreamReader::take_record(const MotionRecord& record) {
  ++records_;
  if (record.event == MotionRecord::text_record) return take_text(record);
  if (text_goes_on_) return fail("IG-0643", {std::to_string(records_), "a text that goes on is not continued"});
  if (record.event != MotionRecord::circle_record) return take_event(record);
  if (has_circle_) return fail("IG-0643", {std::to_string(records_), "a second circle follows the first"});
  circle_ = record;
  has_circle_ = true;
  return true;
}

bool MotionStreamReader::take_text(const MotionRecord& record) {
  const auto fails = [&](const char* why) { return fail("IG-0643", {std::to_string(records_), why}); };
  const bool is_continued = text_goes_on_;
  text_goes_on_ = has(record, MotionRecord::goes_on);
  if (record.line + std::size_t{is_continued} != texts_.size())
    return fails("its text has another number than the next");
  if (record.file > text_record_bytes || (text_goes_on_ && record.file != text_record_bytes))
    return fails("its text has a length that no record has");
  text_bytes_ += record.file + sizeof(std::string);
  if (text_bytes_ > most_text_bytes) return fails("the texts take more than 64 MiB");
  const auto bytes = std::bit_cast<std::array<char, sizeof record>>(record);
  if (!is_continued) texts_.emplace_back();
  texts_.back().append(bytes.data() + offsetof(MotionRecord, program), record.file);
  return true;
}

bool MotionStreamReader::take_event(const MotionRecord& record) {
  const auto fails = [&](const char* why) { return fail("IG-0643", {std::to_string(records_), why}); };
  if (record.event > static_cast<unsigned>(Motion::Event::end)) return fails("it is of an unknown kind");
  if (record.file >= texts_.size()) return fails("its file has no name");
  const Motion::Event event = event_of(record);
  const bool has_text = record.text != MotionRecord::no_text;
  if (has_text && record.text >= texts_.size()) return fails("its text is missing");
  if (has_text != needs_text(event)) return fails(has_text ? "its kind has no text" : "its text is missing");
  if (record.known > all_axes) return fails("it has an unknown axis");
  const bool needs_circle = event == Motion::Event::arc && has(record, MotionRecord::has_center);
  if (needs_circle != has_circle_) return fails(has_circle_ ? "a circle precedes it" : "its circle is missing");
  has_circle_ = false;
  ended_ = !on_record_(record, needs_circle ? &circle_ : nullptr);
  return !ended_;
}

bool read_motions(Source& stream, const std::string& name, const MotionListener& listener, DiagnosticSink& sink) {
  MotionTeller teller(listener);
  return replay(
      stream, name, teller, [&] { return teller.goes_on(); }, sink);
}

bool convert_motions(Source& stream, const std::string& name, Output& output, const MotionOptions& options,
                     DiagnosticSink& sink) {
  switch (options.format) {
    case Format::csv:
      return options.exact ? convert(stream, name, CsvLines<true>(output), options, sink)
                           : convert(stream, name, CsvLines<false>(output), options, sink);
    case Format::text: return convert(stream, name, TextLines(output, options.exact), options, sink);
    case Format::binary: throw std::invalid_argument("a motion stream is converted to text");
    case Format::jsonl: break;
  }
  return options.exact ? convert(stream, name, JsonLines<true>(output), options, sink)
                       : convert(stream, name, JsonLines<false>(output), options, sink);
}

}  // namespace isogloss
