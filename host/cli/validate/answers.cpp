// Answers of the host and of the syntax: what a function leaves in *out where it answers "absent" is nothing to use,
// and a build that says "changed" has called a function that changes something.
#include <algorithm>
#include <type_traits>

#include "isogloss/engine/host_functions.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// In *out of a field that is absent. Each run has another one.
thread_local int poison = 0;

ig_value poison_of(const ig_block* block, ig_field f) {
  const Document& d = *reinterpret_cast<const Document*>(block);
  if (f < d.size() && d.layout().fields[f].type == IG_NUMBER) return {.number = 777.125 * poison};
  return {.integer = poison};
}

/// Of those whose bit is not in the answer.
std::uint32_t with_poison(std::uint32_t answer, const ig_block* block, const ig_field* fields, std::uint32_t count,
                          ig_value* out) {
  for (std::uint32_t i = 0; i < count && i < 32; ++i)
    if ((answer >> i & 1) == 0) out[i] = poison_of(block, fields[i]);
  return answer;
}

ig_host poisoning_host() {
  ig_host out = host_table(Mode::fast);
  out.flags = 0;
  out.get = [](const ig_block* b, ig_field f, ig_value* v) {
    const std::int32_t answer = host_table(Mode::fast).get(b, f, v);
    if (answer == 0) *v = poison_of(b, f);
    return answer;
  };
  out.take = [](ig_block* b, ig_field f, ig_value* v) {
    const std::int32_t answer = host_table(Mode::fast).take(b, f, v);
    if (answer == 0) *v = poison_of(b, f);
    return answer;
  };
  out.get_many = [](const ig_block* b, const ig_field* f, std::uint32_t n, ig_value* v) {
    return with_poison(host_table(Mode::fast).get_many(b, f, n, v), b, f, n, v);
  };
  out.take_many = [](ig_block* b, const ig_field* f, std::uint32_t n, ig_value* v) {
    return with_poison(host_table(Mode::fast).take_many(b, f, n, v), b, f, n, v);
  };
  out.record = [](const ig_block* b, std::uint32_t index, const ig_field* f, std::uint32_t n, ig_value* v) {
    return with_poison(host_table(Mode::fast).record(b, index, f, n, v), b, f, n, v);
  };
  out.word = [](const ig_block* b, ig_field f, ig_word* w) {
    const std::int32_t answer = host_table(Mode::fast).word(b, f, w);
    if (answer == 0)
      *w = {f, static_cast<std::uint16_t>(poison), static_cast<std::uint16_t>(poison), poison_of(b, f), 0, 0};
    return answer;
  };
  out.transform = [](const ig_block* b, ig_field f, double* m) {
    const std::int32_t answer = host_table(Mode::fast).transform(b, f, m);
    if (answer == 0) std::fill_n(m, 16, 777.125 * poison);
    return answer;
  };
  out.map_point = [](ig_block* b, ig_direction way, const double* from, double* to) {
    const double copy[3] = {from[0], from[1], from[2]};
    const std::int32_t answer = host_table(Mode::fast).map_point(b, way, copy, to);
    if (answer == 0) std::fill_n(to, 3, 777.125 * poison);
    return answer;
  };
  return out;
}

}  // namespace

void check_absent_answers(Examination& e) {
  constexpr std::uint64_t random_ones = 10;
  const ig_host host = poisoning_host();
  ChainSettings settings;
  settings.host = &host;
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const std::vector<TestBlock> blocks = many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0);
    std::vector<std::string> first;
    std::size_t differing = SIZE_MAX;
    for (poison = 0; poison < 2 && differing == SIZE_MAX; ++poison) {
      Bench bench(stand.alone, settings);  // what services keep begins anew
      bench.start();
      for (std::size_t i = 0; i < blocks.size() && differing == SIZE_MAX; ++i) {
        e.attempt(std::string(stand.syntax->id) + ", " + blocks[i].name +
                  "; what an absent field leaves in *out is nothing to use");
        std::string shown = bench.run(blocks[i]).shown;
        if (poison == 0)
          first.push_back(std::move(shown));
        else if (shown != first[i])
          differing = i;
      }
    }
    if (differing != SIZE_MAX)
      e.find(std::string(stand.syntax->id) + ", " + blocks[differing].name,
             "its result depends on what *out holds after an answer of 0, for a field that is absent");
  }
}

namespace {

thread_local bool has_acted = false;

/// A function that changes the block, or what belongs to the run.
template <auto member>
struct Acting;
template <class R, class... A, R (*ig_host::*member)(A...)>
struct Acting<member> {
  static R call(A... arguments) {
    has_acted = true;
    return (host_table(Mode::fast).*member)(arguments...);
  }
};

/// One that takes what is there: `nothing` is its answer where nothing is.
template <auto member>
struct Taking;
template <class R, class... A, R (*ig_host::*member)(A...)>
struct Taking<member> {
  static R call(A... arguments) {
    constexpr R nothing = std::is_same_v<decltype(member), decltype(&ig_host::take_code)> ? static_cast<R>(-1) : R(0);
    const R answer = (host_table(Mode::fast).*member)(arguments...);
    has_acted = has_acted || answer != nothing;
    return answer;
  }
};

ig_host noting_host() {
  using H = ig_host;
  ig_host out = host_table(Mode::fast);
  out.flags = 0;
  replace_members<Taking, &H::take, &H::take_many, &H::take_code, &H::take_point>(out);
  replace_members<Acting, &H::set, &H::set_many, &H::amend_many, &H::erase, &H::set_text, &H::set_words, &H::rewrite,
                  &H::move, &H::add_leftover, &H::set_transform, &H::set_translation, &H::append, &H::append_many,
                  &H::set_record, &H::map_records, &H::report, &H::fault, &H::flow, &H::ahead, &H::set_moving_transform,
                  &H::set_point>(out);
  return out;
}

}  // namespace

void check_changed(Examination& e) {
  constexpr std::uint64_t random_ones = 10;
  const ig_host host = noting_host();
  ChainSettings settings;
  settings.host = &host;
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    if (stand.syntax->build == nullptr || stand.syntax->service_count > 0) continue;  // a service may have acted
    Bench bench(stand.alone, settings);
    for (const TestBlock& block : many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0)) {
      const std::string where = std::string(stand.syntax->id) + ", " + block.name;
      e.attempt(where);
      bench.prepare(block);
      bench.scan();
      has_acted = false;
      if (bench.build() != IG_CHANGED || has_acted) continue;
      e.find(where, "its build() says changed, but it wrote, took and reported nothing");
      break;
    }
  }
}

}  // namespace isogloss::cli
