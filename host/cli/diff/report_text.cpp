#include <fmt/format.h>

#include <algorithm>

#include "diff/report.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli::parting {

namespace {

std::string blocks(std::uint64_t n) { return fmt::format("{} {}", n, n == 1 ? "block" : "blocks"); }

std::string or_none(const std::string& value) { return value.empty() ? "-" : printable(value); }

std::string values_text(const std::vector<Parting>& values, std::string_view indent, std::size_t most) {
  std::string out;
  for (const Parting& v : values) {
    if (most-- == 0) return out + fmt::format("{}...\n", indent);
    if (v.field == "diagnostic") {
      out += fmt::format("{}{}\n", indent, printable(v.a.empty() ? v.b : v.a));
      if (!v.a.empty() && !v.b.empty()) out += fmt::format("{}{}\n", indent, printable(v.b));
      continue;
    }
    const std::string writer = v.writer_a == v.writer_b || v.writer_b.empty() ? v.writer_a
                               : v.writer_a.empty()                           ? v.writer_b
                                                                              : v.writer_a + " | " + v.writer_b;
    out += fmt::format("{}{} = {} | {}{}{}\n", indent, v.field, or_none(v.a), or_none(v.b),
                       v.unit.empty() ? "" : " " + v.unit, writer.empty() ? "" : "  (" + writer + ")");
  }
  return out;
}

/// Where the character begins that holds the byte `at`, in UTF-8.
std::size_t begin_of_character(std::string_view text, std::size_t at) {
  constexpr std::size_t most_bytes = 3;  // behind the first
  std::size_t begin = std::min(at, text.size());
  while (begin > 0 && begin < text.size() && at - begin < most_bytes &&
         (static_cast<unsigned char>(text[begin]) & 0xc0) == 0x80)
    --begin;
  return begin;
}

constexpr std::size_t most_of_line = 500, before_difference = 40;

/// A line of a program may be a mebibyte: the part from `begin` on.
std::string line_of_program(std::string_view text, std::size_t begin) {
  begin = begin_of_character(text, begin);
  const std::size_t end = begin_of_character(text, begin + most_of_line);
  return (begin > 0 ? "… " : "") + printable(text.substr(begin, end - begin), "\t") + (end < text.size() ? " …" : "");
}

std::string block_text(const PartedBlock& block, std::string_view indent) {
  const std::string place = place_text(block.file_a, block.line_a, block.file_b, block.line_b);
  const std::string_view a = block.text_a, b = block.text_b;
  const bool are_two = block.line_a != 0 && block.line_b != 0 && a != b;
  const std::string_view first = block.line_a != 0 ? a : b;
  std::size_t begin = 0;
  if (are_two) {
    // Two lines show where they differ.
    const auto different =
        static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
    if (different + before_difference > most_of_line) begin = different - before_difference;
  }
  std::string out = fmt::format("{}{}{}{}\n", indent, place, place.empty() ? "" : "  ", line_of_program(first, begin));
  if (are_two) out += fmt::format("{}  against  {}\n", indent, line_of_program(b, begin));
  return out;
}

/// Fields on which the cause acts, then those that follow; the most frequent first would hide how it spreads.
std::string fields_text(const Group& group) {
  constexpr std::size_t most = 12;
  std::string out;
  for (const bool is_direct : {true, false}) {
    std::string list;
    std::size_t shown = 0, all = 0;
    for (const auto& [path, count] : group.fields) {
      if (count.is_direct != is_direct || ++all > most) continue;
      list += fmt::format("{}{}{}", shown++ == 0 ? "" : ", ", path,
                          count.blocks == group.blocks ? "" : fmt::format(" ({})", count.blocks));
    }
    if (all > most) list += fmt::format(", and {} more", all - most);
    if (!list.empty()) out += fmt::format("    {} {}\n", is_direct ? "fields:  " : "follows: ", list);
  }
  return out;
}

std::string group_text(const Group& g) {
  std::string out = fmt::format("\n{}: {}", heading(g), blocks(g.blocks));
  if (g.direct_blocks == 0)
    out += g.blocks == 1 ? ", which follows" : ", which follow";
  else if (g.direct_blocks < g.blocks)
    out += fmt::format(", {} of them directly", g.direct_blocks);
  out += '\n';
  const std::string syntaxes = g.syntax_a == g.syntax_b || g.syntax_b.empty() ? g.syntax_a
                               : g.syntax_a.empty()                           ? g.syntax_b
                                                                              : g.syntax_a + " | " + g.syntax_b;
  if (!syntaxes.empty()) out += fmt::format("    syntax:   {}\n", syntaxes);
  for (const Evidence& e : g.evidence) {
    if (e.trial == Evidence::Trial::no_cause) {
      out += fmt::format("    no cause: {}; tried, the block differs as before\n", printable(text_of(e)));
      continue;
    }
    const bool is_in_heading = heading(g).find(printable(text_of(e))) != std::string::npos;
    const bool has_places = !e.place_a.empty() || !e.place_b.empty();
    if (!is_in_heading)
      out += fmt::format("    also:     {}\n", printable(text_of(e)));
    else if (has_places)
      out += fmt::format("    set in:   {} | {}\n", or_none(e.place_a), or_none(e.place_b));
    if (e.trial == Evidence::Trial::cause && !g.acts_together)
      out += fmt::format("    tried:    with {} on both sides the block is the same\n", printable(e.a));
  }
  if (g.acts_together)
    out += "    tried:    with all of them on both sides the block is the same, with one alone it differs\n";
  if (g.trial == Evidence::Trial::cause)
    out += fmt::format("    tried:    {} on both sides the block is the same\n",
                       g.kind == Group::Kind::syntaxes && g.syntax_a.empty() ? "without it" : "with that of side A");
  out += fields_text(g);
  for (const PartedBlock& example : g.examples) {
    out += block_text(example, "    ");
    out += values_text(example.values, "        ", 3);
  }
  return out;
}

std::string deviation_text(const Deviation& d, const std::string& unit) {
  const std::string size = d.size > 0 && !unit.empty() ? fmt::format(" (by {:.6g} {})", d.size, unit) : std::string();
  return fmt::format("{}  {}: {} | {}{}", place_text(d.file_a, d.line_a, d.file_b, d.line_b), d.event, or_none(d.a),
                     or_none(d.b), size);
}

std::string programs_text(const std::string& a, const std::string& b) {
  return a == b ? printable(a) : printable(a) + " | " + printable(b);
}

}  // namespace

