#include "diff/motions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "diff/aligner.hpp"
#include "diff/match.hpp"
#include "diff/motion_stream.hpp"
#include "diff/values.hpp"
#include "run_progress.hpp"

namespace isogloss::cli::parting {

namespace {

using M = Motion;

/// Columns that are compared together, and by which measure.
struct Measure {
  enum class Kind : std::uint8_t { distance, angle, exact };
  const char* name;
  Kind kind;
  M::Column first;
  int count;
  const char* unit;
  const char* letters;  ///< one for each column
};
constexpr Measure measures[] = {{"machine position", Measure::Kind::distance, M::mx, 3, "mm", "XYZ"},
                                {"rotary axes", Measure::Kind::angle, M::a, 3, "deg", "ABC"},
                                {"program position", Measure::Kind::distance, M::px, 3, "mm", "XYZ"},
                                {"arc centre, machine", Measure::Kind::distance, M::mcx, 3, "mm", "XYZ"},
                                {"arc centre, program", Measure::Kind::distance, M::cx, 3, "mm", "XYZ"},
                                {"sweep of the arc", Measure::Kind::angle, M::sweep, 1, "deg", ""},
                                {"direction of the arc", Measure::Kind::exact, M::ccw, 1, "", ""},
                                {"turns of the arc", Measure::Kind::exact, M::circles, 1, "", ""},
                                {"normal of the arc", Measure::Kind::exact, M::nx, 3, "", "XYZ"},
                                {"feed", Measure::Kind::exact, M::feed, 1, "mm/s", ""},
                                {"value of the event", Measure::Kind::exact, M::value, 1, "", ""}};

std::string text_of(const Motion& m, const Measure& measure) {
  std::string out;
  for (int i = 0; i < measure.count; ++i) {
    const int column = measure.first + i;
    if ((m.known >> column & 1u) == 0) continue;
    out += (out.empty() ? "" : " ") +
           (measure.letters[0] != '\0' ? std::string(1, measure.letters[i]) : std::string()) +
           number_text(m.at[column]);
  }
  return out;
}

/// How far two motions are apart; negative: one of them has no such value.
double size_of(const Motion& a, const Motion& b, const Measure& measure) {
  double sum = 0, greatest = 0;
  for (int i = 0; i < measure.count; ++i) {
    const int column = measure.first + i;
    if (((a.known ^ b.known) >> column & 1u) != 0) return -1;
    const double apart = std::abs(a.at[column] - b.at[column]);
    sum += apart * apart;
    greatest = std::max(greatest, apart);
  }
  return measure.kind == Measure::Kind::distance ? std::sqrt(sum) : greatest;
}

bool is_within(double size, const Measure& measure, const Tolerance& tolerance) {
  constexpr double printed = 1e-6;  // the last decimal of a stream
  if (size < 0) return false;
  switch (measure.kind) {
    case Measure::Kind::distance: return size <= tolerance.mm;
    case Measure::Kind::angle: return size <= tolerance.degrees;
    default: return size <= printed;
  }
}

class MotionComparison {
 public:
  MotionComparison(MotionReport& report, bool keeps_all) : report_(report), keeps_all_(keeps_all) {}

  void add(const MotionBlock* a, const MotionBlock* b) {
    const auto size = [](const MotionBlock* block) {
      return block == nullptr ? 0 : static_cast<int>(block->motions.size());
    };
    report_.motions_a += static_cast<std::uint64_t>(size(a));
    report_.motions_b += static_cast<std::uint64_t>(size(b));
    const auto at = [](const MotionBlock* block, int i) -> const Motion* {
      return block == nullptr || i < 0 ? nullptr : &block->motions[static_cast<std::size_t>(i)];
    };
    for (const Match& m :
         match_in_order(size(a), size(b), [&](int i, int j) { return likeness(*at(a, i), *at(b, j)); }))
      compare(at(a, m.a), at(b, m.b), a, b);
  }

 private:
  int likeness(const Motion& a, const Motion& b) const {
    if (a.event != b.event || a.words != b.words) return 0;
    for (const Measure& measure : measures)
      if (!is_within(size_of(a, b, measure), measure, report_.tolerance)) return 2;
    return 3;
  }

