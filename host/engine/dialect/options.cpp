#include "dialect/options.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace isogloss {

std::optional<double> parse_number(std::string_view text) {
  const bool has_plus = text.starts_with('+');
  if (has_plus) text.remove_prefix(1);
  if (text.empty() || (has_plus && text[0] == '-') || text.find_first_not_of("0123456789.-") != std::string_view::npos)
    return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<OptionValue> parse_option(const ig_option_decl& option, std::string_view text) {
  OptionValue out;
  out.text = std::string(text);
  switch (option.type) {
    case IG_OPTION_TEXT:
    case IG_OPTION_FIELDS: return out;
    case IG_OPTION_NUMBER: {
      const std::optional<double> v = parse_number(text);
      if (!v || *v < option.minimum || *v > option.maximum) return std::nullopt;
      out.number = *v;
      return out;
    }
    case IG_OPTION_INTEGER: {
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.integer);
      if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
      out.number = static_cast<double>(out.integer);
      if (out.number < option.minimum || out.number > option.maximum) return std::nullopt;
      return out;
    }
    case IG_OPTION_BOOLEAN:
      if (text != "true" && text != "false") return std::nullopt;
      out.integer = text == "true" ? 1 : 0;
      return out;
    case IG_OPTION_CHOICE: {
      std::string_view rest = option.choices;
      for (std::int64_t i = 0; !rest.empty(); ++i) {
        const std::size_t bar = rest.find('|');
        if (rest.substr(0, bar) == text) {
          out.integer = i;
          return out;
        }
        rest = bar == std::string_view::npos ? std::string_view{} : rest.substr(bar + 1);
      }
      return std::nullopt;
    }
    default: return std::nullopt;
  }
}

std::string describe_option(const ig_option_decl& option) {
  const auto range = [&](std::string what) {
    if (std::isfinite(option.minimum) && std::isfinite(option.maximum))
      return fmt::format("{} from {} to {}", what, option.minimum, option.maximum);
    if (std::isfinite(option.minimum)) return fmt::format("{} of at least {}", what, option.minimum);
    if (std::isfinite(option.maximum)) return fmt::format("{} of at most {}", what, option.maximum);
    return what;
  };
  switch (option.type) {
    case IG_OPTION_NUMBER: return range("a number");
    case IG_OPTION_INTEGER: return range("a whole number");
    case IG_OPTION_BOOLEAN: return "true or false";
    case IG_OPTION_CHOICE: {
      std::string out = "one of ";
      for (const char* c = option.choices; *c != '\0'; ++c) out += *c == '|' ? std::string(", ") : std::string(1, *c);
      return out;
    }
    case IG_OPTION_FIELDS: return "field patterns";
    default: return "text";
  }
}

}  // namespace isogloss
