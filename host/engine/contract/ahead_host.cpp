#include "isogloss/engine/scanned_line.hpp"

#include "contract/host_values.hpp"

namespace isogloss {

namespace calls {
namespace {

LineNotes& notes_of(const ig_block* block) { return *doc(block).chain->notes; }

/// A function that needs more than the text of the line, or does what is not noted: the line is left to its turn.
template <auto function>
struct Leaving;
template <class R, class B, class... A, R (*ig_host::*function)(B*, A...)>
struct Leaving<function> {
  static R call(B* block, A... arguments) {
    notes_of(block).leave();
    return (host_table(Mode::fast).*function)(block, arguments...);
  }
};
template <auto function>
constexpr auto leaving = Leaving<function>::call;

std::int32_t get_ahead(const ig_block* block, ig_field f, ig_value* out) {
  const Document& d = doc(block);
  const bool is_there = get<Mode::fast>(block, f, out) != 0;
  if (f < d.size() && d.is_modal(f) && !d.fresh(f))
    notes_of(block).add({f, 0, 0, is_there ? d.value(f) : ig_value{},
                         LineNotes::was_read | (is_there ? 0u : LineNotes::was_absent), 0});
  return is_there ? 1 : 0;
}

void set_ahead(ig_block* block, ig_field f, ig_value v) {
  const Document& d = doc(block);
  if (f < d.size()) notes_of(block).add({f, 0, 0, v, LineNotes::is_value, d.current});
  set<Mode::fast>(block, f, v);
}

void set_words_ahead(ig_block* block, const ig_word* words, std::uint32_t count) {
  const Document& d = doc(block);
  for (const ig_word& w : std::span(words, count))
    if (w.field < d.size())
      notes_of(block).add(
          {w.field, w.begin, w.end, w.value, w.flags & std::uint32_t{IG_WORD_WITHOUT_POINT}, d.current});
  set_words<Mode::fast>(block, words, count);
}

std::int32_t in_turn_ahead(ig_block* block) {
  notes_of(block).leave();
  return 0;
}

constexpr ig_host make_table() {
  return {.struct_size = sizeof(ig_host),
          .flags = 0,  // every read is seen
          .get = get_ahead,
          .get_many = leaving<&ig_host::get_many>,
          .take = leaving<&ig_host::take>,
          .take_many = leaving<&ig_host::take_many>,
          .set = set_ahead,
          .set_many = leaving<&ig_host::set_many>,
          .amend_many = leaving<&ig_host::amend_many>,
          .erase = leaving<&ig_host::erase>,
          .is_fresh = is_fresh<Mode::fast>,
          .take_code = leaving<&ig_host::take_code>,
          .find_code = leaving<&ig_host::find_code>,
          .text = leaving<&ig_host::text>,
          .set_text = leaving<&ig_host::set_text>,
          .source = source,
          .set_words = set_words_ahead,
          .rewrite = leaving<&ig_host::rewrite>,
          .move = leaving<&ig_host::move>,
          .word = leaving<&ig_host::word>,
          .add_leftover = leaving<&ig_host::add_leftover>,
          .leftover = leaving<&ig_host::leftover>,
          .set_transform = leaving<&ig_host::set_transform>,
          .set_translation = leaving<&ig_host::set_translation>,
          .transform = leaving<&ig_host::transform>,
          .map_point = leaving<&ig_host::map_point>,
          .frame_changed = leaving<&ig_host::frame_changed>,
          .append = leaving<&ig_host::append>,
          .count = leaving<&ig_host::count>,
          .record = leaving<&ig_host::record>,
          .set_record = leaving<&ig_host::set_record>,
          .map_records = leaving<&ig_host::map_records>,
          .symbol = leaving<&ig_host::symbol>,
          .symbol_text = leaving<&ig_host::symbol_text>,
          .report = leaving<&ig_host::report>,
          .fault = leaving<&ig_host::fault>,
          .flow = leaving<&ig_host::flow>,
          .ahead = leaving<&ig_host::ahead>,
          .fresh_many = fresh_many<Mode::fast>,
          .set_moving_transform = leaving<&ig_host::set_moving_transform>,
          .get_point = leaving<&ig_host::get_point>,
          .take_point = leaving<&ig_host::take_point>,
          .set_point = leaving<&ig_host::set_point>,
          .fresh_point = fresh_point<Mode::fast>,
          .in_turn = in_turn_ahead};
}

constexpr ig_host table = make_table();

}  // namespace
}  // namespace calls

const ig_host& ahead_table() { return calls::table; }

std::size_t leave_to_turn(void*, const ig_host*, ig_block* block, const char*, std::size_t size, std::size_t) {
  calls::notes_of(block).leave();
  return size;
}

}  // namespace isogloss
