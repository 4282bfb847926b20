/// The names that a chain knows: addresses (X, CR, I1) and codes (G1, SUPA, TRANS), as its syntaxes declare them.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include <isogloss/cnc/further_axes.hpp>

#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

class WordFields {
 public:
  WordFields() {
    for (std::size_t i = 0; i < addresses_.size(); ++i) {
      const std::string_view name = ig::word_name(addresses_.path(i));  // Parsing.
      if (name.size() == 1 && letter_index(name[0]) < 26)
        letters_[letter_index(name[0])] = addresses_.id(i);
      else
        names_.emplace(name, addresses_.id(i));
    }
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      std::string_view name = codes_.path(i);
      for (const std::string_view prefix : {"Parsing.Flags.", "Parsing."})
        if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
      enter(name, codes_.id(i));
    }
  }

  ig_field letter(char c) const { return letters_[letter_index(c)]; }
  ig_field address(const std::string& name) const {
    if (name.size() == 1) return ig::cnc::is_letter(name[0]) ? letter(name[0]) : IG_NO_FIELD;
    const auto it = names_.find(name);
    return it == names_.end() ? IG_NO_FIELD : it->second;
  }
  ig_field code(char letter, std::uint32_t number) const {
    const std::vector<ig_field>& row = numbered_[to_upper(letter) == 'G' ? 0 : 1];
    return number < row.size() ? row[number] : IG_NO_FIELD;
  }
  ig_field code(const std::string& name) const {
    const auto it = named_.find(name);
    return it == named_.end() ? IG_NO_FIELD : it->second;
  }

 private:
  void enter(std::string_view name, ig_field field) {
    const bool is_numbered =
        name.size() > 1 && (name[0] == 'G' || name[0] == 'M') && skip_digits(name, 1) == name.size() && name.size() < 6;
    if (!is_numbered) {
      named_.emplace(name, field);
      return;
    }
    std::size_t number = 0;
    for (const char c : name.substr(1)) number = number * 10 + static_cast<std::size_t>(c - '0');
    std::vector<ig_field>& row = numbered_[name[0] == 'G' ? 0 : 1];
    if (row.size() <= number) row.resize(number + 1, IG_NO_FIELD);
    row[number] = field;
  }
  static std::array<ig_field, 26> none() {
    std::array<ig_field, 26> out{};
    out.fill(IG_NO_FIELD);
    return out;
  }

  ig::Fields addresses_{"addresses", "Parsing.*", ig::write, "The addresses that words may have."};
  ig::Fields codes_{"codes", "Parsing.Flags.* Parsing.*", ig::write, "The codes that syntaxes of this chain know.",
                    IG_CODE};
  std::array<ig_field, 26> letters_ = none();
  std::unordered_map<std::string, ig_field> names_;
  std::array<std::vector<ig_field>, 2> numbered_;
  std::unordered_map<std::string, ig_field> named_;
};

}  // namespace siemens
