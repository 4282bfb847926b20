// Texts of the host, read beyond their end or after the call.
#include "validate/guarded_texts.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

#include "validate/subject.hpp"

namespace isogloss::cli {

GuardedTexts::~GuardedTexts() {
  for (const Page& p : pages_) munmap(p.begin, p.size);
}

ig_text GuardedTexts::copy(ig_text text) {
  if (text.data == nullptr) return text;
  const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t readable = (text.size + page - 1) / page * page;
  void* const mapped = mmap(nullptr, readable + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::runtime_error("no memory for a text");
  char* const end = static_cast<char*>(mapped) + readable;
  std::memcpy(end - text.size, text.data, text.size);
  if (readable > 0) mprotect(mapped, readable, PROT_READ);
  mprotect(end, page, PROT_NONE);
  pages_.push_back({mapped, readable + page});
  return {end - text.size, text.size};
}

void GuardedTexts::end_call() {
  constexpr std::size_t most_pages = 256;
  for (const Page& page : pages_) mprotect(page.begin, page.size, PROT_NONE);
  for (; pages_.size() > most_pages; pages_.pop_front()) munmap(pages_.front().begin, pages_.front().size);
}

namespace {

thread_local GuardedTexts* guarded = nullptr;

ig_host guarding_host() {
  ig_host out = host_table(Mode::fast);
  out.flags = 0;
  out.text = [](const ig_block* b, ig_field f) { return guarded->copy(host_table(Mode::fast).text(b, f)); };
  out.source = [](const ig_block* b) { return guarded->copy(host_table(Mode::fast).source(b)); };
  out.leftover = [](const ig_block* b, std::uint32_t index, ig_leftover* l) {
    const std::int32_t answer = host_table(Mode::fast).leftover(b, index, l);
    if (answer != 0) l->name = guarded->copy(l->name);
    return answer;
  };
  out.symbol_text = [](const ig_block* b, ig_symbol s) {
    return guarded->copy(host_table(Mode::fast).symbol_text(b, s));
  };
  return out;
}

/// Each text of the block is cut inside of a character, or holds what nobody expects.
void add_odd_texts(const Stand& stand, std::vector<TestBlock>& blocks) {
  const std::vector<FieldInfo>& infos = stand.alone.linked->layout.fields;
  const TestBlock full = full_block(stand.alone, fields_of(stand.alone));
  for (const std::string& text : odd_texts()) {
    TestBlock block = full;
    block.name = fmt::format("a block whose texts are {:?}", text);
    block.text = text;
    for (Assignment& a : block.assignments)
      if (infos[a.field].type == IG_TEXT) a.text = text;
    blocks.push_back(std::move(block));
  }
}

}  // namespace

void check_texts(Examination& e) {
  constexpr std::uint64_t random_ones = 20;
  const ig_host host = guarding_host();
  ChainSettings settings;
  settings.host = &host;
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    GuardedTexts texts;
    guarded = &texts;
    Bench bench(stand.alone, settings);
    bench.place_text = [&texts](std::string_view text) {
      const ig_text out = texts.copy({text.data(), text.size()});
      return std::string_view(out.data, out.size);
    };
    std::vector<TestBlock> blocks = many_blocks(stand, e, random_ones);
    if (stand.dependencies.empty()) add_odd_texts(stand, blocks);
    for (const TestBlock& block : blocks) {
      e.attempt(std::string(stand.syntax->id) + ", " + block.name +
                "; no byte behind a text or after the call may be read");
      for (int i = 0; i < 2; ++i) {
        bench.run(block, false);
        texts.end_call();
      }
    }
  }
  guarded = nullptr;
}

}  // namespace isogloss::cli
