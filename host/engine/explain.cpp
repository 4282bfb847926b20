// Listens to the traced chain. The document is shown as JSON before and after each build of the wanted line, and the
// difference of the two is what the syntax did; all other blocks cost nothing.
#include "isogloss/engine/explain.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "isogloss/engine/document_json.hpp"
#include "json_difference.hpp"

namespace isogloss {

namespace {

using Leaves = std::vector<std::pair<std::string, std::string>>;

std::vector<ExplainedChange> changes(const Leaves& before, const Leaves& after) {
  std::vector<ExplainedChange> out;
  std::map<std::string_view, std::string_view> old(before.begin(), before.end());
  for (const auto& [path, value] : after) {
    const auto was = old.find(path);
    if (was == old.end())
      out.push_back({path, "", value});
    else if (was->second != value)
      out.push_back({path, std::string(was->second), value});
    if (was != old.end()) old.erase(was);
  }
  for (const auto& [path, value] : before)
    if (old.contains(path)) out.push_back({path, value, ""});
  return out;
}

class Explainer : public Exporter {
 public:
  Explainer(const LinkedDialect& linked, std::uint32_t line) : linked_(linked), line_(line) {}

  void listen(Chain& chain) {
    chain_ = &chain;
    chain.trace = [this](std::uint32_t position, bool before) { build(position, before); };
  }

  void begin(Document&, const SymbolTable&) override {}
  bool end() override { return true; }

  bool block(Document& document, const SymbolTable& symbols) override {
    if (document.source.line != line_) return true;
    open(document, symbols);
    const auto at =
        std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.column == document.source.column; });
    Open done = std::move(*at);
    open_.erase(at);
    ExplainedBlock out = std::move(done.block);
    const Json shown = show_json(document, symbols);
    out.document = shown.dump(2, ' ', false, Json::error_handler_t::replace);
    for (const auto& [path, value] : json_leaves(shown)) out.values.push_back(describe(document, path, value));
    for (std::uint32_t p = 0; p < linked_.chain.size(); ++p) {
      const LinkedSyntax& s = linked_.chain[p];
      if (s.syntax->build != nullptr && !done.called[p]) out.slept.push_back({s.element.alias, wakes_on(s)});
    }
    blocks.push_back(std::move(out));
    return true;
  }

  std::vector<ExplainedBlock> blocks;

 private:
  /// A block of the line on its way through the chain. With look-ahead its document is copied, so that the place is
  /// what tells one from another.
  struct Open {
    std::uint32_t column;
    ExplainedBlock block;
    Leaves before;
    std::vector<bool> called;
  };

  void build(std::uint32_t position, bool before) {
    const Document* const document = Chain::breadcrumb().document;
    if (document == nullptr || document->source.line != line_) return;
    Open& o = open(*document, chain_->symbols());
    if (before) {
      o.before = json_leaves(show_json(*document, chain_->symbols()));
      return;
    }
    o.called[position] = true;
    const LinkedSyntax& s = linked_.chain[position];
    o.block.steps.push_back(
        {s.element.alias, s.plugin->name, changes(o.before, json_leaves(show_json(*document, chain_->symbols())))});
  }

  /// The record of this block; begun at its first build, when the scanners have just read it.
  Open& open(const Document& document, const SymbolTable& symbols) {
    for (Open& o : open_)
      if (o.column == document.source.column) return o;
    Open o{document.source.column, {}, {}, std::vector<bool>(linked_.chain.size())};
    o.block.where = {std::string(document.source.file), document.source.line, document.source.column + 1};
    o.block.text = std::string(document.source.text);
    std::map<std::uint16_t, ExplainedStep> scanned;
    for (const auto& [path, value] : json_leaves(show_json(document, symbols))) {
      const ig_field f = field_of(document, path);
      if (f == IG_NO_FIELD || document.fresh(f)) {
        const std::uint16_t writer = f == IG_NO_FIELD ? std::uint16_t{0} : document.writer(f);
        scanned[writer].changes.push_back({path, "", value});
      } else {
        o.block.carried.push_back(describe(document, path, value));
      }
    }
    for (auto& [writer, step] : scanned) {
      step.syntax = writer == 0 ? "(text)" : linked_.chain[writer - 1u].element.alias;
      if (writer != 0) step.plugin = linked_.chain[writer - 1u].plugin->name;
      o.block.steps.push_back(std::move(step));
    }
    open_.push_back(std::move(o));
    return open_.back();
  }

  /// The field behind a path of the JSON view: a list of codes stands for its first code, a transform for its entry.
  static ig_field field_of(const Document& document, const std::string& path) {
    const Layout& layout = document.layout();
    if (const auto f = layout.find(path)) return *f;
    const std::size_t bracket = path.find('[');
    if (bracket != std::string::npos) {
      const std::size_t close = path.find(']', bracket);
      return layout.id(path.substr(0, bracket) + "." + path.substr(bracket + 1, close - bracket - 1));
    }
    for (ig_field f = 0; f < document.size(); ++f)
      if (document.present(f) && layout.fields[f].type == IG_CODE && layout.fields[f].path.starts_with(path + "."))
        return f;
    return IG_NO_FIELD;
  }

  ExplainedValue describe(const Document& document, const std::string& path, const std::string& value) const {
    const ig_field f = field_of(document, path);
    ExplainedValue out{path, value, "", 0};
    if (f == IG_NO_FIELD) return out;
    const std::uint16_t writer = document.writer(f);
    if (writer != 0 && writer <= linked_.chain.size()) out.writer = linked_.chain[writer - 1u].element.alias;
    if (f < document.set_line.size()) out.line = document.set_line[f];
    return out;
  }

  static std::string wakes_on(const LinkedSyntax& s) {
    std::string out;
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field_decl& d = s.syntax->fields[i];
      if ((d.access & (IG_WAKE | IG_WAKE_WHILE)) == 0) continue;
      if (!out.empty()) out += ", ";
      out += d.path;
      if ((d.access & IG_WAKE_WHILE) != 0 && d.wake_value != nullptr) out += std::string("=") + d.wake_value;
    }
    return out;
  }

  const LinkedDialect& linked_;
  std::uint32_t line_;
  Chain* chain_ = nullptr;
  std::vector<Open> open_;
};

}  // namespace

std::vector<ExplainedBlock> explain(const LinkedDialect& linked, Source& source, const std::string& name,
                                    std::uint32_t line, RunOptions options, DiagnosticSink& sink) {
  Explainer explainer(linked, line);
  options.chain.mode = Mode::traced;
  options.stop_after_line = line;
  options.prepare = [&](Chain& chain) { explainer.listen(chain); };
  run(linked, source, name, options, {&explainer}, sink);
  return std::move(explainer.blocks);
}

}  // namespace isogloss
