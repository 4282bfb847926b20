// Where the machine stands behind a block is where the motions have left it: no move is lost between the two.
#include <algorithm>
#include <array>
#include <cmath>

#include "events.hpp"
#include "isogloss/engine/exporter.hpp"
#include "product.hpp"
#include "property.hpp"

namespace isogloss::properties {

namespace {

constexpr std::string_view axis_letters = "XYZABC";

/// Compares each block with the motions up to it. The motions of a block come after the block itself.
class MachineWatch : public Exporter {
 public:
  void begin(Document& document, const SymbolTable&) override {
    for (std::size_t i = 0; i < ids_.size(); ++i)
      ids_[i] = document.layout().id(std::string("MachineCoordinate.") + axis_letters[i]);
    standing_ = read(document);
  }
  bool block(Document& document, const SymbolTable&) override {
    compare();
    line_ = document.source.line;
    said_ = read(document);
    return true;
  }
  bool end() override {
    compare();
    return true;
  }
  void move(const Motion& motion) {
    for (unsigned i = 0; i < standing_.size(); ++i)
      if (motion.machine.has(i)) standing_[i] = motion.machine.at[i];
  }
  const std::string& fault() const { return fault_; }
  bool has_compared() const { return has_compared_; }

 private:
  using Place = std::array<double, 6>;  // NaN: not known

  Place read(const Document& document) const {
    Place out;
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = ids_[i] != IG_NO_FIELD && document.present(ids_[i]) ? document.number(ids_[i]) : NAN;
    return out;
  }

  void compare() {
    if (line_ == 0 || !fault_.empty()) return;
    for (std::size_t i = 0; i < said_.size(); ++i) {
      if (std::isnan(said_[i])) continue;
      has_compared_ = true;
      if (std::abs(said_[i] - standing_[i]) <= 1e-6 * std::max(1.0, std::abs(said_[i]))) continue;
      fault_ = "line " + std::to_string(line_) + ": " + axis_letters[i] + " is at " + std::to_string(said_[i]) +
               " in the block, and at " + std::to_string(standing_[i]) + " by the motions";
      return;
    }
  }

  std::array<ig_field, 6> ids_{};
  Place standing_{}, said_{};
  std::uint32_t line_ = 0;
  bool has_compared_ = false;
  std::string fault_;
};

}  // namespace

namespace {

/// Where no move follows, the blocks of these languages give the place on the contour in place of the tool's.
bool is_compensated_elsewhere(const Case& program) {
  if (is_iso(program.dialect)) return false;
  const std::string text = program.text();
  constexpr std::string_view sides[] = {"G41", "G42", " RL", " RR"};
  return std::any_of(std::begin(sides), std::end(sides),
                     [&](std::string_view side) { return text.find(side) != std::string::npos; });
}

}  // namespace

Verdict judge_machine(const Case& program) {
  if (is_compensated_elsewhere(program)) return {};
  MachineWatch watch;
  const auto listener = make_motion_listener(
      [&](const Motion& motion) {
        watch.move(motion);
        return true;
      },
      {});
  DiagnosticList said;
  const std::string text = program.text();
  const std::unique_ptr<Source> source = memory_source(text);
  run(product::dialect(program.dialect), *source, "program", options_of(program), {&watch, listener.get()}, said);
  // Behind this alarm the blocks forget the tool's distance from the contour before a move takes it there.
  const auto changes_plane = [](const Diagnostic& d) { return d.code == "ISO-0471"; };
  if (std::any_of(said.all.begin(), said.all.end(), changes_plane)) return {};
  return {watch.has_compared(), watch.fault()};
}

}  // namespace isogloss::properties
