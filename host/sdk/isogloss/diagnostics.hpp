/// Diagnostics: declared where they belong, raised by their codes.
///
/// A syntax lists its own in a member `static constexpr std::array diagnostics{ig::diagnostic(…), …}`; what several
/// syntaxes of a plugin raise stands in one `const ig::Diagnostics` at namespace scope. What a diagnostic means, with
/// an example, stands under "Diagnostics" on the page of the syntax, or on the page beside the shared list.
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

/// A row of the plugin's table. `text` has {0}, {1} … where the arguments of Block::report() go. Without an explanation
/// and an example those of the page count.
constexpr ig_diagnostic_decl diagnostic(ig_severity severity, const char* code, const char* text,
                                        const char* explanation = nullptr, const char* example = nullptr) {
  return {sizeof(ig_diagnostic_decl), severity, code, text, explanation, example};
}

/// The code of a diagnostic that some file of the plugin declares.
struct DiagnosticCode {
  std::string_view code;
  friend constexpr bool operator==(DiagnosticCode, DiagnosticCode) = default;
};

/// diag("ACME-0001"); what is no code does not compile: two to four capitals, a hyphen, four digits.
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

/// The table of one plugin. Its files put their diagnostics in before the entry function can be called.
class DiagnosticTable {
 public:
  void add(std::span<const ig_diagnostic_decl> some) { rows_.insert(rows_.end(), some.begin(), some.end()); }

  /// In the order of codes, each once, with the words of the pages. `leading` keep their places, which are their
  /// numbers.
  std::span<const ig_diagnostic_decl> complete(std::span<const ig_diagnostic_decl> leading) {
    std::stable_sort(rows_.begin(), rows_.end(), is_before);
    rows_.erase(std::unique(rows_.begin(), rows_.end(),
                            [](const auto& a, const auto& b) { return a.code == std::string_view(b.code); }),
                rows_.end());
    for (ig_diagnostic_decl& row : rows_) explain(row);
    leading_ = leading.size();
    rows_.insert(rows_.begin(), leading.begin(), leading.end());
    return rows_;
  }

  /// The number of a code, or no_such_row.
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

/// `const ig::Diagnostics acme_shared_diagnostics{ig::diagnostic(…), …};` puts what several syntaxes raise into the
/// plugin.
struct Diagnostics {
  Diagnostics(std::initializer_list<ig_diagnostic_decl> some) {
    detail::diagnostic_table().add({some.begin(), some.size()});
  }
};

}  // namespace ig
