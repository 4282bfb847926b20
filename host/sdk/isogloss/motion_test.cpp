#include "isogloss/motion.hpp"

#include <new>
#include <utility>

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using isogloss_test::BlockDocument;

namespace {

/// Moves of both kinds, a dwell, a feed move without feed, a spindle stop, and more pecks than are handed over at once.
template <class Rapid, class Feed, class Dwell, class Stop>
void make_steps(const Rapid& rapid, const Feed& feed, const Dwell& dwell, const Stop& stop) {
  rapid({1, 2, 50});
  feed({1, 2, -3}, 1.5);
  dwell(0.25);
  feed({1, 2, -4}, 0);
  stop();
  for (int k = 0; k < 40; ++k) {
    feed({1, 2, -5.0 - k}, 2);
    rapid({1, 2, 3});
  }
}

/// Each as text.
std::vector<std::string> steps_of(BlockDocument& document) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < document.step_count(); ++i) {
    std::string& text = out.emplace_back();
    for (const char* path : {"MotionEvent.Form", "SpindleControl.Direction"})
      if (document.step_has(i, path)) text += document.step_name(i, path) + ' ';
    if (document.step_has(i, "MotionEvent.IsRapid"))
      text += std::to_string(document.step_integer(i, "MotionEvent.IsRapid"));
    for (const char* path : {"ProgramXyz.X", "ProgramXyz.Y", "ProgramXyz.Z", "MotionEvent.Feedrate_mmds", "Dwell.Time"})
      text += document.step_has(i, path) ? ' ' + std::to_string(document.step(i, path)) : " -";
  }
  return out;
}

}  // namespace

TEST_CASE("steps that are handed over several at a time are the steps of single calls") {
  BlockDocument alone, together;
  const auto motion = alone.member<ig::CompoundMotion>();
  ig::Block b = alone.block();
  make_steps([&](const ig::Vec3& p) { motion.rapid_to(b, p); },
             [&](const ig::Vec3& p, double feed) { motion.feed_to(b, p, feed); },
             [&](double seconds) { motion.dwell(b, seconds); }, [&] { motion.spindle(b, ig::Spindle::stop); });

  const auto other = together.member<ig::CompoundMotion>();
  ig_host host = *together.block().host();
  static decltype(ig_host::append) append;
  static int calls;
  append = std::exchange(host.append, [](ig_block* block, const ig_field* fields, std::uint32_t count,
                                         const ig_value* v) { return ++calls, append(block, fields, count, v); });
  calls = 0;
  const bool is_newer = GENERATE(false, true);
  CAPTURE(is_newer);
  if (!is_newer) host.struct_size = offsetof(ig_host, append_many);
  ig::Block block(&host, together.block().raw());
  {
    ig::CompoundSteps steps(block, other);
    make_steps([&](const ig::Vec3& p) { steps.rapid_to(p); },
               [&](const ig::Vec3& p, double feed) { steps.feed_to(p, feed); },
               [&](double seconds) { steps.dwell(seconds); }, [&] { steps.spindle(ig::Spindle::stop); });
  }
  CHECK(steps_of(together) == steps_of(alone));
  CHECK(alone.step_count() == 85);
  CHECK(calls == (is_newer ? 2 : 85));  // of the dwell and of the spindle alone
}

TEST_CASE("a host that has no memory for the steps is asked once") {
  BlockDocument document;
  const auto motion = document.member<ig::CompoundMotion>();
  ig_host host = *document.block().host();
  static int calls;
  calls = 0;
  host.append_many = [](ig_block*, const ig_field*, std::uint32_t, std::uint32_t, const std::uint32_t*,
                        const ig_value*) -> std::uint32_t {
    ++calls;
    throw std::bad_alloc();
  };
  ig::Block block(&host, document.block().raw());
  const bool is_at_end = GENERATE(false, true);
  CAPTURE(is_at_end);
  const auto cycle = [&] {
    ig::CompoundSteps steps(block, motion);
    steps.rapid_to({1, 2, 3});
    if (!is_at_end) steps.dwell(1);
  };
  CHECK_THROWS_AS(cycle(), std::bad_alloc);
  CHECK(calls == 1);
}
