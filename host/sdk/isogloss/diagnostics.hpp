/// Diagnostics: declared beside the syntax that raises them, and raised by their codes.
///
/// A syntax lists its own diagnostics in a member `static constexpr std::array diagnostics{ig::diagnostic(…), …}`.
/// Those that several syntaxes of a plugin raise are listed in one `const ig::Diagnostics` at namespace scope. The
/// explanation of a diagnostic, with an example, is under "Diagnostics" on the page of the syntax, or on the page
/// beside the shared list.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "isogloss.h"
#include "isogloss/pages.hpp"

namespace ig {

/// One row of the plugin's table. {0}, {1} … in `text` stand for the arguments of Block::report(). Without an
/// explanation and an example, those of the page are used.
constexpr ig_diagnostic_decl diagnostic(ig_severity severity, const char* code, const char* text,
                                        const char* explanation = nullptr, const char* example = nullptr) {
  return {sizeof(ig_diagnostic_decl), severity, code, text, explanation, example};
}

/// The code of a diagnostic that a file of the plugin declares.
struct DiagnosticCode {
  std::string_view code;
  friend constexpr bool operator==(DiagnosticCode, DiagnosticCode) = default;
};

/// diag("ACME-0001"). A code is two to four capitals, a hyphen and four digits; anything else does not compile.
consteval DiagnosticCode diag(std::string_view code) {
  const std::size_t hyphen = code.find('-');
  bool is_code = hyphen >= 2 && hyphen <= 4 && code.size() == hyphen + 5;
  for (std::size_t i = 0; is_code && i < code.size(); ++i) {
    const char c = code[i];
    is_code = i < hyphen ? c >= 'A' && c <= 'Z' : i == hyphen || (c >= '0' && c <= '9');
  }
  if (!is_code) throw "a code is two to four capitals, a hyphen and four digits";
  return {code};
}

namespace detail {

inline bool is_before(const ig_diagnostic_decl& a, const ig_diagnostic_decl& b) {
  return std::string_view(a.code) < b.code;
}

/// The table of one plugin. All files add their diagnostics before the entry function can be called.
class DiagnosticTable {
 public:
  void add(std::span<const ig_diagnostic_decl> some) { rows_.insert(rows_.end(), some.begin(), some.end()); }

  /// Sorts the rows by code, drops duplicates and adds the explanations of the pages. The rows of `leading` come first
  /// and keep their indices. Two rows with one code and two texts both stay, and the host refuses the plugin.
  std::span<const ig_diagnostic_decl> complete(std::span<const ig_diagnostic_decl> leading) {
    std::stable_sort(rows_.begin(), rows_.end(), is_before);
    rows_.erase(std::unique(rows_.begin(), rows_.end(),
                            [](const auto& a, const auto& b) {
                              return a.code == std::string_view(b.code) && a.text == std::string_view(b.text) &&
                                     a.severity == b.severity;
                            }),
                rows_.end());
    for (ig_diagnostic_decl& row : rows_) explain(row);
    leading_ = leading.size();
    rows_.insert(rows_.begin(), leading.begin(), leading.end());
    return rows_;
  }

  /// The index of a code, or no_such_row.
  std::uint32_t find(std::string_view code) const {
    const auto number = [this](auto row) { return static_cast<std::uint32_t>(row - rows_.begin()); };
    const auto first = rows_.begin() + static_cast<std::ptrdiff_t>(leading_);
    const auto sorted =
        std::lower_bound(first, rows_.end(), code,
                         [](const ig_diagnostic_decl& row, std::string_view sought) { return row.code < sought; });
    if (sorted != rows_.end() && sorted->code == code) return number(sorted);
    const auto leading = std::find_if(rows_.begin(), first, [code](const auto& row) { return row.code == code; });
    return leading != first ? number(leading) : no_such_row;
  }
  static constexpr std::uint32_t no_such_row = 0xffffffffu;

 private:
  static void explain(ig_diagnostic_decl& row) {
    if (row.explanation != nullptr) return;
    const EmbeddedDiagnostic* const words = embedded_diagnostic(row.code);
    row.explanation = words != nullptr ? words->explanation : "";
    row.example = words != nullptr ? words->example : "";
  }

  std::vector<ig_diagnostic_decl> rows_;
  std::size_t leading_ = 0;
};
inline DiagnosticTable& diagnostic_table() {
  static DiagnosticTable table;
  return table;
}

}  // namespace detail

/// Puts diagnostics that several syntaxes raise into the plugin: `const ig::Diagnostics
/// acme_shared_diagnostics{ig::diagnostic(…), …};` at namespace scope.
struct Diagnostics {
  Diagnostics(std::initializer_list<ig_diagnostic_decl> some) {
    detail::diagnostic_table().add({some.begin(), some.size()});
  }
};

}  // namespace ig
