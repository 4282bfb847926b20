// Motions as values, on several threads: one dialect is linked once, and each thread runs a program of its own with it.
// Prints path length and events of each program, and where the first one stands at its end.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <isogloss/engine/motion.hpp>
#include <isogloss/engine/runner.hpp>
#include <string>
#include <thread>
#include <vector>

namespace {

/// What a listener adds up. A Motion and its texts end with the call, so that it copies what it keeps.
struct Path {
  double feed_mm = 0;  // of straight moves
  double arc_deg = 0;
  std::size_t events = 0;
  isogloss::MotionPoint end;
  std::string last_term;

  bool add(const isogloss::Motion& m) {
    ++events;
    if (!m.term.empty()) last_term = m.term;
    if (m.arc != nullptr) arc_deg += std::abs(m.arc->sweep_deg);
    if (m.event == isogloss::Motion::Event::feed) {
      double sum = 0;
      for (unsigned i = 0; i < 3; ++i) sum += std::pow(m.machine.at[i] - m.machine_start.at[i], 2);
      feed_mm += std::sqrt(sum);
    }
    if (m.event <= isogloss::Motion::Event::arc) end = m.machine;
    return m.event != isogloss::Motion::Event::stop;  // false: M00 ends the run
  }
};

Path run(const isogloss::LinkedDialect& linked, std::string_view program, isogloss::DiagnosticSink& problems) {
  Path path;
  const auto listener = isogloss::make_motion_listener([&](const isogloss::Motion& m) { return path.add(m); });
  const auto source = isogloss::memory_source(program);
  isogloss::run(linked, *source, "in memory", {}, {listener.get()}, problems);
  return path;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: motions PREFIX DIALECT\n", stderr);
    return 2;
  }
  const std::filesystem::path prefix = argv[1];
  isogloss::DiagnosticList problems;
  isogloss::Library library({prefix / "lib/isogloss/plugins"});
  const isogloss::DialectReader dialects({prefix / "share/isogloss/dialects"});
  const auto dialect = dialects.read(argv[2], problems);
  const auto linked = dialect ? isogloss::link(*dialect, library, problems) : nullptr;
  if (!linked) return 1;

  const std::vector<std::string> programs = {
      "G21 G90 G54 G17\nG0 X10. Y20. Z5.\nG1 Z-1. F600.\nG3 X20. Y30. I0. J10.\nM30\n",
      "G21 G90 G54 G17\nG0 X0. Y0. Z0.\nG1 X30. Y40. F600.\nM0\nG1 X0.\nM30\n",
  };
  std::vector<Path> paths(programs.size());
  std::vector<isogloss::DiagnosticList> faults(programs.size());  // one for each thread
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < programs.size(); ++i)
    threads.emplace_back([&, i] { paths[i] = run(*linked, programs[i], faults[i]); });
  for (std::thread& thread : threads) thread.join();

  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (faults[i].has_errors()) return 1;
    std::printf("%zu events, %g mm by feed, %g deg of arcs, %s\n", paths[i].events, paths[i].feed_mm, paths[i].arc_deg,
                paths[i].last_term.c_str());
  }
  std::printf("X%g Y%g Z%g\n", paths[0].end.at[0], paths[0].end.at[1], paths[0].end.at[2]);
  return 0;
}
