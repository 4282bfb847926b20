/// The cases of an importer's page.
#pragma once

#include "isogloss/engine/cases.hpp"

namespace isogloss {

/// Empty when the case holds, else what differs, for people.
std::string run_import_case(const Page& page, const Case& one, const std::string& file, Library& library);

}  // namespace isogloss
