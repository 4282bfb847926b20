// Diagnostics of a chain: what syntaxes and the host report about a block, and where in the file that is.
#include <algorithm>
#include <array>

#include "contract/flow_host.hpp"
#include "isogloss/engine/chain.hpp"
#include "run/calling.hpp"
#include "run/cursor.hpp"

namespace isogloss {

namespace {

/// Before the first block a place is one in the text of the program.
void place_in_program(const FlowHost& program, std::uint32_t begin, std::uint32_t end, Diagnostic& out) {
  std::array<char, 4096> buffer;
  std::uint32_t line = 1, line_begin = 0, at = 0;
  char last = '\0';
  while (at < begin) {
    const std::size_t size = program.text(at, buffer.data(), std::min<std::size_t>(buffer.size(), begin - at));
    if (size == 0) return;
    for (std::size_t i = 0; i < size; ++i) {
      const char c = buffer[i];
      ++at;
      if (c == '\n' || c == '\r') {
        line += c == '\n' && last == '\r' ? 0 : 1;
        line_begin = at;
      }
      last = c;
    }
  }
  out.where.line = line;
  out.where.column = begin - line_begin + 1;
  out.end_column = end - line_begin + 1;
}

}  // namespace

void Chain::report(const Document& d, Severity severity, std::string_view code, std::string message,
                   std::uint32_t begin, std::uint32_t end, std::string hint) {
  ++reports_;
  const auto& severities = linked_.dialect.severities;
  if (!severities.empty())
    if (const auto found = severities.find(std::string(code)); found != severities.end())
      severity = found->second.severity;
  Diagnostic out{severity, std::string(code), std::move(message), {}, 0, std::move(hint)};
  out.where = {std::string(d.source.file), d.source.line, d.source.column + begin + 1};
  if (end > begin) out.end_column = d.source.column + end + 1;
  if (d.source.line == 0 && end > begin && flow != nullptr) place_in_program(*flow, begin, end, out);
  if (d.source.is_joined) [[unlikely]]
    place_in_joined(d, begin, end, out);
  sink_.add(std::move(out));
}

/// A range that reaches into the next line is cut at the end of its own line.
void Chain::place_in_joined(const Document& d, std::uint32_t begin, std::uint32_t end, Diagnostic& out) {
  const BlockSource& source = d.source;
  if (joined_ == nullptr) joined_ = std::make_unique<LinePlaces>();
  const LinePlace place = &d == &document_ ? joined_->at(source.text, begin) : LinePlace::of(source.text, begin);
  const auto column = static_cast<std::uint32_t>(begin - place.begin) + (place.line == 0 ? source.column : 0);
  out.where.line = source.line + place.line;
  out.where.column = column + 1;
  if (end <= begin) return;
  const std::string_view behind = source.text.substr(std::min<std::size_t>(begin, source.text.size()));
  const std::size_t size = behind.substr(0, end - begin).find_first_of("\r\n");
  out.end_column = column + 1 + static_cast<std::uint32_t>(std::min<std::size_t>(end - begin, size));
}

/// The SDK's trampoline has reported the reason; a plugin without the SDK may not have.
void Chain::tell_failure(const Document& d, std::uint32_t position) {
  if (failure_said_by != position + 1) {
    const Diagnostic text =
        host_diagnostic("IG-0401", {}, {linked_.chain[position].element.alias, "its build() gives no reason"});
    report(d, text.severity, text.code, text.message, 0, 0);
  }
  failure_said_by = 0;
}

/// Reports an exception of the running syntax; exceptions of the host are rethrown.
[[gnu::cold]] void Chain::tell_exception(const Document& d, const char* phase) {
  if (d.current == 0) throw;
  const std::uint32_t position = d.current - 1u;
  const LinkedSyntax& s = linked_.chain[position];
  const Diagnostic text = exception_diagnostic(*s.plugin, s.element.alias, phase, {});
  report(d, text.severity, text.code, text.message, 0, 0);
  failure_said_by = 0;
}

}  // namespace isogloss
