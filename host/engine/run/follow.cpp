#include "isogloss/engine/follow.hpp"

#include <nlohmann/json.hpp>

#include "run/explain_values.hpp"

namespace isogloss {

namespace {

class Follower : public Exporter {
 public:
  Follower(const LinkedDialect& linked, const std::vector<ig_field>& fields,
           const std::function<bool(const FollowedChange&)>& told)
      : linked_(linked), told_(told) {
    for (const ig_field f : fields) followed_.push_back({f, false, {}, {}, {}});
  }

  void begin(Document& initial, const SymbolTable& symbols) override { look(initial, symbols); }
  bool block(Document& document, const SymbolTable& symbols) override { return look(document, symbols); }
  bool end() override { return true; }

 private:
  struct Followed {
    ig_field field;
    bool is_present;
    ig_value value;
    std::array<double, 16> matrix;
    std::string text;  // JSON
  };

  bool look(const Document& d, const SymbolTable& symbols) {
    for (Followed& f : followed_)
      if (has_changed(d, f) && !tell(d, symbols, f)) return false;
    return true;
  }

  bool has_changed(const Document& d, const Followed& f) const {
    const FieldInfo& info = linked_.layout.fields[f.field];
    const bool is_present = d.present(f.field);
    if (!is_carried(info.life) && info.type != IG_TRANSFORM) return is_present;
    if (is_present != f.is_present) return true;
    if (!is_present) return false;
    if (info.type == IG_TRANSFORM) return !d.frame(f.field).is_same(f.matrix.data());
    return info.type == IG_TEXT || d.value(f.field).integer != f.value.integer;
  }

  bool tell(const Document& d, const SymbolTable& symbols, Followed& f) {
    const FieldInfo& info = linked_.layout.fields[f.field];
    const bool is_kept = is_carried(info.life) || info.type == IG_TRANSFORM;
    FollowedChange change{
        d.source.file, d.source.line, d.source.text, info.path, is_kept ? f.text : std::string(), "", ""};
    f.is_present = d.present(f.field);
    if (f.is_present) {
      f.value = d.value(f.field);
      if (info.type == IG_TRANSFORM)
        std::copy(std::begin(d.frame(f.field).matrix), std::end(d.frame(f.field).matrix), f.matrix.begin());
      if (const std::uint16_t writer = d.writer(f.field); writer != 0 && writer <= linked_.chain.size())
        change.writer = linked_.chain[writer - 1u].element.alias;
      change.after = shown(d, symbols, f, info.type);
    }
    const bool is_repeated = is_kept && change.after == f.text;
    f.text = change.after;
    return is_repeated || told_(change);
  }

  static std::string shown(const Document& d, const SymbolTable& symbols, const Followed& f, ig_type type) {
    const auto quoted = [](std::string_view text) {
      return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    };
    switch (type) {
      case IG_NUMBER: return number_text(f.value.number);
      case IG_INTEGER: return std::to_string(f.value.integer);
      case IG_BOOLEAN: return f.value.integer != 0 ? "true" : "false";
      case IG_SYMBOL: return quoted(symbols.text(static_cast<ig_symbol>(f.value.symbol)));
      case IG_TEXT: return quoted(d.text(f.field));
      default: return nlohmann::json(f.matrix).dump();
    }
  }

  const LinkedDialect& linked_;
  const std::function<bool(const FollowedChange&)>& told_;
  std::vector<Followed> followed_;
};

}  // namespace

std::vector<ig_field> fields_to_follow(const Layout& layout, std::string_view path) {
  std::vector<ig_field> out;
  for (ig_field f = 0; f < layout.fields.size(); ++f) {
    const FieldInfo& info = layout.fields[f];
    const bool is_below =
        info.path.starts_with(path) && (info.path.size() == path.size() || info.path[path.size()] == '.');
    const bool is_value = info.type != IG_CODE && info.type != IG_SWITCH && info.life != IG_LIFE_WORD;
    if (is_below && is_value && !info.hidden) out.push_back(f);
  }
  return out;
}

RunResult follow(const LinkedDialect& linked, Source& source, const std::string& name,
                 const std::vector<ig_field>& fields, const std::function<bool(const FollowedChange&)>& told,
                 const RunOptions& options, DiagnosticSink& sink) {
  Follower follower(linked, fields, told);
  return run(linked, source, name, options, {&follower}, sink);
}

}  // namespace isogloss
