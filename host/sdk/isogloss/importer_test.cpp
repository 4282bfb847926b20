#include "isogloss/importer.hpp"

#include <catch2/catch.hpp>

#include "isogloss/plugin.hpp"

namespace {

using Lines = std::vector<std::pair<std::string, std::size_t>>;

Lines lines_of(std::string_view text) {
  Lines out;
  for (const ig::TextLine& line : ig::TextLines(text)) out.emplace_back(line.text, line.begin);
  return out;
}

struct TwoTables {
  static constexpr auto spec = ig::importer("TwoTables", "Reads nothing.").files("*.a *.b").fills("First", "Second");
  ig::IntegerOption step{"step", "2", {1, 9}, "A step."};
  static unsigned recognise(std::string_view text, std::string_view name) {
    if (text == "throw") throw std::runtime_error("recognise");
    return text.empty() ? 0 : static_cast<unsigned>(name.size());
  }
  void read(ig::Import&) const { throw std::runtime_error("odd step " + std::to_string(step)); }
};

ig_text text(std::string_view s) { return ig::to_text(s); }

}  // namespace

TEST_CASE("lines end in LF, CR LF or CR, and have their places") {
  CHECK(lines_of("").empty());
  CHECK(lines_of("a\nb") == Lines{{"a", 0}, {"b", 2}});
  CHECK(lines_of("a\r\n\r\nb\r\n") == Lines{{"a", 0}, {"", 3}, {"b", 5}});
  CHECK(lines_of("a\rb\r") == Lines{{"a", 0}, {"b", 2}});
  CHECK(lines_of("\n\n") == Lines{{"", 0}, {"", 1}});
}

TEST_CASE("an importer declares its tables and options, and does not write unless it has write()") {
  const ig_importer& importer = *ig::detail::descriptor_of<TwoTables>().get();
  CHECK(std::string_view(importer.files) == "*.a *.b");
  CHECK(std::string_view(importer.dependencies[1]) == "Second");
  CHECK(importer.dependencies[2] == nullptr);
  REQUIRE(importer.option_count == 1);
  CHECK(std::string_view(importer.options[0].name) == "step");
  CHECK(importer.write == nullptr);
}

TEST_CASE("what an importer throws stays inside: it does not recognise the file, or fails with the reason") {
  const ig_importer& importer = *ig::detail::descriptor_of<TwoTables>().get();
  CHECK(importer.recognise(text("x"), text("abc")) == 3);
  CHECK(importer.recognise(text("throw"), text("abc")) == 0);
  static std::string reason;
  ig_import_api api{};
  api.struct_size = sizeof api;
  api.text = [](const ig_import*) { return text(""); };
  api.option_integer = [](const ig_import*, std::uint32_t) { return std::int64_t{7}; };
  api.fail = [](ig_import*, ig_text why) { reason = ig::to_view(why); };
  CHECK(importer.read(&api, nullptr) == IG_FAILED);
  CHECK(reason == "odd step 7");
}

TEST_CASE("a part of a file is quoted without control characters, and cut between characters") {
  CHECK(ig::shown_part("G10 L2") == "G10 L2");
  CHECK(ig::shown_part("a\tb\x7f") == "a b ");
  CHECK(ig::shown_part(std::string(40, 'x')) == std::string(40, 'x'));
  CHECK(ig::shown_part(std::string(41, 'x')) == std::string(40, 'x') + "…");
  CHECK(ig::shown_part(std::string(39, 'x') + "ä") == std::string(39, 'x') + "…");
}
