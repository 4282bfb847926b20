// Codes that the builder of the machine has added: what each of them does here, by its name. A control hands such codes
// to the builder's logic, which no program shows, so only the user can know.
#include <isogloss_machine_code.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

constexpr std::string_view klartext_cycle = "CYCL DEF ";
constexpr std::array<std::string_view, 6> kinds{"", "nothing", "codes", "call", "position", "refused"};

enum class UnknownPrograms { error, nothing };

/// Capital letters, one blank between two words, and codes as scanners name them: M8 is M08, M8.0 too, and G054.1 is
/// G54.1; a cycle's number has no leading zeros, and FN 19 no blank.
std::string canonical(std::string_view written) {
  std::string out;
  for (const char c : trim(written)) {
    if (!is_blank(c))
      out += to_upper(c);
    else if (!out.ends_with(' '))
      out += ' ';
  }
  const bool is_family = out.ends_with('*');
  const bool is_code = out.size() > 1 && (out[0] == 'G' || out[0] == 'M') && is_digit(out[1]);
  if (is_code && out.ends_with(".0")) out.resize(out.size() - 2);
  if (is_code && out.ends_with('.')) out.pop_back();
  while (is_code && out[1] == '0' && out.size() > 2 && is_digit(out[2])) out.erase(1, 1);
  if (is_code && !is_family && skip_digits(out, 1) == 2) out.insert(1, 1, '0');
  if (out.starts_with("FN ") && out.size() > 3 && is_digit(out[3])) out.erase(2, 1);
  while (out.starts_with(klartext_cycle) && out.size() > klartext_cycle.size() + 1 && out[klartext_cycle.size()] == '0')
    out.erase(klartext_cycle.size(), 1);
  while (out.size() > 2 && out[0] == 'O' && out[1] == '0' && is_digit(out[2])) out.erase(1, 1);
  return out;
}

/// G or M with a number that may have one decimal.
bool is_code(std::string_view name) {
  if (name.size() < 2 || (name[0] != 'G' && name[0] != 'M')) return false;
  const std::size_t end = skip_digits(name, 1);
  return end > 1 && (end == name.size() || (name[end] == '.' && end + 2 == name.size() && is_digit(name[end + 1])));
}

/// A cycle, or what may call a program: two letters or more, or L and a number.
bool is_found_by_name(std::string_view name) {
  if (name.starts_with(klartext_cycle))
    return name.size() > klartext_cycle.size() && skip_digits(name, klartext_cycle.size()) == name.size();
  const auto is_part = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  if (name.size() < 2 || is_digit(name[0]) || skip_while(name, 0, is_part) != name.size()) return false;
  return !is_digit(name[1]) || ((name[0] == 'L' || name[0] == 'O') && skip_digits(name, 1) == name.size());
}

/// The beginning that the names of a family have in common; empty where the name is none of a family.
std::string_view beginning_of_family(std::string_view name) {
  return name.ends_with('*') ? name.substr(0, name.size() - 1) : std::string_view{};
}

/// G and M with digits or none: a family of codes, to which no program belongs.
bool begins_codes(std::string_view beginning) {
  return (beginning[0] == 'G' || beginning[0] == 'M') && skip_digits(beginning, 1) == beginning.size();
}

/// CYCLE9*, L9*, M2*, CYCL DEF 3*: the beginning of what a name may be.
bool is_family(std::string_view name) {
  const std::string_view beginning = beginning_of_family(name);
  if (beginning.empty()) return false;
  if (name.starts_with(klartext_cycle)) return skip_digits(beginning, klartext_cycle.size()) == beginning.size();
  const auto is_part = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  return !is_digit(name[0]) && skip_while(beginning, 0, is_part) == beginning.size();
}

bool names_codes(std::string_view name) {
  return is_code(name) || (is_family(name) && begins_codes(beginning_of_family(name)));
}

/// The name as families compare it: M08 is M8.
std::string without_zeros(std::string name) {
  if (is_code(name) && name[1] == '0' && name.size() > 2 && is_digit(name[2])) name.erase(1, 1);
  return name;
}

/// "M8  m50" becomes "M08 M50"; empty where a word is not a code.
std::string codes_of(std::string_view written) {
  std::string out;
  for (std::string_view rest = trim(written); !rest.empty(); rest = trim(rest)) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string code = canonical(rest.substr(0, end));
    if (!is_code(code)) return {};
    out.append(out.empty() ? "" : " ").append(code);
    rest.remove_prefix(end);
  }
  return out;
}

