#include "diff/compare.hpp"

#include "diff/aligner.hpp"
#include "diff/recorder.hpp"
#include "run_progress.hpp"

namespace isogloss::cli::parting {

BlockResult compare_blocks(const RunOfSide& a, const RunOfSide& b, const LineOrder* order,
                           const std::vector<std::string>& ignored, const ComparisonOptions& options,
                           Session& session) {
  BlockResult out;
  const std::array<const RunOfSide*, 2> sides{&a, &b};
  const std::array<std::unique_ptr<Source>, 2> sources{a.program->source(session), b.program->source(session)};
  if (sources[0] == nullptr || sources[1] == nullptr) {
    out.faults.fill("its program cannot be read");
    return out;
  }
  std::vector<std::string> not_compared = ignored;
  for (const char* const path : {"Source.File", "Source.Line", "Source.Text"}) not_compared.emplace_back(path);
  const FieldMap map(*a.side.linked, *b.side.linked, not_compared);
  for (const std::string& path : ignored)
    if (!map.has_ignored(path)) out.unknown_fields.push_back(path);
  std::array<Channel<Snapshot>, 2> channels;
  std::array<std::unique_ptr<Recorder>, 2> recorders;
  for (std::size_t side = 0; side < 2; ++side)
    recorders[side] = std::make_unique<Recorder>(*sides[side]->side.linked, map, static_cast<int>(side), order,
                                                 sides[side]->program->path(), channels[side]);
  std::array<ProgressOfThread, 2> progress;
  const auto run_side = [&](std::size_t side) {
    const RunOfSide& one = *sides[side];
    Recorder& recorder = *recorders[side];
    RunOptions run_options = one.options;
    run_options.chain.mode = Mode::traced;
    run_options.chain.hears_rows = true;
    run_options.prepare = [&recorder](Chain& chain) { recorder.listen(chain); };
    progress[side].listen(run_options);
    CountedReports said;
    recorder.count(said);
    EndAtErrors limit(said, one.most_errors);
    std::string fault;
    try {
      run(*one.side.linked, *sources[side], one.program->path(), run_options, {&recorder, &limit}, recorder);
    } catch (const std::exception& e) {
      fault = e.what();
    }
    out.is_cut[side] = limit.has_ended();
    recorder.finish(std::move(fault));
  };
  Comparison comparison(map, a.side, b.side, options);
  Aligner<Snapshot> aligner(channels);
  {
    TwoThreads threads(run_side, [&] {
      for (Channel<Snapshot>& channel : channels) channel.close();
    });
    for (std::size_t side = 0; side < 2; ++side)
      channels[side].watch(sides[side]->watchdog, [&threads, side] { threads.report_stall(side); });
    ComparisonProgress shown(session, a.program->path(), progress[0]);
    while (true) {
      shown.step();
      Comparison::Pair pair = aligner.next();
      if (pair[0] == nullptr && pair[1] == nullptr) break;
      Comparison::Pair old = comparison.add(std::move(pair));
      for (std::size_t side = 0; side < 2; ++side)
        if (old[side] != nullptr) channels[side].give_back(std::move(old[side]));
    }
    for (std::size_t side = 0; side < 2; ++side) {
      out.faults[side] = aligner.end_of(side).fault;
      if (!out.faults[side].empty()) out.reported_by_fault[side] = aligner.end_of(side).reported;
    }
    comparison.add_ends(aligner.end_of(0), aligner.end_of(1));
  }
  out.report = comparison.finish();
  out.errors_of_both = comparison.errors_of_both();
  out.report.program_a = a.program->path();
  out.report.program_b = b.program->path();
  return out;
}

}  // namespace isogloss::cli::parting
