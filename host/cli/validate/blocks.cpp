// One build on blocks that a program may hold, and on some that it should not.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

std::string trying(const Stand& stand, const TestBlock& block) {
  return std::string(stand.syntax->id) + ", " + block.name;
}

/// A syntax that takes no word may do all of its work before the first block; then its build() serves the cases of its
/// page alone.
bool is_ever_called(const ig_syntax& syntax) {
  const auto has_field = [&](unsigned access) {
    return std::any_of(syntax.fields, syntax.fields + syntax.field_count,
                       [&](const ig_field_decl& f) { return (f.access & access) != 0; });
  };
  return syntax.build == nullptr || syntax.inspects != 0 || has_field(IG_WAKE | IG_WAKE_WHILE) ||
         (syntax.restart != nullptr && !has_field(IG_TAKE));
}

/// Calls `judge` with each block of the cases, and with a block in which each declared field has a value.
template <class Judge>
void on_each_block(Examination& e, Mode mode, Judge&& judge) {
  Subject subject(e);
  for (Stand& stand : stands_of(subject, e)) {
    stand.blocks.push_back(full_block(stand.alone, fields_of(stand.alone)));
    Bench bench(stand.alone, in_mode(mode));
    for (const TestBlock& block : stand.blocks) {
      e.attempt(trying(stand, block));
      judge(stand, block, bench);
    }
  }
}

}  // namespace

void check_empty_block(Examination& e) {
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const TestBlock empty{.name = "an empty block"};
    e.attempt(trying(stand, empty));
    Bench bench(stand.alone, in_mode(Mode::checked));
    if (const std::string fault = bench.run(empty, false).fault(); !fault.empty()) e.find(trying(stand, empty), fault);
  }
}

void check_absent_fields(Examination& e) {
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const std::vector<ig_field> fields = fields_of(stand.alone);
    const std::vector<FieldInfo>& infos = stand.alone.linked->layout.fields;
    Bench bench(stand.alone, in_mode(Mode::checked));
    const auto without_each = [&](TestBlock block) {
      const std::string name = block.name;
      for (const ig_field f : fields) {
        block.absent = {f};
        block.name = name + " without " + infos[f].path;
        e.attempt(trying(stand, block));
        if (const std::string fault = bench.run(block, false).fault(); !fault.empty())
          e.find(trying(stand, block), fault);
      }
    };
    without_each(full_block(stand.alone, fields));
    for (const TestBlock& block : stand.blocks)
      if (!block.before.is_null()) without_each(block);
  }
}

