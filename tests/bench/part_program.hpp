// What the workload writer builds programs with: seeded numbers, words, and a file of exactly N blocks.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <string>
#include <string_view>

namespace bench {

inline constexpr double pi = std::numbers::pi;

// The standard's distributions differ from library to library; these do not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {  // splitmix64
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1.0p-53);
  }
  int from(int low, int high) {  // both inclusive
    return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double probability) { return between(0, 1) < probability; }
  template <class T, std::size_t N>
  const T& of(const std::array<T, N>& choices) {
    return choices[next() % N];
  }

 private:
  std::uint64_t state_;
};

// A word with a decimal point, trailing zeros dropped, as CAM posts write it: X12.5, Z-3., R0.25.
inline std::string word(char letter, double value, int decimals = 3) {
  std::array<char, 48> text{};
  int size = std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string_view digits(text.data(), static_cast<std::size_t>(size));
  while (digits.back() == '0') digits.remove_suffix(1);
  if (digits == "-0.") digits = "0.";
  return letter + std::string(digits);
}

inline std::string code(char letter, int number) { return letter + std::to_string(number); }

inline double round4(double value) { return std::round(value * 1e4) / 1e4; }

struct Point {
  double x = 0;
  double y = 0;
};

class Program {
 public:
  Program(std::FILE* out, long blocks) : out_(out), left_(blocks) {}

  // Blocks that are kept free: a cycle may have been cut off, and G28 wants it cancelled.
  static constexpr long closing = 5;
  bool room() const { return left_ > closing; }

  template <class... Words>
  void block(const Words&... words) {
    if (room()) write(words...);
  }
  void start() { block("G21", "G17", "G90", "G94", "G40", "G49", "G80"); }
  void finish() {
    static constexpr std::array<std::string_view, closing> last{"G80", "M9", "M5", "G91 G28 Z0.", "M30"};
    while (left_ > 0) write(last[static_cast<std::size_t>(closing - left_)]);
    std::fwrite(text_.data(), 1, text_.size(), out_);
  }

 private:
  template <class... Words>
  void write(const Words&... words) {
    bool first = true;
    for (std::string_view each : {std::string_view(words)...}) {
      if (each.empty()) continue;
      if (!first) text_ += ' ';
      text_ += each;
      first = false;
    }
    text_ += '\n';
    --left_;
    if (text_.size() > 1u << 18) {
      std::fwrite(text_.data(), 1, text_.size(), out_);
      text_.clear();
    }
  }

  std::FILE* out_;
  long left_;
  std::string text_;
};

}  // namespace bench
