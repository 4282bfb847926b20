// Scanners that say that they may be asked ahead: what another instance found before the turn of the block is what they
// would find in it, and build() needs no more.
#include <fmt/format.h>

#include <algorithm>

#include "isogloss/engine/scanned_line.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

bool scans_ahead(const ig_syntax& syntax) { return (syntax.scan_flags & IG_SCANS_AHEAD) != 0; }

/// A block of which another instance has read the text.
struct Ahead {
  TestBlock block;
  LineNotes notes;
  std::vector<Leftover> leftovers;  // which no scanner took
};

/// The host reports them, where no scanner takes them.
bool holds_control_characters(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

/// Those that are not left to their turn. They are read from the last to the first, so that nothing may be kept of the
/// block before.
std::vector<Ahead> read_ahead(const Stand& stand, std::vector<TestBlock> blocks) {
  ChainSettings settings;
  settings.host = &ahead_table();
  std::vector<Ahead> out;
  LineNotes before;
  Bench bench(stand.alone, settings);
  bench.chain().notes = &before;
  bench.start();
  std::reverse(blocks.begin(), blocks.end());
  for (TestBlock& block : blocks) {
    if (holds_control_characters(block.text)) continue;
    Ahead ahead{std::move(block), {}, {}};
    bench.chain().notes = &before;
    bench.prepare(ahead.block);
    bench.chain().notes = &ahead.notes;
    Document& d = bench.chain().document();
    d.begin_scan(ahead.notes.summary);
    ++bench.chain().builds;  // work of its own to the watch over calls that do not return
    bench.scan();
    ahead.leftovers = d.leftovers;
    ahead.notes.complete(d);
    if (!ahead.notes.line.is_left) out.push_back(std::move(ahead));
  }
  std::reverse(out.begin(), out.end());
  bench.chain().notes = &before;
  return out;
}

}  // namespace

void check_scan_ahead(Examination& e) {
  constexpr std::uint64_t random_ones = 300;
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e, Missing::is_told_elsewhere)) {
    if (!scans_ahead(*stand.syntax)) continue;
    e.attempt(fmt::format("{}, texts that are scanned ahead", stand.syntax->id));
    const std::vector<Ahead> all = read_ahead(stand, many_blocks(stand, e, random_ones));
    Bench usual(stand.alone, {}), other(stand.alone, {});
    usual.start();
    other.start();
    for (const Ahead& ahead : all) {
      other.read_text = [&](Chain& chain) {
        if (!chain.take_scanned(ahead.notes.line)) chain.scan_with(stand.alone.position);
        chain.document().leftovers = ahead.leftovers;
      };
      const std::string in_turn = usual.run(ahead.block).shown, given = other.run(ahead.block).shown;
      if (in_turn == given) continue;
      e.find(
          fmt::format("{}, the text {:?}", stand.syntax->id, ahead.block.text),
          fmt::format("scanned ahead, and built by another instance, it gives\n{}\nin place of\n{}", given, in_turn));
      break;
    }
  }
}

}  // namespace isogloss::cli
