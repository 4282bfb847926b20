/// The pages that isogloss_add_plugin() embeds in a plugin.
#pragma once

namespace ig {

/// The text of `stem`.md (of `name`.cases.md: `name`.cases), which stood beside the plugin's sources, or nullptr.
/// Static storage; any thread.
const char* embedded_page(const char* stem) noexcept;

/// The folder of that page below the plugin's CMakeLists.txt ("cycles"), or nullptr where it stands beside that.
const char* embedded_folder(const char* stem) noexcept;

/// What a page says of a diagnostic: an item `* **ACME-0001** (error): in short.` with the explanation on the lines
/// below it, the last of which may be `Example: …`.
struct EmbeddedDiagnostic {
  const char* code;
  const char* explanation;
  const char* example;
};

/// Of the pages that stood beside the plugin's sources, or nullptr. Static storage; any thread.
const EmbeddedDiagnostic* embedded_diagnostic(const char* code) noexcept;

}  // namespace ig
