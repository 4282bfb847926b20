// Listens to the traced chain. The document is shown as JSON before and after each build of the wanted line, and the
// difference of the two is what the syntax did; all other blocks cost nothing.
#include "isogloss/engine/explain.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "contract/flow_host.hpp"
#include "document/json_difference.hpp"
#include "isogloss/engine/document_json.hpp"
#include "run/cursor.hpp"
#include "run/explain_records.hpp"
#include "run/explain_rows.hpp"
#include "run/explain_uses.hpp"
#include "run/explain_values.hpp"
#include "run/explain_words.hpp"
#include "run/frame_history.hpp"

namespace isogloss {

namespace {

class Explainer : public Exporter {
 public:
  Explainer(const LinkedDialect& linked, const ExplainTarget& target, const std::vector<DependencyElement>& given)
      : linked_(linked), target_(target), rows_(linked, given), frames_(linked.layout) {
    auto summaries = std::make_shared<std::map<std::string, std::string, std::less<>>>();
    for (const LinkedSyntax& s : linked.chain)
      (*summaries)[s.element.alias] = s.syntax->summary != nullptr ? s.syntax->summary : "";
    summaries_ = std::move(summaries);
  }

  void listen(Chain& chain) {
    chain_ = &chain;
    origins_.emplace(linked_, chain);
    chain.listen_to_rows();
    chain.trace = [this](std::uint32_t position, bool before) { build(position, before); };
    chain.scanned = [this](std::uint32_t position, std::size_t begin, std::size_t end) { scan(position, begin, end); };
    chain.condition_examined = [this](const Document& document, std::string_view text, std::uint32_t outcome) {
      examine(document, text, outcome);
    };
    chain.variable_used = [this](const Document& document, bool is_write, std::string_view name, std::uint64_t scope,
                                 const ig_argument* value) { use(document, is_write, name, scope, value); };
  }

  void begin(Document&, const SymbolTable&) override {}
  bool end() override { return true; }

  bool block(Document& document, const SymbolTable& symbols) override {
    frames_.look(document, [&](std::string_view section) { return ValueOrigins::label(document, symbols, section); });
    if (!is_wanted(document)) return note(document), true;
    open(document, symbols);
    const auto at = std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.is_of(document.source); });
    Open done = std::move(*at);
    open_.erase(at);
    if (done.block.pass != target_.pass) return true;
    ExplainedBlock out = std::move(done.block);
    const Json shown = show_json(document, symbols);
    out.document = shown.dump(2, ' ', false, Json::error_handler_t::replace);
    for (const auto& [path, value] : json_leaves(shown))
      out.values.push_back(origins_->describe(document, path, value));
    out.words = done.words.words(out.text);
    out.ladder = origins_->ladder(document, symbols, frames_);
    out.summaries = summaries_;
    for (std::uint32_t p = 0; p < linked_.chain.size(); ++p) {
      const LinkedSyntax& s = linked_.chain[p];
      if (s.syntax->build != nullptr && !done.called[p]) out.slept.push_back({s.element.alias, wakes_on(*s.syntax)});
    }
    blocks.push_back(std::move(out));
    reach.is_cut = blocks.size() >= target_.most_blocks;
    return !reach.is_cut;
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
    std::uint32_t line, column;
    ExplainedBlock block;
    Leaves before;
    std::vector<bool> called;
    WordLog words;
    bool is_of(const BlockSource& source) const { return line == source.line && column == source.column; }
  };

  void scan(std::uint32_t position, std::size_t begin, std::size_t end) {
    if (scanned_block_ != chain_->blocks) {
      if (!is_wanted(chain_->document())) return;
      scanned_block_ = chain_->blocks;
      scanned_ = WordLog(linked_);
    }
    scanned_.scanned(position, begin, end);
  }

  void use(const Document& document, bool is_write, std::string_view name, std::uint64_t scope,
           const ig_argument* value) {
    if (is_wanted(document)) {
      uses_.begin(chain_->blocks);
      if (is_write)
        uses_.write(name, value);
      else
        uses_.read(*chain_, log_, name, scope, value);
      give_uses();
    }
    if (is_write) log_.write(document, name, scope, value);
  }

  void examine(const Document& document, std::string_view text, std::uint32_t outcome) {
    if (!is_wanted(document)) return;
    uses_.begin(chain_->blocks);
    uses_.examine(text, outcome);
    give_uses();
  }

