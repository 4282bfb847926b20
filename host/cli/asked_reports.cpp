#include "asked_reports.hpp"

#include <algorithm>
#include <string>

namespace isogloss::cli {

bool AskedReports::is_new(const Diagnostic& d) {
  std::size_t name = std::hash<std::string>{}(d.code);
  const auto add = [&name](std::size_t more) { name = (name ^ more) * 1099511628211u; };
  add(std::hash<std::string>{}(d.message));
  add(std::hash<std::string>{}(d.where.file));
  add(d.where.line);
  add(d.where.column);
  return seen_.insert(name).second;
}

void AskedReports::add(Diagnostic diagnostic) {
  constexpr std::size_t most = 100'000, most_at_a_place = 20;
  if (is_error(diagnostic)) ++errors_;
  const bool is_kept = is_wanted_(diagnostic);
  if (!is_kept && is_error(diagnostic)) {
    const auto is_elsewhere = [&](const Location& at) {
      return at.line != diagnostic.where.line || at.file != diagnostic.where.file;
    };
    if (!last_errors.empty() && is_elsewhere(last_errors.front().where)) last_errors.clear();
    const bool is_there = std::any_of(last_errors.begin(), last_errors.end(), [&](const Diagnostic& d) {
      return d.where.column == diagnostic.where.column && d.message == diagnostic.message;
    });
    if (!is_there && last_errors.size() < most_at_a_place) last_errors.push_back(std::move(diagnostic));
  } else if (is_kept && all.size() < most && is_new(diagnostic)) {
    all.push_back(std::move(diagnostic));
  }
}

void AskedReports::end_at_errors(RunOptions& options, std::uint64_t most) {
  options.goes_on = [this, most, before = options.goes_on] {
    has_ended_run_ = has_ended_run_ || (most != 0 && errors_ >= most);
    return !has_ended_run_ && (!before || before());
  };
}

}  // namespace isogloss::cli
