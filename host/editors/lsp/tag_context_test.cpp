#include "lsp/tag_context.hpp"

#include <catch2/catch.hpp>

namespace isogloss::editors {

namespace {

/// The context at the bar: "part element attribute [what stands there]".
std::string at_bar(std::string text) {
  const std::size_t bar = text.find('|');
  text.erase(bar, 1);
  const TagContext c = context_at(text, bar);
  if (c.part == TagContext::Part::none) return "none";
  const char* const part = c.part == TagContext::Part::element     ? "element "
                           : c.part == TagContext::Part::attribute ? "attribute "
                                                                   : "value ";
  return part + c.element + " " + c.attribute + " [" + text.substr(c.begin, c.end - c.begin) + "]";
}

}  // namespace

TEST_CASE("a place in a tag is an element, an attribute or a value") {
  const std::pair<const char*, const char*> table[] = {
      {"<A>|</A>", "none"},
      {"<!-- <A b| -->", "none"},
      {"<|", "element   []"},
      {"<Wo|rdSyntax a=\"1\"/>", "element WordSyntax  [WordSyntax]"},
      {"<A |/>", "attribute A  []"},
      {"<A b=\"1\" |/>", "attribute A  []"},
      {"<A bc| d=\"1\"/>", "attribute A bc [bc]"},
      {"<A b=\"|\"/>", "value A b []"},
      {"<A b=\"x|y\" c=\"z\"/>", "value A b [xy]"},
      {"<A b='1' c='x|'/>", "value A c [x]"},
      {"<A b=\"1>2\" c|=\"\"/>", "attribute A c [c]"},
      {"|", "none"},
  };
  for (const auto& [text, wanted] : table) {
    CAPTURE(text);
    CHECK(at_bar(text) == wanted);
  }
}

}  // namespace isogloss::editors
