/// Codes of a control that a dialect knows by name but does not execute: each gets one diagnostic that says what is
/// missing, and its words are taken with it.
#pragma once

#include <vector>

#include "isogloss/cnc/leftovers.hpp"

namespace ig::cnc {

/// A member of the syntax that reports such codes.
class RecognisedCodes {
 public:
  /// Codes with one reason. Give their words no unit, `X[]`: nothing reads the values, so a missing decimal point needs
  /// no report.
  struct Feature {
    Call codes;
    std::string_view missing;
  };
  /// The arguments of the diagnostic are the code and `missing`.
  RecognisedCodes(DiagnosticCode diagnostic, std::vector<Feature> features)
      : diagnostic_(diagnostic), features_(std::move(features)) {}

  /// Takes and reports every such code that no syntax has answered; true when the block held one.
  bool report(Block& b) const {
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
