// Binary motion streams: reported where they are damaged, and the same whatever the form they are converted to.
#include <cmath>

#include "isogloss/engine/motion_stream.hpp"
#include "isogloss/engine/runner.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

class StreamTarget : public Target {
 public:
  void run(std::string_view bytes) override {
    std::size_t heard = 0;
    DiagnosticList said;
    const std::unique_ptr<Source> source = memory_source(bytes);
    const bool is_whole = read_motions(
        *source, "stream",
        [&](const Motion&) {
          ++heard;
          return true;
        },
        said);
    if (is_whole == said.has_errors()) fail("a damaged stream is reported, and no other");
    if (is_whole && heard > 0) accept();
    for (const Format format : {Format::csv, Format::jsonl, Format::text}) {
      DiagnosticList of_form;
      TextOutput text;
      const std::unique_ptr<Source> again = memory_source(bytes);
      if (convert_motions(*again, "stream", text, {format, false, true, true, {}}, of_form) != is_whole)
        fail("whether a stream is damaged does not depend on its form");
    }
  }

  std::vector<std::string> samples() const override {
    std::vector<std::string> out;
    for (const std::string& program : texts_of_files("tests/programs/fanuc", ".nc")) {
      if (out.size() == 30) break;
      TextOutput stream;
      const auto exporter = make_motion_exporter(stream, {Format::binary, false, true, true, {}});
      const std::unique_ptr<Source> source = memory_source(program);
      DiagnosticList ignored;
      isogloss::run(dialect("fanuc"), *source, "program", {}, {exporter.get()}, ignored);
      out.push_back(std::move(stream.text));
    }
    return out;
  }
};

}  // namespace

std::unique_ptr<Target> make_stream_target() { return std::make_unique<StreamTarget>(); }

}  // namespace isogloss::fuzz
