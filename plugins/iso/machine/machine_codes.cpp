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

#include "machine/machine_code_names.hpp"
#include "machine/row_fields.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

constexpr std::array<std::string_view, 7> kinds{"", "nothing", "codes", "call", "position", "refused", "set"};

enum class UnknownPrograms { error, nothing };

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

  ig::Column does{"does", nullptr, "", {}, "What the code does: nothing, codes, call, position, set or refused.", true};
  ig::Column codes{"codes", nullptr, "", {}, "The codes as which it acts: M8 M50.", true};
  ig::Column program{"program", nullptr, "", {}, "The program that it calls: its number, or its name.", true};
  ig::Column position{
      "position", nullptr, "", {}, "Where the axes go by rapid, in machine coordinates, mm and degrees: Z0 X10.", true};
  ig::Column fields{
      "fields", nullptr, "fields", {}, "Fields of the block and their values: Coolant.Mode=FLOOD; Dwell.Time={P}.",
      true};
  ig::Column text{"text", nullptr, "", {}, "Why the code is refused.", true};
  ig::Column when{"when", nullptr, "", {}, "When a cycle acts: defined or called; else as its number says.", true};
  ig::Column arguments{
      "arguments", nullptr, "", {}, "Of a G or M code that calls: passed or none; else passed for G codes.", true};
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
      return "its name is a code, as M92, a cycle, as CYCL DEF 392 or CYCLE996, a program, as L9000, or a family, as "
             "CYCLE9*";
    if (!table.text(row, when).empty() && !name.starts_with(klartext_cycle))
      return "when has no effect here: only CYCL DEF may wait for its call";
    if (const std::string_view passed = table.text(row, arguments); !passed.empty()) {
      if (passed != "passed" && passed != "none")
        return "arguments=\"" + std::string(passed) + "\" is none of passed, none";
      if (kind != "call" || !names_codes(name))
        return "arguments has no effect here: only G and M codes that call have it";
    }
    if (const std::string_view unused = unused_column(row, kind); !unused.empty())
      return std::string(unused) + " has no effect with does=\"" + std::string(kind) + "\": remove it";
    if (kind == "nothing") return "";
    if (kind == "call") return lacks(program, "program=\"9001\"");
    if (kind == "refused") return lacks(text, "text=\"why it is refused\"");
    if (kind == "set") {
      const std::string fault = fields_fault(table.text(row, fields));
      return fault.empty() ? lacks(fields, "fields=\"Coolant.Mode=FLOOD\"") : fault;
    }
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
    return kind.empty() ? "does is missing: nothing, codes, call, position, set or refused"
                        : "does=\"" + std::string(kind) + "\" is none of nothing, codes, call, position, set, refused";
  }

 private:
  /// The name of a column that has a text and no effect with this kind; empty where there is none.
  std::string_view unused_column(std::string_view row, std::string_view kind) const {
    struct Use {
      const ig::Column& column;
      std::string_view name, kind;
    };
    if (kind.empty() || std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) return {};
    for (const Use& use :
         {Use{codes, "codes", "codes"}, Use{program, "program", "call"}, Use{position, "position", "position"},
          Use{text, "text", "refused"}, Use{fields, "fields", "set"}})
      if (kind != use.kind && !table.text(row, use.column).empty()) return use.name;
    return {};
  }

  struct Row {
    std::string name, codes, program, text, title, fields;
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
    if (row.shown.does == IG_CODE_SETS) row.fields = canonical_fields(table.text(written, fields));
    row.title = table.text(written, title);
    const std::string_view passed = table.text(written, arguments);
    row.shown.arguments = passed == "passed"                                                      ? 2
                          : passed.empty() && place->first[0] == 'G' && names_codes(place->first) ? 1
                                                                                                  : 0;
    row.shown.when = table.text(written, when) == "defined" ? 1 : table.text(written, when) == "called" ? 2 : 0;
    row.shown.name = ig::to_text(place->first);
    row.name = written;
    row.shown.row = ig::to_text(row.name);
    row.shown.codes = ig::to_text(row.codes);
    row.shown.program = ig::to_text(row.program);
    row.shown.text = ig::to_text(row.text);
    row.shown.title = ig::to_text(row.title);
    row.shown.fields = ig::to_text(row.fields);
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
      const bool is_cycle = name.starts_with(klartext_cycle), is_of_cycles = size >= klartext_cycle.size();
      if (is_cycle ? is_of_cycles : !begins_codes(name.substr(0, size)) || is_code(canonical_name))
        return &row->second.shown;
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
