/// Names that follow from the name of a plugin (of a type, a file, a namespace), and text as sources hold it.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace isogloss::cli {

/// Letters, digits and single hyphens, beginning with a letter, and no word of C++ or CMake.
bool is_plugin_name(std::string_view name);

/// "AcmeClamp" for "acme-clamp".
std::string type_name_of(std::string_view name);

/// "acme_g181_cycle_syntax" for "AcmeG181CycleSyntax": the name of the file of a syntax, as the SDK derives it.
std::string snake_case(std::string_view id);

/// ASCII letters alone change.
std::string lower_case(std::string_view name);
std::string upper_case(std::string_view name);

/// "acme_clamp" for "acme-clamp".
std::string identifier(std::string_view name);

/// "ACME" for "acme-clamp": the first four letters, as a prefix of diagnostics.
std::string prefix_of(std::string_view name);

/// Two to eight capitals.
bool is_prefix(std::string_view prefix);

/// For a literal of C and C++.
std::string escaped_literal(std::string_view text);

/// No control characters.
bool is_one_line(std::string_view text);

/// {"M171", "M172"} for "m171,m172"; two empty texts where these are not two M codes of up to four digits.
std::pair<std::string, std::string> switch_codes(std::string_view codes);

/// "G181" for "g181"; empty where it is no G code of up to three digits.
std::string cycle_code(std::string_view code);

}  // namespace isogloss::cli
