#include "batch/results.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "batch/assets.hpp"
#include "crash_guard.hpp"
#include "markup.hpp"
#include "output_file.hpp"
#include "outputs.hpp"

namespace isogloss::cli::batch {

namespace {

/// How a program ended, in the order of the totals.
constexpr struct {
  const char* status;
  const char* in_words;
  int exit;
} statuses[] = {
    {"ok", "ok", success},
    {"errors", "with errors", input_errors},
    {"not run", "not run", cannot_start},
    {"fault", "stopped by a fault of a plugin or of the host", internal_fault},
    {"crashed", "crashed", internal_fault},
    {"out of time", "out of time", input_errors},
    {"out of memory", "out of memory", input_errors},
};

constexpr const char* numbers[] = {"Blocks",      "Events",      "Rapids",         "Feeds",
                                   "Arcs",        "ToolChanges", "RapidLength_mm", "FeedLength_mm",
                                   "RapidTime_s", "FeedTime_s",  "DwellTime_s",    "Time_s"};

std::string status_name(const ChildEnd& end, bool has_result) {
  switch (end.how) {
    case ChildEnd::How::killed_by_signal: return "crashed";
    case ChildEnd::How::out_of_time: return "out of time";
    case ChildEnd::How::out_of_memory: return "out of memory";
    case ChildEnd::How::not_started: return "not run";
    case ChildEnd::How::exited: break;
  }
  for (const auto& one : statuses)
    if (one.exit == end.number && (has_result || end.number == cannot_start)) return one.status;
  return "fault";
}

/// Of what a plugin may have made up, nothing but what has the expected kind.
std::string text_in(const Json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}
std::uint64_t count_in(const Json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}
Json number_in(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number() ? *found : Json();
}

/// Why a process has written no result.
std::string reason(const ChildEnd& end, const ChildLimits& limits) {
  switch (end.how) {
    case ChildEnd::How::killed_by_signal: return fmt::format("its process was ended by signal {}", end.number);
    case ChildEnd::How::out_of_time: return fmt::format("it was not done after {} s", limits.seconds);
    case ChildEnd::How::out_of_memory: return fmt::format("it needed more than {} MiB", limits.memory_mib);
    case ChildEnd::How::not_started: return fmt::format("no process: {}", std::strerror(end.number));
    case ChildEnd::How::exited: break;
  }
  const std::string line = end.errors.substr(0, end.errors.find('\n'));
  return line.empty() ? fmt::format("its process ended with status {} and said nothing", end.number) : line;
}

std::uint64_t count_of(const Json& result, const char* severity) {
  std::uint64_t out = 0;
  const auto all = result.find("Diagnostics");
  if (all == result.end() || !all->is_array()) return out;
  for (const Json& one : *all)
    if (text_in(one, "Severity") == severity) out += count_in(one, "Count");
  return out;
}

/// "line 3", or with the file where it is another one than the program.
std::string place_of(const Json& first, const std::string& program) {
  const std::string file = text_in(first, "File");
  const std::uint64_t line = count_in(first, "Line");
  if (file.empty() || (file == program && line == 0)) return {};
  return file == program ? fmt::format("line {}", line) : line == 0 ? file : fmt::format("{}:{}", file, line);
}

/// The first error or warning as one line.
std::string first_said(const Json& result) {
  const auto found = result.find("First");
  if (found == result.end() || !found->is_object()) return {};
  const std::string place = place_of(*found, text_in(result, "Program")), code = text_in(*found, "Code");
  return (place.empty() ? "" : place + ": ") + text_in(*found, "Message") + (code.empty() ? "" : " [" + code + "]");
}

/// A sheet would calculate a text that begins as a formula does.
std::string csv_text(const std::string& text) {
  const bool is_formula = !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
  if (!is_formula && text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = is_formula ? "\"'" : "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

/// Inside of a script element neither an end tag nor a comment may begin.
std::string for_script(const Json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

/// Of the processes that write results into a folder one at a time. Where the file system has no locks, nothing waits.
class OneWriter {
 public:
  explicit OneWriter(const std::string& folder) : descriptor_(::open(folder.c_str(), O_RDONLY | O_CLOEXEC)) {
    while (descriptor_ >= 0 && !is_alone_) {
      is_alone_ = ::flock(descriptor_, LOCK_EX) == 0;
      if (!is_alone_ && errno != EINTR) break;
    }
  }
  ~OneWriter() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OneWriter(const OneWriter&) = delete;
  OneWriter& operator=(const OneWriter&) = delete;

  bool is_alone() const { return is_alone_; }

 private:
  int descriptor_;
  bool is_alone_ = false;
};

}  // namespace

std::string programs_in_words(std::uint64_t count) { return fmt::format("{} program{}", count, count == 1 ? "" : "s"); }

Json result_of(const std::string& program, const ChildEnd& end, const std::optional<Work>& work,
               const ChildLimits& limits) {
  const bool is_whole = end.how == ChildEnd::How::exited && work.has_value();
  Json out{{"Isogloss", 1}, {"Program", program}, {"Status", status_name(end, work.has_value())}};
  if (is_whole && work->summary.is_object())
    for (const auto& [name, value] : work->summary.items())
      if (!out.contains(name) && name != "First") out[name] = value;
  if (is_whole && work->first.is_object())
    out["First"] = work->first;
  else if (!is_whole)
    out["First"] = Json{{"Severity", "error"}, {"Message", reason(end, limits)}};
  return out;
}

int status_of(const Json& result) {
  const std::string status = text_in(result, "Status");
  for (const auto& one : statuses)
    if (status == one.status) return one.exit;
  return internal_fault;
}

void ResultFiles::add(const Json& result) {
  const std::string program = text_in(result, "Program"), status = text_in(result, "Status"),
                    dialect = text_in(result, "Dialect"), said = first_said(result);
  ++by_status_[status];
  lines_ += result.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";

  csv_ += csv_text(program) + "," + status + "," + csv_text(dialect);
  for (const char* const name : numbers) {
    const Json value = number_in(result, name);
    csv_ += "," + (value.is_null() ? std::string() : value.dump());
  }
  for (const char* const severity : {"error", "warning", "note"})
    csv_ += fmt::format(",{}", count_of(result, severity));
  csv_ += "," + csv_text(said) + "\n";

  cases_ += fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                        visible_xml(dialect.empty() ? "no dialect" : dialect), visible_xml(program));
  cases_ += status == "ok" ? std::string("/>\n")
                           : fmt::format("><{0} type=\"{1}\" message=\"{2}\"/></testcase>\n",
                                         status == "errors" ? "failure" : "error", status, visible_xml(said));

  Json row = Json::array({program, status, dialect});
  for (const char* const name : {"Blocks", "ToolChanges", "FeedLength_mm", "Time_s"})
    row.push_back(number_in(result, name));
  for (const char* const severity : {"error", "warning"}) row.push_back(count_of(result, severity));
  row.push_back(said);
  rows_ += (count_ == 0 ? "" : ",\n") + for_script(row);
  ++count_;
}

std::string ResultFiles::as_csv() const {
  std::string head = "Program,Status,Dialect";
  for (const char* const name : numbers) head += fmt::format(",{}", name);
  return head + ",Errors,Warnings,Notes,First\n" + csv_;
}

std::string ResultFiles::as_junit() const {
  const auto number = [&](const char* status) {
    const auto found = by_status_.find(status);
    return found == by_status_.end() ? 0 : found->second;
  };
  const std::uint64_t failures = number("errors");
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
             "  <testsuite name=\"isogloss batch\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
             count_, failures, count_ - failures - number("ok")) +
         cases_ + "  </testsuite>\n</testsuites>\n";
}

std::string ResultFiles::as_html() const {
  std::string page(asset("overview.html"));
  const auto put = [&](std::string_view name, std::string_view text) {
    page.replace(page.find(name), name.size(), text);
  };
  put("@POLICY@", fmt::format("default-src 'none'; style-src '{}'; script-src '{}'", asset("overview.css.hash"),
                              asset("overview.js.hash")));
  put("@STYLE@", asset("overview.css"));
  put("@WORDS@", in_words());
  put("@SCRIPT@", asset("overview.js"));
  put("@ROWS@", "[" + rows_ + "]");  // the last: texts of programs may hold any of these names
  return page;
}

bool ResultFiles::write(const std::string& folder, Session& session) const {
  const OneWriter writer(folder);
  struct Part {
    std::string path;
    std::unique_ptr<OutputFile> file;
  };
  std::vector<Part> parts;
  bool is_written = true;
  const auto tell = [&](const Part& part, const std::string& error) {
    if (part.file != nullptr && part.file->reader_is_gone()) return;
    session.report("IG-0511", {part.path}, {error});
    is_written = false;
  };
  const auto write = [&](const char* name, std::string_view text) {
    Part& part = parts.emplace_back(Part{(std::filesystem::path(folder) / name).string(), nullptr});
    if (writer.is_alone()) OutputFile::remove_left_behind(part.path);
    std::string error;
    part.file = OutputFile::open(part.path, error);
    if (part.file != nullptr) part.file->write(text);
    if (part.file == nullptr || !part.file->complete()) tell(part, part.file == nullptr ? error : part.file->error());
  };
  write("results.jsonl", lines_);
  write("results.csv", as_csv());
  write("results.xml", as_junit());
  write("overview.html", as_html());
  if (!is_written) return false;
  // All of one batch or none: a signal waits.
  const WholeLines none_is_left;
  for (const Part& part : parts)
    if (!part.file->commit()) tell(part, part.file->error());
  return is_written;
}

std::string ResultFiles::in_words() const {
  std::string out = programs_in_words(count_);
  const char* separator = ": ";
  for (const auto& one : statuses) {
    const auto found = by_status_.find(one.status);
    if (found == by_status_.end()) continue;
    out += fmt::format("{}{} {}", separator, found->second, one.in_words);
    separator = ", ";
  }
  return out;
}

}  // namespace isogloss::cli::batch