/// "Z0 X10.5" in `row`; false where a word is not an axis with a number, or names an axis again.
bool read_position(std::string_view written, ig_machine_code& row) {
  for (std::string_view rest = trim(written); !rest.empty(); rest = trim(rest)) {
    const std::size_t axis = std::string_view("XYZABC").find(to_upper(rest[0]));
    const ig::Decimal number = ig::read_decimal(rest, 1);
    if (axis > 5 || (row.axes >> axis & 1u) != 0 || !number.ok || number.end == 1) return false;
    if (number.end < rest.size() && rest[number.end] != ' ') return false;
    row.axes |= 1u << axis;
    row.position[axis] = number.value + 0.0;
    rest.remove_prefix(number.end);
  }
  return row.axes != 0;
}

struct MachineCodeTable {
  static constexpr auto spec = ig::dependency("MachineCodes", "Codes, cycles and programs of the machine's builder.")
                                   .rows("Code", "name")
                                   .provides("isogloss.machine-code/1");

  ig::Column does{"does", nullptr, "", {}, "What the code does: nothing, codes, call, position or refused.", true};
  ig::Column codes{"codes", nullptr, "", {}, "The codes as which it acts: M8 M50.", true};
  ig::Column program{"program", nullptr, "", {}, "The program that it calls: its number, or its name.", true};
  ig::Column position{
      "position", nullptr, "", {}, "Where the axes go by rapid, in machine coordinates, mm and degrees: Z0 X10.", true};
  ig::Column text{"text", nullptr, "", {}, "Why the code is refused.", true};
  ig::Column when{"when", nullptr, "", {}, "When a cycle acts: defined or called; else as its number says.", true};
  ig::Column arguments{"arguments", nullptr, "", {},
                       "Of a G or M code that calls: passed or none; else passed for G codes.", true};
  ig::Column title{"title", nullptr, "", {}, "What the builder calls it; explain shows it.", true};
  ig::Choice<UnknownPrograms> unknown_programs{
      "unknown-programs", "error|nothing", "error",
      "A call of a program that is not found and has no row: an error, or it does nothing, with a note."};
  ig::Table table;
  ig::RowNames names;

  MachineCodeTable() {
    for (const std::string& name : names) spellings.emplace(canonical(name), name);
    for (const std::string& name : names) load(name);
    answers.unknown_programs = unknown_programs == UnknownPrograms::nothing ? 1 : 0;
  }

  const void* service(std::string_view id) const { return id == "isogloss.machine-code/1" ? &answers : nullptr; }

  std::string row_fault(std::string_view row) const {
    const std::string_view kind = table.text(row, does);
    const auto lacks = [&](const ig::Column& column, const char* example) {
      return trim(table.text(row, column)).empty() ? "does=\"" + std::string(kind) + "\" needs " + example
                                                   : std::string();
    };
    const std::string name = canonical(row);
    for (auto [other, last] = spellings.equal_range(name); other != last; ++other)
      if (other->second != row) return "the row " + other->second + " is the same code";
    if (const std::string_view time = table.text(row, when); !time.empty() && time != "defined" && time != "called")
      return "when=\"" + std::string(time) + "\" is none of defined, called";
    if (!is_code(name) && !is_found_by_name(name) && !is_family(name))
      return "its name is a code, as M92, a cycle, as CYCL DEF 392 or CYCLE996, a program, as L9000, or a family, as CYCLE9*";
    if (!table.text(row, when).empty() && !name.starts_with(klartext_cycle))
      return "when has no effect here: only CYCL DEF may wait for its call";
    if (const std::string_view passed = table.text(row, arguments); !passed.empty()) {
      if (passed != "passed" && passed != "none") return "arguments=\"" + std::string(passed) + "\" is none of passed, none";
      if (kind != "call" || !names_codes(name)) return "arguments has no effect here: only G and M codes that call have it";
    }
    if (const std::string_view unused = unused_column(row, kind); !unused.empty())
      return std::string(unused) + " has no effect with does=\"" + std::string(kind) + "\": remove it";
    if (kind == "nothing") return "";
    if (kind == "call") return lacks(program, "program=\"9001\"");
    if (kind == "refused") return lacks(text, "text=\"why it is refused\"");
    if (kind == "codes") {
      const bool is_read = table.text(row, codes).empty() || !codes_of(table.text(row, codes)).empty();
      return is_read ? lacks(codes, "codes=\"M8 M50\"") : "codes is a list of G and M codes, as codes=\"M8 M50\"";
    }
    if (kind == "position") {
      ig_machine_code unused{};
      const bool is_read = table.text(row, position).empty() || read_position(table.text(row, position), unused);
      return is_read ? lacks(position, "position=\"Z0 X10\"")
                     : "position is each axis of X Y Z A B C once, with a number, as position=\"Z0 X10\"";
    }
    return kind.empty() ? "does is missing: nothing, codes, call, position or refused"
                        : "does=\"" + std::string(kind) + "\" is none of nothing, codes, call, position, refused";
  }

