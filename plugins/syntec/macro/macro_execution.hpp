/// Executes the statements of files in MACRO format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "macro/macro_expression.hpp"
#include "macro/macro_structure.hpp"

namespace syntec {

/// A complete statement. `begin` is where it stands in the text, `place` the block in which it began.
struct Statement {
  Keyword keyword = Keyword::none;
  MacroText text{};
  std::size_t begin = 0;
  ig_place place{};

  ig::Where where() const { return text.from(begin); }
  std::size_t behind_word() const { return name_end(text.text, begin); }
};

/// The one member of the syntax.
class MacroExecution {
 public:
  MacroEnvironment environment;
  MacroStructure structure{environment.flow};

  void restart() {
    structure.restart();
    arrival_ = Arrival::none;
    told_.clear();
  }
  void execute(ig::Block& b, const Statement& s);

 private:
  /// How the run came to the statement: a branch that was chosen, the end of a loop that sends back to its beginning,
  /// or an end to which a jump went.
  enum class Arrival : std::uint8_t { none, branch, again, end };

  // ---- macro_flow.cpp

  void go_to(ig::Block& b, const Statement& s);
  void begin_if(ig::Block& b, const Statement& s);
  void begin_case(ig::Block& b, const Statement& s, int level);
  void begin_while(ig::Block& b, const Statement& s, int level);
  void begin_for(ig::Block& b, const Statement& s, int level, Arrival arrival);
  void end_repeat(ig::Block& b, const Statement& s, int level);
  std::optional<bool> condition(ig::Block& b, const Statement& s, std::string_view closing);
  std::optional<int> level_of(ig::Block& b, const Statement& s, Arrival arrival);
  bool jump(ig::Block& b, const Statement& s, std::string_view role, int level, Arrival arrival);
  void to_end(ig::Block& b, const Statement& s, int level) { jump(b, s, "CLOSE", level, Arrival::end); }

  // ---- macro_execution.cpp

  void assign(ig::Block& b, const Statement& s);
  bool assign_text(ig::Block& b, const MacroStore::Variable& v, std::string_view text, ig::Where where);
  void call(ig::Block& b, const Statement& s);
  void alarm(ig::Block& b, const Statement& s, const std::vector<MacroValue>& given);
  void message(ig::Block& b, const Statement& s, const std::vector<MacroValue>& given) const;
  bool is_first(std::string_view name);
  /// True where the statement ends at the position; false, and said, where something follows.
  static bool ends(ig::Block& b, const Statement& s, std::size_t position);
  static void incomplete(ig::Block& b, const Statement& s, std::string_view missing);
  static std::string_view written(const Statement& s);

  Arrival arrival_ = Arrival::none;
  std::uint64_t arrival_frame_ = 0;
  std::vector<std::string> told_;
  ig::TextField name_{"Vars.Name", ig::read | ig::write, {ig::Life::block, "", "The variable that was assigned."}};
  ig::Out<double> value_{"Vars.Value", {ig::Life::block, "", "The value that was assigned; absent: none."}};
};

}  // namespace syntec