  void compare(const Motion* a, const Motion* b, const MotionBlock* in_a, const MotionBlock* in_b) {
    bool parts = false;
    const auto note = [&](const std::string& kind, const char* unit, Deviation d) {
      parts = true;
      if (in_a != nullptr) d.file_a = in_a->file, d.line_a = in_a->line;
      if (in_b != nullptr) d.file_b = in_b->file, d.line_b = in_b->line;
      d.event = a != nullptr ? a->event : b->event;
      count(kind, unit, d);
    };
    if (a == nullptr || b == nullptr) {
      const Motion& only = a != nullptr ? *a : *b;
      Deviation d;
      (a != nullptr ? d.a : d.b) = fmt::format("{} {}", only.event, text_of(only, measures[0]));
      note(fmt::format("only in {}", a != nullptr ? report_.name_a : report_.name_b), "", std::move(d));
    } else if (a->event != b->event || a->words != b->words) {
      Deviation d;
      d.a = fmt::format("{} {}", a->event, a->words);
      d.b = fmt::format("{} {}", b->event, b->words);
      note("kind of event", "", std::move(d));
    } else {
      for (const Measure& measure : measures) {
        const double size = size_of(*a, *b, measure);
        if (is_within(size, measure, report_.tolerance)) continue;
        Deviation d;
        d.size = std::max(size, 0.0);
        d.a = text_of(*a, measure);
        d.b = text_of(*b, measure);
        note(measure.name, measure.unit, std::move(d));
      }
    }
    if (parts) ++report_.parted;
  }

  void count(const std::string& name, const char* unit, const Deviation& d) {
    auto kind = report_.kinds.begin();
    while (kind != report_.kinds.end() && kind->first != name) ++kind;
    if (kind == report_.kinds.end()) {
      report_.kinds.push_back({name, {unit, 0, d, d}});
      kind = report_.kinds.end() - 1;
    }
    ++kind->second.motions;
    if (d.size > kind->second.greatest.size) kind->second.greatest = d;
    if (keeps_all_) report_.all.emplace_back(name, d);
  }

  MotionReport& report_;
  const bool keeps_all_;
};

}  // namespace

MotionReport compare_motions(const RunOfSide& a, const RunOfSide& b, const LineOrder* order, const Tolerance& tolerance,
                             bool keeps_all, Session& session) {
  MotionReport report;
  report.name_a = a.side.name;
  report.name_b = b.side.name;
  report.program_a = a.program->path();
  report.program_b = b.program->path();
  report.tolerance = tolerance;
  const std::array<const RunOfSide*, 2> sides{&a, &b};
  const std::array<std::unique_ptr<Source>, 2> sources{a.program->source(session), b.program->source(session)};
  if (sources[0] == nullptr || sources[1] == nullptr) {
    report.faults.fill("its program cannot be read");
    return report;
  }
  std::array<Channel<MotionBlock>, 2> channels;
  std::array<ProgressOfThread, 2> progress;
  const auto run_side = [&](std::size_t side) {
    const RunOfSide& one = *sides[side];
    MotionStream stream(static_cast<int>(side), order, one.program->path(), channels[side]);
    CountedReports said;
    EndAtErrors limit(said, one.most_errors);
    std::string fault;
    try {
      const std::unique_ptr<Exporter> exporter = make_motion_exporter(stream, {Format::csv, false, false, true, {}});
      RunOptions options = one.options;
      progress[side].listen(options);
      run(*one.side.linked, *sources[side], one.program->path(), options, {exporter.get(), &limit}, said);
    } catch (const std::exception& e) {
      fault = e.what();
    }
    report.is_cut[side] = limit.has_ended();
    report.errors[side] = said.errors();
    report.first_error[side] = said.first_error();
    if (!fault.empty()) report.reported_by_fault[side] = std::move(said.first());
    stream.finish(std::move(fault));
  };
  MotionComparison comparison(report, keeps_all);
  Aligner<MotionBlock> aligner(channels);
  TwoThreads threads(run_side, [&] {
    for (Channel<MotionBlock>& channel : channels) channel.close();
  });
  for (std::size_t side = 0; side < 2; ++side)
    channels[side].watch(sides[side]->watchdog, [&threads, side] { threads.report_stall(side); });
  ComparisonProgress shown(session, a.program->path(), progress[0]);
  while (true) {
    shown.step();
    const Aligner<MotionBlock>::Pair pair = aligner.next();
    if (pair[0] == nullptr && pair[1] == nullptr) break;
    comparison.add(pair[0].get(), pair[1].get());
  }
  for (std::size_t side = 0; side < 2; ++side) report.faults[side] = aligner.end_of(side).fault;
  return report;
}

}  // namespace isogloss::cli::parting
