// A program in inches makes the motions of the same program in millimetres. Which words are lengths is said here anew,
// from the manuals and not by the units that syntaxes declare: a length that one of them forgot is not converted.
#include "heard.hpp"
#include "plain_block.hpp"
#include "property.hpp"

namespace isogloss::properties {

namespace {

constexpr double mm_per_inch = 25.4;

bool is_length(const PlainBlock& block, char address, const std::string& dialect) {
  const Codes tilt{68.2}, scaling{51}, rotation{68}, tapping{74, 84};
  if (block.has_code({4})) return false;
  switch (address) {
    case 'X':
    case 'Y':
    case 'Z':
    case 'F': return true;
    case 'R': return !block.has_code(rotation);
    case 'Q': return !block.has_code(tilt);
    case 'I': return !block.has_code(scaling) && !block.has_code(tilt);
    case 'J':
      return !block.has_code(scaling) && !block.has_code(tilt) && !(dialect == "haas" && block.has_code(tapping));
    case 'K': return !block.has_code(scaling) && !block.has_code(tilt) && (dialect == "haas" || !block.is_cycle());
    default: return false;
  }
}

/// The program in two units, line by line the same.
struct Pair {
  std::string metric, inch;
  bool has_lengths = false;
};

Pair in_both_units(const Case& program) {
  const bool is_siemens = program.dialect == "siemens";
  Pair out{is_siemens ? "G710\n" : "G21\n", is_siemens ? "G700\n" : "G20\n"};
  const std::string text = program.text();
  for (const Block& block : blocks_of(program, text)) {
    const auto plain = plain_block(program, text, block);
    if (!plain) continue;
    for (const PlainWord& word : plain->words) {
      const bool converts = is_length(*plain, word.address, program.dialect);
      const std::string letter(1, word.address);
      out.metric += converts ? letter + decimal(word.value) : word.text;
      out.inch += converts ? letter + decimal(word.value / mm_per_inch) : word.text;
      out.has_lengths = out.has_lengths || (converts && word.value != 0);
    }
    out.metric += '\n';
    out.inch += '\n';
  }
  return out;
}

}  // namespace

Verdict judge_units(const Case& program) {
  if (!has_plain_words(program.dialect)) return {};
  const Pair texts = in_both_units(program);
  if (!texts.has_lengths) return {};
  Heard metric = heard(program, texts.metric), inch = heard(program, texts.inch);
  // What is too short for a control to see depends on its least increment, which is another one in inches.
  for (Heard* const one : {&metric, &inch})
    std::erase_if(one->said.all, [](const Diagnostic& d) { return d.code == "ISO-0605"; });
  std::string fault = difference_of(metric, inch, "in mm", "in inches", RotaryFeeds::left_out);
  if (!fault.empty()) fault += "in mm:\n" + texts.metric + "in inches:\n" + texts.inch;
  return {true, fault};
}

}  // namespace isogloss::properties
