#include "lsp/same_motions.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "isogloss/engine/exporter.hpp"

namespace isogloss::editors {

namespace {

/// A checksum of all bytes (FNV-1a).
class Checksum : public Output {
 public:
  bool write(std::string_view bytes) override {
    constexpr std::uint64_t prime = 1099511628211u;
    for (const char c : bytes) sum_ = (sum_ ^ static_cast<unsigned char>(c)) * prime;
    return true;
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 14695981039346656037u;
};

struct Outcome {
  std::uint64_t motions = 0;
  std::multiset<std::pair<std::uint32_t, std::string>> diagnostics;
  bool is_whole = true;
};

Outcome outcome_of(const Setup& setup, const std::string& path, const std::string& text, const Surroundings& around) {
  using Clock = std::chrono::steady_clock;
  Outcome out;
  Checksum sum;
  const std::unique_ptr<Exporter> exporter = make_motion_exporter(sum, {Format::csv, false, true, true, {}});
  const Clock::time_point last = Clock::now() + std::chrono::milliseconds(around.settings.budget_ms);
  RunOptions options = setup.options;
  options.goes_on = [&] { return out.is_whole = out.is_whole && Clock::now() < last && around.goes_on(); };
  DiagnosticList list;
  const std::unique_ptr<Source> source = memory_source(text);
  run(*setup.linked, *source, path, options, {exporter.get()}, list);
  out.motions = sum.sum();
  for (const Diagnostic& d : list.all) out.diagnostics.emplace(d.where.line, d.code);
  return out;
}

}  // namespace

std::string why_not_same(const Setup& setup, const std::string& path, const std::string& before,
                         const std::string& after, const Surroundings& around) {
  const Outcome a = outcome_of(setup, path, before, around), b = outcome_of(setup, path, after, around);
  if (!a.is_whole || !b.is_whole) return "the run takes too long to compare all motions";
  if (a.motions != b.motions) return "the program would not make the same motions";
  if (a.diagnostics != b.diagnostics) return "the program would have other diagnostics";
  return {};
}

}  // namespace isogloss::editors
