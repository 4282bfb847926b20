// Tries properties on random programs of each dialect. A program that breaks one is made as short as it gets and
// printed.
//
//   isogloss_properties [--seed S] [--cases N] [--dialect D] [--property P] [--case NUMBER | --file FILE] [--all]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>

#include "budget.hpp"
#include "shrink.hpp"

namespace isogloss::properties {

namespace {

constexpr Property properties[] = {
    {"bytes", 100, judge_bytes},
    {"foreign-words", 40, judge_foreign_words},
    {"blanks", 100, judge_blanks},
    {"order", 100, judge_order, is_iso},
    {"numbers", 100, judge_numbers},
    {"canonical", 100, judge_canonical},
    {"halves", 36, judge_halves},
    {"ahead", 10, judge_ahead},
    {"machine", 100, judge_machine},
    {"units", 100, judge_units, has_plain_words},
    {"modal", 100, judge_modal, has_plain_words},
    {"distances", 100, judge_distances, has_plain_words},
};

struct Wanted {
  std::uint64_t seed = 1;
  int cases = 0;  ///< 0: as many as the property says
  std::string dialect, property, file;
  std::optional<std::uint64_t> number;  ///< this case alone
  bool goes_on = false;                 ///< behind the first fault of a property in a dialect
};

void report(const Property& property, const Wanted& wanted, std::uint64_t number, const Case& program) {
  const Case shortest = shrink(property, program);
  const std::string file = "property-" + std::string(property.name) + "-" + program.dialect + ".nc";
  std::ofstream(file, std::ios::binary) << shortest.text();
  std::printf("%s in %s, seed %llu, case %llu, shortened to %s:\n%s%s\n", property.name, program.dialect.c_str(),
              static_cast<unsigned long long>(wanted.seed), static_cast<unsigned long long>(number), file.c_str(),
              shortest.text().c_str(), property.judge(shortest).fault.c_str());
  std::printf("again: isogloss_properties --seed %llu --dialect %s --property %s --case %llu\n\n",
              static_cast<unsigned long long>(wanted.seed), program.dialect.c_str(), property.name,
              static_cast<unsigned long long>(number));
}

/// How many cases broke the property.
int try_property(const Property& property, const std::string& dialect, const Wanted& wanted) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const int cases = wanted.cases != 0 ? wanted.cases : isogloss_test::budgeted(property.cases);
  int tried = 0, broken = 0, run = 0;
  for (std::uint64_t number = wanted.number.value_or(0);; ++number) {
    if (run == (wanted.number ? 1 : cases) || (broken != 0 && !wanted.goes_on)) break;
    ++run;
    const Case program = make_case(dialect, wanted.seed, number);
    const Verdict verdict = property.judge(program);
    tried += verdict.was_tried ? 1 : 0;
    if (verdict.fault.empty()) continue;
    ++broken;
    report(property, wanted, number, program);
  }
  const std::chrono::duration<double> seconds = Clock::now() - start;
  std::printf("%s.%s: %d programs, tried on %d, broken by %d, %.1f s\n", property.name, dialect.c_str(), run, tried,
              broken, seconds.count());
  std::fflush(stdout);
  // A property that is tried on nothing tests nothing.
  const bool is_empty = tried == 0 && !wanted.number && (property.fits == nullptr || property.fits(dialect));
  if (is_empty) std::printf("%s.%s: no program to try it on\n", property.name, dialect.c_str());
  return broken + (is_empty ? 1 : 0);
}

int try_file(const Wanted& wanted) {
  std::ifstream in(wanted.file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  int broken = 0;
  for (const Property& property : properties) {
    if (!wanted.property.empty() && wanted.property != property.name) continue;
    const Verdict verdict = property.judge(case_of_text(wanted.dialect, wanted.seed, text));
    std::printf("%s: %s\n", property.name, verdict.fault.empty() ? "holds" : verdict.fault.c_str());
    broken += verdict.fault.empty() ? 0 : 1;
  }
  return broken;
}

int main_of(int argc, char** argv) {
  Wanted wanted;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const char* const value = i + 1 < argc ? argv[i + 1] : "";
    if (option == "--all") {
      wanted.goes_on = true;
      continue;
    }
    ++i;
    if (option == "--seed")
      wanted.seed = std::strtoull(value, nullptr, 10);
    else if (option == "--cases")
      wanted.cases = std::atoi(value);
    else if (option == "--dialect")
      wanted.dialect = value;
    else if (option == "--property")
      wanted.property = value;
    else if (option == "--case")
      wanted.number = std::strtoull(value, nullptr, 10);
    else if (option == "--file")
      wanted.file = value;
    else
      return std::fprintf(stderr, "there is no option %s\n", option.c_str()), 2;
  }
  int broken = 0;
  if (!wanted.file.empty()) return try_file(wanted) == 0 ? 0 : 1;
  for (const Property& property : properties)
    for (const std::string& dialect : dialect_names()) {
      const bool is_wanted = (wanted.property.empty() || wanted.property == property.name) &&
                             (wanted.dialect.empty() || wanted.dialect == dialect);
      if (is_wanted) broken += try_property(property, dialect, wanted);
    }
  return broken == 0 ? 0 : 1;
}

}  // namespace

}  // namespace isogloss::properties

int main(int argc, char** argv) {
  try {
    return isogloss::properties::main_of(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "an exception comes out: %s\n", e.what());
    return 1;
  }
}
