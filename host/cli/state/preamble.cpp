#include "state/preamble.hpp"

#include <charconv>
#include <cmath>

namespace isogloss::cli {

namespace {

constexpr double mm_per_inch = 25.4;
constexpr std::string_view part = "restart ";

std::optional<double> number_of(std::string_view text) {
  double out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(out) : std::nullopt;
}

bool is_same(std::string_view a, std::string_view b) {
  const auto x = number_of(a), y = number_of(b);
  return x && y ? *x == *y : a == b;
}

bool is_one_of(std::string_view value, std::string_view choices) {
  for (std::size_t begin = 0; begin <= choices.size();) {
    const std::size_t end = std::min(choices.find('|', begin), choices.size());
    if (is_same(value, choices.substr(begin, end - begin))) return true;
    begin = end + 1;
  }
  return false;
}

bool holds_one(std::string_view condition, const StateFields& state) {
  const bool is_denied = condition.starts_with('!');
  if (is_denied) condition.remove_prefix(1);
  const std::size_t equals = std::min(condition.find('='), condition.size());
  const bool differs = equals > 0 && equals < condition.size() && condition[equals - 1] == '!';
  const auto found = state.find(condition.substr(0, equals - (differs ? 1 : 0)));
  if (equals == condition.size()) return (found != state.end()) != is_denied;
  if (found == state.end()) return false;
  std::string_view choices = condition.substr(equals + 1);
  if (choices.starts_with('@')) {
    const auto other = state.find(choices.substr(1));
    choices = other == state.end() ? std::string_view() : other->second;
  }
  return is_one_of(found->second, choices) != differs;
}

/// Eight decimals: an inch needs more than a millimetre.
std::string length(double mm, bool is_inch, bool is_plain) {
  const double value = is_inch ? mm / mm_per_inch : mm;
  return block_number(std::round(value * 1e8) / 1e8, true, is_plain);
}

class PreambleValues {
 public:
  PreambleValues(const ProgramPoint& point, const Layout& layout)
      : state_(fields_of(point.block.carried)), layout_(layout), point_(point) {
    const auto unit = state_.find("Unit.System");
    is_inch_ = unit != state_.end() && unit->second == "Inch";
  }
  const StateFields& state() const { return state_; }

  bool operator()(std::string_view name, std::string_view format, std::string& out) const {
    if (name == "LINE") return out += std::to_string(point_.block.where.line), true;
    const auto found = state_.find(name);
    if (found == state_.end()) return false;
    const auto number = number_of(found->second);
    if (!number) return out += found->second, true;
    const auto field = layout_.find(name);
    const bool is_length = format == "length" || (field && layout_.fields[*field].unit == "mm");
    const bool is_plain = format == "n" || (field && layout_.fields[*field].type != IG_NUMBER);
    out += length(*number, is_length && is_inch_, is_plain);
    return true;
  }

 private:
  StateFields state_;
  const Layout& layout_;
  const ProgramPoint& point_;
  bool is_inch_ = false;
};

}  // namespace

StateFields fields_of(const std::vector<ExplainedValue>& values) {
  StateFields out;
  for (const ExplainedValue& v : values) {
    const bool is_name = v.value.size() >= 2 && v.value.front() == '"';
    out[v.path] = is_name ? v.value.substr(1, v.value.size() - 2) : v.value;
  }
  return out;
}

bool holds(std::string_view when, const StateFields& state) {
  for (std::size_t begin = 0; begin < when.size();) {
    const std::size_t end = std::min(when.find(' ', begin), when.size());
    if (end > begin && !holds_one(when.substr(begin, end - begin), state)) return false;
    begin = end + 1;
  }
  return true;
}

bool has_preamble(const ProgramText& text) {
  for (const ProgramText::Row& row : text.rows)
    if (row.name.starts_with(part)) return true;
  return false;
}

std::string make_preamble(const ProgramText& text, const ProgramPoint& point, const Layout& layout) {
  const PreambleValues values(point, layout);
  std::string out;
  for (const ProgramText::Row& row : text.rows) {
    if (!row.name.starts_with(part) || !holds(row.when, values.state())) continue;
    std::string block;
    if (row.name.ends_with(" variable")) {
      for (const auto& [number, value] : point.variables) {
        if (!value) continue;
        block.clear();
        const auto assigned = [&, id = number, to = *value](std::string_view name, std::string_view,
                                                            std::string& line) {
          if (name == "VARIABLE") line += std::to_string(id);
          if (name == "VALUE") line += block_number(to, true);
          return name == "VARIABLE" || name == "VALUE";
        };
        if (row.block.fill(assigned, block)) out += block + "\n";
      }
    } else if (row.block.fill(std::cref(values), block)) {
      out += block + "\n";
    }
  }
  return out;
}

}  // namespace isogloss::cli
