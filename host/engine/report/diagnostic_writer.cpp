#include "isogloss/engine/diagnostic_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "export/text_buffer.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss {

namespace {

// Limit of a message or a hint: program text and texts of plugins may have any length.
constexpr std::size_t longest_text = 4096;

void shorten(std::string& text) {
  if (text.size() <= longest_text) return;
  std::size_t size = longest_text;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80) --size;  // no half of a character
  text = text.substr(0, size) + fmt::format("… and {} bytes more", text.size() - size);
}

std::string place(const Diagnostic& d) {
  std::string out = d.where.file.empty() ? "isogloss" : d.where.file;
  if (d.where.line != 0) out += fmt::format(":{}", d.where.line);
  if (d.where.line != 0 && d.where.column != 0) out += fmt::format(":{}", d.where.column);
  return out;
}

std::string_view sarif_level(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

std::string_view colour(Severity severity) {
  return severity == Severity::error ? "\033[1;31m" : severity == Severity::warning ? "\033[1;35m" : "\033[1;36m";
}

/// A message without numbers and quoted text, which differ from place to place.
std::string wording(std::string_view message) {
  std::string out;
  bool is_quoted = false;
  for (const char c : message) {
    if (c == '\'') is_quoted = !is_quoted;
    const bool is_number = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
    if (!is_quoted && !is_number) out += c;
  }
  return out;
}

}  // namespace

DiagnosticWriter::DiagnosticWriter(DiagnosticPolicy policy, Write write) : policy_(policy), write_(std::move(write)) {}

DiagnosticWriter::~DiagnosticWriter() = default;

void DiagnosticWriter::add(Diagnostic diagnostic) {
  shorten(diagnostic.message);
  shorten(diagnostic.hint);
  if (policy_.warnings_are_errors && diagnostic.severity == Severity::warning) diagnostic.severity = Severity::error;
  errors_ += diagnostic.severity == Severity::error;
  warnings_ += diagnostic.severity == Severity::warning;
  Count& count = by_code_[diagnostic.code];
  ++count.number;
  count.severity = std::max(count.severity, diagnostic.severity);
  switch (policy_.style) {
    case DiagnosticStyle::text:
      if (!is_repeat(diagnostic)) write_text(diagnostic);
      break;
    case DiagnosticStyle::json: write_json(diagnostic); break;
    case DiagnosticStyle::sarif: write_sarif(diagnostic); break;
  }
}

/// Was it written often enough, or in the same words at the same place?
bool DiagnosticWriter::is_repeat(const Diagnostic& d) {
  if (policy_.repeats == 0) return false;
  Said& said = said_[d.code];
  const auto is_same = [&](const Diagnostic& other) {
    return other.where.line == d.where.line && other.where.column == d.where.column && other.message == d.message &&
           other.where.file == d.where.file;
  };
  // Another word in the message of an error is news, another number is not.
  constexpr std::size_t most_wordings = 20;
  const bool is_new = d.severity == Severity::error && said.wordings.size() < most_wordings &&
                      said.wordings.insert(wording(d.message)).second;
  if ((said.written.size() >= policy_.repeats && !is_new) ||
      std::any_of(said.written.begin(), said.written.end(), is_same)) {
    ++said.unsaid;
    return true;
  }
  said.written.push_back(d);
  return false;
}

void DiagnosticWriter::write_text(const Diagnostic& d) {
  const bool colours = policy_.colours;
  std::string line = fmt::format("{}: {}{}: {}{} [{}]\n", printable(place(d)), colours ? colour(d.severity) : "",
                                 to_string(d.severity), colours ? "\033[0m" : "", printable(d.message), d.code);
  if (!d.hint.empty()) line += fmt::format("  hint: {}\n", printable(d.hint));
  write_(line);
}

void DiagnosticWriter::write_json(const Diagnostic& d) {
  std::string line = fmt::format(R"({{"Severity":"{}","Code":{},"Message":{})", to_string(d.severity),
                                 json_string(d.code), json_string(d.message));
  if (!d.where.file.empty()) line += fmt::format(R"(,"File":{})", json_string(d.where.file));
  if (d.where.line != 0) line += fmt::format(R"(,"Line":{})", d.where.line);
  if (d.where.column != 0) line += fmt::format(R"(,"Column":{})", d.where.column);
  if (d.end_column != 0) line += fmt::format(R"(,"EndColumn":{})", d.end_column);
  if (!d.hint.empty()) line += fmt::format(R"(,"Hint":{})", json_string(d.hint));
  write_(line += "}\n");
}

void DiagnosticWriter::write_sarif(const Diagnostic& d) {
  std::string out;
  if (!sarif_open_)
    out = R"({"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{"results":[)";
  out += sarif_open_ ? ",\n" : "\n";
  sarif_open_ = true;
  const std::string message = d.hint.empty() ? d.message : d.message + " (" + d.hint + ")";
  out += fmt::format(R"({{"ruleId":{},"level":"{}","message":{{"text":{}}})", json_string(d.code),
                     sarif_level(d.severity), json_string(message));
  if (!d.where.file.empty()) {
    out += fmt::format(R"(,"locations":[{{"physicalLocation":{{"artifactLocation":{{"uri":{}}})",
                       json_string(d.where.file));
    if (d.where.line != 0) {
      out += fmt::format(R"(,"region":{{"startLine":{})", d.where.line);
      if (d.where.column != 0) out += fmt::format(R"(,"startColumn":{})", d.where.column);
      if (d.end_column != 0) out += fmt::format(R"(,"endColumn":{})", d.end_column);
      out += '}';
    }
    out += "}}]";
  }
  write_(out += '}');
}

std::uint64_t DiagnosticWriter::number() const {
  std::uint64_t all = 0;
  for (const auto& [code, count] : by_code_) all += count.number;
  return all;
}

void DiagnosticWriter::finish_program() {
  if (policy_.style == DiagnosticStyle::text && policy_.repeats != 0) {
    for (const auto& [code, said] : said_)
      if (said.unsaid != 0) write_(fmt::format("… and {} more [{}]\n", said.unsaid, code));
  }
  said_.clear();
}

void DiagnosticWriter::finish() {
  if (finished_) return;
  finished_ = true;
  finish_program();
  if (policy_.style != DiagnosticStyle::sarif) return;
  std::string out;
  if (!sarif_open_)
    out = R"({"$schema":"https://json.schemastore.org/sarif-2.1.0.json","version":"2.1.0","runs":[{"results":[)";
  out +=
      "],\n\"tool\":{\"driver\":{\"name\":\"isogloss\",\"version\":" + json_string(ISOGLOSS_VERSION) + ",\"rules\":[";
  bool first = true;
  for (const auto& [code, count] : by_code_) {
    out += first ? "\n" : ",\n";
    first = false;
    out += fmt::format(R"({{"id":{}}})", json_string(code));
  }
  write_(out += "]}}}]}\n");
}

}  // namespace isogloss
