#include "../../tests/support/declarations.hpp"

TEST_CASE("no declaration depends on an option") { isogloss_test::check_declarations(*ig_plugin_v1()); }

TEST_CASE("the parameters of the cycles have the units of the manual") {
  const auto unit_of = [](std::string_view path) {
    const ig_plugin& plugin = *ig_plugin_v1();
    for (std::uint32_t s = 0; s < plugin.syntax_count; ++s)
      for (std::uint32_t f = 0; f < plugin.syntaxes[s]->field_count; ++f)
        if (const ig_field_decl& field = plugin.syntaxes[s]->fields[f]; field.path == path)
          return std::string(field.unit);
    return std::string("no such field");
  };
  CHECK(unit_of("Parsing.CYCLE81.RTP") == "mm");
  CHECK(unit_of("Parsing.CYCLE81.DTB") == "s");
  CHECK(unit_of("Parsing.CYCLE81.GMODE").empty());
  CHECK(unit_of("Parsing.CYCLE85.FFR") == "mm/min");
  CHECK(unit_of("Parsing.CYCLE86.POSS") == "deg");
}