std::string heading(const Group& group) {
  std::string codes;
  for (const std::string& code : group.codes) codes += (codes.empty() ? "" : " ") + code;
  if (codes.empty()) return printable(group.cause);
  // "G83 peck clearance: 5115 = ..."
  const bool begins_with_title = std::any_of(group.evidence.begin(), group.evidence.end(), [&](const Evidence& e) {
    return !e.title.empty() && group.cause.starts_with(e.title + ": ");
  });
  return printable(codes + (begins_with_title ? " " : ": ") + group.cause);
}

std::string place_text(const std::string& file_a, std::uint32_t line_a, const std::string& file_b,
                       std::uint32_t line_b) {
  const std::string a = line_a == 0 ? "" : fmt::format("{}:{}", printable(file_a), line_a);
  const std::string b = line_b == 0 ? "" : fmt::format("{}:{}", printable(file_b), line_b);
  return a == b || b.empty() ? a : a.empty() ? b : a + " | " + b;
}

std::string as_text(const Report& r) {
  std::string out =
      fmt::format("{}: {} | {}\n", programs_text(r.program_a, r.program_b), printable(r.name_a), printable(r.name_b));
  const std::string size =
      r.blocks_a == r.blocks_b ? blocks(r.blocks_a) : fmt::format("{} | {}", r.blocks_a, blocks(r.blocks_b));
  if (r.parted == 0) return out + fmt::format("{}, no difference\n", size);
  out += fmt::format("{}, {} {}, {} {}\n", size, r.parted, r.parted == 1 ? "differs" : "differ", r.groups.size(),
                     r.groups.size() == 1 ? "cause" : "causes");
  for (const Group& group : r.groups) out += group_text(group);
  if (!r.all.empty()) out += "\nAll blocks that differ:\n";
  for (std::size_t i = 0; i < r.all.size(); ++i) {
    out += block_text(r.all[i], "  ");
    out += fmt::format("      {}\n", heading(r.groups[r.all_groups[i]]));
    out += values_text(r.all[i].values, "      ", r.all[i].values.size());
  }
  return out;
}

std::string as_text(const MotionReport& r) {
  std::string out =
      fmt::format("{}: {} | {}\n", programs_text(r.program_a, r.program_b), printable(r.name_a), printable(r.name_b));
  const std::string size = r.motions_a == r.motions_b ? fmt::format("{} events", r.motions_a)
                                                      : fmt::format("{} | {} events", r.motions_a, r.motions_b);
  const std::string tolerance = fmt::format("{:g} mm and {:g} deg", r.tolerance.mm, r.tolerance.degrees);
  if (r.parted == 0) return out + fmt::format("{}, the same within {}\n", size, tolerance);
  out += fmt::format("{}, {} {} by more than {}\n", size, r.parted, r.parted == 1 ? "differs" : "differ", tolerance);
  for (const auto& [name, kind] : r.kinds) {
    out += fmt::format("\n{}: {} {}\n", printable(name), kind.motions, kind.motions == 1 ? "event" : "events");
    out += fmt::format("    first:    {}\n", deviation_text(kind.first, kind.unit));
    if (kind.greatest.size > 0 && kind.motions > 1)
      out += fmt::format("    greatest: {}\n", deviation_text(kind.greatest, kind.unit));
  }
  if (!r.all.empty()) out += "\nAll of them:\n";
  for (const auto& [name, d] : r.all) out += fmt::format("  {}  [{}]\n", deviation_text(d, ""), printable(name));
  return out;
}

}  // namespace isogloss::cli::parting
