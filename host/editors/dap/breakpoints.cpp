#include "dap/breakpoints.hpp"

#include <charconv>
#include <filesystem>

namespace isogloss::dap {

std::variant<HitCondition, std::string> HitCondition::parse(std::string_view text) {
  const auto skip_blanks = [&] {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  };
  constexpr std::pair<std::string_view, Kind> signs[] = {
      {">=", Kind::at_least}, {"<=", Kind::at_most}, {"==", Kind::equal}, {"=", Kind::equal},
      {">", Kind::more},      {"<", Kind::less},     {"%", Kind::every}};
  HitCondition out;
  skip_blanks();
  for (const auto& [sign, kind] : signs)
    if (text.starts_with(sign)) {
      out.kind_ = kind;
      text.remove_prefix(sign.size());
      break;
    }
  skip_blanks();
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.number_);
  const bool is_number = !text.empty() && error == std::errc() && end == text.data() + text.size();
  if (!is_number || (out.kind_ == Kind::every && out.number_ == 0))
    return "a hit count is a number such as 5, or >= 5, or % 5 for every fifth time";
  return out;
}

bool HitCondition::holds(std::uint64_t hits) const {
  switch (kind_) {
    case Kind::equal: return hits == number_;
    case Kind::at_least: return hits >= number_;
    case Kind::more: return hits > number_;
    case Kind::at_most: return hits <= number_;
    case Kind::less: return hits < number_;
    case Kind::every: return hits % number_ == 0;
  }
  return false;
}

std::variant<LogMessage, std::string> LogMessage::parse(std::string_view text, const Layout& layout) {
  LogMessage out;
  std::string plain;
  while (!text.empty()) {
    const char c = text.front();
    const bool is_doubled = (c == '{' || c == '}') && text.size() > 1 && text[1] == c;
    if (is_doubled || c != '{') {
      plain += c;
      text.remove_prefix(is_doubled ? 2 : 1);
      continue;
    }
    const std::size_t end = text.find('}');
    if (end == std::string_view::npos) return "a brace of the message is not closed";
    auto expression = Expression::parse(text.substr(1, end - 1), layout);
    if (auto* const fault = std::get_if<std::string>(&expression)) return std::move(*fault);
    out.pieces_.push_back({std::move(plain), std::get<Expression>(std::move(expression))});
    plain.clear();
    text.remove_prefix(end + 1);
  }
  out.pieces_.push_back({std::move(plain), std::nullopt});
  return out;
}

std::string LogMessage::fill(const Scene& scene, const VariableSource& variables) const {
  std::string out;
  for (const Piece& piece : pieces_) {
    out += piece.text;
    if (piece.expression) out += shown(piece.expression->evaluate(scene, variables));
  }
  return out;
}

std::string canonical_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path found = std::filesystem::weakly_canonical(path, error);
  return error ? path : found.string();
}

}  // namespace isogloss::dap
