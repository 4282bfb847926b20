/// A linked chain seen as a whole: where each syntax comes from, who must stand before whom, who writes what for whom.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catalogue.hpp"

namespace isogloss::cli {

/// Why one syntax of a chain stands before another.
struct Relation {
  enum class Kind : std::uint8_t { declared, field, code };
  Kind kind;
  std::uint32_t first, second;     ///< positions in the chain
  std::vector<std::string> names;  ///< declared: by whom; else the fields, or the codes that both take
};
std::vector<Relation> relations(const LinkedDialect& linked);

/// "iso.xml:12", by the name of the file alone.
std::string short_place(const Location& where);
/// "G81 G82" and words, which the syntax takes.
std::vector<std::string> taken_codes(const LinkedSyntax& s, const Layout& layout);
/// The edit that put the element in, or null: then its dialect lists it.
const AppliedEdit* placing_edit(const Dialect& dialect, const std::string& alias);

/// Stages with their syntaxes in order: place, declared order, fields with their readers, codes.
/// {"Dialect", "File", "Extends": [names], "Stages": [{"Stage", "Syntaxes": [{"Position" from 1, "As", "Syntax",
///  "Plugin", "File", "Line", "After": [aliases], "Before": [aliases], "Takes": [codes],
///  "Writes": [{"Field", "For": [aliases]}]}]}]}
Json describe_chain(const LinkedDialect& linked);
std::string chain_as_text(const Json& chain);
/// `link`: where the box of a syntax leads, by its id, escaped; empty: nowhere.
std::string chain_as_svg(const Json& chain, const std::function<std::string(const std::string&)>& link = {});

/// Where one syntax of the chain comes from, and what must stand before and after it. A place is {"File", "Line"}.
/// {"Dialect", "As", "Syntax", "Plugin", "Stage", "Position", "Of", "Place", "PlacedBy": {"Edit", "Anchor", "Dialect"},
///  "Options": [{"Name", "Value", "Place"}], "Edits": [{"Edit", "Dialect", "Place"}], "Takes": [codes],
///  "MustFollow" and "MustPrecede": [{"Syntax", "Declared", "Because": [sentences]}]}
Json describe_why(const LinkedDialect& linked, std::uint32_t position);
std::string why_as_text(const Json& why);

/// What differs, one row each; null where a side has none. Part: file, plugin, table, table option, row, initial,
/// chain, moved, option. A place is "FILE:LINE".
/// {"Left", "Right", "Same", "Differences": [{"Part", "Name", "Left", "Right", "LeftPlace", "RightPlace"}]}
Json describe_difference(const Dialect& left, const Dialect& right, Library& library);
std::string difference_as_text(const Json& difference);

}  // namespace isogloss::cli
