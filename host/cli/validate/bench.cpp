// One syntax of a chain at work on one block.
#include <algorithm>
#include <ctime>

#include "validate/subject.hpp"

namespace isogloss::cli {

std::string Trial::fault(bool reported_only) const {
  for (const Diagnostic& d : diagnostics) {
    if (d.code == "IG-0350") return d.message + " [" + d.code + "]";
    // A build may fail over a value that is no everyday one, as long as it says why.
    const bool has_reason = d.message.find("gives no reason") == std::string::npos;
    if (d.code == "IG-0401" && !(reported_only && has_reason)) return d.message + " [" + d.code + "]";
    if (d.code == "IG-0402" && !reported_only) return d.message + " [" + d.code + "]";
  }
  if (reported_only) return {};
  if (status != IG_UNCHANGED && status != IG_CHANGED && status != IG_FAILED)
    return "its build() returned the status " + std::to_string(status);
  if (status == IG_UNCHANGED && has_changed) return "its build() says unchanged, but the block changed";
  return {};
}

double thread_seconds() {
  timespec out{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &out);
  return static_cast<double>(out.tv_sec) + static_cast<double>(out.tv_nsec) * 1e-9;
}

Bench::Bench(const LinkedAlone& alone, ChainSettings settings)
    : alone_(alone), chain_(std::make_unique<Chain>(*alone.linked, std::move(settings), said_)) {
  clean_.emplace(chain_->document());
  for (const LinkedDependency& d : alone.linked->dependencies)
    if (DependencyTable* const table = chain_->table(d.element.alias)) tables_.emplace_back(table, *table);
}

void Bench::start() {
  for (auto& [table, at_first] : tables_) *table = at_first;
  chain_->document() = *clean_;
  chain_->start("block");
}

void Bench::prepare(const TestBlock& block) {
  said_.all.clear();
  Document& d = chain_->document();
  d = *clean_;
  if (!block.previous.is_null()) {
    chain_->begin_block({"previous", 1, 0, "", false});
    load_json(block.previous, d, chain_->symbols());
  }
  chain_->begin_block({"block", 2, 0, place_text ? place_text(block.text) : std::string_view(block.text), false});
  if (!block.before.is_null()) load_json(block.before, d, chain_->symbols());
  const Layout& layout = d.layout();
  for (const Assignment& a : block.assignments) {
    const ig_type type = layout.fields[a.field].type;
    if (type == IG_TEXT) {
      d.set_text(a.field, a.text);
    } else if (type == IG_TRANSFORM) {
      Frame frame;
      frame.kind = Frame::Kind::translation;
      frame.matrix[12] = a.value.number;
      d.set_frame(a.field, frame);
    } else {
      d.set(a.field, a.value);
      d.count_code(a.field);
    }
  }
  for (const ig_field f : block.absent) d.erase(f);
}

std::string Bench::show(const TestBlock& block) {
  prepare(block);
  Json shown = show_json(chain_->document(), chain_->symbols());
  if (!block.text.empty()) shown["UnparsedText"] = block.text;
  return shown.is_null() ? "{}" : shown.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Trial Bench::run(const TestBlock& block, bool shows) {
  prepare(block);
  ++chain_->builds;  // a trial is work of its own to the watch over calls that do not return
  Document& d = chain_->document();
  const ig_syntax& syntax = *alone_.linked->chain[alone_.position].syntax;
  scan();
  Trial out;
  if (syntax.build != nullptr) {
    const Document before = d;
    out.status = chain_->build(alone_.position);
    out.has_changed = !d.same_content(before);
  }
  out.diagnostics = std::move(said_.all);
  said_.all.clear();
  if (!shows) return out;
  out.shown = show_json(d, chain_->symbols()).dump(-1, ' ', false, Json::error_handler_t::replace);
  for (const Diagnostic& said : out.diagnostics) out.shown += "\n" + said.code + " " + said.message;
  return out;
}

double Bench::time(const TestBlock& block, int repeats) {
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    prepare(block);
    ++chain_->builds;
    const double begin = thread_seconds();
    build();
    times.push_back((thread_seconds() - begin) * 1e9);
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

ChainSettings in_mode(Mode mode) {
  ChainSettings out;
  out.mode = mode;
  return out;
}

std::string creation_fault(const LinkedAlone& alone, const ChainSettings& settings) {
  DiagnosticList said;
  try {
    const Chain chain(*alone.linked, settings, said);
    for (const Diagnostic& d : said.all)
      if (d.code == "IG-0402") return d.message + " [IG-0402]";
    return {};
  } catch (const std::runtime_error& error) {
    return said.all.empty() ? error.what() : said.all.back().message;
  }
}

}  // namespace isogloss::cli
