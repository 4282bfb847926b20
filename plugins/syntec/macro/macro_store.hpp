/// What macros read and write: the local variables of each call with its arguments, the common variables, the stack of
/// PUSH. The dependency SyntecVariables owns one store; the syntaxes reach it through its service.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_value.hpp"

namespace syntec {

inline constexpr const char* macro_store_service = "syntec.macro-variables/1";
inline constexpr std::uint32_t last_local = 400;
inline constexpr std::uint32_t last_register = 65535;

/// A bit of the tag of each call of this plugin; the lower ones number the calls.
inline constexpr std::uint64_t own_call = std::uint64_t{1} << 60;

/// The local variable of an argument, from its letter; 0 for G, N and O, which are no arguments.
constexpr std::uint32_t variable_of_letter(char letter) {
  constexpr std::array<std::uint8_t, 26> variables{1, 2, 3,  7,  8,  9,  0,  11, 4,  5,  6,  12, 13,
                                                   0, 0, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  return letter >= 'A' && letter <= 'Z' ? variables[static_cast<std::size_t>(letter - 'A')] : 0u;
}

/// The arguments of a call: by letter, and by names such as X1, which GETARG alone reads.
struct Arguments {
  std::array<MacroValue, 26> letters{};
  std::map<std::string, MacroValue, std::less<>> named{};

  const MacroValue* find(std::string_view name) const;
  void set(std::string_view name, MacroValue value);
};

/// A macro that G66 or G66.1 keeps until G67.
struct ModalCall {
  std::string program;
  std::int64_t number;  ///< 0: `program` is the name of a file
  std::uint32_t repeats;
  std::uint64_t tag;  ///< its local variables, the same in each call
  bool each_block;
};

/// What called the program of a level; inside, codes that call macros have their own meaning.
enum class Caller : std::uint8_t { program, g_code, m_code, t_code };

class MacroStore {
 public:
  enum class Area : std::uint8_t { local, number, at, reg };  ///< #1 to #400, # above, @, R
  struct Variable {
    Area area = Area::local;
    std::uint32_t number = 0;
  };

  /// Receives each number that is written to a variable which outlives the run.
  struct Keeper {
    virtual void keep(const Variable& variable, double value) = 0;

   protected:
    ~Keeper() = default;
  };

  struct Level {
    std::uint64_t tag = 0;
    std::uint32_t pass = 1;
    Caller caller = Caller::program;
    bool is_of_code = false;       ///< a code has called this program itself
    bool keeps_locals = false;     ///< of a modal call: its variables live until G67
    bool is_offered = false;       ///< of a modal call by another plugin, which gives each call a tag of its own
    std::uint64_t offered_in = 0;  ///< the frame whose block offered it
    std::vector<MacroValue> values = std::vector<MacroValue>(last_local + 1);
    Arguments arguments{}, trap{};
    std::uint32_t read_letters = 0;
    std::vector<ModalCall> modal{};
  };

  MacroStore() { levels_.resize(1); }

  Level& level() { return levels_[present_]; }
  const MacroValue& read(const Variable& v) const;
  /// False for a register that nobody has given a value.
  bool is_known(const Variable& v) const { return v.area != Area::reg || common_[3].contains(v.number); }
  void write(const Variable& v, MacroValue value);
  void give(const Variable& v, double value) { common_[index(v.area)][v.number] = MacroValue::real(value); }
  void keep_in(Keeper* keeper) { keeper_ = keeper; }

  /// Begins a call: its level waits for the frame that shows the returned tag.
  std::uint64_t enter(Arguments arguments, Caller caller);
  /// The level of a modal call, which exists from G66 to G67 below all that call it.
  std::uint64_t enter_modal(Arguments arguments);
  void leave_last();
  bool is_new_frame(std::uint64_t frame, std::uint32_t pass) {
    if (frame == frame_ && pass == pass_) return false;
    frame_ = frame;
    pass_ = pass;
    return true;
  }
  /// Makes the level of this tag the present one; a new pass begins with its arguments.
  void select(std::uint64_t tag, std::uint32_t pass);
  /// Does select() have to make a level for a tag that no enter() gave? It is of a call by another plugin.
  bool is_foreign(std::uint64_t tag) const;
  /// Before select() makes that level. Programs in ISO format have left the levels that are of none of the frames. The
  /// arguments are those that the calling block has offered, or those of the last modal call that a frame has offered.
  void enter_foreign(std::span<const ig_frame> callers, std::uint32_t call_line);
  /// The next block may belong to another level, though its frame seems to be the same.
  void forget_frame() { frame_ = no_frame; }
  /// What a trap block gives to GETTRAPARG of the modal call.
  void set_trap(std::uint64_t tag, Arguments trap);
  void drop_modal(std::uint64_t tag);

  /// Arguments of a call that another plugin makes from a block, or of a modal one, up to end_offer().
  void offer(Arguments arguments, std::uint64_t frame, std::uint32_t line);
  void offer_modal(Arguments arguments, std::uint64_t frame);
  void end_offer();

  std::vector<MacroValue> stack;

 private:
  static std::size_t index(Area area) { return static_cast<std::size_t>(area); }
  static void fill(Level& level);
  Level make(std::uint64_t tag, Arguments arguments, Caller caller);
  void drop_modals(Level& level);

  std::vector<Level> levels_;
  std::size_t present_ = 0;
  std::vector<Level> parked_;  // of modal calls
  std::array<std::unordered_map<std::uint32_t, MacroValue>, 4> common_;
  struct Offer {
    Arguments arguments{};
    std::uint64_t frame = 0;
    std::uint32_t line = 0;  ///< 0: there is no offer
  };
  Offer offer_{};
  Keeper* keeper_ = nullptr;
  std::uint64_t last_tag_ = 0;
  static constexpr std::uint64_t no_frame = ~std::uint64_t{0};
  std::uint64_t frame_ = no_frame;
  std::uint32_t pass_ = 0;
};

/// #12, @12 or R12, as a table and a diagnostic name it.
std::string name_of(const MacroStore::Variable& v);
/// @401 to @655, @10000 to @14095 and from @100000 on are registers of the PLC.
std::optional<MacroStore::Variable> at_variable(double number);
std::optional<MacroStore::Variable> hash_variable(double number);
/// Registers of the PLC, and #1080 to #1099.
bool holds_integers(const MacroStore::Variable& v);

/// A member of each syntax that uses the store; a store of its own where the dialect has no SyntecVariables.
class StoreMember {
 public:
  StoreMember() : service_(macro_store_service, ig::Need::optional, "What macros read and write.") {}
  MacroStore& operator*() const { return service_ ? *const_cast<MacroStore*>(service_.operator->()) : own_; }
  MacroStore* operator->() const { return &**this; }

 private:
  ig::Service<MacroStore> service_;
  mutable MacroStore own_;
};

}  // namespace syntec
