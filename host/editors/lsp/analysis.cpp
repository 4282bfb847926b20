#include "lsp/analysis.hpp"

#include <chrono>
#include <set>
#include <stdexcept>
#include <tuple>
#include <unordered_map>

#include "isogloss/engine/exporter.hpp"

namespace isogloss::editors {

namespace {

constexpr std::size_t most_uses = 200'000;  // of variables, jumps and rows: what an editor shows of a program

/// Keeps the first diagnostics, and counts the others.
class BoundedList : public DiagnosticSink {
 public:
  BoundedList(Analysis& out, std::size_t most) : out_(out), most_(most) {}
  void add(Diagnostic diagnostic) override {
    if (out_.diagnostics.size() < most_)
      out_.diagnostics.push_back(std::move(diagnostic));
    else
      ++out_.unlisted;
  }

 private:
  Analysis& out_;
  std::size_t most_;
};

class Recorder : public Exporter {
 public:
  Recorder(const Setup& setup, const std::string& path, Analysis& out, std::function<bool()> goes_on)
      : path_(path), out_(out), layout_(setup.linked->layout), goes_on_(std::move(goes_on)) {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      axes_[i] = layout_.id(std::string("MachineCoordinate.") + "XYZABC"[i]);
    items_ = list_id("CompoundMotion.Items");
  }

  void listen(Chain& chain) {
    chain_ = &chain;
    chain.listen_to_rows();
    chain.variable_used = [this](const Document& d, bool is_write, std::string_view name, std::uint64_t scope,
                                 const ig_argument* value) { use(d, is_write, name, scope, value); };
  }

  void moved(const FlowStep& step) {
    if (out_.moves.size() >= most_uses) return;
    if (!moves_.emplace(std::string(step.file), step.line, std::string(step.to_file), step.to_line).second) return;
    out_.moves.push_back({step.kind, std::string(step.file), std::string(step.label), std::string(step.to_file),
                          step.line, step.column, step.to_line});
  }

  void begin(Document&, const SymbolTable&) override {}
  bool end() override { return true; }

  bool block(Document& d, const SymbolTable& symbols) override {
    constexpr std::uint64_t interval = 1024;
    if (++blocks_ % interval == 0 && !goes_on_()) return false;
    if (d.source.file != path_ || d.source.line == 0) return true;
    const std::uint32_t line = d.source.line;
    if (out_.lines.size() < line) out_.lines.resize(std::max<std::size_t>(line, out_.lines.size() * 3 / 2));
    LineFacts& facts = out_.lines[line - 1];
    if (facts.passes == 0) note_once(d, line);
    ++facts.passes;
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (d.present(axes_[i])) {
        facts.machine[i] = d.number(axes_[i]);
        facts.known |= 1u << i;
      }
    const bool moves_once = d.present(form_) && d.fresh(form_);
    facts.moves = moves_once || (items_ < d.lists.size() && d.lists[items_].count > 0);
    if (moves_once) {
      facts.is_rapid = d.present(rapid_) && d.fresh(rapid_) && d.value(rapid_).integer != 0;
      facts.feed_mm_min = d.present(feed_) && d.fresh(feed_) ? static_cast<float>(d.number(feed_) * 60) : 0;
    }
    facts.motion = name_of(d, motion_, symbols);
    facts.cycle = name_of(d, cycle_, symbols);
    return true;
  }

 private:
  std::size_t list_id(std::string_view path) const {
    for (std::size_t i = 0; i < layout_.lists.size(); ++i)
      if (layout_.lists[i].path == path) return i;
    return layout_.lists.size();
  }

