#include "explain/follow_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "asked_reports.hpp"
#include "chain_trial.hpp"
#include "explain/frame_text.hpp"
#include "isogloss/engine/printable.hpp"
#include "json_text.hpp"
#include "output_file.hpp"

namespace isogloss::cli {

namespace {

bool is_same_name(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return small(x) == small(y); });
}

/// The name as the document spells it; empty, and reported, where the dialect has no such field.
std::string find_name(const std::string& wanted, const LinkedDialect& linked, Session& session) {
  std::set<std::string> names;
  for (const FieldInfo& info : linked.layout.fields) {
    if (info.hidden || fields_to_follow(linked.layout, info.path).empty()) continue;
    for (std::size_t dot = info.path.find('.'); dot != std::string::npos; dot = info.path.find('.', dot + 1))
      names.insert(info.path.substr(0, dot));
    names.insert(info.path);
  }
  for (const std::string& name : names)
    if (is_same_name(name, wanted)) return name;
  // The last part alone, where only one field has it: FeedrateValue.
  std::vector<std::string> by_leaf;
  for (const std::string& name : names)
    if (const std::size_t dot = name.rfind('.'); dot != std::string::npos && is_same_name(name.substr(dot + 1), wanted))
      by_leaf.push_back(name);
  if (by_leaf.size() == 1) return by_leaf.front();
  const std::string near = nearest_name(wanted, {names.begin(), names.end()});
  session.report("IG-0180", {}, {linked.dialect.name, wanted},
                 !by_leaf.empty() ? "name its section, too: " + by_leaf.front()
                 : near.empty()   ? "isogloss list fields names them"
                                  : "did you mean " + near + "?");
  return {};
}

class Printer {
 public:
  Printer(const FollowRequest& request, OutputFile& output) : request_(request), output_(output) {
    if (request.json) buffer_ = "[";
  }

  bool add(const FollowedChange& c) {
    const NamedLines& lines = request_.lines;
    const bool is_inside = lines.first == 0 || (c.line >= lines.first && c.line <= lines.last);
    if (!is_inside || !is_in_file(c.file)) return true;
    buffer_ += request_.json ? json_of(c) : text_of(c);
    ++count_;
    if (buffer_.size() < 1u << 16) return true;
    const bool is_written = output_.write(buffer_);
    buffer_.clear();
    return is_written;
  }
  void finish() {
    if (request_.json) buffer_ += count_ == 0 ? "]\n" : "\n]\n";
    output_.write(buffer_);
  }
  std::size_t count() const { return count_; }

 private:
  bool is_in_file(std::string_view file) const {
    return request_.in.empty() || file == request_.in ||
           std::filesystem::path(file).filename() == std::filesystem::path(request_.in).filename();
  }

  static std::string shown(const FollowedChange& c, const std::string& value) {
    const std::string effect = c.path.starts_with("ProgramToMcTransform.") ? effect_of_json(value) : std::string();
    return value.empty() ? "absent" : effect.empty() ? printable(value) : effect;
  }

  static std::string text_of(const FollowedChange& c) {
    const std::string place = c.line == 0 ? "before the first block" : fmt::format("{}:{}", c.file, c.line);
    std::string value = fmt::format("{} = {}", c.path, shown(c, c.after));
    if (!c.before.empty()) value += fmt::format(" (was {})", shown(c, c.before));
    std::string out = fmt::format("{}: {}  {}", place, value, c.writer.empty() ? "initial state" : c.writer);
    if (c.after.empty()) out = fmt::format("{}: {}", place, value);
    return out + (c.text.empty() ? "" : "  | " + printable(c.text, "\t")) + "\n";
  }

  std::string json_of(const FollowedChange& c) const {
    Json one{{"File", std::string(c.file)}, {"Line", c.line}, {"Path", std::string(c.path)}};
    if (!c.before.empty()) one["Before"] = Json::parse(c.before);
    if (!c.after.empty()) one["After"] = Json::parse(c.after);
    if (!c.writer.empty()) one["Writer"] = std::string(c.writer);
    one["Text"] = std::string(c.text);
    return (count_ == 0 ? "\n  " : ",\n  ") + one.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  const FollowRequest& request_;
  OutputFile& output_;
  std::string buffer_;
  std::size_t count_ = 0;
};

}  // namespace

int follow_field(const FollowRequest& request, const LinkedDialect& linked, Source& source, const RunOptions& options,
                 Session& session) {
  const std::string name = find_name(request.field, linked, session);
  if (name.empty()) return cannot_start;
  session.progress().data_goes_to_stdout();
  const std::unique_ptr<OutputFile> output = OutputFile::standard_output();
  Printer printer(request, *output);
  // Only the host's, which may end the run: the other diagnostics of the program were not asked for.
  AskedReports said([](const Diagnostic& d) { return d.where.line == 0 || d.code.starts_with("IG-"); });
  try {
    follow(
        linked, source, request.lines.program, fields_to_follow(linked.layout, name),
        [&](const FollowedChange& c) { return printer.add(c); }, options, said);
  } catch (const std::runtime_error& e) {
    return report_no_begin(linked, options.chain, request.lines.program, e, session);
  }
  session.progress().hide();
  printer.finish();
  if (printer.count() == 0) session.report("IG-0183", {request.lines.program, 0, 0}, {name});
  for (Diagnostic& d : said.all) session.diagnostics().add(std::move(d));
  if (!output->commit() && !output->reader_is_gone()) {
    session.report("IG-0511", {"standard output"}, {output->error()});
    return cannot_start;
  }
  return session.status();
}

}  // namespace isogloss::cli
