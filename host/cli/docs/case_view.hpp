/// A case of a page, as its labelled fences: what goes in beside what comes out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "docs/addresses.hpp"

namespace isogloss::cli::docs {

/// "#BeforeBuild:" and the fence after it; or "#Diagnostics: any", which has none.
struct CasePart {
  std::string label;  ///< "BeforeBuild"
  std::string value;  ///< what stands behind the colon
  std::string text;
  bool has_fence = false;
};

/// "BeforeBuild" and "" of "#BeforeBuild:"; no label where the paragraph is none.
CasePart case_label(std::string_view paragraph);

std::string case_as_html(const std::vector<CasePart>& parts, const std::string& from_file, const Addresses& addresses);

}  // namespace isogloss::cli::docs
