#include "../../tests/support/declarations.hpp"

namespace {

/// Declares X unless its option says no, and then Y.
struct Conditional {
  static constexpr auto spec = ig::syntax("ConditionalSyntax", "Declares what an option says.");
  enum class X { declared, left_out };
  ig::Choice<X> choice_{"x", "declared|left-out", "declared", "Whether X is declared."};
  std::optional<ig::Word> x_{choice_ == X::declared ? std::optional(ig::Word("Parsing.X", ig::read)) : std::nullopt};
  ig::Word y_{"Parsing.Y", ig::read};
  ig::Name name_{"after them"};
  ig::Status build(ig::Block&) { return ig::Status::unchanged; }
};

}  // namespace

TEST_CASE("a declaration that depends on an option is detected") {
  const ig::detail::SyntaxDescriptor<Conditional> descriptor;
  isogloss_test::Observer with(*descriptor.get(), 0, 0), without(*descriptor.get(), 0, 1);
  CHECK(with.run() != without.run());
}

TEST_CASE("no declaration depends on an option") { isogloss_test::check_declarations(*ig_plugin_v1()); }
