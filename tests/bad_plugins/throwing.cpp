// Plugins of the SDK that throw; where is chosen by FAULT_….
#include <isogloss/sdk.hpp>
#include <stdexcept>

const char* ig::embedded_page(const char*) noexcept { return nullptr; }

namespace {

struct Throws {
  static constexpr auto spec = ig::syntax("BadSyntax", "Throws.");
  ig::Word x{"Parsing.X"};

#if defined(FAULT_throws_in_create)
  // The prototype of the descriptor has no binding; instances do.
  bool refuses = ig::detail::binding != nullptr ? throw std::runtime_error("not in this chain") : false;
#endif

  ig::Status build(ig::Block&) const {
#if defined(FAULT_throws_in_build)
    throw std::runtime_error("not this block");
#elif defined(FAULT_throws_a_number)
    throw 7;
#endif
    return ig::Status::unchanged;
  }
};

const ig::Register<Throws> registered;

constexpr std::array diagnostics{ig::diagnostic(IG_NOTE, "BAD-0001", "unused", "Unused.", "")};

}  // namespace

#if defined(FAULT_throws_in_entry)
extern "C" IG_EXPORT const ig_plugin* ig_plugin_v1(void) { throw std::runtime_error("not today"); }
#else
ISOGLOSS_PLUGIN(NAME, "1.0.0", "tests", diagnostics)
#endif
