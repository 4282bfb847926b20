#include "isogloss/engine/document_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "document/document_shape.hpp"
#include "export/text_buffer.hpp"

namespace isogloss {

namespace {

/// Builds the JSON; whole numbers become integers.
class JsonSink {
 public:
  explicit JsonSink(Json& root) : open_{&root} {}

  void begin(const std::string& key) { open_.push_back(&((*open_.back())[key] = Json::object())); }
  void begin_record() {
    open_.back()->push_back(Json::object());
    open_.push_back(&open_.back()->back());
  }
  void begin_list(const std::string& key) { open_.push_back(&((*open_.back())[key] = Json::array())); }
  void end() { open_.pop_back(); }
  void end_list() { open_.pop_back(); }

  static std::string key_of(const std::string& name) { return valid_utf8(name); }
  void number(const std::string& key, double value) { (*open_.back())[key] = number(value); }
  void integer(const std::string& key, std::int64_t value) { (*open_.back())[key] = value; }
  void boolean(const std::string& key, bool value) { (*open_.back())[key] = value; }
  void text(const std::string& key, std::string_view value) { (*open_.back())[key] = valid_utf8(value); }
  void item(const std::string& value) { open_.back()->push_back(valid_utf8(value)); }
  void item(double value) { open_.back()->push_back(number(value)); }

 private:
  static Json number(double value) {
    constexpr double largest_exact = 9007199254740992.0;
    if (value == std::trunc(value) && std::abs(value) <= largest_exact) return static_cast<std::int64_t>(value);
    return value;
  }
  std::vector<Json*> open_;
};

[[noreturn]] void wrong(const std::string& path, std::string_view expected, const Json& found) {
  throw std::runtime_error(path + ": " + std::string(expected) + " is expected, this is " + found.type_name());
}

/// A value of the field's type; not for words, codes, texts and transforms.
ig_value read_value(const Json& json, ig_type type, const std::string& path, SymbolTable& symbols) {
  ig_value v{};
  switch (type) {
    case IG_NUMBER:
      if (!json.is_number()) wrong(path, "a number", json);
      v.number = json.get<double>();
      break;
    case IG_INTEGER: {
      if (!json.is_number()) wrong(path, "a whole number", json);
      const double number = json.get<double>();
      if (number != std::trunc(number) || std::abs(number) > 9e18) wrong(path, "a whole number", json);
      v.integer = json.is_number_float() ? static_cast<std::int64_t>(number) : json.get<std::int64_t>();
      break;
    }
    case IG_BOOLEAN:
      if (!json.is_boolean()) wrong(path, "true or false", json);
      v.integer = json.get<bool>() ? 1 : 0;
      break;
    case IG_SYMBOL:
      if (!json.is_string()) wrong(path, "a name", json);
      v.symbol = symbols.intern(json.get_ref<const std::string&>());
      break;
    default: wrong(path, "nothing", json);
  }
  return v;
}

class Loader {
 public:
  Loader(Document& document, SymbolTable& symbols) : d_(document), layout_(document.layout()), symbols_(symbols) {}

  /// The parts that have no field.
  Json load(const Json& json) {
    if (!json.is_object()) wrong("the document", "an object", json);
    Json rest = Json::object();
    for (const auto& [key, value] : json.items()) {
      Json unknown;
      if (key == "Parsing")
        unknown = load_parsing(value);
      else if (key == "ProgramToMcTransform")
        unknown = load_transforms(value);
      else
        unknown = load_at(key, value);
      if (!unknown.is_null()) rest[key] = std::move(unknown);
    }
    return rest;
  }

 private:
  /// Null when everything has a field.
  Json load_at(const std::string& path, const Json& json) {
    if (const ig_field f = layout_.id(path); is_value(f)) {
      if (layout_.fields[f].type == IG_TEXT) {
        if (!json.is_string()) wrong(path, "a text", json);
        d_.set_text(f, json.get_ref<const std::string&>());
      } else {
        d_.set(f, read_value(json, layout_.fields[f].type, path, symbols_));
      }
      return {};
    }
    for (std::size_t i = 0; i < layout_.lists.size(); ++i)
      if (layout_.lists[i].path == path) return load_list(i, json);
    return json.is_object() ? load_members(path, json) : json;
  }

