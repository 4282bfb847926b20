// The small steps that a block is made of, alone: a number read, a number written, a block begun, a field set.
#include <benchmark/benchmark.h>

#include <isogloss/number.hpp>

#include "export/number_writer.hpp"
#include "isogloss/engine/document.hpp"

namespace {

void read_decimal(benchmark::State& state) {
  const std::string_view text = "X-123.4567";
  for (auto _ : state) benchmark::DoNotOptimize(ig::read_decimal(text, 1));
}
BENCHMARK(read_decimal);

void write_decimal(benchmark::State& state) {
  char text[isogloss::number_room];
  double value = -123.4567;
  for (auto _ : state) {
    benchmark::DoNotOptimize(isogloss::write_decimal(text, value));
    value += 0.001;
  }
}
BENCHMARK(write_decimal);

isogloss::Layout standard_layout() {
  isogloss::Layout layout;
  layout.fields = isogloss::standard_fields();
  layout.lists = isogloss::standard_lists();
  layout.index();
  return layout;
}

void begin_block(benchmark::State& state) {
  const isogloss::Layout layout = standard_layout();
  isogloss::Document document(layout, std::vector<std::uint64_t>(layout.fields.size() * 2), 2);
  for (auto _ : state) document.begin({"part.nc", 1, 0, "X1."});
}
BENCHMARK(begin_block);

void set_three_fields(benchmark::State& state) {
  const isogloss::Layout layout = standard_layout();
  isogloss::Document document(layout, std::vector<std::uint64_t>(layout.fields.size() * 2), 2);
  const ig_field x = layout.id("ProgramXyz.X");
  for (auto _ : state) {
    for (ig_field axis = 0; axis < 3; ++axis) document.set(x + axis, {.number = 1.0});
    benchmark::DoNotOptimize(document.active[0]);
  }
}
BENCHMARK(set_three_fields);

}  // namespace

BENCHMARK_MAIN();
