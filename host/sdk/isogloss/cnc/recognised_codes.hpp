/// Codes of one control that are known by name but not executed: each is one diagnostic that says what is missing, and
/// its words go with it.
#pragma once

#include <vector>

#include "isogloss/cnc/leftovers.hpp"

namespace ig::cnc {

class RecognisedCodes {
 public:
  /// Give the words no unit, `X[]`: nobody reads them, and a decimal point that is missing there is no news.
  struct Feature {
    Call codes;
    std::string_view missing;
  };
  /// The diagnostic gets the code and what is missing.
  RecognisedCodes(DiagnosticCode diagnostic, std::vector<Feature> features)
      : diagnostic_(diagnostic), features_(std::move(features)) {}

  /// True where the block had one.
  bool say(Block& b) const {
    bool any = false;
    for (const Feature& feature : features_)
      for (std::uint32_t row = 0; row < feature.codes.code_count(); ++row) any |= take(b, feature, row);
    return any;
  }

 private:
  bool take(Block& b, const Feature& feature, std::uint32_t row) const {
    const ig_field code = feature.codes.code(row);
    if (!is_unanswered(b, code)) return false;
    std::uint32_t found = 0;
    ig_value unused[32];
    b.take_code(&code, 1, &found);
    b.take_many(feature.codes.row(row), static_cast<std::uint32_t>(feature.codes.letters().size()), unused);
    b.report(diagnostic_, Where::word(code), b.text(feature.codes.name(row)), feature.missing);
    return true;
  }

  DiagnosticCode diagnostic_;
  std::vector<Feature> features_;
};

}  // namespace ig::cnc
