// The floor under every interpreter: reads a program and turns letters and numbers into words, nothing else. Prints
// blocks, words and a checksum, so that the work cannot be left out.
//
//   tokenizer FILE

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>

namespace {

struct Count {
  std::uint64_t blocks = 0;
  std::uint64_t words = 0;
  double checksum = 0;
};

void tokenize(std::string_view line, Count& count) {
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at < end) {
    const char c = *at++;
    const auto letter = static_cast<unsigned char>((c | 0x20) - 'a');
    if (letter < 26) {
      while (at < end && *at == ' ') ++at;
      if (at < end && *at == '+') ++at;
      double value = 0;
      at = std::from_chars(at, end, value, std::chars_format::fixed).ptr;
      ++count.words;
      count.checksum += value * (letter + 1);
    } else if (c == '(') {
      const void* close = std::memchr(at, ')', static_cast<std::size_t>(end - at));
      at = close == nullptr ? end : static_cast<const char*>(close) + 1;
    }
  }
  ++count.blocks;
}

// Lines of a window; what is left of the last one moves to the front of the next.
Count tokenize(std::FILE* file) {
  Count count;
  std::string window(1u << 18, '\0');
  std::size_t kept = 0;
  while (const std::size_t read = std::fread(window.data() + kept, 1, window.size() - kept, file)) {
    std::string_view text(window.data(), kept + read);
    for (std::size_t eol = 0; (eol = text.find('\n')) != std::string_view::npos; text.remove_prefix(eol + 1))
      tokenize(text.substr(0, eol), count);
    kept = text.size();
    std::memmove(window.data(), text.data(), kept);
    if (kept == window.size()) window.resize(2 * window.size());
  }
  if (kept > 0) tokenize(std::string_view(window.data(), kept), count);
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: tokenizer FILE\n", stderr);
    return 2;
  }
  std::FILE* file = std::fopen(argv[1], "rb");
  if (file == nullptr) {
    std::perror(argv[1]);
    return 1;
  }
  const Count count = tokenize(file);
  std::fclose(file);
  std::printf("blocks %llu words %llu checksum %.6f\n", static_cast<unsigned long long>(count.blocks),
              static_cast<unsigned long long>(count.words), count.checksum);
  return 0;
}
