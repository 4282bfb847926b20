// Finds the option or operand at the cursor. What parses command lines accepts whole ones only, so this reads them
// anew.
#include "completion/completion.hpp"

#include <algorithm>

namespace isogloss::cli {

namespace {

const UsageItem* find_option(const Usage& usage, std::string_view name) {
  for (const UsageItem& option : usage.options)
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
  return nullptr;
}

/// The options that stand before the name of a command, in the form of the others.
Usage usage_of_isogloss() {
  Usage out;
  for (const CommonOption& o : common_options) {
    UsageItem item;
    item.names.emplace_back(o.name);
    item.value = o.value;
    item.description = o.summary;
    item.is_repeatable = !o.value.empty();
    out.options.push_back(std::move(item));
  }
  return out;
}

void keep(const UsageItem& option, const std::string& value, TypedLine& line) {
  const std::string& name = option.names.back();
  if (name == "--plugins")
    line.places.plugins.push_back(value);
  else if (name == "--dialects")
    line.places.dialects.push_back(value);
  else if (name == "--machines")
    line.places.machines.push_back(value);
  else if (name == "--dialect")
    line.dialect = value;
  else if (name == "--machine")
    line.machine = value;
  else if (name == "--format")
    line.format = value;
}

}  // namespace

Usage usage_of(const Command& command) {
  Usage out;
  Arguments question;
  question.describe = &out;
  command.run(question);
  return out;
}

void read_typed(const std::vector<std::string>& words, TypedLine& line) {
  line.usage = usage_of_isogloss();
  line.word = words.empty() ? "" : words.back();
  std::size_t operands = 0;
  bool options_ended = false;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const bool is_last = at + 1 == words.size();
    const std::string& word = words[at];
    if (!options_ended && word == "--" && !is_last) {
      options_ended = true;
    } else if (!options_ended && word.starts_with('-') && (word.size() > 1 || is_last)) {
      const std::size_t equals = word.find('=');
      const UsageItem* const option = find_option(line.usage, word.substr(0, equals));
      if (option == nullptr) continue;
      if (equals != std::string::npos) {
        if (is_last) line.item = option;
        if (is_last) line.word = word.substr(equals + 1);
        keep(*option, word.substr(equals + 1), line);
      } else if (!option->value.empty() && !is_last) {
        ++at;
        if (at + 1 == words.size()) line.item = option;
        keep(*option, words[at], line);
      }
      if (!is_last) line.given.push_back(option);
    } else if (line.command == nullptr) {
      if (is_last) return;
      line.command =
          std::find_if(std::begin(commands), std::end(commands), [&](const Command& c) { return c.name == word; });
      if (line.command == std::end(commands)) {
        line.usage = {};
        line.command = nullptr;
        return;
      }
      line.usage = usage_of(*line.command);
      line.given.clear();
    } else {
      const std::vector<UsageItem>& all = line.usage.operands;
      if (is_last && operands < all.size()) line.item = &all[operands];
      if (!is_last && line.operand.empty()) line.operand = word;
      if (operands < all.size() && !all[operands].is_repeatable) ++operands;
    }
  }
}

std::vector<Completion> words_of(const TypedLine& line) {
  std::vector<Completion> out;
  const bool is_option = line.item == nullptr && line.word.starts_with('-');
  if (line.item != nullptr)
    for (const std::string& word : line.item->words) out.push_back({.text = word, .description = {}});
  else if (line.command == nullptr && !is_option && !line.usage.options.empty())
    for (const Command& c : commands)
      if (!c.is_hidden) out.push_back({std::string(c.name), std::string(c.summary)});
  // Where no operand fits, an option is what can follow.
  if (!is_option && (line.item != nullptr || line.command == nullptr)) return out;
  for (const UsageItem& option : line.usage.options) {
    if (!option.is_repeatable && std::find(line.given.begin(), line.given.end(), &option) != line.given.end()) continue;
    for (const std::string& name : option.names)
      if (is_option || &name == &option.names.back()) out.push_back({name, option.description});
  }
  return out;
}

}  // namespace isogloss::cli
