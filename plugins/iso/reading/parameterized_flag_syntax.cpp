// Codes that own words: X in `G81 X5. R2.` is the cycle's X, X in `G28 X5.` the intermediate point. Each code that a
// syntax declares with words of its own gets those words of the block; the other words stay with the block. Where
// several such codes own an address, the nearest one before the word gets it, else the first one of the block.
#include <isogloss/cnc/cycle_codes.hpp>

#include "reading/owned_words.hpp"

namespace iso {
namespace {

struct ParameterizedFlagSyntax {
  static constexpr auto spec = ig::syntax("ParameterizedFlagSyntax", "Gives words to the codes that own them.")
                                   .after("FlagSyntax", "WordSyntax")
                                   .before("DecimalPointSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0593",
                     "{0} goes to {1}, but {2} in the same block takes {0} as well: write them in two blocks"),
  };

  ig::Fields codes{"codes", "Parsing.*", ig::read | ig::wake, "The codes that may own words.", IG_CODE};
  ig::Fields words{"words", "Parsing.*.?", ig::write, "The words that they own."};
  ig::Fields addresses{"addresses", "Parsing.?", ig::read | ig::take, "The words of the block that they may have."};
  std::vector<WordRow> rows = rows_of(codes, words);
  WordRow block = row_of_block(addresses);
  std::vector<ig_field> owners = owner_codes();
  std::vector<std::vector<ig_field>> sources = source_words();
  ig::Codes motions{{"G00", "G01", "G02", "G03", "G33"}, ig::read};
  ig_field thread = motions.id(4);
  // For each of `rows`
  std::vector<bool> is_cycle = rows_of_kind(ig::cnc::cycle_kind), is_pattern = rows_of_kind(ig::cnc::hole_pattern_kind);

  ig::Status build(ig::Block& b) const {
    std::uint32_t found = 0;
    const std::int32_t last = b.find_code(owners.data(), static_cast<std::uint32_t>(owners.size()), &found);
    if (last < 0) return ig::Status::unchanged;
    if (found == 1 && is_replaced(b, static_cast<std::size_t>(last))) return ig::Status::unchanged;
    return found == 1 ? give_all(b, static_cast<std::size_t>(last)) : share(b, found);
  }

 private:
  /// G33 owns no words where another motion code follows it: that code moves the axes, and F is its feed rate.
  bool is_replaced(const ig::Block& b, std::size_t row) const {
    if (rows[row].code != thread) return false;
    const auto last = b.find(motions);
    return last && motions.id(*last) != thread;
  }

  std::vector<ig_field> owner_codes() const {
    std::vector<ig_field> out;
    for (const WordRow& row : rows) out.push_back(row.code);
    return out;
  }

  std::vector<bool> rows_of_kind(std::string_view kind) const {
    const ig::MatchedFields of_kind("Parsing.*{" + std::string(kind) + "}", ig::read, IG_CODE);
    std::vector<bool> out(rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (std::size_t i = 0; i < of_kind.size(); ++i) out[row] = out[row] || of_kind.id(i) == rows[row].code;
    return out;
  }

  std::vector<std::vector<ig_field>> source_words() const {
    std::vector<std::vector<ig_field>> out;
    for (const WordRow& row : rows) {
      std::vector<ig_field>& sources_of_row = out.emplace_back();
      for (const char letter : row.letters) sources_of_row.push_back(block.word(letter));
    }
    return out;
  }

  ig::Status give_all(ig::Block& b, std::size_t row) const {
    const std::vector<ig_field>& from = sources[row];
    std::array<ig_value, 32> values;
    std::uint32_t present = b.get_many(from.data(), static_cast<std::uint32_t>(from.size()), values.data());
    const bool any = present != 0;
    for (; present != 0; present &= present - 1) {
      const std::size_t i = static_cast<std::size_t>(std::countr_zero(present));
      b.move(from[i], rows[row].words[i]);
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

  struct Owner {
    std::size_t row;
    std::int64_t ordinal;  ///< position among the codes of the block
    std::uint32_t begin;
  };

  ig::Status share(ig::Block& b, std::uint32_t found) const {
    std::array<Owner, 16> owners_here;
    std::size_t count = 0;
    for (std::size_t row = 0; row < rows.size() && count < std::min<std::size_t>(found, owners_here.size()); ++row) {
      ig_value code;
      if (!b.get(rows[row].code, code) || is_replaced(b, row)) continue;
      ig_word place{};
      b.word(rows[row].code, place);
      owners_here[count++] = {row, code.integer, place.begin};
    }
    const auto end = owners_here.begin() + static_cast<std::ptrdiff_t>(count);
    std::sort(owners_here.begin(), end, [](const Owner& l, const Owner& r) { return l.ordinal < r.ordinal; });

    bool any = false;
    for (std::size_t i = 0; i < block.words.size(); ++i) {
      ig_value value;
      if (!b.get(block.words[i], value)) continue;
      ig_word place{};
      b.word(block.words[i], place);
      const Choice chosen = owner_of(block.letters[i], place.begin, {owners_here.data(), count});
      if (chosen.owner == nullptr) continue;
      const WordRow& owner = rows[chosen.owner->row];
      if (chosen.other != nullptr)
        b.report(ig::diag("ISO-0593"), ig::Where::word(block.words[i]), std::string_view(&block.letters[i], 1),
                 owner.name, rows[chosen.other->row].name);
      b.move(block.words[i], owner.word(block.letters[i]));
      any = true;
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

  struct Choice {
    const Owner* owner = nullptr;  ///< null: no code owns the address
    const Owner* other = nullptr;  ///< another code that owns it; null: there is none
  };

  /// The nearest code before the column that owns the address, else the first code that owns it. A pattern of holes has
  /// its words before the cycle that it repeats: G82 Z-3. R1. G70 I10. L6.
  Choice owner_of(char letter, std::uint32_t begin, std::span<const Owner> in_order) const {
    const auto owns = [&](const Owner& owner) { return rows[owner.row].word(letter) != IG_NO_FIELD; };
    const bool is_of_pattern = std::any_of(in_order.begin(), in_order.end(),
                                           [&](const Owner& owner) { return is_pattern[owner.row] && owns(owner); });
    Choice out;
    for (const Owner& owner : in_order) {
      if (!owns(owner) || (is_of_pattern && is_cycle[owner.row])) continue;
      const bool is_nearer = out.owner == nullptr || owner.begin < begin;
      if (out.owner != nullptr) out.other = is_nearer ? out.owner : &owner;
      if (is_nearer) out.owner = &owner;
    }
    return out;
  }
};

const ig::Register<ParameterizedFlagSyntax> parameterized_flag_syntax;

}  // namespace
}  // namespace iso
