#include "document/document_shape.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>

using namespace isogloss;

namespace {

Layout layout_of(std::initializer_list<const char*> codes, std::initializer_list<const char*> words) {
  Layout layout;
  for (const char* const path : codes)
    layout.fields.push_back({path, IG_CODE, IG_LIFE_WORD, "", "", false, IG_NO_FIELD});
  for (const char* const path : words)
    layout.fields.push_back({path, IG_NUMBER, IG_LIFE_WORD, "mm", "", false, IG_NO_FIELD});
  for (ig_field f = static_cast<ig_field>(codes.size()); f < layout.fields.size(); ++f) layout.shown.push_back(f);
  layout.index();
  return layout;
}

/// The names below a node: "A(B,C(D))".
std::string names(const std::vector<ShapeNode>& nodes) {
  std::string out;
  for (const ShapeNode& node : nodes) {
    out += (out.empty() ? "" : ",") + node.name;
    if (!node.children.empty()) out += "(" + names(node.children) + ")";
  }
  return out;
}

const ShapeNode& section(const std::vector<ShapeNode>& shape, std::string_view name) {
  return *std::find_if(shape.begin(), shape.end(), [&](const ShapeNode& node) { return node.name == name; });
}

}  // namespace

TEST_CASE("a code with decimals and the one without own their words side by side") {
  const Layout layout =
      layout_of({"Parsing.B5.1", "Parsing.B5", "Parsing.B5.1.2"},
                {"Parsing.B5.P", "Parsing.B5.1.P", "Parsing.B5.1.2.Q", "Parsing.B5.1.R", "Parsing.X"});
  CHECK(names(section(document_shape(layout), "Parsing").children) == "Flags,X,B5.1(P,R),B5(P),B5.1.2(Q)");
}

TEST_CASE("sections nest by their points, fields in the order of the layout") {
  const Layout layout = layout_of({}, {"Own.B", "Own.A.Y", "Other", "Own.A.X", "Own.C"});
  const std::vector<ShapeNode> shape = document_shape(layout);
  CHECK(names(section(shape, "Own").children) == "B,A(Y,X),C");
  CHECK(section(shape, "Other").kind == ShapeNode::Kind::field);
}
