/// Macros of a machine: names that stand for texts in all programs. The dependency SiemensMacros gives them through a
/// service.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include <isogloss/provenance.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

inline constexpr const char* macro_service = "siemens.macros/1";

struct MachineMacro {
  std::string text;
  std::string row;  ///< its name as the user wrote it
};

/// By their names in upper case.
using MacroTable = std::unordered_map<std::string, MachineMacro>;

/// Why a macro cannot be used; empty where it can. `name` is in upper case.
std::string macro_fault(std::string_view name, std::string_view text);

/// A member of each syntax that reads words.
class Macros {
 public:
  const MachineMacro* find(const std::string& name) const {
    if (!holds_any_) return nullptr;
    const auto it = table_->find(name);
    return it == table_->end() ? nullptr : &it->second;
  }
  bool holds_any() const { return holds_any_; }

 private:
  ig::Service<MacroTable> table_{macro_service, ig::Need::optional, "Macros of the machine."};
  bool holds_any_ = table_ && !table_->empty();
};

/// Records in the block which macros of the machine have answered.
class MacroRecord {
 public:
  void add(ig::Block& b, const std::string& name, const MachineMacro& macro) const {
    rows_.add(b, macro.row);
    std::string all(b.text(name_));
    if ((", " + all + ", ").find(", " + name + ", ") != std::string::npos) return;
    if (!all.empty()) all += ", ";
    b.set_text(name_, all += name);
  }

 private:
  ig::TextField name_{"SiemensMacro.Name",
                      ig::read | ig::write,
                      {ig::Life::block, "", "The macros of the table SiemensMacros that this block uses."}};
  ig::AnsweredRows rows_{macro_service};
};

}  // namespace siemens