  Json load_members(const std::string& path, const Json& json) {
    if (json.empty()) return json;
    Json rest;
    for (const auto& [key, value] : json.items())
      if (Json unknown = load_at(path + '.' + key, value); !unknown.is_null()) rest[key] = std::move(unknown);
    return rest;
  }

  bool is_value(ig_field f) const {
    if (f == IG_NO_FIELD || layout_.fields[f].hidden) return false;
    const ig_type type = layout_.fields[f].type;
    return type != IG_CODE && type != IG_TRANSFORM && type != IG_SWITCH;
  }

  Json load_parsing(const Json& json) {
    if (!json.is_object()) wrong("Parsing", "an object", json);
    Json rest;
    for (const auto& [key, value] : json.items()) {
      const std::string path = "Parsing." + key;
      const ig_field owner = code(key);
      Json unknown;
      if (key == "Flags") {
        load_flags(value);
      } else if (value.is_object() && owner != IG_NO_FIELD) {
        set_code(owner);
        for (const auto& [letter, number] : value.items()) {
          if (is_value(layout_.id(path + '.' + letter)))
            load_word(path + '.' + letter, key + '.' + letter, number);
          else
            unknown[letter] = number;
        }
      } else if (value.is_object() || value.is_array()) {
        unknown = load_at(path, value);
      } else {
        load_word(path, key, value);
      }
      if (!unknown.is_null()) rest[key] = std::move(unknown);
    }
    return rest;
  }

  void load_flags(const Json& json) {
    if (!json.is_array()) wrong("Parsing.Flags", "a list", json);
    for (const Json& flag : json) {
      if (!flag.is_string()) wrong("Parsing.Flags", "a list of codes", flag);
      const auto& name = flag.get_ref<const std::string&>();
      if (const ig_field f = code(name); f != IG_NO_FIELD)
        set_code(f);
      else
        d_.leftovers.push_back({IG_LEFT_UNKNOWN, IG_NO_FIELD, d_.codes_seen, d_.codes_seen, name});
    }
  }

  /// A word's number or expression. `name`: what a leftover of it is called.
  void load_word(const std::string& path, const std::string& name, const Json& json) {
    const ig_field found = layout_.id(path);
    const ig_field f = is_value(found) ? found : IG_NO_FIELD;
    if (f != IG_NO_FIELD && !layout_.is_word(f)) {
      load_at(path, json);
    } else if (json.is_string()) {
      d_.leftovers.push_back({IG_LEFT_EXPRESSION, f, 0, 0, name, json.get<std::string>()});
    } else if (!json.is_number()) {
      wrong(path, "a number or an expression", json);
    } else if (f == IG_NO_FIELD) {
      d_.leftovers.push_back({IG_LEFT_WORD, f, 0, 0, name, json.dump()});
    } else {
      const auto flags = json.is_number_float() ? std::uint32_t{0} : std::uint32_t{IG_WORD_WITHOUT_POINT};
      d_.set_word({f, 0, 0, {.number = json.get<double>()}, flags, 0});
    }
  }

  /// A code that owns words, or one that does not; the document knows it as one of the two.
  ig_field code(const std::string& name) const {
    for (const std::string_view prefix : {parsing_prefix, flags_prefix}) {
      const ig_field f = layout_.id(std::string(prefix) + name);
      if (f != IG_NO_FIELD && layout_.fields[f].type == IG_CODE) return f;
    }
    return IG_NO_FIELD;
  }
  void set_code(ig_field f) { d_.set_word({f, 0, 0, {}, 0, 0}); }

