#include "lsp/settings.hpp"

#include <catch2/catch.hpp>

namespace isogloss::editors {

TEST_CASE("settings take what is right and name what is wrong") {
  std::vector<std::string> faults;
  const Json json{{"dialect", "fanuc"},
                  {"set", {"A.B.C=1"}},
                  {"subprograms", {1}},
                  {"budgetMs", 1},
                  {"inlayHints", {{"machine", false}, {"modal", 1}}},
                  {"format", "all"},
                  {"unknown", 7}};
  const Settings s = with({}, json, faults);
  CHECK(s.dialect == "fanuc");
  CHECK(s.set == std::vector<std::string>{"A.B.C=1"});
  CHECK(s.budget_ms == Settings{}.budget_ms);
  CHECK_FALSE(s.shows_machine);
  CHECK(s.shows_modal);
  CHECK(faults.size() == 4);
}

TEST_CASE("settings that are no object change nothing") {
  std::vector<std::string> faults;
  CHECK(with({}, Json(7), faults) == Settings{});
  CHECK(faults.size() == 1);
  CHECK(with({}, Json(nullptr), faults) == Settings{});
  CHECK(faults.size() == 1);
}

}  // namespace isogloss::editors