  void give_uses() {
    for (Open& o : open_)
      if (o.number == chain_->blocks) uses_.give_to(o.block, o.number);
  }

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
    note_request(o);
    if (o.block.pass != target_.pass) return;
    const LinkedSyntax& s = linked_.chain[position];
    o.words.look(*document, static_cast<std::uint16_t>(position + 1));
    o.block.steps.push_back({s.element.alias, s.plugin->name, false, rows_.answers(*s.syntax),
                             rows_.since(*chain_, rows_before_),
                             changes_of(o.before, json_leaves(show_json(*document, chain_->symbols())))});
    if (ExplainedStep& step = o.block.steps.back(); !step.changes.empty())
      rows_.add_from_start(*chain_, static_cast<std::uint16_t>(position + 1), step.rows);
  }

  /// The record of this block; begun at its first build, when the scanners have just read it.
  Open& open(const Document& document, const SymbolTable& symbols) {
    const bool is_built = &document == &chain_->document();
    const BlockSource& source = document.source;
    for (Open& o : open_)
      if (o.is_of(source) && (!is_built || o.number == chain_->blocks)) return o;
    Passes& passes = passes_[source.line];
    if (passes.count == 0 || source.column <= passes.last_column) ++passes.count;
    passes.last_column = source.column;
    if (source.line <= target_.line) reach.passes = passes.count;
    const bool is_scanned = is_built && scanned_block_ == chain_->blocks;
    Open o{chain_->blocks,
           source.line,
           source.column,
           {},
           {},
           std::vector<bool>(linked_.chain.size()),
           is_scanned ? std::move(scanned_) : WordLog(linked_)};
    o.block.pass = passes.count;
    if (passes.count != target_.pass) {
      open_.push_back(std::move(o));
      return open_.back();
    }
    o.words.look(document, 0);
    if (is_built) uses_.give_to(o.block, o.number);
    o.block.frames = frames_of(*chain_->flow);
    o.block.where = {std::string(document.source.file), document.source.line, document.source.column + 1};
    o.block.text = std::string(document.source.text);
    std::map<std::uint16_t, ExplainedStep> scanned;
    for (const auto& [path, value] : json_leaves(show_json(document, symbols))) {
      const ig_field f = ValueOrigins::field_of(document, path);
      if (f == IG_NO_FIELD || document.fresh(f)) {
        const std::uint16_t writer = f == IG_NO_FIELD ? std::uint16_t{0} : document.writer(f);
        scanned[writer].changes.push_back({path, "", value});
      } else {
        o.block.carried.push_back(origins_->describe(document, path, value));
      }
    }
    for (const Chain::AnsweredRow& row : chain_->answered_rows) scanned.try_emplace(row.syntax);
    for (auto& [writer, step] : scanned) {
      step.is_scan = true;
      step.syntax = writer == 0 ? "(text)" : linked_.chain[writer - 1u].element.alias;
      if (writer != 0) step.plugin = linked_.chain[writer - 1u].plugin->name;
      if (writer != 0) step.rows = rows_.since(*chain_, 0, writer);
      o.block.steps.push_back(std::move(step));
    }
    note_request(o);
    open_.push_back(std::move(o));
    return open_.back();
  }

  /// A block that waits for those after it is built again when one of them may have asked for a jump of its own.
  void note_request(Open& o) const {
    if (o.number == chain_->blocks && o.block.go.kind == ExplainedGo::Kind::next)
      o.block.go = go_of(chain_->flow->requested());
  }

  bool is_wanted(const Document& document) const {
    const BlockSource& source = document.source;
    const std::uint32_t more = source.is_joined ? LinePlace::of(source.text, source.text.size()).line : 0;
    return source.line + more >= target_.line && source.line <= target_.last() && chain_->flow != nullptr &&
           chain_->flow->is_file(document.source.file, target_.file);
  }

  const LinkedDialect& linked_;
  const ExplainTarget& target_;
  ExplainedRows rows_;
  FrameHistory frames_;
  std::shared_ptr<const std::map<std::string, std::string, std::less<>>> summaries_;
  std::size_t rows_before_ = 0;
  struct Passes {
    std::uint64_t count = 0;
    std::uint32_t last_column = 0;
  };
  std::map<std::uint32_t, Passes> passes_;  // by line
  std::optional<ValueOrigins> origins_;
  VariableLog log_;
  WordLog scanned_{linked_};  // of the block that is being read
  BlockUses uses_;
  std::uint64_t scanned_block_ = 0;
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
  // The lines of a range run in any order, so that none of them is known to be the last one.
  if (target.last() == target.line) options.stop_after_line = target.line;
  options.stop_in_file = target.file;
  options.stop_after_pass = target.pass;
  options.prepare = [&](Chain& chain) { explainer.listen(chain); };
  run(linked, source, name, options, {&explainer}, sink);
  if (reach != nullptr) *reach = std::move(explainer.reach);
  return std::move(explainer.blocks);
}

}  // namespace isogloss