  Json load_list(std::size_t index, const Json& json) {
    const ListInfo& info = layout_.lists[index];
    if (!json.is_array()) wrong(info.path, "a list", json);
    ListData list;
    list.stride = static_cast<std::uint32_t>(info.fields.size());
    for (const Json& record : json) {
      if (!list.has_room()) list.make_room();
      list.add(0);
      const std::string path = info.path + '[' + std::to_string(list.count - 1) + ']';
      if (!record.is_object()) wrong(path, "an object", record);
      if (!load_record(record, path, "", info, list)) return json;  // an unknown record passes through unchanged
    }
    d_.lists[index] = std::move(list);
    return {};
  }

  bool load_record(const Json& json, const std::string& path, const std::string& prefix, const ListInfo& info,
                   ListData& list) {
    for (const auto& [key, value] : json.items()) {
      const std::string name = prefix.empty() ? key : prefix + '.' + key;
      const auto field =
          std::find_if(info.fields.begin(), info.fields.end(), [&](const FieldInfo& f) { return f.path == name; });
      if (field != info.fields.end()) {
        const auto i = static_cast<std::size_t>(field - info.fields.begin());
        list.record(list.count - 1)[i] = read_value(value, field->type, path + '.' + name, symbols_);
        list.masks().back() |= std::uint64_t{1} << i;
      } else if (!value.is_object() || !load_record(value, path, name, info, list)) {
        return false;
      }
    }
    return true;
  }

  Json load_transforms(const Json& json) {
    if (!json.is_array()) wrong("ProgramToMcTransform", "a list", json);
    Json rest;
    for (const Json& entry : json) {
      const auto source = entry.find("Source");
      const auto matrix = entry.find("Mat4d");
      const ig_field f = entry.is_object() && source != entry.end() && source->is_string()
                             ? layout_.id("ProgramToMcTransform." + source->get<std::string>())
                             : IG_NO_FIELD;
      if (f == IG_NO_FIELD || layout_.fields[f].type != IG_TRANSFORM) {
        rest.push_back(entry);
        continue;
      }
      const std::string path = layout_.fields[f].path + ".Mat4d";
      if (matrix == entry.end() || !matrix->is_array() || matrix->size() != 16)
        throw std::runtime_error(path + ": a list of 16 numbers is expected");
      double m[16];
      for (std::size_t i = 0; i < 16; ++i) m[i] = read_value((*matrix)[i], IG_NUMBER, path, symbols_).number;
      const auto kind = entry.find("Kind");
      if (kind != entry.end() && *kind == "Dynamic")
        d_.move_frame(f, m);
      else
        d_.set_frame(f, Frame::from(m));
    }
    return rest;
  }

  Document& d_;
  const Layout& layout_;
  SymbolTable& symbols_;
};

}  // namespace

Json load_json(const Json& json, Document& document, SymbolTable& symbols) {
  const std::uint16_t writer = std::exchange(document.current, std::uint16_t{0});
  Json rest = Loader(document, symbols).load(json);
  document.current = writer;
  return rest;
}

Json show_json(const Document& document, const SymbolTable& symbols, const std::set<std::string>* sections) {
  Json root = Json::object();
  JsonSink sink(root);
  DocumentView(document.layout()).show(document, symbols, {.sections = sections}, sink);
  return root;
}

std::set<std::string> written_sections(const Document& document, std::uint16_t writer) {
  std::set<std::string> sections;
  const Layout& layout = document.layout();
  const auto section = [](const std::string& path) { return path.substr(0, path.find('.')); };
  for (ig_field f = 0; f < document.size(); ++f) {
    if (layout.fields[f].hidden || layout.fields[f].type == IG_SWITCH) continue;
    if (document.present(f) && document.writer(f) == writer) sections.insert(section(layout.fields[f].path));
  }
  for (std::size_t i = 0; i < document.lists.size(); ++i)
    if (document.lists[i].count != 0) sections.insert(section(layout.lists[i].path));
  for (const Leftover& left : document.leftovers)
    sections.insert(left.kind == IG_LEFT_TEXT || left.kind == IG_LEFT_STATEMENT ? "UnparsedText" : "Parsing");
  return sections;
}

}  // namespace isogloss
