// The entry of the tables plugin: importers of files that belong to no brand with a dialect of its own.
#include <isogloss/sdk.hpp>

ISOGLOSS_PLUGIN("tables", "1.0.0", "Isogloss")
