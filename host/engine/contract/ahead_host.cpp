#include "isogloss/engine/scanned_line.hpp"

#include "contract/host_values.hpp"
#include "isogloss/engine/host_functions.hpp"

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
std::int32_t get_ahead(const ig_block* block, ig_field f, ig_value* out) {
  const Document& d = doc(block);
  const bool is_there = get<Mode::fast>(block, f, out) != 0;
  if (f < d.size() && d.is_modal(f) && !d.fresh(f)) {
    notes_of(block).add(f, is_there, is_there ? d.value(f) : ig_value{});
  }
  return is_there ? 1 : 0;
}

void set_ahead(ig_block* block, ig_field f, ig_value v) { doc(block).add(f, v); }

void set_words_ahead(ig_block* block, const ig_word* words, std::uint32_t count) { doc(block).add_words(words, count); }

std::int32_t in_turn_ahead(ig_block* block) {
  notes_of(block).leave();
  return 0;
}

/// What a scanner may do ahead; all else leaves the line.
constexpr ig_host make_table() {
  ig_host out{};
  out.struct_size = sizeof out;
  out.flags = 0;  // without IG_HOST_SHOWS_BLOCKS every read is seen
  replace_functions<Leaving>(out);
  out.get = get_ahead;
  out.is_fresh = is_fresh<Mode::fast>;
  out.fresh_many = fresh_many<Mode::fast>;
  out.fresh_point = fresh_point<Mode::fast>;
  out.source = source;
  out.set = set_ahead;
  out.set_words = set_words_ahead;
  out.in_turn = in_turn_ahead;
  return out;
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
