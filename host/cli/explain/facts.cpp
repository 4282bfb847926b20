#include "explain/facts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace isogloss::cli {

namespace {

constexpr std::uintmax_t largest_file = 1u << 30;
constexpr std::string_view line_blanks = " \t";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
char upper_of(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Position of `code` in `text` as a word of its own, in any case.
bool holds_word(std::string_view text, std::string_view code) {
  for (std::size_t i = 0; i + code.size() <= text.size(); ++i) {
    bool is_same = true;
    for (std::size_t k = 0; is_same && k < code.size(); ++k) is_same = upper_of(text[i + k]) == upper_of(code[k]);
    const char behind = i + code.size() < text.size() ? text[i + code.size()] : ' ';
    const bool ends = is_digit(code.back()) ? !is_digit(behind) && behind != '.' : !is_letter(behind);
    const bool begins = i == 0 || !is_letter(text[i - 1]);
    if (is_same && begins && ends) return true;
  }
  return false;
}

}  // namespace

LineTexts::File LineTexts::read(const std::string& path) {
  File out;
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code)) return out;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (code || size > largest_file) return out;
  std::ifstream file(path, std::ios::binary);
  out.bytes.resize(size);
  file.read(out.bytes.data(), static_cast<std::streamsize>(size));
  out.bytes.resize(static_cast<std::size_t>(file.gcount()));
  find_lines(out);
  return out;
}

void LineTexts::give(const std::string& path, const std::string& text) {
  File& file = files_[path];
  file.bytes = text;
  find_lines(file);
}

void LineTexts::find_lines(File& out) {
  out.begins.assign(1, 0);
  // Lines end as in the run: LF, CR or both.
  for (std::size_t i = 0; i < out.bytes.size(); ++i) {
    const bool is_half = out.bytes[i] == '\r' && i + 1 < out.bytes.size() && out.bytes[i + 1] == '\n';
    if ((out.bytes[i] == '\n' || out.bytes[i] == '\r') && !is_half) out.begins.push_back(i + 1);
  }
}

std::string LineTexts::at(const ProgramLine& line) {
  if (line.line == 0) return {};
  auto found = files_.find(line.file);
  if (found == files_.end()) found = files_.emplace(line.file, read(line.file)).first;
  const File& file = found->second;
  if (line.line > file.begins.size()) return {};
  const std::size_t begin = file.begins[line.line - 1];
  std::string_view text = std::string_view(file.bytes).substr(begin);
  text = text.substr(0, text.find_first_of("\r\n"));
  const std::size_t first = text.find_first_not_of(line_blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(line_blanks) + 1 - first));
}

bool mentions(std::string_view text, std::string_view code) {
  if (code.empty()) return false;
  if (holds_word(text, code)) return true;
  std::size_t digits = 0;
  while (digits < code.size() && is_letter(code[digits])) ++digits;
  std::size_t zeros = digits;
  while (zeros + 1 < code.size() && code[zeros] == '0' && is_digit(code[zeros + 1])) ++zeros;
  if (zeros == digits) return false;
  return holds_word(text, std::string(code.substr(0, digits)) + std::string(code.substr(zeros)));
}

Facts::Facts(const ExplainedBlock& block, LineTexts& lines, std::span<const Diagnostic> reports)
    : block_(block), lines_(lines), reports_(reports), document_(Json::parse(block.document)) {
  for (const ExplainedValue& v : block.values) now_.emplace(v.path, &v);
  for (const ExplainedValue& v : block.carried) before_.emplace(v.path, &v);
  if (text("Unit.System") == "Inch") unit_mm_ = 25.4;
}

std::optional<double> Facts::number_of(const ExplainedValue* value) {
  if (value == nullptr) return std::nullopt;
  const Json json = Json::parse(value->value, nullptr, false);
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

std::string Facts::text(const std::string& path) const {
  const ExplainedValue* const value = now(path);
  if (value == nullptr) return {};
  const Json json = Json::parse(value->value, nullptr, false);
  return json.is_string() ? json.get<std::string>() : value->value;
}

bool Facts::has_changed(const std::string& path) const {
  const ExplainedValue *const was = before(path), *const is = now(path);
  return is != nullptr && (was == nullptr || was->value != is->value);
}

std::string Facts::report() const {
  for (const Severity severity : {Severity::error, Severity::warning})
    for (const Diagnostic& d : reports_)
      if (d.severity == severity && d.where.line == block_.where.line && d.where.file == block_.where.file)
        return fmt::format("{} [{}]", d.message, d.code);
  return {};
}

const ExplainedWord* Facts::word(const std::string& name) const {
  for (const ExplainedWord& w : block_.words)
    if (w.name == name) return &w;
  return nullptr;
}

std::string Facts::place(const ProgramLine& line) const {
  if (line.line == 0) return "before the first block";
  if (line.file == block_.where.file) return fmt::format("line {}", line.line);
  return fmt::format("line {} of {}", line.line, std::filesystem::path(line.file).filename().string());
}

}  // namespace isogloss::cli
