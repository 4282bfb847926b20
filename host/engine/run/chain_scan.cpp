// Scanning: the scanners of a chain take the text of a block apart, byte by byte.
#include <algorithm>

#include "isogloss/engine/scanned_line.hpp"

namespace isogloss {

namespace {

bool is_blank(unsigned char c) { return c == ' ' || c == '\t'; }

/// A scanner that goes back would read the same bytes without end: it counts as one that took nothing.
[[gnu::cold]] void refuse_begin(Chain& chain, std::size_t at) {
  const Document& d = chain.document();
  const LinkedSyntax& s = chain.linked().chain[d.current - 1u];
  const Diagnostic text = host_diagnostic(
      "IG-0402", {}, {s.element.alias, "its scan() returned a position before the one at which it was asked"});
  chain.report(d, text.severity, text.code, text.message, static_cast<std::uint32_t>(at),
               static_cast<std::uint32_t>(at + 1));
}

}  // namespace

/// No scanner accepted this byte of the text.
[[gnu::cold]] void Chain::leave_byte(Document& d, std::size_t position) {
  d.current = 0;
  const auto c = static_cast<unsigned char>(d.source.text[position]);
  const auto begin = static_cast<std::uint32_t>(position);
  if (c < 0x20) {
    constexpr char digits[] = "0123456789ABCDEF";
    const Diagnostic control = host_diagnostic("IG-0412", {}, {{digits[c >> 4], digits[c & 15]}});
    report(d, control.severity, control.code, control.message, begin, begin + 1);
  }
  d.add_leftover(IG_LEFT_TEXT, IG_NO_FIELD, begin, begin + 1, d.source.text.substr(position, 1));
}

/// A scanner that claims bytes beyond the text cannot have seen them: the byte stays unscanned.
[[gnu::cold]] std::size_t Chain::refuse_end(std::size_t at) {
  const LinkedSyntax& s = linked_.chain[document_.current - 1u];
  const Diagnostic text = host_diagnostic(
      "IG-0402", {}, {s.element.alias, "its scan() returned an end after the text, so its bytes stay unscanned"});
  report(document_, text.severity, text.code, text.message, static_cast<std::uint32_t>(at),
         static_cast<std::uint32_t>(at + 1));
  return at;
}

/// Scans from the position on. The position is the caller's variable, because a scanner may throw.
template <bool is_heard>
[[gnu::always_inline]] inline void Chain::scan_from(std::size_t& position) {
  Document& d = document_;
  const char* const text = d.source.text.data();
  const std::size_t size = d.source.text.size();
  ig_block* const block = d.block();
  while (position < size) {
    const auto c = static_cast<unsigned char>(text[position]);
    if (is_blank(c)) {
      ++position;
      continue;
    }
    if (c == '\r' || c == '\n') {  // a lone carriage return also ends a line
      if (d.source.is_joined) {
        ++position;
        continue;
      }
      split_at = position + 1;
      break;
    }
    std::size_t next = position;
    for (const std::uint16_t scanner : scanners_[c]) {
      const Step& step = steps_[scanner];
      d.current = static_cast<std::uint16_t>(scanner + 1);
      next = step.scan(step.self, host_, block, text, size, position);
      if (next > position) break;
      if (next < position) [[unlikely]]
        refuse_begin(*this, position);
    }
    if (next > size) [[unlikely]]
      next = refuse_end(position);
    if (next <= position) {
      next = position + 1;
      leave_byte(d, position);
    } else if constexpr (is_heard) {
      scanned(d.current - 1u, position, next);
    }
    position = next;
    if (split_at != 0 || skip_rest || ends_file) break;
  }
}

std::size_t Chain::scan() {
  const std::size_t size = document_.source.text.size();
  std::size_t position = 0;
  is_scanning_ = true;
  for (bool is_done = false; !is_done;) try {
      if (scanned) [[unlikely]]
        scan_from<true>(position);
      else
        scan_from<false>(position);
      is_done = true;
    } catch (...) {
      tell_exception(document_, "scan");
      leave_byte(document_, position++);
    }
  is_scanning_ = false;
  document_.current = 0;
  return split_at != 0 ? std::min(split_at, size) : size;
}

/// Has this block the values that were read while its text was scanned ahead?
bool Chain::has_read_values(const ScannedLine& line) const {
  const Document& d = document_;
  for (const ScannedLine::Read& read : std::span(line.read(), line.reads)) {
    if (d.present(read.field) != (read.is_there != 0)) return false;
    if (read.is_there != 0 && d.value(read.field).integer != read.value.integer) return false;
  }
  return true;
}

bool Chain::take_scanned(const ScannedLine& line) {
  if (line.reads != 0 && !has_read_values(line)) return false;
  document_.set_summed(line.summary());
  return true;
}

std::size_t Chain::scan_with(std::uint32_t position) {
  for (auto& list : scanners_) list.clear();
  const ig_syntax& syntax = *linked_.chain[position].syntax;
  if (syntax.scan != nullptr && syntax.triggers != nullptr)
    for (const char* c = syntax.triggers; *c != '\0'; ++c)
      scanners_[static_cast<unsigned char>(*c)].push_back(static_cast<std::uint16_t>(position));
  return scan();
}

}  // namespace isogloss