  std::uint16_t name_of(const Document& d, ig_field f, const SymbolTable& symbols) {
    if (!d.present(f)) return 0;
    const ig_symbol symbol = d.value(f).symbol;
    const auto found = names_.find(symbol);
    if (found != names_.end()) return found->second;
    if (out_.names.size() > 60'000) return 0;
    const auto index = static_cast<std::uint16_t>(out_.names.size());
    out_.names.emplace_back(symbols.text(symbol));
    return names_[symbol] = index;
  }

  /// What the editor shows of a line however often it runs.
  void note_once(const Document& d, std::uint32_t line) {
    if (d.present(change_) && d.fresh(change_) && d.present(spindle_tool_))
      out_.tools.push_back({line, d.value(spindle_tool_).integer});
    for (const Chain::AnsweredRow& row : chain_->answered_rows)
      if (out_.rows.size() < most_uses) out_.rows.push_back({line, row.dependency, row.row});
  }

  void use(const Document& d, bool is_write, std::string_view name, std::uint64_t scope, const ig_argument* value) {
    if (out_.variables.size() >= most_uses) return;
    const auto key = std::tuple(d.source.line, is_write, std::hash<std::string_view>{}(name),
                                std::hash<std::string_view>{}(d.source.file));
    if (!uses_.insert(key).second) return;
    VariableUse out{std::string(name), std::string(d.source.file), scope, d.source.line, is_write, {}};
    if (value != nullptr && value->is_text != 0)
      out.value = std::string(value->text.data, value->text.size);
    else if (value != nullptr)
      out.value = Json(value->number).dump();
    out_.variables.push_back(std::move(out));
  }

  const std::string& path_;
  Analysis& out_;
  const Layout& layout_;
  std::function<bool()> goes_on_;
  std::uint64_t blocks_ = 0;
  std::array<ig_field, 6> axes_{};
  std::size_t items_ = 0;
  ig_field motion_ = layout_.id("MotionState.Term"), cycle_ = layout_.id("CannedCycle.Term"),
           form_ = layout_.id("MotionEvent.Form"), rapid_ = layout_.id("MotionEvent.IsRapid"),
           feed_ = layout_.id("MotionEvent.Feedrate_mmds"), change_ = layout_.id("ToolChange.IsChange"),
           spindle_tool_ = layout_.id("ToolChange.SpindleToolId");
  Chain* chain_ = nullptr;
  std::unordered_map<ig_symbol, std::uint16_t> names_;
  std::set<std::tuple<std::string, std::uint32_t, std::string, std::uint32_t>> moves_;
  std::set<std::tuple<std::uint32_t, bool, std::size_t, std::size_t>> uses_;
};

}  // namespace

Analysis analyse(const Setup& setup, const std::string& path, const std::string& text, const Settings& settings,
                 const std::function<bool()>& goes_on) {
  using Clock = std::chrono::steady_clock;
  Analysis out;
  BoundedList sink(out, settings.most_diagnostics);
  const Clock::time_point last = Clock::now() + std::chrono::milliseconds(settings.budget_ms);
  const auto has_time = [&] {
    out.is_interrupted = out.is_interrupted || !goes_on();
    out.is_cut = out.is_cut || Clock::now() > last;
    return !out.is_interrupted && !out.is_cut;
  };
  Recorder recorder(setup, path, out, has_time);
  RunOptions options = setup.options;
  options.prepare = [&](Chain& chain) { recorder.listen(chain); };
  options.moved = [&](const FlowStep& step) { recorder.moved(step); };
  options.goes_on = has_time;
  const std::unique_ptr<Source> source = memory_source(text);
  try {
    run(*setup.linked, *source, path, options, {&recorder}, sink);
  } catch (const std::runtime_error& e) {
    if (out.diagnostics.empty()) out.diagnostics.push_back(host_diagnostic("IG-0660", {path, 1, 1}, {e.what()}));
  }
  if (out.unlisted > 0)
    out.diagnostics.push_back(host_diagnostic("IG-0662", {path, 1, 1}, {std::to_string(out.unlisted)}));
  if (out.is_cut)
    out.diagnostics.push_back(
        host_diagnostic("IG-0661", {path, 1, 1}, {std::to_string(settings.budget_ms)}, "raise isogloss.budgetMs"));
  return out;
}

}  // namespace isogloss::editors
