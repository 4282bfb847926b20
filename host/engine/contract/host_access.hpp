/// What the host's functions check an access against: nothing that linking has settled in the fast mode, the
/// declarations of the syntax in the checked mode.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "isogloss/engine/chain.hpp"

namespace isogloss::calls {

inline Document& doc(ig_block* block) { return *reinterpret_cast<Document*>(block); }
inline const Document& doc(const ig_block* block) { return *reinterpret_cast<const Document*>(block); }

inline bool allowed(const std::vector<std::uint64_t>& mask, ig_field f) {
  return (f >> 6) < mask.size() && (mask[f >> 6] >> (f & 63) & 1) != 0;
}

inline void violation(const Document& d, const std::string& what) {
  if (d.current == 0 || d.chain == nullptr) return;
  const LinkedSyntax& syntax = d.chain->linked().chain[d.current - 1u];
  const Diagnostic text = host_diagnostic("IG-0402", {}, {syntax.element.alias, what});
  d.chain->report(d, text.severity, text.code, text.message, 0, 0);
}

inline std::string field_name(const Document& d, ig_field f) {
  if (is_record_field(f)) return list_of(f) < d.layout().lists.size() ? d.layout().lists[list_of(f)].path : "?";
  return f < d.size() ? d.layout().fields[f].path : "a field that does not exist";
}

enum class Use { read, write, take };

/// False when the field must not be touched; the fast table only rejects ids outside the document.
template <Mode M>
bool may(const Document& d, ig_field f, Use use) {
  if (f >= d.size()) {
    if constexpr (M == Mode::checked)
      if (f != IG_NO_FIELD) violation(d, "it used a field that does not exist");
    return false;
  }
  if constexpr (M == Mode::checked) {
    if (d.current == 0) return true;
    const LinkedSyntax& s = d.chain->linked().chain[d.current - 1u];
    const bool ok = use == Use::read    ? allowed(s.may_read, f) || allowed(s.may_take, f) || allowed(s.may_write, f)
                    : use == Use::write ? allowed(s.may_write, f)
                                        : allowed(s.may_take, f);
    if (!ok)
      violation(d, std::string(use == Use::read    ? "it reads "
                               : use == Use::write ? "it writes "
                                                   : "it takes ") +
                       field_name(d, f) + ", which it does not declare");
    return ok;
  }
  return true;
}

/// Why the value is none of the field's type; empty when it is one.
inline std::string value_fault(const Document& d, const FieldInfo& info, ig_value v) {
  switch (info.type) {
    case IG_NUMBER: return std::isfinite(v.number) ? "" : "a value that is not a number";
    case IG_TEXT: return "a plain value: a text has set_text";
    case IG_TRANSFORM: return "a plain value: a transform has set_transform";
    case IG_BOOLEAN:
      return v.integer == 0 || v.integer == 1 ? "" : "the value " + std::to_string(v.integer) + ", while it is 0 or 1";
    case IG_SYMBOL: return v.symbol != 0 && v.symbol <= d.chain->symbols().size() ? "" : "a name that does not exist";
    default: return {};
  }
}

template <Mode M>
bool sound(const Document& d, ig_field f, ig_value v) {
  if constexpr (M == Mode::checked) {
    const FieldInfo& info = d.layout().fields[f];
    const std::string fault = value_fault(d, info, v);
    if (!fault.empty()) violation(d, "it gives " + info.path + " " + fault);
    return fault.empty();
  }
  return true;
}

/// Is the field of the type that the function `name` is for? All tables refuse others, the checked one says so.
template <Mode M>
bool is_of_type(const Document& d, ig_field f, ig_type type, const char* name) {
  const FieldInfo& info = d.layout().fields[f];
  if (info.type == type) return true;
  if constexpr (M == Mode::checked)
    violation(d, std::string("it calls ") + name + " with " + info.path + ", which is no " +
                     (type == IG_TEXT ? "text" : "transform"));
  return false;
}

/// Columns of the block's text: begin <= end <= its size, or the place behind it, where something is missing. A block
/// that was made without its text has the columns of another one, so only a scanner's are measured against the text.
template <Mode M>
void check_columns(const Document& d, std::uint64_t begin, std::uint64_t end, const char* what) {
  if constexpr (M == Mode::checked) {
    constexpr std::uint64_t most = 1u << 16;
    const char* const phase = Chain::breadcrumb().phase;
    const bool is_scanned = phase != nullptr && std::string_view(phase) == "scan";
    const std::uint64_t size = d.source.text.size(), room = is_scanned ? size + 1 : std::max(size + 1, most);
    if (end > room || (is_scanned && begin > end))
      violation(d, "it gives " + std::string(what) + " the columns " + std::to_string(begin) + " to " +
                       std::to_string(end) + " of a text of " + std::to_string(size) + " bytes");
  }
}

enum class Change { none, value };

template <Mode M>
void note_line(Document& d, ig_field f, Change change) {
  if constexpr (M == Mode::traced) {
    if (f >= d.origins.size()) return;
    Document::Origin& origin = d.origins[f];
    origin.line = d.source.line;
    origin.file = d.file_number;
    if (change == Change::none) return;
    origin.since = origin.line;
    origin.since_file = origin.file;
  }
}

/// What the write of `v` will be; only the traced mode asks.
template <Mode M>
Change change_to(const Document& d, ig_field f, ig_value v) {
  if constexpr (M == Mode::traced)
    return d.present(f) && d.value(f).integer == v.integer ? Change::none : Change::value;
  return Change::value;
}

}  // namespace isogloss::calls
