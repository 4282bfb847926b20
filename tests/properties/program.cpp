#include "program.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "product.hpp"

namespace isogloss::properties {

namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t most_lines = 40;

Lines lines_of(std::string_view text) {
  Lines out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    line.erase(std::remove(line.begin(), line.end(), '\r'), line.end());
    out.push_back(std::move(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

const std::vector<Lines>& stock_of(const std::string& dialect) {
  static std::map<std::string, std::vector<Lines>> stocks;
  std::vector<Lines>& out = stocks[dialect];
  // Dialects of one family lend each other their programs: the words are mostly the same.
  const std::vector<std::string> families =
      is_iso(dialect) ? std::vector<std::string>{dialect, dialect, "fanuc", "iso"} : std::vector<std::string>{dialect};
  if (out.empty())
    for (const std::string& family : families)
      for (const std::string& text : product::programs_of(family)) out.push_back(lines_of(text));
  return out;
}

/// Another number in place of one of the line.
void change_number(std::string& line, Random& random) {
  constexpr const char* numbers[] = {"0", "1", "-1", "2.5", "10.", "-7.25", "0.001", "100", "359.999", "4"};
  std::vector<std::size_t> places;
  const auto is_part = [&](std::size_t i) {
    return std::isdigit(static_cast<unsigned char>(line[i])) != 0 || line[i] == '.';
  };
  for (std::size_t i = 1; i < line.size(); ++i)
    if (is_part(i) && !is_part(i - 1)) places.push_back(i);
  if (places.empty()) return;
  const std::size_t begin = places[random.below(places.size())];
  std::size_t end = begin;
  while (end < line.size() && is_part(end)) ++end;
  line.replace(begin, end - begin, numbers[random.below(std::size(numbers))]);
}

void change(Lines& lines, const std::vector<Lines>& stock, Random& random) {
  if (lines.size() < 2) return;
  const std::size_t at = 1 + random.below(lines.size() - 1);
  const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
  switch (random.below(6)) {
    case 0: lines.erase(place); break;
    case 1: lines.insert(place, lines[random.below(lines.size())]); break;
    case 2:
    case 3: change_number(lines[at], random); break;
    default: {
      const Lines& other = stock[random.below(stock.size())];
      const std::size_t begin = random.below(other.size()), count = std::min(1 + random.below(6), other.size() - begin);
      const auto first = other.begin() + static_cast<std::ptrdiff_t>(begin);
      lines.insert(place, first, first + static_cast<std::ptrdiff_t>(count));
    }
  }
}

}  // namespace

std::uint64_t Random::next() {  // splitmix64
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

std::uint64_t choice_at(std::uint64_t seed, std::string_view text, std::size_t place) {
  std::uint64_t sum = seed * 31 + place;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return Random(sum).next();
}

std::string Case::text() const {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

std::vector<std::pair<std::string, std::string>> Case::assignments() const {
  std::vector<std::pair<std::string, std::string>> out{{"ToolOffsetTable.1.H", "120"},
                                                       {"ToolOffsetTable.1.D", "4"},
                                                       {"ToolOffsetTable.2.H", "80.5"},
                                                       {"ToolOffsetTable.2.D", "3"}};
  if (dialect == "siemens") {
    out.emplace_back("SiemensCoordinateTable.G54.X", "100");
    out.emplace_back("SiemensCoordinateTable.G54.Z", "-20");
  } else if (dialect != "heidenhain") {
    out.emplace_back("IsoCoordinateTable.G54.X", "100");
    out.emplace_back("IsoCoordinateTable.G55.Z", "-20");
  }
  return out;
}

const std::vector<std::string>& dialect_names() {
  static const std::vector<std::string> names{"fanuc", "haas",   "iso",     "mazak",
                                              "okuma", "syntec", "siemens", "heidenhain"};
  return names;
}

bool has_plain_words(std::string_view dialect) { return dialect != "heidenhain"; }

bool is_iso(std::string_view dialect) { return dialect != "siemens" && dialect != "heidenhain"; }

Case make_case(const std::string& dialect, std::uint64_t seed, std::uint64_t number) {
  Random random(choice_at(seed, dialect, number));
  const std::vector<Lines>& stock = stock_of(dialect);
  Case out{dialect, random.next(), stock[random.below(stock.size())]};
  if (out.lines.size() > most_lines) {  // some lines of its middle, between its own beginning and end
    const std::size_t cut = out.lines.size() - most_lines, at = 5 + random.below(most_lines - 10);
    const auto first = out.lines.begin() + static_cast<std::ptrdiff_t>(at);
    out.lines.erase(first, first + static_cast<std::ptrdiff_t>(cut));
  }
  for (std::size_t i = random.below(12); i > 0; --i) change(out.lines, stock, random);
  return out;
}

Case case_of_text(const std::string& dialect, std::uint64_t seed, std::string_view text) {
  return {dialect, seed, lines_of(text)};
}

}  // namespace isogloss::properties
