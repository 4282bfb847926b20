/// The Markdown pages that isogloss_add_plugin() embeds in a plugin, and the diagnostics that they explain.
#pragma once

namespace ig {

/// The text of `stem`.md, or nullptr where the plugin has no such page; the stem of name.cases.md is "name.cases".
/// Static storage; safe on any thread.
const char* embedded_page(const char* stem) noexcept;

/// The folder of that page below the plugin's CMakeLists.txt ("cycles"), or nullptr where it stands beside that.
const char* embedded_folder(const char* stem) noexcept;

/// What a page says about a diagnostic: an item `* **ACME-0001** (error): in short.`, the explanation on the lines
/// below it, and an example where the last line is `Example: …`.
struct EmbeddedDiagnostic {
  const char* code;
  const char* explanation;
  const char* example;
};

/// What the plugin's pages say about this code, or nullptr. Static storage; safe on any thread.
const EmbeddedDiagnostic* embedded_diagnostic(const char* code) noexcept;

}  // namespace ig
