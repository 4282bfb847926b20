// Part programs of one dialect: no fault inside, no number that is not finite, and the same motions whatever the pieces
// in which the text is read.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/motion.hpp"
#include "isogloss/engine/runner.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

/// Gives a few bytes at a time, never the same number twice.
class InPieces : public Source {
 public:
  explicit InPieces(std::string_view text) : text_(text) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t n = std::min({size, text_.size() - given_, 1 + given_ % 13});
    if (n != 0) std::memcpy(buffer, text_.data() + given_, n);
    given_ += n;
    return n;
  }

 private:
  std::string_view text_;
  std::size_t given_ = 0;
};

void expect_finite(double value) {
  if (!std::isfinite(value)) fail("no number that is not finite leaves the engine");
}

void look_at(const MotionPoint& point, unsigned axes) {
  for (unsigned i = 0; i < axes; ++i)
    if ((point.known >> i & 1u) != 0) expect_finite(point.at[i]);
}

bool look_at(const Motion& motion) {
  look_at(motion.program, 3);
  look_at(motion.machine, 6);
  if (motion.has_feed) expect_finite(motion.feed_mm_s);
  if (motion.has_value) expect_finite(motion.value);
  return true;
}

class ProgramTarget : public Target {
 public:
  ProgramTarget(std::string name, std::string before, std::string behind)
      : name_(std::move(name)), before_(std::move(before)), behind_(std::move(behind)) {}

  void run(std::string_view bytes) override {
    const std::string text = before_ + std::string(bytes) + behind_;
    const bool is_checked = text.size() % 2 == 0;
    const std::unique_ptr<Source> whole = memory_source(text);
    InPieces pieces(text);
    const std::string once = motions(*whole, is_checked ? Mode::checked : Mode::fast, text.size());
    if (once.find('\n') + 1 < once.size()) accept();  // there is a motion below the head
    // A second run takes as long as the first, and the pieces matter to few inputs.
    if (text.size() % 4 < 2 && motions(pieces, Mode::fast, text.size()) != once)
      fail("the pieces in which a text is read change no motion");
  }

  std::vector<std::string> samples() const override {
    if (!before_.empty()) return expressions();
    return product::programs_of(name_);
  }

  std::vector<std::string> words() const override {
    std::set<std::string> out;
    for (const FieldInfo& field : dialect(name_).layout.fields)
      if (field.path.starts_with("Parsing.")) add_words(field.path.substr(8), out);
    for (const LinkedSyntax& syntax : dialect(name_).chain)
      for (const OptionValue& option : syntax.options) add_words(option.text, out);
    return {out.begin(), out.end()};
  }

 private:
  /// Loops make most of the inputs that are kept, so only one input of eight may go round for long.
  static RunOptions limited(Mode mode, std::size_t size) {
    const std::uint64_t rounds = size / 2 % 8 == 0 ? 2'000 : 200;
    RunOptions out;
    out.chain.mode = mode;
    out.maximum_blocks = 2'000;
    out.maximum_motions = 20'000;
    out.maximum_jumps = out.maximum_loop_blocks = out.maximum_repeat_blocks = rounds;
    out.maximum_depth = 20;
    return out;
  }

  std::string motions(Source& source, Mode mode, std::size_t size) const {
    TextOutput lines, blocks;
    const auto csv = make_motion_exporter(lines, {Format::csv, false, true, true, {}});
    const auto all = make_block_exporter(blocks, Format::jsonl);
    const auto finite = make_motion_listener([](const Motion& motion) { return look_at(motion); });
    DiagnosticList said;
    try {
      isogloss::run(dialect(name_), source, "program", limited(mode, size), {csv.get(), all.get(), finite.get()}, said);
    } catch (const std::runtime_error& e) {
      fail("a program does not keep a run from its start: " + std::string(e.what()));
    }
    expect_no_internal_fault(said.all);
    for (const char* const number : {"nan", "inf"})
      if (lines.text.find(std::string(",") + number) != std::string::npos)
        fail("no number that is not finite leaves the engine");
    return lines.text;
  }

  std::vector<std::string> expressions() const {
    if (name_ == "fanuc")
      return {"[#1+#2]*3.",
              "ROUND[SIN[30.]*10]/[#1-1]",
              "#[#1+1]",
              "FIX[-2.5] MOD 2",
              "[#1 EQ 1] AND [#2 GT 2]",
              "ATAN[1]/[2]",
              "SQRT[-1]",
              "EXP[1000]",
              "#0",
              "-[-[-#2]]",
              "POW[2,-3]"};
    if (name_ == "siemens")
      return {"R1+R2*3",      "SIN(30)*10/(R1-1)", "R[R1+1]",   "TRUNC(-2.5) MOD 2", "(R1==1) AND (R2>2)",
              "ATAN2(1,2)",   "SQRT(-1)",          "EXP(1000)", "$P_UIFR[1,X,TR]",   "-(-(-R2))",
              "POT(R1) DIV 0"};
    if (name_ == "syntec")
      return {"#1 + #2 * 3",
              "ROUND(SIN(30.) * 10) / (#1 - 1)",
              "#[#1 + 1] XOR 0xFF",
              "FLOOR(-2.5) MOD 2",
              "(#1 = #0) AND (#2 > 2)",
              "ATAN2(1, 2)",
              "SQRT(-1)",
              "EXP(1000)",
              "@[#1] <> \"AB\"",
              "NOT -(-(-#2))",
              "POW(2, -3) & STD(100, #1600)",
              "STR2INT(\"1#2\") OR GETARG(X1)"};
    return {"Q1 + Q2 * 3", "SIN 30 * 10 / (Q1 - 1)", "+Q1",   "INT -2.5 % 2",
            "SQRT -1",     "ATAN (1 / 2)",           "LN 0",  "Q2 ^ 1000",
            "PI",          "- ( - ( - Q2 ) )",       "SGN Q1"};
  }

  std::string name_, before_, behind_;
};

}  // namespace

std::unique_ptr<Target> make_program_target(const std::string& dialect, const std::string& before,
                                            const std::string& behind) {
  return std::make_unique<ProgramTarget>(dialect, before, behind);
}

}  // namespace isogloss::fuzz
