// Listens to the traced chain. The document is shown as JSON before and after each build of the wanted line, and the
// difference of the two is what the syntax did; all other blocks cost nothing.
#include "isogloss/engine/explain.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "contract/flow_host.hpp"
#include "dialect/row_checks.hpp"
#include "document/json_difference.hpp"
#include "isogloss/engine/document_json.hpp"
#include "run/cursor.hpp"

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
  Explainer(const LinkedDialect& linked, const ExplainTarget& target, const std::vector<DependencyElement>& given)
      : linked_(linked), target_(target), given_(given) {}

  void listen(Chain& chain) {
    chain_ = &chain;
    chain.listen_to_rows();
    chain.trace = [this](std::uint32_t position, bool before) { build(position, before); };
  }

  void begin(Document&, const SymbolTable&) override {}
  bool end() override { return true; }

  bool block(Document& document, const SymbolTable& symbols) override {
    if (!is_wanted(document)) return note(document), true;
    open(document, symbols);
    const auto at =
        std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.column == document.source.column; });
    Open done = std::move(*at);
    open_.erase(at);
    if (done.block.pass != target_.pass) return true;
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
  ExplainReach reach;

 private:
  /// Follows the run while it is elsewhere.
  void note(const Document& document) {
    const BlockSource& source = document.source;
    reach.last = {std::string(source.file), source.line, source.column + 1};
    reach.last_text = std::string(source.text);
    if (chain_->flow == nullptr || !chain_->flow->is_file(source.file, target_.file)) return;
    if (reach.first == 0) reach.first = source.line;
    if (reach.jumped_to == 0 && before_ != 0 && before_ < target_.line && source.line > target_.line) {
      reach.jumped_from = before_;
      reach.jumped_to = source.line;
    }
    before_ = source.line;
  }

  /// A block of the line on its way through the chain. With look-ahead its document is copied while the next one is
  /// built; those that wait come out in their order.
  struct Open {
    std::uint64_t number;  // of the block in the run
    std::uint32_t column;
    ExplainedBlock block;
    Leaves before;
    std::vector<bool> called;
  };

  void build(std::uint32_t position, bool before) {
    const Document* const document = Chain::breadcrumb().document;
    if (document == nullptr || !is_wanted(*document)) return;
    Open& o = open(*document, chain_->symbols());
    if (before && o.block.pass != target_.pass) return;
    if (before) {
      rows_before_ = chain_->answered_rows.size();
      o.before = json_leaves(show_json(*document, chain_->symbols()));
      return;
    }
    o.called[position] = true;
    note_call(o.block);
    if (o.block.pass != target_.pass) return;
    const LinkedSyntax& s = linked_.chain[position];
    o.block.steps.push_back({s.element.alias, s.plugin->name, answers(s), rows_from(rows_before_, std::nullopt),
                             changes(o.before, json_leaves(show_json(*document, chain_->symbols())))});
    if (ExplainedStep& step = o.block.steps.back(); !step.changes.empty())
      add_rows_at_start(step.rows, static_cast<std::uint16_t>(position + 1));
  }

  std::vector<ExplainedAnswer> answers(const LinkedSyntax& s) const {
    std::vector<ExplainedAnswer> out;
    for (std::uint32_t i = 0; i < s.syntax->service_count; ++i)
      for (const Provision& p : provisions_)
        if (p.service == s.syntax->services[i].id)
          out.push_back({p.service, linked_.dependencies[p.dependencies.front()].element.alias});
    return out;
  }

  /// The rows that have answered since there were `first` of them; only those that this syntax has asked.
  std::vector<ExplainedRow> rows_from(std::size_t first, std::optional<std::uint16_t> syntax) const {
    std::vector<ExplainedRow> out;
    for (std::size_t i = first; i < chain_->answered_rows.size(); ++i) {
      const Chain::AnsweredRow& row = chain_->answered_rows[i];
      if (syntax && row.syntax != *syntax) continue;
      const LinkedDependency& dependency = linked_.dependencies[row.dependency];
      ExplainedRow one{dependency.element.alias, row.row, place_of(dependency, row.row)};
      if (std::find(out.begin(), out.end(), one) == out.end()) out.push_back(std::move(one));
    }
    return out;
  }

  /// The rows that have answered the syntax when the chain was created: their values hold in each block. A row of the
  /// table itself, as of a dialect without a machine, tells nothing.
  void add_rows_at_start(std::vector<ExplainedRow>& rows, std::uint16_t syntax) const {
    for (const Chain::AnsweredRow& row : chain_->rows_at_start) {
      if (row.syntax != syntax) continue;
      const LinkedDependency& dependency = linked_.dependencies[row.dependency];
      ExplainedRow one{dependency.element.alias, row.row, place_of(dependency, row.row)};
      if (one.where.file.empty() || std::find(rows.begin(), rows.end(), one) != rows.end()) continue;
      rows.push_back(std::move(one));
    }
  }

  /// Where the row stands: in a file of this run, or in the dialect or machine.
  Location place_of(const LinkedDependency& dependency, const std::string& row) const {
    Location out;
    const auto look = [&](const DependencyElement& element) {
      for (const TableRow& one : element.rows)
        if (key_of(*dependency.dependency, one) == row) out = one.where;
    };
    look(dependency.element);
    for (const DependencyElement& given : given_)
      if (given.alias == dependency.element.alias) look(given);
    return out;
  }

  /// The record of this block; begun at its first build, when the scanners have just read it.
  Open& open(const Document& document, const SymbolTable& symbols) {
    const bool is_built = &document == &chain_->document();
    for (Open& o : open_)
      if (o.column == document.source.column && (!is_built || o.number == chain_->blocks)) return o;
    if (reach.passes == 0 || document.source.column <= last_column_) ++reach.passes;
    last_column_ = document.source.column;
    Open o{chain_->blocks, document.source.column, {}, {}, std::vector<bool>(linked_.chain.size())};
    o.block.pass = reach.passes;
    if (reach.passes != target_.pass) {
      open_.push_back(std::move(o));
      return open_.back();
    }
    add_frames(o.block);
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
    for (const Chain::AnsweredRow& row : chain_->answered_rows) scanned.try_emplace(row.syntax);
    for (auto& [writer, step] : scanned) {
      step.syntax = writer == 0 ? "(text)" : linked_.chain[writer - 1u].element.alias;
      if (writer != 0) step.plugin = linked_.chain[writer - 1u].plugin->name;
      if (writer != 0) step.rows = rows_from(0, writer);
      o.block.steps.push_back(std::move(step));
    }
    note_call(o.block);
    open_.push_back(std::move(o));
    return open_.back();
  }

  void note_call(ExplainedBlock& block) const {
    if (const FlowHost::Call call = chain_->flow->requested_call(); block.calls.empty() && !call.file.empty()) {
      block.calls = call.program;
      block.callee = {call.file, call.line, 1};
    }
  }

  bool is_wanted(const Document& document) const {
    const BlockSource& source = document.source;
    const std::uint32_t more = source.is_joined ? LinePlace::of(source.text, source.text.size()).line : 0;
    return target_.line - source.line <= more && chain_->flow != nullptr &&
           chain_->flow->is_file(document.source.file, target_.file);
  }

  void add_frames(ExplainedBlock& block) const {
    ig_frame f{};
    f.struct_size = sizeof f;
    for (std::uint32_t level = 0; chain_->flow->frame(level, f); ++level)
      block.frames.push_back({std::string(f.file.data, f.file.size), std::string(f.program.data, f.program.size),
                              f.call_line, f.pass, f.passes});
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
  const ExplainTarget& target_;
  const std::vector<DependencyElement>& given_;  // tables of this run
  std::size_t rows_before_ = 0;
  const std::vector<Provision> provisions_ = provisions(linked_);
  std::uint32_t last_column_ = 0;
  std::uint32_t before_ = 0;  // the last line of the target's file that was run
  Chain* chain_ = nullptr;
  std::vector<Open> open_;
};

}  // namespace

std::vector<ExplainedBlock> explain(const LinkedDialect& linked, Source& source, const std::string& name,
                                    const ExplainTarget& target, RunOptions options, DiagnosticSink& sink,
                                    ExplainReach* reach) {
  const std::vector<DependencyElement> given = options.chain.dependencies;
  Explainer explainer(linked, target, given);
  options.chain.mode = Mode::traced;
  options.chain.hears_rows = true;
  options.stop_after_line = target.line;
  options.stop_in_file = target.file;
  options.stop_after_pass = target.pass;
  options.prepare = [&](Chain& chain) { explainer.listen(chain); };
  run(linked, source, name, options, {&explainer}, sink);
  if (reach != nullptr) *reach = std::move(explainer.reach);
  return std::move(explainer.blocks);
}

}  // namespace isogloss
