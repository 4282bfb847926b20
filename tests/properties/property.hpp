/// What holds of every program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "program.hpp"

namespace isogloss::properties {

struct Verdict {
  bool was_tried = false;  ///< the program has something to try the property on
  std::string fault;       ///< empty: the property holds
};

struct Property {
  const char* name;
  int cases;  ///< for each dialect, without sanitizers
  Verdict (*judge)(const Case& program);
  bool (*fits)(std::string_view dialect) = nullptr;  ///< null: each dialect
};

// In the files *_property.cpp.
Verdict judge_bytes(const Case& program);
Verdict judge_foreign_words(const Case& program);
Verdict judge_blanks(const Case& program);
Verdict judge_order(const Case& program);
Verdict judge_numbers(const Case& program);
Verdict judge_canonical(const Case& program);
Verdict judge_halves(const Case& program);
Verdict judge_ahead(const Case& program);
Verdict judge_machine(const Case& program);
Verdict judge_units(const Case& program);
Verdict judge_modal(const Case& program);
Verdict judge_distances(const Case& program);

}  // namespace isogloss::properties
