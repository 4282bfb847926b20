// Answers to FN 18: SYSREAD that only the machine knows: its modes, its options, the state of its tools and axes.
#include <set>
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "language/system_answers.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct HeidenhainSystemData {
  static constexpr auto spec = ig::dependency("HeidenhainSystemData", "What FN 18: SYSREAD reads on this machine.")
                                   .rows("Data", "id")
                                   .provides(system_answer_service);

  ig::Column value{"Value", nullptr, "", {}, "What the Q parameter becomes, in the unit of the program."};
  ig::Column title{"title", nullptr, "", {}, "What it means; explain shows it.", true};
  ig::Table table;
  ig::RowNames names;
  SystemAnswers answers;
  std::set<std::string> repeated;

  HeidenhainSystemData() {
    for (const std::string& name : names) {
      const auto key = SystemKey::read(name);
      const auto given = table.value(name, value);
      if (key && given && !answers.add(*key, {*given, name, std::string(table.text(name, title))}))
        repeated.insert(name);
    }
  }

  const void* service(std::string_view id) const { return id == system_answer_service ? &answers : nullptr; }

  std::string row_fault(std::string_view row) const {
    if (!SystemKey::read(row)) return "its id is ID and a number, perhaps with NR and IDX behind it, as ID990 NR2 IDX0";
    if (!table.value(row, value)) return "it needs a value, as Value=\"1\"";
    if (repeated.count(std::string(row)) != 0) return "another row has the same ID, NR and IDX";
    return "";
  }
};

const ig::Register<HeidenhainSystemData> heidenhain_system_data;

}  // namespace

std::optional<SystemKey> SystemKey::read(std::string_view text) {
  SystemKey key;
  std::size_t i = skip_blanks(text, 0);
  const auto word = [&](std::string_view letters, double& out) {
    std::size_t digits = i;
    for (const char c : letters)
      if (to_upper(at(text, digits++)) != c) return false;
    const ig::Decimal number = is_digit(at(text, digits)) ? ig::read_decimal(text, digits) : ig::Decimal{};
    if (!number.ok || number.end <= digits) return false;
    out = number.value;
    i = skip_blanks(text, number.end);
    return true;
  };
  if (!word("ID", key.id)) return std::nullopt;
  if (word("NR", key.number)) word("IDX", key.index);
  return i == text.size() ? std::optional(key) : std::nullopt;
}

}  // namespace heidenhain
