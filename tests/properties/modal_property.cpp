// A code that stays in force may be written again, and a position may be written as a distance: neither changes a
// motion.
#include <algorithm>
#include <cmath>
#include <map>

#include "heard.hpp"
#include "isogloss/engine/exporter.hpp"
#include "plain_block.hpp"
#include "product.hpp"
#include "property.hpp"

namespace isogloss::properties {

namespace {

/// Follows which code of group 01, or which canned cycle, is in force; nothing where it is not known.
class MotionInForce {
 public:
  void see(const PlainBlock& block) {
    int named = 0;
    for (const double code : block.codes) {
      if (code > 3 && code != 80 && !is_cycle_code(code)) continue;
      ++named;
      now_ = code;
    }
    if (named > 1 || now_ == 80) now_.reset();
    is_cycle_ = now_ && is_cycle_code(*now_);
  }
  std::optional<double> now() const { return now_; }
  bool is_cycle() const { return is_cycle_; }

 private:
  static bool is_cycle_code(double code) {
    PlainBlock one;
    one.codes.insert(code);
    return one.is_cycle();
  }

  std::optional<double> now_;
  bool is_cycle_ = false;
};

/// Nothing jumps here, so numbers of blocks only stand in the way.
void drop_number(PlainBlock& block) {
  std::erase_if(block.words, [](const PlainWord& w) { return w.address == 'N'; });
}

bool has_no_code_but(const PlainBlock& block, const Codes& allowed) {
  return std::all_of(block.codes.begin(), block.codes.end(), [&](double code) { return allowed.count(code) != 0; });
}

/// Blocks that only move, by a code that is in force: axes, and what belongs to a move.
bool only_moves(const PlainBlock& block, const Codes& allowed) {
  return block.has_any_of("XYZ") && !block.has_any_of("OMTHDLP") && has_no_code_but(block, allowed);
}

/// Calls and returns leave the order of the lines; M29 is for the block behind it alone.
bool is_left_out(const PlainBlock& block) {
  const PlainWord* const m = block.word('M');
  return block.has('O') || (m != nullptr && (m->value >= 96 || m->value == 29));
}

/// Of one program, two texts with the same lines.
struct Texts {
  std::string plain, changed;
  bool is_changed = false;
};

Verdict judged(const Case& program, const Texts& texts, const std::string& changed) {
  if (!texts.is_changed) return {};
  Heard plain = heard(program, texts.plain), other = heard(program, texts.changed);
  // That a hole goes up is told where its depth is programmed, or the cycle called.
  for (Heard* const one : {&plain, &other})
    std::erase_if(one->said.all, [](const Diagnostic& d) { return d.code == "ISO-0514"; });
  std::string fault = difference_of(plain, other, "as it was", changed);
  if (!fault.empty()) fault += "as it was:\n" + texts.plain + changed + ":\n" + texts.changed;
  return {true, fault};
}

}  // namespace

/// The code in force, written again in a block that moves by it.
Verdict judge_modal(const Case& program) {
  if (!has_plain_words(program.dialect)) return {};
  const std::string text = program.text();
  Texts texts;
  MotionInForce motion;
  for (const Block& block : blocks_of(program, text)) {
    auto plain = plain_block(program, text, block);
    if (!plain || is_left_out(*plain)) continue;
    drop_number(*plain);
    const auto before = motion.now();
    motion.see(*plain);
    std::string again;
    if (before && only_moves(*plain, {17, 18, 19, 54, 55, 90, 91, 94, 95, 98, 99})) {
      again = "G" + std::to_string(static_cast<int>(*before));
      texts.is_changed = true;
    }
    texts.plain += plain->text() + "\n";
    texts.changed += again + plain->text() + "\n";
  }
  return judged(program, texts, "with codes written again");
}

namespace {

/// Where the program stands behind each line.
class Places : public Exporter {
 public:
  void begin(Document& document, const SymbolTable&) override {
    for (std::size_t i = 0; i < 3; ++i) ids_[i] = document.layout().id(std::string("ProgramXyz.") + "XYZ"[i]);
  }
  bool block(Document& document, const SymbolTable&) override {
    Vector at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = document.present(ids_[i]) ? document.number(ids_[i]) : NAN;
    at_[document.source.line] = at;
    return true;
  }
  bool end() override { return true; }

