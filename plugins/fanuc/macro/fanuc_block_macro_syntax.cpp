// Under G66.1 the words of each block are not executed: they are the arguments of the macro, which is called for each
// block. The syntax is asleep unless G66 or G66.1 is in force.
#include <isogloss/cnc/scan.hpp>

#include "macro/macro_arguments.hpp"
#include "macro/macro_environment.hpp"
#include "macro/macro_program_call.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

struct FanucBlockMacro {
  static constexpr auto spec =
      ig::syntax("FanucBlockMacroSyntax", "Calls the macro of G66.1 with the words of each block.")
          .after("WordSyntax", "FanucMacroWordSyntax", "FanucMacroCallSyntax")
          .before("ParameterizedFlagSyntax", "DecimalPointSyntax", "FanucModalMacroSyntax");

  ig::Fields addresses_{"addresses", "Parsing.?", ig::read | ig::take, "The words that are arguments."};
  ig::Fields codes_{"codes", "Parsing.Flags.* Parsing.*", ig::read | ig::write, "The codes that are arguments.",
                    IG_CODE};
  MacroFrame frame_;
  ProgramsOfBuilder builder_;
  ArgumentUnits units_;
  ig::Signal modal_{"MacroCall.~Modal", ig::read | ig::wake_while, ig::Life::modal};
  ig::Signal statement_{"Parsing.~MacroStatement", ig::read}, call_{"Parsing.~MacroCall", ig::read};
  ig::Codes returns_{{"M99"}, ig::read};
  std::vector<ig_field> g_codes_, m_codes_;
  std::vector<double> g_numbers_, m_numbers_;

  FanucBlockMacro() {
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      std::string_view name = codes_.path(i);
      for (const std::string_view prefix : {"Parsing.Flags.", "Parsing."})
        if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
      const ig::Decimal number = name.size() > 1 ? ig::read_decimal(name, 1) : ig::Decimal{};
      if (!number.ok || number.end != name.size()) continue;
      if (name[0] == 'G') {
        g_codes_.push_back(codes_.id(i));
        g_numbers_.push_back(number.value);
      } else if (name[0] == 'M' && !ends_program(number.value)) {
        m_codes_.push_back(codes_.id(i));
        m_numbers_.push_back(number.value);
      }
    }
  }

  ig::Status build(ig::Block& b) {
    if (b.is_raised(statement_) || b.is_raised(call_)) return ig::Status::unchanged;
    frame_.enter(b);
    MacroStore& store = frame_.store();
    if (store.modal_calls().empty() || !store.modal_calls().back().each_block) return ig::Status::unchanged;
    std::uint32_t found = 0;
    const std::int32_t g = b.find_code(g_codes_.data(), size_of(g_codes_), &found);
    if (g >= 0 && g_numbers_[static_cast<std::size_t>(g)] == 67) return ig::Status::unchanged;
    if (b.find(returns_)) return ig::Status::unchanged;  // P names where M99 goes on
    MacroStore::Locals arguments = MacroStore::no_locals();
    bool any = g >= 0;
    if (any) arguments[10] = g_numbers_[static_cast<std::size_t>(g)];
    for (std::size_t i = 0; i < addresses_.size(); ++i)
      any |= pass(b, addresses_.id(i), addresses_.path(i).back(), arguments);
    const std::int32_t m = b.find_code(m_codes_.data(), size_of(m_codes_), &found);
    if (m >= 0) {
      arguments[13] = m_numbers_[static_cast<std::size_t>(m)];
      for (const ig_field code : m_codes_) b.erase(code);
    }
    if (!any && m < 0) return ig::Status::unchanged;

    const MacroStore::ModalCall call = store.modal_calls().back();
    if (call.repeats == 0) return ig::Status::changed;
    report_deep_call(b, store, ig::Where::block());
    const std::uint64_t tag = store.enter(arguments, true);
    frame_.note_arguments(b, tag, arguments);
    settle_modal(store, ask_program(b, builder_, frame_.flow, call.program, call.repeats, tag, ig::Where::block(),
                                    call.arguments));
    return ig::Status::changed;
  }

 private:
  static std::uint32_t size_of(const std::vector<ig_field>& codes) { return static_cast<std::uint32_t>(codes.size()); }
  static bool ends_program(double m) { return m == 2 || m == 30 || m == 99; }

  /// L and P are arguments here, too; N and O are not.
  static std::uint32_t variable_for(char letter) {
    if (letter == 'L') return 12;
    if (letter == 'P') return 16;
    return variable_of[letter_index(letter)];
  }

  bool pass(ig::Block& b, ig_field field, char letter, MacroStore::Locals& arguments) const {
    const std::uint32_t variable = letter_index(letter) < 26 ? variable_for(letter) : 0;
    ig_word word{};
    ig_value value;
    if (variable == 0 || !b.word(field, word) || !b.take(field, value)) return false;
    arguments[variable] = (word.flags & IG_WORD_WITHOUT_POINT) != 0
                              ? units_.counted(b, letter, value.number, word.begin, word.end)
                              : value.number;
    return true;
  }
};

const ig::Register<FanucBlockMacro> fanuc_block_macro_syntax;

}  // namespace
}  // namespace fanuc
