// Feeds targets: their samples, the corpus of inputs that once showed a fault, and damaged ones of both. The input at
// work stands in fuzz-last-TARGET, for whoever finds the process dead.
//
//   isogloss_fuzz [--runs N | --minutes N] [--seed S] [--file FILE] [TARGET]...
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <random>

#include "target.hpp"

namespace isogloss::fuzz {

namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;

struct Wanted {
  std::uint64_t runs = 200, seed = 1;
  double minutes = 0;  ///< for each target, in place of a number of runs
  std::string file;    ///< this input alone
  std::vector<std::string> targets;
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> corpus_of(const std::string& target) {
  std::vector<std::string> out;
  const fs::path folder = fs::path(ISOGLOSS_SOURCE) / "tests/fuzz/corpus" / target;
  if (!fs::is_directory(folder)) return out;
  for (const auto& entry : fs::directory_iterator(folder)) out.push_back(text_of(entry.path()));
  return out;
}

class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}

  std::string damaged(const std::vector<std::string>& inputs) {
    std::string out = inputs[below(inputs.size())];
    for (std::size_t i = 1 + below(5); i > 0; --i) change(out, inputs[below(inputs.size())]);
    constexpr std::size_t most_bytes = 1u << 14;
    out.resize(std::min(out.size(), most_bytes));
    return out;
  }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % std::max<std::size_t>(count, 1)); }

  void change(std::string& text, const std::string& other) {
    constexpr const char* odd[] = {
        "0", "-1", "1e9", "99999999999999999999", "\t", "\"", "%", "[", "]", "(", "<", "{", "\xff", "#", "=", "\n"};
    const std::size_t at = below(text.size() + 1), size = std::min(1 + below(20), text.size() - at);
    switch (below(8)) {
      case 0: text.erase(at, size); break;
      case 1: text.insert(at, odd[below(std::size(odd))]); break;
      case 2: text.insert(at, text.substr(below(text.size() + 1), size)); break;
      case 3: text.insert(at, other.substr(below(other.size() + 1), 1 + below(60))); break;
      case 4: text.resize(at); break;
      case 5: {  // the end of a line is missing
        const std::size_t end = std::min(text.find('\n', at), text.size());
        text.replace(at, end - at, below(2) == 0 ? "" : " ");
        break;
      }
      case 6:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1u << below(8)));
    }
  }

  std::mt19937_64 random_;
};

class Feeding {
 public:
  Feeding(const std::string& name, Target& target) : last_("fuzz-last-" + name), target_(target) {}
  ~Feeding() {
    std::error_code ignored;
    fs::remove(last_, ignored);
  }
  Feeding(const Feeding&) = delete;
  Feeding& operator=(const Feeding&) = delete;

  void feed(const std::string& input) {
    std::ofstream(last_, std::ios::binary) << input;
    target_.run(input);
  }
  /// Damaged inputs, until enough of them were fed or the time is over; how many.
  std::uint64_t feed_damaged(const std::vector<std::string>& inputs, const Wanted& wanted) {
    const auto end = Clock::now() + std::chrono::duration<double, std::ratio<60>>(wanted.minutes);
    Damage damage(wanted.seed);
    std::uint64_t done = 0;
    while (wanted.minutes > 0 ? Clock::now() < end : done < wanted.runs) {
      feed(damage.damaged(inputs));
      ++done;
    }
    return done;
  }

 private:
  std::string last_;
  Target& target_;
};

int run_target(const std::string& name, const Wanted& wanted) {
  const std::unique_ptr<Target> target = make_target(name);
  if (target == nullptr) {
    std::string known;
    for (const std::string& one : target_names()) known += " " + one;
    std::fprintf(stderr, "there is no target %s; there are%s\n", name.c_str(), known.c_str());
    return 2;
  }
  Feeding feeding(name, *target);
  if (!wanted.file.empty()) {
    feeding.feed(text_of(wanted.file));
    return 0;
  }
  std::vector<std::string> inputs = corpus_of(name);
  for (const std::string& input : inputs) feeding.feed(input);
  for (std::string& sample : target->samples()) inputs.push_back(std::move(sample));
  inputs.emplace_back();
  // Of many samples no more than there are runs: the others are what damaged ones begin with.
  const std::size_t step = std::max<std::size_t>(1, inputs.size() / (wanted.runs + 1));
  for (std::size_t i = 0; i < inputs.size(); i += step) feeding.feed(inputs[i]);
  if (target->accepted() == 0) {
    std::fprintf(stderr, "%s refuses all its samples: it tests nothing\n", name.c_str());
    return 1;
  }
  const std::uint64_t damaged = feeding.feed_damaged(inputs, wanted);
  std::printf("%s: %zu inputs, %llu damaged ones, seed %llu\n", name.c_str(), inputs.size(),
              static_cast<unsigned long long>(damaged), static_cast<unsigned long long>(wanted.seed));
  return std::fflush(stdout);
}

int main_of(int argc, char** argv) {
  Wanted wanted;
  for (int i = 1; i < argc; ++i) {
    const bool has_value = i + 1 < argc;
    if (std::strcmp(argv[i], "--runs") == 0 && has_value)
      wanted.runs = std::strtoull(argv[++i], nullptr, 10);
    else if (std::strcmp(argv[i], "--seed") == 0 && has_value)
      wanted.seed = std::strtoull(argv[++i], nullptr, 10);
    else if (std::strcmp(argv[i], "--minutes") == 0 && has_value)
      wanted.minutes = std::strtod(argv[++i], nullptr);
    else if (std::strcmp(argv[i], "--file") == 0 && has_value)
      wanted.file = argv[++i];
    else
      wanted.targets.emplace_back(argv[i]);
  }
  if (wanted.targets.empty()) wanted.targets = target_names();
  int status = 0;
  for (const std::string& name : wanted.targets) status = std::max(status, run_target(name, wanted));
  return status;
}

}  // namespace

}  // namespace isogloss::fuzz

int main(int argc, char** argv) {
  try {
    return isogloss::fuzz::main_of(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "the input is the last one: an exception comes out: %s\n", e.what());
    return 1;
  }
}