void check_extreme_values(Examination& e) {
  constexpr double numbers[] = {std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity(),
                                1e308,
                                -1e308,
                                std::numeric_limits<double>::denorm_min()};
  constexpr std::int64_t integers[] = {INT64_MAX, INT64_MIN, -1};
  constexpr std::int64_t ordinals[] = {500, 32'767};  // of codes of two bytes in the longest text that columns reach
  const std::string huge(1 << 20, 'A');
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const std::vector<ig_field> fields = fields_of(stand.alone);
    const std::vector<FieldInfo>& infos = stand.alone.linked->layout.fields;
    // As in a run: the fast table does not look at the values.
    Bench bench(stand.alone, in_mode(Mode::fast));
    const auto judge = [&](const TestBlock& block) {
      e.attempt(trying(stand, block));
      if (const std::string fault = bench.run(block, false).fault(true); !fault.empty())
        e.find(trying(stand, block), fault);
    };
    const auto with = [&](TestBlock block, const Assignment& a, const std::string& value) {
      block.name += " where " + infos[a.field].path + " is " + value;
      block.assignments.push_back(a);
      judge(block);
    };
    TestBlock full = full_block(stand.alone, fields);
    for (const ig_field f : fields) {
      const ig_type type = infos[f].type;
      if (type == IG_NUMBER || type == IG_TRANSFORM) {
        for (const double number : numbers) {
          const Assignment a{f, {.number = number}, {}};
          with(full, a, std::to_string(number));
          for (const TestBlock& block : stand.blocks)
            if (!block.before.is_null() && (std::isnan(number) || number == 1e308))
              with(block, a, std::to_string(number));
        }
      } else if (type == IG_INTEGER) {
        for (const std::int64_t number : integers) with(full, {f, {.integer = number}, {}}, std::to_string(number));
      } else if (type == IG_CODE) {
        for (const std::int64_t ordinal : ordinals)
          with(full, {f, {.integer = ordinal}, {}}, fmt::format("code {} of its block", ordinal));
      } else if (type == IG_TEXT) {
        with(full, {f, {}, huge}, "a text of 1 MiB");
        with(full, {f, {}, std::string("\0\xff\n\"", 4)}, "a text of control characters");
        with(full, {f, {}, ""}, "an empty text");
        for (const std::string& text : odd_texts()) with(full, {f, {}, text}, fmt::format("the text {:?}", text));
      }
    }
    for (const std::string& text : odd_texts()) {
      TestBlock block = full;
      block.name += fmt::format(" of the text {:?}", text);
      block.text = text;
      judge(block);
    }
    for (const double number : numbers) judge(block_of_numbers(stand, number));
    if (stand.syntax->scan != nullptr) {
      judge({.name = "a text of 20,000 bytes", .text = std::string(20'000, stand.syntax->triggers[0])});
      judge({.name = "a number of 20,000 digits",
             .text = std::string(1, stand.syntax->triggers[0]) + std::string(20'000, '9')});
    }
  }
}

void check_finite_results(Examination& e) {
  constexpr double numbers[] = {1e308, -1e308};
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const std::vector<ig_field> fields = fields_of(stand.alone);
    const std::vector<FieldInfo>& infos = stand.alone.linked->layout.fields;
    Bench bench(stand.alone, in_mode(Mode::checked));
    const auto judge = [&](TestBlock block, ig_field f, double number) {
      block.name += fmt::format(" where {} is {}", infos[f].path, number);
      block.assignments.push_back({f, {.number = number}, {}});
      e.attempt(trying(stand, block));
      for (const Diagnostic& d : bench.run(block, false).diagnostics)
        if (d.code == "IG-0402" && d.message.find("not a number") != std::string::npos)
          e.find(trying(stand, block), d.message + " [IG-0402]");
    };
    std::vector<TestBlock> blocks = stand.blocks;
    blocks.push_back(full_block(stand.alone, fields));
    for (const TestBlock& block : blocks)
      for (const ig_field f : fields)
        for (const double number : numbers)
          if (infos[f].type == IG_NUMBER && infos[f].path.starts_with("Parsing.")) judge(block, f, number);
  }
}

void check_declarations(Examination& e) {
  {
    const Subject subject(e);
    for (const ig_syntax* syntax : subject.syntaxes())
      if (!is_ever_called(*syntax))
        e.find(syntax->id, "no field wakes it, so its build() is never called; declare IG_WAKE for a field");
  }
  on_each_block(e, Mode::checked, [&](const Stand& stand, const TestBlock& block, Bench& bench) {
    for (const Diagnostic& d : bench.run(block, false).diagnostics)
      if (d.code == "IG-0402") e.find(trying(stand, block), d.message + " [IG-0402]");
  });
}

void check_unchanged(Examination& e) {
  on_each_block(e, Mode::fast, [&](const Stand& stand, const TestBlock& block, Bench& bench) {
    Trial trial = bench.run(block, false);
    trial.diagnostics.clear();
    if (const std::string fault = trial.fault(); !fault.empty()) e.find(trying(stand, block), fault);
  });
}

namespace {

/// Records of lists that the last build left in its block.
std::size_t records_of(Bench& bench) {
  std::size_t out = 0;
  for (const ListData& list : bench.chain().document().lists) out += list.count;
  return out;
}

/// Nanoseconds of one build, which a busy machine does not make larger: the least of several looks.
double build_time(Bench& bench, const TestBlock& block, double budget) {
  constexpr int first_look = 3, close_look = 15, looks = 4;
  double ns = bench.time(block, first_look);
  for (int i = 0; i < looks && ns > budget; ++i) ns = std::fmin(ns, bench.time(block, close_look));
  return ns;
}

}  // namespace

void check_time(Examination& e) {
  constexpr std::uint64_t random_ones = 30;
  constexpr double ns_of_part = 1000, ns_of_diagnostic = 3000;
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    Bench bench(stand.alone, in_mode(Mode::fast));
    for (const TestBlock& block : many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0)) {
      e.attempt(trying(stand, block));
      const std::size_t said = bench.run(block, false).diagnostics.size();
      // A random block has far more fields than a program, and a cycle of many steps takes longer than one of a few;
      // the host writes the text of a diagnostic within the build.
      const std::size_t parts = records_of(bench) + block.assignments.size();
      const double budget = static_cast<double>(e.options.budget) + ns_of_part * static_cast<double>(parts) +
                            ns_of_diagnostic * static_cast<double>(said);
      const double ns = build_time(bench, block, budget);
      if (ns <= budget) continue;
      std::string more;
      if (parts > 0) more += fmt::format(" and {} ns for each of its {} fields and records", ns_of_part, parts);
      if (said > 0) more += fmt::format(" and {} ns for each of its {} diagnostics", ns_of_diagnostic, said);
      e.find(trying(stand, block),
             fmt::format("its build takes {:.0f} ns, more than the budget of {} ns{}", ns, e.options.budget, more));
    }
  }
}

void check_waits(Examination& e) {
  constexpr std::uint64_t random_ones = 200;
  constexpr int tries = 3;  // the first build of a kind may wait for the library's own pages
  // How often this thread gave up the processor of its own accord, which a busy machine does not change.
  const auto waits = [] {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nvcsw;
  };
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    Bench bench(stand.alone, in_mode(Mode::fast));
    for (const TestBlock& block : many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0)) {
      e.attempt(trying(stand, block));
      bool always_waits = true;
      for (int i = 0; i < tries && always_waits; ++i) {
        bench.prepare(block);
        const long before = waits();
        bench.scan();
        bench.build();
        always_waits = waits() > before;
      }
      if (!always_waits) continue;
      e.find(trying(stand, block), "its build waits: it sleeps, or it reads or writes outside of the block");
      break;
    }
  }
}

}  // namespace isogloss::cli
