/// The results of a batch, a line for each program, in files for programs and for people.
#pragma once

#include <map>

#include "batch/batch_arguments.hpp"
#include "batch/program_work.hpp"

namespace isogloss::cli::batch {

/// What is told of a program: how its process ended and what it has written. It holds nothing that another run of the
/// same would tell differently, such as times of the clock.
Json result_of(const std::string& program, const ChildEnd& end, const std::optional<Work>& work,
               const ChildLimits& limits);

/// The exit status that the result stands for.
int status_of(const Json& result);

/// "1 program", "12 programs".
std::string programs_in_words(std::uint64_t count);

/// The files of a batch's folder: results.jsonl, results.csv, results.xml (JUnit) and overview.html.
class ResultFiles {
 public:
  /// In the order of the programs.
  void add(const Json& result);
  /// All of them, or none: false, and reported, when one cannot be written.
  bool write(const std::string& folder, Session& session) const;
  /// "12 programs: 10 ok, 2 with errors".
  std::string in_words() const;

 private:
  std::string as_csv() const;
  std::string as_junit() const;
  std::string as_html() const;

  std::string lines_, csv_, cases_, rows_;
  std::map<std::string, std::uint64_t> by_status_;
  std::uint64_t count_ = 0;
};

}  // namespace isogloss::cli::batch
