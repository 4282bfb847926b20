#include "lsp/settings.hpp"

namespace isogloss::editors {

namespace {

class SettingsReader {
 public:
  SettingsReader(const Json& json, std::vector<std::string>& faults) : json_(json), faults_(faults) {}

  void read(const char* key, std::string& out) {
    if (const Json* const value = find(key)) value->is_string() ? void(out = *value) : fault(key, "a text");
  }
  void read(const char* key, bool& out) {
    if (const Json* const value = find(key)) value->is_boolean() ? void(out = *value) : fault(key, "true or false");
  }
  void read(const char* key, std::uint32_t& out, std::uint32_t minimum, std::uint32_t maximum) {
    const Json* const value = find(key);
    if (value == nullptr) return;
    if (value->is_number_integer() && *value >= minimum && *value <= maximum)
      out = *value;
    else
      fault(key, "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum));
  }
  void read(const char* key, std::vector<std::string>& out) {
    const Json* const value = find(key);
    if (value == nullptr) return;
    std::vector<std::string> texts;
    if (!value->is_array()) return fault(key, "a list of texts");
    for (const Json& one : *value) {
      if (!one.is_string()) return fault(key, "a list of texts");
      texts.push_back(one);
    }
    out = std::move(texts);
  }
  Json section(const char* key) {
    const Json* const value = find(key);
    if (value == nullptr) return Json::object();
    if (value->is_object()) return *value;
    fault(key, "an object");
    return Json::object();
  }

 private:
  const Json* find(const char* key) const {
    if (!json_.is_object()) return nullptr;
    const auto at = json_.find(key);
    return at == json_.end() || at->is_null() ? nullptr : &*at;
  }
  void fault(const char* key, const std::string& wanted) {
    faults_.push_back(std::string("The setting '") + key + "' must be " + wanted + ": it is ignored.");
  }
  const Json& json_;
  std::vector<std::string>& faults_;
};

}  // namespace

Settings with(Settings s, const Json& json, std::vector<std::string>& faults) {
  if (json.is_null()) return s;
  if (!json.is_object()) faults.emplace_back("The settings must be an object: they are ignored.");
  SettingsReader reader(json, faults);
  reader.read("dialect", s.dialect);
  reader.read("machine", s.machine);
  reader.read("offsets", s.offsets);
  reader.read("tools", s.tools);
  reader.read("variables", s.variables);
  reader.read("blockSkip", s.block_skip);
  reader.read("program", s.program);
  reader.read("set", s.set);
  reader.read("subprograms", s.subprograms);
  reader.read("optionalStop", s.optional_stop);
  reader.read("budgetMs", s.budget_ms, 50, 60'000);
  reader.read("maxDiagnostics", s.most_diagnostics, 1, 100'000);
  const Json hints = reader.section("inlayHints");
  SettingsReader of_hints(hints, faults);
  of_hints.read("machine", s.shows_machine);
  of_hints.read("modal", s.shows_modal);
  const Json format = reader.section("format");
  SettingsReader of_format(format, faults);
  of_format.read("blanks", s.formats_words);
  of_format.read("blockNumbers", s.formats_numbers);
  of_format.read("step", s.number_step, 1, 1000);
  return s;
}

}  // namespace isogloss::editors
