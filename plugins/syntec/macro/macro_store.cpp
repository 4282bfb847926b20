/// Levels of macro calls with their local variables, and the variables that all programs share.
#include "macro/macro_store.hpp"

#include <algorithm>
#include <cmath>

namespace syntec {

const MacroValue* Arguments::find(std::string_view name) const {
  if (name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z') return &letters[static_cast<std::size_t>(name[0] - 'A')];
  const auto found = named.find(name);
  return found != named.end() ? &found->second : nullptr;
}

void Arguments::set(std::string_view name, MacroValue value) {
  if (name.size() == 1) {
    letters[static_cast<std::size_t>(name[0] - 'A')] = std::move(value);
    return;
  }
  named.insert_or_assign(std::string(name), std::move(value));
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

/// What G66 keeps ends with the program in which it stands.
void MacroStore::drop_modals(Level& level) {
  for (const ModalCall& call : level.modal) drop_modal(call.tag);
  level.modal.clear();
}

void MacroStore::leave_last() {
  while (levels_.size() > present_ + 1) {
    drop_modals(levels_.back());
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

void MacroStore::offer(Arguments arguments, std::uint64_t frame, std::uint32_t line) {
  frame_ = no_frame;
  offer_ = {std::move(arguments), frame, line};
}

void MacroStore::offer_modal(Arguments arguments, std::uint64_t frame) {
  frame_ = no_frame;
  enter_modal(std::move(arguments));
  parked_.back().is_offered = true;
  parked_.back().offered_in = frame;
}

void MacroStore::end_offer() {
  const auto last = std::find_if(parked_.rbegin(), parked_.rend(), [](const Level& level) { return level.is_offered; });
  if (last != parked_.rend()) parked_.erase(std::next(last).base());
}

bool MacroStore::is_foreign(std::uint64_t tag) const {
  return tag != 0 && (tag & own_call) == 0 &&
         std::none_of(levels_.begin(), levels_.end(), [&](const Level& level) { return level.tag == tag; });
}

void MacroStore::enter_foreign(std::span<const ig_frame> callers, std::uint32_t call_line) {
  const auto is_called = [&](const Level& level) {
    return std::any_of(callers.begin(), callers.end(), [&](const ig_frame& f) { return f.tag == level.tag; });
  };
  while (present_ > 0 && !is_called(levels_[present_])) --present_;
  leave_last();
  const bool is_of_block =
      !callers.empty() && offer_.line != 0 && offer_.frame == callers.back().id && offer_.line == call_line;
  if (!is_of_block) offer_ = {};
  std::erase_if(parked_, [&](const Level& level) {
    return level.is_offered &&
           std::none_of(callers.begin(), callers.end(), [&](const ig_frame& f) { return f.id == level.offered_in; });
  });
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
      const bool is_modal = (tag & own_call) == 0 && offer_.line == 0;
      const auto parked = std::find_if(parked_.rbegin(), parked_.rend(),
                                       [&](const Level& l) { return l.tag == tag || (is_modal && l.is_offered); });
      if (parked != parked_.rend()) {
        levels_.push_back(std::move(*parked));
        levels_.back().tag = tag;
        parked_.erase(std::next(parked).base());
      } else {
        levels_.push_back(make(tag, std::exchange(offer_, {}).arguments, Caller::program));
      }
      ++present_;
    }
    leave_last();
  }
  Level& level = levels_[present_];
  if (level.pass != pass && tag != 0) {
    level.pass = pass;
    drop_modals(level);
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
