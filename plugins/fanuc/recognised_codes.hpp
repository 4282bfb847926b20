/// Codes of one brand that are known by name but not executed: each is an error that says what is missing, and its
/// words go with it.
#pragma once

#include <vector>

#include "brand_diagnostics.hpp"
#include "leftovers.hpp"

namespace fanuc {

class RecognisedCodes {
 public:
  struct Feature {
    ig::Call codes;
    std::string_view missing;
  };
  explicit RecognisedCodes(std::vector<Feature> features) : features_(std::move(features)) {}

  ig::Status say(ig::Block& b) const {
    bool any = false;
    for (const Feature& feature : features_)
      for (std::uint32_t row = 0; row < feature.codes.code_count(); ++row) any |= take(b, feature, row);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static bool take(ig::Block& b, const Feature& feature, std::uint32_t row) {
    const ig_field code = feature.codes.code(row);
    if (!iso::is_unanswered(b, code)) return false;
    std::uint32_t found = 0;
    ig_value unused[32];
    b.host()->take_code(b.raw(), &code, 1, &found);
    b.host()->take_many(b.raw(), feature.codes.row(row), static_cast<std::uint32_t>(feature.codes.letters().size()),
                        unused);
    b.report(brand_diag("FAN-0201"), ig::Where::word(code), b.text(feature.codes.name(row)), feature.missing);
    return true;
  }

  std::vector<Feature> features_;
};

}  // namespace fanuc
