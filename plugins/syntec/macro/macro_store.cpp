/// Levels of macro calls with their local variables, and the variables that all programs share.
#include "macro/macro_store.hpp"

#include <algorithm>
#include <cmath>

namespace syntec {

const MacroValue* Arguments::find(std::string_view name) const {
  if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z') return &letters[static_cast<std::size_t>(name[0] - 'A')];
  for (const auto& [known, value] : named)
    if (known == name) return &value;
  return nullptr;
}

void Arguments::set(std::string_view name, MacroValue value) {
  if (name.size() == 1) {
    letters[static_cast<std::size_t>(name[0] - 'A')] = std::move(value);
    return;
  }
  for (auto& [known, before] : named)
    if (known == name) {
      before = std::move(value);
      return;
    }
  named.emplace_back(std::string(name), std::move(value));
}

const MacroValue& MacroStore::read(const Variable& v) const {
  static const MacroValue vacant;
  if (v.number == 0 && v.area != Area::reg) return vacant;
  if (v.area == Area::local) return levels_[present_].values[v.number];
  const auto& area = common_[index(v.area)];
  const auto found = area.find(v.number);
  return found == area.end() ? vacant : found->second;
}

void MacroStore::write(const Variable& v, MacroValue value) {
  if (v.area == Area::local) {
    levels_[present_].values[v.number] = std::move(value);
    return;
  }
  if (keeper_ != nullptr && value.is_number()) keeper_->keep(v, value.number);
  common_[index(v.area)][v.number] = std::move(value);
}

void MacroStore::fill(Level& level) {
  level.values.assign(last_local + 1, MacroValue());
  for (std::size_t i = 0; i < level.arguments.letters.size(); ++i)
    if (const std::uint32_t n = variable_of_letter(static_cast<char>('A' + i)); n != 0)
      level.values[n] = level.arguments.letters[i];
}

MacroStore::Level MacroStore::make(std::uint64_t tag, Arguments arguments, Caller caller) {
  Level level;
  level.tag = tag;
  level.caller = caller;
  level.arguments = std::move(arguments);
  fill(level);
  return level;
}

void MacroStore::leave_last() {
  while (levels_.size() > present_ + 1) {
    if (levels_.back().keeps_locals) parked_.push_back(std::move(levels_.back()));
    levels_.pop_back();
  }
}

std::uint64_t MacroStore::enter(Arguments arguments, Caller caller) {
  frame_ = no_frame;
  leave_last();
  // A program that a code has called sees all codes as they are, also through the programs that it calls.
  const bool is_of_code = caller != Caller::program;
  if (!is_of_code) caller = level().caller;
  levels_.push_back(make(++last_tag_ | own_call, std::move(arguments), caller));
  levels_.back().is_of_code = is_of_code;
  return levels_.back().tag;
}

std::uint64_t MacroStore::enter_modal(Arguments arguments) {
  parked_.push_back(make(++last_tag_ | own_call, std::move(arguments), Caller::program));
  parked_.back().keeps_locals = true;
  return parked_.back().tag;
}

void MacroStore::set_trap(std::uint64_t tag, Arguments trap) {
  const auto level = std::find_if(parked_.begin(), parked_.end(), [&](const Level& one) { return one.tag == tag; });
  if (level != parked_.end()) level->trap = std::move(trap);
}

void MacroStore::drop_modal(std::uint64_t tag) {
  std::erase_if(parked_, [&](const Level& level) { return level.tag == tag; });
}

void MacroStore::offer(Arguments arguments, bool is_modal) {
  frame_ = no_frame;
  if (is_modal) {
    std::erase_if(parked_, [](const Level& level) { return level.is_offered; });
    enter_modal(std::move(arguments));
    parked_.back().is_offered = true;
    has_offer_ = false;
  } else {
    offered_ = std::move(arguments);
    has_offer_ = true;
  }
}

void MacroStore::select(std::uint64_t tag, std::uint32_t pass) {
  if (levels_[present_].tag != tag) {
    std::size_t below = present_;
    while (below > 0 && levels_[below].tag != tag) --below;
    if (present_ + 1 < levels_.size() && levels_[present_ + 1].tag == tag) {
      ++present_;
    } else if (levels_[below].tag == tag) {
      present_ = below;
    } else {
      leave_last();
      const bool is_foreign = (tag & own_call) == 0;
      const auto parked = std::find_if(parked_.begin(), parked_.end(), [&](const Level& l) {
        return l.tag == tag || (is_foreign && !has_offer_ && l.is_offered);
      });
      if (parked != parked_.end()) {
        levels_.push_back(std::move(*parked));
        levels_.back().tag = tag;
        parked_.erase(parked);
      } else {
        levels_.push_back(make(tag, std::exchange(offered_, {}), Caller::program));
        has_offer_ = false;
      }
      ++present_;
    }
    leave_last();
  }
  Level& level = levels_[present_];
  if (level.pass != pass && tag != 0) {
    level.pass = pass;
    if (!level.keeps_locals) fill(level);
  }
}

std::string name_of(const MacroStore::Variable& v) {
  const char* const prefix = v.area == MacroStore::Area::reg ? "R" : v.area == MacroStore::Area::at ? "@" : "#";
  return prefix + std::to_string(v.number);
}

std::optional<MacroStore::Variable> at_variable(double number) {
  if (!(number >= 0 && number <= 165535) || number != std::floor(number)) return std::nullopt;
  const auto n = static_cast<std::uint32_t>(number);
  if (n >= 401 && n <= 655) return MacroStore::Variable{MacroStore::Area::reg, n - 400};
  if (n >= 10000 && n <= 14095) return MacroStore::Variable{MacroStore::Area::reg, n - 10000};
  if (n >= 100000) return MacroStore::Variable{MacroStore::Area::reg, n - 100000};
  if (n <= 1999 || (n >= 60000 && n <= 79999)) return MacroStore::Variable{MacroStore::Area::at, n};
  return std::nullopt;
}

bool holds_integers(const MacroStore::Variable& v) {
  return v.area == MacroStore::Area::reg ||
         (v.area == MacroStore::Area::number && v.number >= 1080 && v.number <= 1099);
}

std::optional<MacroStore::Variable> hash_variable(double number) {
  if (!(number >= 0 && number <= 31986) || number != std::floor(number)) return std::nullopt;
  const auto n = static_cast<std::uint32_t>(number);
  return MacroStore::Variable{n <= last_local ? MacroStore::Area::local : MacroStore::Area::number, n};
}

}  // namespace syntec
