#include "validate/option_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "markup.hpp"

namespace isogloss::cli {

namespace {

/// In the form of dialect files, which knows no exponent.
std::string number_text(double number) {
  std::string out = fmt::format("{:.17f}", number);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.ends_with('.')) out.pop_back();
  return out;
}

}  // namespace

std::string any_value(const ig_option_decl& o) {
  switch (o.type) {
    case IG_OPTION_NUMBER:
    case IG_OPTION_INTEGER: return fmt::format("{}", std::isfinite(o.minimum) ? o.minimum : std::fmin(o.maximum, 1));
    case IG_OPTION_BOOLEAN: return "true";
    case IG_OPTION_CHOICE: return std::string(o.choices).substr(0, std::string_view(o.choices).find('|'));
    case IG_OPTION_FIELDS: return "Parsing.X";
    default: return "A";
  }
}

std::vector<Candidate> candidates(const ig_option_decl& o) {
  std::vector<Candidate> out;
  switch (o.type) {
    case IG_OPTION_NUMBER:
    case IG_OPTION_INTEGER:
      if (std::isfinite(o.minimum)) {
        out.push_back({number_text(o.minimum)});
        out.push_back({number_text(o.minimum - 1), false});
      }
      if (std::isfinite(o.maximum)) {
        out.push_back({number_text(o.maximum)});
        out.push_back({number_text(o.maximum + 1), false});
      }
      out.push_back({"a word", false});
      break;
    case IG_OPTION_BOOLEAN: out = {{"true"}, {"false"}, {"perhaps", false}}; break;
    case IG_OPTION_CHOICE:
      for (std::string_view rest = o.choices; !rest.empty();) {
        const std::size_t end = std::min(rest.find('|'), rest.size());
        out.push_back({std::string(rest.substr(0, end))});
        rest.remove_prefix(std::min(end + 1, rest.size()));
      }
      out.push_back({"no such choice", false});
      break;
    case IG_OPTION_FIELDS: out = {{"", true, true}, {"Parsing.X Parsing.**", true, true}}; break;
    default: out = {{"", true, true}, {"A", true, true}, {"12", true, true}, {std::string(60'000, 'A'), true, true}};
  }
  return out;
}

std::string random_value(const ig_option_decl& o, std::mt19937_64& random) {
  switch (o.type) {
    case IG_OPTION_NUMBER:
    case IG_OPTION_INTEGER: {
      const double least = std::isfinite(o.minimum) ? std::ceil(o.minimum) : std::fmin(-10, o.maximum);
      const double most = std::isfinite(o.maximum) ? std::floor(o.maximum) : std::fmax(1000, o.minimum);
      const double range = std::fmin(std::fmax(most - least, 0), 1e9);
      // Small numbers mean something more often than large ones.
      const double end = random() % 2 == 0 ? std::fmin(range, 20) : range;
      return number_text(least + static_cast<double>(random() % (static_cast<std::uint64_t>(end) + 1)));
    }
    case IG_OPTION_BOOLEAN: return random() % 2 == 0 ? "true" : "false";
    case IG_OPTION_CHOICE: {
      const std::vector<Candidate> all = candidates(o);
      return all[random() % (all.size() - 1)].value;  // the last one is no choice
    }
    default: return o.fallback != nullptr ? o.fallback : any_value(o);
  }
}

std::string other_options(const ig_syntax& syntax, std::uint64_t seed) {
  if (syntax.option_count == 0) return {};
  std::mt19937_64 random(seed);
  std::string out = "<" + std::string(syntax.id);
  constexpr int tries = 16;
  for (std::uint32_t i = 0; i < syntax.option_count; ++i) {
    const ig_option_decl& o = syntax.options[i];
    std::string value = random_value(o, random);
    for (int k = 0; k < tries && o.fallback != nullptr && value == o.fallback; ++k) value = random_value(o, random);
    out += fmt::format(" {}=\"{}\"", o.name, escaped_xml(value));
  }
  return out + "/>";
}

}  // namespace isogloss::cli
