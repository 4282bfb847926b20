// Plugins of the SDK that throw, declare another thing each time, or misspell names; which is chosen by FAULT_….
#include <isogloss/sdk.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

const char* ig::embedded_page(const char*) noexcept { return nullptr; }
const char* ig::embedded_folder(const char*) noexcept { return nullptr; }
const ig::EmbeddedDiagnostic* ig::embedded_diagnostic(const char*) noexcept { return nullptr; }

namespace {

struct Throws {
#if defined(FAULT_misspells)
  static constexpr auto spec = ig::syntax("BadSyntax", "Misspells.").before("ProgramXyzSyntx").after("QueenOfHearts");
  ig::In<double> misspelt{"Feedrate.FeedrateValu"};
  ig::In<double> foreign{"Wonderland.RabbitHole"};
  ig::In<double> known{"Feedrate.FeedrateValue"};
  ig::NumberOption size{"Size", "1", {}, "mm", "A size."};
#else
  static constexpr auto spec = ig::syntax("BadSyntax", "Throws.");
#endif
  ig::Word x{"Parsing.X"};

#if defined(FAULT_declares_another_field)
  ig::Word other{ig::detail::binding != nullptr ? "Parsing.Y" : "Parsing.Z"};
#elif defined(FAULT_declares_more_fields)
  std::vector<ig::Word> more = make_more();
  static std::vector<ig::Word> make_more() {
    std::vector<ig::Word> out;
    if (ig::detail::binding != nullptr) out.emplace_back("Parsing.Y");
    return out;
  }
#elif defined(FAULT_declares_fewer_options)
  std::optional<ig::NumberOption> option = make_option();
  static std::optional<ig::NumberOption> make_option() {
    if (ig::detail::binding != nullptr) return std::nullopt;
    return ig::NumberOption("size", "1", {}, "mm", "A size.");
  }
#endif
#if defined(FAULT_throws_in_create)
  // The prototype of the descriptor has no binding; instances do.
  bool refuses = ig::detail::binding != nullptr ? throw std::runtime_error("not in this chain") : false;
#endif

  ig::Status build(ig::Block&) const {
#if defined(FAULT_throws_in_build)
    throw std::runtime_error("not this block");
#elif defined(FAULT_throws_a_number)
    throw 7;
#elif defined(FAULT_declares_in_build)
    [[maybe_unused]] const ig::Out<double> local{"Feedrate.FeedrateValue"};
#endif
    return ig::Status::unchanged;
  }
};

const ig::Register<Throws> registered;

#if defined(FAULT_misspells)
struct WakesItself {
  static constexpr auto spec = ig::syntax("WakesItselfSyntax", "Waits for what it alone writes.");
  ig::Out<double> own{"Wonderland.Own", {ig::Life::block, "", "Its own."}, ig::write | ig::wake};
  ig::Status build(ig::Block& b) const {
    b.set(own, 1.0);
    return ig::Status::changed;
  }
};

const ig::Register<WakesItself> registered_too;
#endif

constexpr std::array diagnostics{ig::diagnostic(IG_NOTE, "BAD-0001", "unused", "Unused.", "")};

}  // namespace

#if defined(FAULT_throws_in_entry)
extern "C" IG_EXPORT const ig_plugin* ig_plugin_v1(void) { throw std::runtime_error("not today"); }
#else
ISOGLOSS_PLUGIN(NAME, "1.0.0", "tests", diagnostics)
#endif
