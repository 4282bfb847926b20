/// The pages that isogloss_add_plugin() embeds in a plugin.
#pragma once

namespace ig {

/// The text of `stem`.md, which stood beside the plugin's sources, or nullptr. Static storage; any thread.
const char* embedded_page(const char* stem) noexcept;

}  // namespace ig
