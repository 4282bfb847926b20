#include "isogloss/engine/motion_stream.hpp"

#include <catch2/catch.hpp>
#include <cstring>

#include "export/record_writer.hpp"
#include "export/test_motions.hpp"

namespace isogloss {

namespace {

/// Some events of each kind, as a run writes them.
std::string events_of_each_kind() {
  StringOutput output;
  RecordWriter writer(output);
  writer.header();
  writer.block({"part.nc", 3, 0, {}});
  Move m;
  m.kind = Move::Kind::rapid;
  m.program = {{1, 2, 3}, 7};
  m.machine = {{1, 2, -7, 0, 0, 45}, 0x27};
  m.is_manual = true;
  writer.move(m, 0.5);
  m.is_manual = false;
  m.kind = Move::Kind::feed;
  m.machine = {{1.0 / 3, 2, 0}, 3};
  m.program = {{0, 2, 0}, 2};
  m.has_feed = true;
  m.feed_mmds = 10;
  writer.move(m, 2);
  const std::string long_name = std::string(300, 'x') + "\xff.nc";
  writer.block({long_name, 4, 0, {}});
  m.kind = Move::Kind::arc;
  m.program = {{10, 0, 0}, 7};
  m.machine = {{10, 0, -50}, 7};
  m.arc.plane = "XY";
  m.arc.has_center = true;
  m.arc.is_ccw = true;
  m.arc.additional_circles = 2;
  m.arc.start[0] = -10;
  m.arc.normal[2] = 1;
  writer.move(m, 3);
  m.arc.has_center = false;
  writer.move(m, 3);
  writer.dwell(1.5);
  writer.spindle("CW", true, 1000);
  writer.spindle("STOP", false, 0);
  writer.orient(90);
  writer.tool(123456789012345678);
  writer.coolant("M8, \"flood\"");
  writer.stop("PAUSE");
  writer.end("LAST");
  writer.flush();
  return output.text;
}

std::string converted(const std::string& stream, MotionOptions options, DiagnosticSink& sink) {
  StringOutput out;
  const auto source = memory_source(stream);
  convert_motions(*source, "part.igm", out, options, sink);
  return out.text;
}

/// The code and message with which a damaged stream is refused.
std::string refusal(const std::string& stream) {
  DiagnosticList said;
  converted(stream, {}, said);
  return said.all.size() == 1 ? said.all[0].code + " " + said.all[0].message : std::to_string(said.all.size());
}

MotionRecord& record_at(std::string& stream, std::size_t place) {
  return *reinterpret_cast<MotionRecord*>(stream.data() + motion_stream_header_bytes + place * sizeof(MotionRecord));
}

/// The place of the first record of this kind.
std::size_t first(std::string& stream, std::uint8_t event) {
  std::size_t place = 0;
  while (record_at(stream, place).event != event) ++place;
  return place;
}

std::string changed(const std::function<void(std::string&)>& change) {
  std::string stream = events_of_each_kind();
  change(stream);
  return refusal(stream);
}

}  // namespace

TEST_CASE("a binary motion stream converts to the text that the run would have written") {
  DiagnosticList said;
  MotionOptions options;
  options.format = Format::csv;
  options.exact = true;
  const std::string csv = converted(events_of_each_kind(), options, said);
  CHECK(said.all.empty());
  CHECK_THAT(csv, Catch::Contains("\npart.nc,3,rapid,1,2,3,1,2,-7,,,45,,,,,,,,,,,,,,,,manual\n"));
  CHECK_THAT(csv, Catch::Contains("\npart.nc,3,feed,,2,,0.3333333333333333,2,,,,,10,"));
  CHECK_THAT(csv, Catch::Contains(std::string(300, 'x') +
                                  "\xEF\xBF\xBD.nc,4,arc,10,0,0,10,0,-50,,,,10,0,0,0,1,2,XY,0,0,0,0,0,1,900,,\n"));
  CHECK_THAT(csv, Catch::Contains("tool,,,,,,,,,,,,,,,,,,,,,,,,123456789012345678,\n"));
  CHECK_THAT(csv, Catch::Contains("\"M8, \"\"flood\"\"\"\n"));
}

TEST_CASE("a listener gets the events of a binary motion stream") {
  std::vector<Motion::Event> events;
  double sweep = 0;
  std::uint32_t known_before_the_feed = 0;
  DiagnosticList said;
  const std::string stream = events_of_each_kind();
  const auto source = memory_source(stream);
  CHECK(read_motions(
      *source, "part.igm",
      [&](const Motion& m) {
        events.push_back(m.event);
        if (m.arc != nullptr && m.arc->has_center) sweep = m.arc->sweep_deg;
        if (m.event == Motion::Event::feed) known_before_the_feed = m.machine_start.known;
        return true;
      },
      said));
  CHECK(events.size() == 12);
  CHECK(sweep == 900);
  CHECK(known_before_the_feed == 0x27);
}

TEST_CASE("a stream may come in pieces of any size") {
  const std::string stream = events_of_each_kind();
  for (const std::size_t size : {1u, 7u, 119u, 121u, 959u, 100'000u}) {
    std::size_t events = 0;
    DiagnosticList said;
    MotionStreamReader reader(
        "part.igm",
        [&](const MotionRecord&, const MotionRecord*) {
          ++events;
          return true;
        },
        said);
    for (std::size_t at = 0; at < stream.size(); at += size)
      CHECK(reader.take(std::string_view(stream).substr(at, size)));
    CHECK(reader.end());
    CHECK(events == 12);
  }
}

TEST_CASE("a damaged stream is refused with a diagnostic, and never read beyond its end") {
  const std::string whole = events_of_each_kind();
  CHECK_THAT(refusal(""), Catch::StartsWith("IG-0640"));
  CHECK_THAT(refusal("a part program\n"), Catch::StartsWith("IG-0640"));
  CHECK_THAT(refusal(whole.substr(1)), Catch::StartsWith("IG-0640"));
  CHECK_THAT(refusal(whole.substr(0, 100)), Catch::StartsWith("IG-0642") && Catch::Contains("its header"));
  for (std::size_t size = motion_stream_header_bytes + 1; size < whole.size(); size += 7)
    if ((size - motion_stream_header_bytes) % sizeof(MotionRecord) != 0)
      CHECK_THAT(refusal(whole.substr(0, size)), Catch::StartsWith("IG-0642"));
  CHECK_THAT(changed([](std::string& s) { s[8] = 2; }), Catch::StartsWith("IG-0641"));
  CHECK_THAT(changed([](std::string& s) { s[16] = 121; }), Catch::StartsWith("IG-0641"));
  using R = MotionRecord;
  const auto at = [](std::uint8_t event, const std::function<void(R&)>& damage) {
    return changed([&](std::string& s) { damage(record_at(s, first(s, event))); });
  };
  CHECK_THAT(at(0, [](R& r) { r.event = 77; }), Catch::Contains("unknown kind"));
  CHECK_THAT(at(0, [](R& r) { r.file = 1000; }), Catch::Contains("its file has no name"));
  CHECK_THAT(at(0, [](R& r) { r.known = 512; }), Catch::Contains("unknown axis"));
  CHECK_THAT(at(0, [](R& r) { r.text = 0; }), Catch::Contains("its kind has no text"));
  CHECK_THAT(at(9, [](R& r) { r.text = R::no_text; }), Catch::Contains("its text is missing"));
  CHECK_THAT(at(9, [](R& r) { r.text = 4'000'000'000; }), Catch::Contains("its text is missing"));
  CHECK_THAT(at(2, [](R& r) { r.flags = 0; }), Catch::Contains("a circle precedes it"));
  CHECK_THAT(at(R::circle_record, [](R& r) { r.event = 3; }), Catch::Contains("its circle is missing"));
  CHECK_THAT(at(R::text_record, [](R& r) { r.line = 1; }), Catch::Contains("another number"));
  CHECK_THAT(at(R::text_record, [](R& r) { r.file = 4'000'000'000; }), Catch::Contains("a length that no record has"));
  CHECK_THAT(at(R::text_record, [](R& r) { r.flags = R::goes_on; }), Catch::StartsWith("IG-0643"));
}

TEST_CASE("texts without end do not fill the memory") {
  std::string stream = motion_stream_header();
  MotionRecord text{};
  text.event = MotionRecord::text_record;
  text.flags = MotionRecord::goes_on;
  text.file = text_record_bytes;
  const std::string endless(reinterpret_cast<const char*>(&text), sizeof text);
  DiagnosticList said;
  MotionStreamReader reader(
      "part.igm", [](const MotionRecord&, const MotionRecord*) { return true; }, said);
  CHECK(reader.take(stream));
  std::size_t taken = 0;
  while (taken < 2'000'000 && reader.take(endless)) ++taken;
  CHECK(taken < 1'000'000);
  REQUIRE(said.all.size() == 1);
  CHECK(said.all[0].code == "IG-0643");
}

TEST_CASE("a run without events is a header alone") {
  test::Stream run({Format::binary, false, false, false, {}});
  run.block(1, [] {});
  const std::string stream = run.text();
  CHECK(stream == motion_stream_header());
}

}  // namespace isogloss