  const Vector* behind(std::uint32_t line) const {
    const auto found = at_.find(line);
    return found == at_.end() ? nullptr : &found->second;
  }

 private:
  std::array<ig_field, 3> ids_{};
  std::map<std::uint32_t, Vector> at_;
};

/// The lines of a program that can be tried. Cutter radius compensation and scaling make other positions of those of
/// the program.
std::vector<std::pair<PlainBlock, bool>> lines_of_positions(const Case& program, const std::string& text) {
  std::vector<std::pair<PlainBlock, bool>> out;
  MotionInForce motion;
  bool is_absolute = true;
  std::string unknown;  // axes whose programmed position is not that of the tool
  for (const Block& block : blocks_of(program, text)) {
    auto plain = plain_block(program, text, block);
    if (!plain || is_left_out(*plain) || plain->has_code({41, 42, 51})) continue;
    drop_number(*plain);
    motion.see(*plain);
    if (plain->has_code({90})) is_absolute = true;
    if (plain->has_code({91})) is_absolute = false;
    const bool only_goes = motion.now() && !motion.is_cycle() && only_moves(*plain, {0, 1, 2, 3, 90});
    const bool is_free = is_absolute && only_goes && unknown.empty() && !plain->has_any_of("ABC");
    if (is_absolute && only_goes) {
      std::erase_if(unknown, [&](char axis) { return plain->has(axis); });
    } else if (!has_no_code_but(*plain, {0, 1, 2, 3, 4, 90, 91, 94, 95}) || plain->has_any_of("HT")) {
      unknown = "XYZ";
    }
    if (is_free) std::erase_if(plain->words, [](const PlainWord& w) { return w.address == 'G' && w.value == 90; });
    out.emplace_back(std::move(*plain), is_free);
  }
  return out;
}

/// The words of the block, with positions counted from `from`.
std::string text_of(const PlainBlock& block, const Vector& from) {
  std::string out;
  for (const PlainWord& word : block.words) {
    const std::size_t axis = std::string_view("XYZ").find(word.address);
    out += axis < 3 ? word.address + decimal(word.value - from[axis]) : word.text;
  }
  return out + "\n";
}

}  // namespace

/// Positions written as distances from where the program stands.
Verdict judge_distances(const Case& program) {
  if (!has_plain_words(program.dialect)) return {};
  const auto lines = lines_of_positions(program, program.text());
  const std::string first = program.dialect == "siemens" ? "G710 G90\n" : "G21 G90\n";
  Texts texts{first, first};
  for (const auto& [block, is_free] : lines) texts.plain += (is_free ? "G90 " : "") + text_of(block, {});
  Places places;
  DiagnosticList unheard;
  events_of(program.dialect, texts.plain, options_of(program), {}, {&places}, unheard);
  std::uint32_t line = 1;
  bool is_back = true;  // to G90
  for (const auto& [block, is_free] : lines) {
    const Vector* const from = is_free ? places.behind(line) : nullptr;
    // Far away, a distance has not the digits that the position has.
    const bool is_known = from != nullptr && std::hypot((*from)[0], (*from)[1], (*from)[2]) < 1e6;
    const bool says_it = block.has_code({90, 91});
    texts.changed += is_known ? "G91 " : is_free || (!is_back && !says_it) ? "G90 " : "";
    texts.changed += text_of(block, is_known ? *from : Vector{});
    is_back = !is_known;
    texts.is_changed = texts.is_changed || is_known;
    ++line;
  }
  return judged(program, texts, "as distances");
}

}  // namespace isogloss::properties