 private:
  /// The name of a column that has a text and no effect with this kind; empty where there is none.
  std::string_view unused_column(std::string_view row, std::string_view kind) const {
    struct Use {
      const ig::Column& column;
      std::string_view name, kind;
    };
    if (kind.empty() || std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) return {};
    for (const Use& use : {Use{codes, "codes", "codes"}, Use{program, "program", "call"},
                           Use{position, "position", "position"}, Use{text, "text", "refused"}})
      if (kind != use.kind && !table.text(row, use.column).empty()) return use.name;
    return {};
  }

  struct Row {
    std::string name, codes, program, text, title;
    ig_machine_code shown{};
  };

  void load(const std::string& written) {
    const auto kind = std::find(kinds.begin() + 1, kinds.end(), table.text(written, does));
    if (kind == kinds.end() || !row_fault(written).empty()) return;
    const auto [place, is_new] = rows.try_emplace(canonical(written));
    Row& row = place->second;
    row.shown.struct_size = sizeof row.shown;
    row.shown.does = static_cast<ig_machine_code_kind>(kind - kinds.begin());
    if (row.shown.does == IG_CODE_ACTS) row.codes = codes_of(table.text(written, codes));
    if (row.shown.does == IG_CODE_CALLS) row.program = trim(table.text(written, program));
    if (row.shown.does == IG_CODE_IS_REFUSED) row.text = table.text(written, text);
    row.title = table.text(written, title);
    const std::string_view passed = table.text(written, arguments);
    row.shown.arguments = passed == "passed" ? 2 : passed.empty() && place->first[0] == 'G' && names_codes(place->first) ? 1 : 0;
    row.shown.when = table.text(written, when) == "defined" ? 1 : table.text(written, when) == "called" ? 2 : 0;
    row.shown.name = ig::to_text(place->first);
    row.name = written;
    row.shown.row = ig::to_text(row.name);
    row.shown.codes = ig::to_text(row.codes);
    row.shown.program = ig::to_text(row.program);
    row.shown.text = ig::to_text(row.text);
    row.shown.title = ig::to_text(row.title);
    if (row.shown.does == IG_CODE_MOVES) read_position(table.text(written, position), row.shown);
  }

  static const ig_machine_code* find(void* self, ig_text name) {
    const auto& rows = static_cast<const MachineCodeTable*>(self)->rows;
    const auto row = name.size == 0 ? rows.begin() : rows.find(canonical(ig::to_view(name)));
    return row == rows.end() ? nullptr : &row->second.shown;
  }

  /// The longest beginning wins, so the search shortens the name.
  static const ig_machine_code* find_family(void* self, ig_text asked) {
    const auto& rows = static_cast<const MachineCodeTable*>(self)->rows;
    const std::string canonical_name = canonical(ig::to_view(asked)), name = without_zeros(canonical_name);
    for (std::size_t size = std::min<std::size_t>(name.size(), most_name); size-- > 1;) {
      const auto row = rows.find(name.substr(0, size) + "*");
      if (row == rows.end()) continue;
      if (!begins_codes(name.substr(0, size)) || is_code(canonical_name)) return &row->second.shown;
    }
    return nullptr;
  }
  static constexpr std::size_t most_name = 100;  // of a family; a name of any length costs no more

  std::multimap<std::string, std::string> spellings;  // the rows as the user named them, by their canonical names
  std::map<std::string, Row> rows;
  ig_machine_code_1 answers{sizeof(ig_machine_code_1), 0, this, &find, &find_family};
};

const ig::Register<MachineCodeTable> machine_codes;

}  // namespace
}  // namespace iso
