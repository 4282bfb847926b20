// What libFuzzer calls: one target of isogloss_fuzz, guided by the coverage of the engine and of the plugins.
//
//   isogloss_fuzzer --target=NAME [option of libFuzzer]... [FOLDER]...
//   isogloss_fuzzer --target=NAME --prepare=FOLDER    writes FOLDER/samples and FOLDER/words.dict, and ends
//   isogloss_fuzzer --list                            prints the names of the targets, and ends
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "target.hpp"

namespace isogloss::fuzz {

namespace {

namespace fs = std::filesystem;

std::unique_ptr<Target> target_at_work;

/// Of "--target=NAME"; libFuzzer itself ignores options with two dashes.
std::optional<std::string> value_of(std::string_view option, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.starts_with(option) && word.substr(option.size()).starts_with('='))
      return std::string(word.substr(option.size() + 1));
  }
  return {};
}

/// A line of libFuzzer's dictionary.
std::string dictionary_line(std::string_view word) {
  std::string out = "\"";
  for (const char c : word) {
    char code[5];
    std::snprintf(code, sizeof code, "\\x%02X", static_cast<unsigned char>(c));
    const bool is_plain = c > ' ' && c < '\x7f' && c != '"' && c != '\\';
    out += is_plain ? std::string(1, c) : std::string(code);
  }
  return out + "\"\n";
}

void prepare(const Target& target, const fs::path& folder) {
  fs::create_directories(folder / "samples");
  const std::vector<std::string> samples = target.samples();
  for (std::size_t i = 0; i < samples.size(); ++i)
    std::ofstream(folder / "samples" / std::to_string(i), std::ios::binary) << samples[i];
  std::ofstream words(folder / "words.dict", std::ios::binary);
  for (const std::string& word : dictionary(target)) words << dictionary_line(word);
}

int initialize(int argc, char** argv) {
  const bool lists = argc > 1 && std::string_view(argv[1]) == "--list";
  target_at_work = make_target(value_of("--target", argc, argv).value_or(""));
  if (target_at_work == nullptr) {
    if (!lists) std::fprintf(stderr, "--target=NAME names none of these targets:\n");
    for (const std::string& known : target_names()) std::fprintf(lists ? stdout : stderr, "%s\n", known.c_str());
    std::exit(lists ? 0 : 2);
  }
  // The counters of a plugin belong to the first input, whichever input needs it first.
  workspace().library().load_all();
  if (const auto folder = value_of("--prepare", argc, argv)) {
    prepare(*target_at_work, *folder);
    std::exit(0);
  }
  return 0;
}

}  // namespace

}  // namespace isogloss::fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) { return isogloss::fuzz::initialize(*argc, *argv); }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  isogloss::fuzz::target_at_work->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
