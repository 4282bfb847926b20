/// Comma-separated values: the fields of a line, and the columns of tools that its head names.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/sdk.hpp>

namespace tables {

enum class CsvTarget {
  none,
  number,
  length,
  length_wear,
  radius,
  diameter,
  radius_wear,
  diameter_wear,
  corner,
  tip_angle,
  teeth,
  speed,
  name
};

/// A column. Without a unit it has that of the option.
struct CsvHead {
  CsvTarget target = CsvTarget::none;
  std::optional<bool> is_inch;
  std::string title;
};

struct CsvField {
  std::string text;  // without quotes and the blanks around it
  std::size_t begin = 0, end = 0;
};

inline bool is_blank_csv(std::string_view line) { return line.find_first_not_of(" \t,;") == std::string_view::npos; }

/// A comma that stands beside semicolons or tabs is a decimal sign.
inline char csv_separator(std::string_view line) {
  for (const char c : {';', '\t', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return '\0';
}

inline std::vector<CsvField> csv_fields(const ig::TextLine& line, char separator) {
  std::vector<CsvField> out(1);
  out.back().begin = line.begin;
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.text.size(); ++i) {
    const char c = line.text[i];
    CsvField& field = out.back();
    if (c == '"') {
      const bool is_text = is_quoted && i + 1 < line.text.size() && line.text[i + 1] == '"';
      if (is_text) field.text += line.text[++i];
      is_quoted = is_text || !is_quoted;
    } else if (c == separator && !is_quoted) {
      field.end = line.begin + i;
      out.emplace_back().begin = line.begin + i + 1;
    } else {
      field.text += c;
    }
  }
  out.back().end = line.begin + line.text.size();
  for (CsvField& field : out) {
    const std::size_t first = field.text.find_first_not_of(" \t");
    field.text.erase(field.text.find_last_not_of(" \t") + 1);
    field.text.erase(0, std::min(first, field.text.size()));
  }
  return out;
}

inline std::string letters_of(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) out += c;
  }
  return out;
}

/// "Tool length [mm]" is "toollength" in mm.
inline CsvHead csv_head(std::string_view title) {
  struct Name {
    std::string_view name;
    CsvTarget target;
  };
  static constexpr std::array names{
      Name{"id", CsvTarget::number},
      Name{"t", CsvTarget::number},
      Name{"no", CsvTarget::number},
      Name{"nr", CsvTarget::number},
      Name{"number", CsvTarget::number},
      Name{"tool", CsvTarget::number},
      Name{"toolid", CsvTarget::number},
      Name{"toolno", CsvTarget::number},
      Name{"toolnumber", CsvTarget::number},
      Name{"h", CsvTarget::length},
      Name{"l", CsvTarget::length},
      Name{"length", CsvTarget::length},
      Name{"toollength", CsvTarget::length},
      Name{"gaugelength", CsvTarget::length},
      Name{"z", CsvTarget::length},
      Name{"zoffset", CsvTarget::length},
      Name{"hwear", CsvTarget::length_wear},
      Name{"lwear", CsvTarget::length_wear},
      Name{"lengthwear", CsvTarget::length_wear},
      Name{"wearlength", CsvTarget::length_wear},
      Name{"r", CsvTarget::radius},
      Name{"radius", CsvTarget::radius},
      Name{"toolradius", CsvTarget::radius},
      Name{"rwear", CsvTarget::radius_wear},
      Name{"radiuswear", CsvTarget::radius_wear},
      Name{"wearradius", CsvTarget::radius_wear},
      Name{"d", CsvTarget::diameter},
      Name{"dia", CsvTarget::diameter},
      Name{"diameter", CsvTarget::diameter},
      Name{"tooldiameter", CsvTarget::diameter},
      Name{"dwear", CsvTarget::diameter_wear},
      Name{"diameterwear", CsvTarget::diameter_wear},
      Name{"weardiameter", CsvTarget::diameter_wear},
      Name{"r2", CsvTarget::corner},
      Name{"cornerradius", CsvTarget::corner},
      Name{"tipangle", CsvTarget::tip_angle},
      Name{"pointangle", CsvTarget::tip_angle},
      Name{"teeth", CsvTarget::teeth},
      Name{"flutes", CsvTarget::teeth},
      Name{"numberofteeth", CsvTarget::teeth},
      Name{"numberofflutes", CsvTarget::teeth},
      Name{"nmax", CsvTarget::speed},
      Name{"maximumspeed", CsvTarget::speed},
      Name{"maxspeed", CsvTarget::speed},
      Name{"name", CsvTarget::name},
      Name{"toolname", CsvTarget::name},
      Name{"description", CsvTarget::name},
      Name{"comment", CsvTarget::name},
  };
  CsvHead out;
  out.title = title;
  const std::size_t bracket = title.find_first_of("([");
  const std::string plain = letters_of(title.substr(0, bracket));
  if (bracket != std::string_view::npos) {
    const std::string in_brackets = letters_of(title.substr(bracket));
    if (in_brackets == "mm") out.is_inch = false;
    if (in_brackets == "in" || in_brackets == "inch" || in_brackets == "inches") out.is_inch = true;
  }
  for (const Name& known : names)
    if (known.name == plain) out.target = known.target;
  return out;
}

/// The numbers that a column of the table can hold.
constexpr double csv_least(CsvTarget target) { return target < CsvTarget::corner ? -1e9 : 0; }
constexpr double csv_most(CsvTarget target) {
  return target == CsvTarget::tip_angle ? 180 : target == CsvTarget::teeth ? 1000 : 1e9;
}

inline std::string_view csv_column(CsvTarget target) {
  switch (target) {
    case CsvTarget::length: return "H";
    case CsvTarget::length_wear: return "HWear";
    case CsvTarget::radius:
    case CsvTarget::diameter: return "D";
    case CsvTarget::radius_wear:
    case CsvTarget::diameter_wear: return "DWear";
    case CsvTarget::corner: return "CornerRadius";
    case CsvTarget::tip_angle: return "TipAngle";
    case CsvTarget::teeth: return "Teeth";
    case CsvTarget::speed: return "MaximumSpeed";
    case CsvTarget::name: return "Name";
    default: return target == CsvTarget::number ? "id" : "";
  }
}

}  // namespace tables
