/// The block document, dense: one bit for present, one for fresh, one for taken, eight bytes of value and the writer
/// for each field. One lives through a run and is carried from block to block in place.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>

#include "isogloss/engine/call_fields.hpp"
#include "isogloss/engine/frame.hpp"
#include "isogloss/engine/layout.hpp"
#include "isogloss/engine/record_list.hpp"
#include "isogloss_view.h"

namespace isogloss {

class Chain;

struct Leftover {
  ig_leftover_kind kind;
  ig_field field;
  std::uint32_t begin, end;
  std::string name;
  std::string value{};  ///< the number or expression where the block has no text for it (a document read from JSON)
};

/// Where the block stands in its source.
struct BlockSource {
  std::string_view file;
  std::uint32_t line = 0;    ///< from 1
  std::uint32_t column = 0;  ///< of the text's first byte, from 0: a line may hold several blocks
  std::string_view text;     ///< alive until the block is finished
  bool is_joined = false;    ///< of several lines, whose ends are in the text
};

/// Where a block lies decides whether its bits are read and written in one line of the cache or across two: the
/// alignments are there for that.
class alignas(64) Document {
  ig_view view_{};  // first: a syntax looks for it where its block begins

 public:
  /// Sizes for one layout; `wake` is wake_words masks, 2 to most_wake_words, for each field (which syntaxes a write
  /// wakes) and, behind them, for each list (which syntaxes a new record wakes).
  Document(const Layout& layout, std::vector<std::uint64_t> wake, std::uint32_t wake_words);
  const Layout& layout() const { return *layout_; }
  /// As a syntax gets it: it begins with the view of the present values.
  ig_block* block() {
    view_ = {reinterpret_cast<const ig_view_bits*>(fields_.bits.data()),
             reinterpret_cast<const ig_view_value*>(fields_.states.data()), size_, 0};
    return reinterpret_cast<ig_block*>(this);
  }

  bool present(ig_field f) const { return f < size_ && (fields_.bits[f >> 6].present >> (f & 63) & 1) != 0; }
  bool fresh(ig_field f) const { return f < size_ && (fields_.bits[f >> 6].fresh >> (f & 63) & 1) != 0; }
  bool taken(ig_field f) const { return f < size_ && (fields_.bits[f >> 6].taken >> (f & 63) & 1) != 0; }
  /// Does its value come from the blocks before, unless this one sets it?
  bool is_modal(ig_field f) const { return (fields_.bits[f >> 6].modal >> (f & 63) & 1) != 0; }
  bool without_point(ig_field f) const { return f < size_ && (fields_.bits[f >> 6].pointless >> (f & 63) & 1) != 0; }
  ig_value value(ig_field f) const { return fields_.states[f].value; }
  double number(ig_field f) const { return fields_.states[f].value.number; }
  std::uint16_t writer(ig_field f) const { return fields_.states[f].writer(); }
  std::string_view text(ig_field f) const;
  std::uint32_t word_begin(ig_field f) const { return fields_.states[f].begin(); }
  std::uint32_t word_end(ig_field f) const { return fields_.states[f].end(); }

  // A write calls nothing but what rarely happens, and that as its last act: then it needs no frame on the stack.

  /// Value, present, fresh, writer; wakes.
  void set(ig_field f, ig_value v) {
    Bits& bits = fields_.bits[f >> 6];
    if ((bits.watched & bit(f)) != 0 && !has_value(f, v)) [[unlikely]]
      return change_watched(f, v);
    fields_.states[f] = {v, written()};
    bits.write(bit(f));
    wake(f);
  }
  /// The same for several; ids outside the document are left out. Codes among them are counted as seen.
  void set_many(const ig_field* f, std::uint32_t count, const ig_value* v) { set_each<false>(f, count, v, 0); }
  /// Their values; a bit for each that is present.
  std::uint32_t get_many(const ig_field* f, std::uint32_t count, ig_value* out) const {
    if (const FieldGroup* const group = group_of(f, count))
      return get_each(*group, fields_.bits[group->word].present & group->mask, out);
    const State* const state = fields_.states.data();
    const Bits* const bits = fields_.bits.data();
    std::uint32_t known = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const ig_field field = f[i];
      if (field >= size_ || (bits[field >> 6].present & bit(field)) == 0) continue;
      out[i] = state[field].value;
      known |= 1u << (i & 31);
    }
    return known;
  }
  /// The place among these fields of the only one that is present; none of them, or several, or not to be told at once.
  enum : std::int32_t { none_present = -1, several_present = -2 };
  std::int32_t only_present(const ig_field* f, std::uint32_t count) const {
    const FieldGroup* const group = group_of(f, count);
    if (group == nullptr) return several_present;
    const std::uint64_t known = fields_.bits[group->word].present & group->mask;
    if (known == 0) return none_present;
    return (known & (known - 1)) == 0 ? group->index[std::countr_zero(known)] : std::int32_t{several_present};
  }
  /// Value, present, writer.
  void write(ig_field f, ig_value v) {
    Bits& bits = fields_.bits[f >> 6];
    if ((bits.watched & bit(f)) != 0 && !has_value(f, v)) tell_change(f);
    fields_.states[f] = {v, written()};
    bits.present |= bit(f);
    bits.taken &= ~bit(f);
    active[1] |= wake_[std::size_t{f} * wake_words_ + 1] & holds_far_words;
  }
  /// A code that a syntax raises counts as seen, too: without one no search for codes needs to look.
  void count_code(ig_field f) { codes_seen += static_cast<std::uint32_t>(fields_.bits[f >> 6].codes >> (f & 63) & 1); }
  void erase(ig_field f) {
    if (is_watched(f)) tell_change(f);
    fields_.bits[f >> 6].present &= ~bit(f);
    fields_.bits[f >> 6].fresh &= ~bit(f);
  }
  /// Gives the value and removes a word; a code stays readable. False when it was not there.
  bool take(ig_field f, ig_value& out) {
    if (!present(f)) return false;
    out = fields_.states[f].value;
    Bits& bits = fields_.bits[f >> 6];
    if ((bits.watched & bit(f)) != 0) tell_change(f);
    bits.present &= ~(bit(f) & ~bits.codes);
    bits.taken |= bit(f);
    return true;
  }

  /// The same for several; a bit for each that was there.
  std::uint32_t take_many(const ig_field* f, std::uint32_t count, ig_value* out) {
    if (const FieldGroup* const group = group_of(f, count)) {
      Bits& bits = fields_.bits[group->word];
      const std::uint64_t these = bits.present & group->mask;
      if ((bits.watched & these) == 0) [[likely]] {
        bits.present &= ~(these & ~bits.codes);
        bits.taken |= these;
        return get_each(*group, these, out);
      }
    }
    const State* const state = fields_.states.data();
    Bits* const all = fields_.bits.data();
    std::uint32_t taken = 0;
    // Most of the fields have their bits in one word, which is written once.
    Bits* bits = nullptr;
    std::uint64_t present = 0, gone = 0;
    const auto write = [&] {
      if (gone == 0) return;
      bits->present = present;
      bits->taken |= gone;
    };
    for (std::uint32_t i = 0; i < count; ++i) {
      const ig_field field = f[i];
      if (field >= size_) continue;
      if (Bits* const here = all + (field >> 6); here != bits) {
        write();
        bits = here;
        present = here->present;
        gone = 0;
      }
      const std::uint64_t mask = bit(field);
      if ((present & mask) == 0) continue;
      out[i] = state[field].value;
      if ((bits->watched & mask) != 0) [[unlikely]]
        tell_change(field);
      present &= ~(mask & ~bits->codes);
      gone |= mask;
      taken |= 1u << (i & 31);
    }
    write();
    return taken;
  }

  // X Y Z of one section mostly lie side by side, and three at once cost little more than one.
  bool is_point(ig_field x) const { return x < points_end_ && (x & 63) <= 61; }
  /// A bit for each that is present; 0 in its place where it is not.
  std::uint32_t get_point(ig_field x, double* out) const {
    const std::uint32_t known = static_cast<std::uint32_t>(fields_.bits[x >> 6].present >> (x & 63)) & 7u;
    using Pair [[gnu::vector_size(16), gnu::may_alias, gnu::aligned(8)]] = double;
    const State* const state = fields_.states.data() + x;
    // X and Y in one piece: the caller copies the point in such pieces, and would have to wait for smaller ones.
    *reinterpret_cast<Pair*>(out) = Pair{state[0].value.number, state[1].value.number};
    out[2] = state[2].value.number;
    if (known != 7u) [[unlikely]]
      for (int i = 0; i < 3; ++i)
        if ((known >> i & 1u) == 0) out[i] = 0;
    return known;
  }
  std::uint32_t fresh_point(ig_field x) const {
    return static_cast<std::uint32_t>(fields_.bits[x >> 6].fresh >> (x & 63)) & 7u;
  }
  std::uint32_t take_point(ig_field x, double* out) {
    Bits& bits = fields_.bits[x >> 6];
    const std::uint32_t known = get_point(x, out);
    const std::uint64_t these = std::uint64_t{known} << (x & 63);
    if ((bits.watched & these) != 0) [[unlikely]]
      return take_watched_point(x, known);
    bits.present &= ~(these & ~bits.codes);
    bits.taken |= these;
    return known;
  }
  [[gnu::always_inline]] void set_point(ig_field x, const double* point) {
    Bits& bits = fields_.bits[x >> 6];
    const std::uint64_t these = std::uint64_t{7} << (x & 63);
    if ((bits.watched & these) != 0) [[unlikely]]
      return set_watched_point(x, point);
    const std::uint64_t place = written();
    State* const state = fields_.states.data() + x;
    state[0] = {{.number = point[0]}, place};
    state[1] = {{.number = point[1]}, place};
    state[2] = {{.number = point[2]}, place};
    bits.write(these);
    wake_by(point_wake_ + std::size_t{x} * wake_words_);
  }
  void set_text(ig_field f, std::string_view text);
  /// Words and codes of the text, with their columns; codes are numbered in their order.
  [[gnu::always_inline]] void set_words(const ig_word* w, std::uint32_t count) {
    State* const state = fields_.states.data();
    Bits* const all = fields_.bits.data();
    const std::uint32_t size = size_;
    const std::uint64_t place = written();
    Woken woken(*this);
    const ig_word* const first = w;
    for (const ig_word* const end = w + count; w != end; ++w) {
      const ig_field f = w->field;
      if (f >= size) continue;
      Bits& bits = all[f >> 6];
      const std::uint64_t mask = bit(f);
      ig_value v = w->value;
      if ((bits.codes & mask) != 0) v.integer = ++codes_seen;
      state[f] = {v, place | std::uint64_t{w->end} << 16 | w->begin};
      bits.write(mask);
      bits.pointless = (bits.pointless & ~mask) | ((w->flags & IG_WORD_WITHOUT_POINT) != 0 ? mask : 0);
      woken.add(f);
    }
    active[0] |= woken.low;
    active[1] |= woken.high;
    if (woken.is_far()) [[unlikely]]
      wake_far_of(&first->field, sizeof *first, count);
  }
  void set_word(const ig_word& w) { set_words(&w, 1); }

  /// What this block got since begin_scan(), to be given to the same block of another document at once.
  struct Summary {
    static constexpr std::uint32_t most_fields = 64, most_pieces = 8;
    struct Field {
      ig_value value;
      std::uint64_t place;  ///< as State's, with the field in its upper 16 bits
      static constexpr int field_at = 48;
      ig_field id() const { return static_cast<ig_field>(place >> field_at); }
    };
    struct Piece {  ///< of the fields whose bits lie in one word
      std::uint64_t word, fields, pointless;
    };
    std::uint64_t wakes[2];
    std::uint16_t fields, codes;
    std::uint32_t pieces;
    Field field[most_fields];  // directly behind those that are used lie the pieces
    Piece room[most_pieces];   // last: what is not used is not kept
    const Piece* piece() const { return reinterpret_cast<const Piece*>(field + fields); }
    std::size_t bytes() const { return offsetof(Summary, field) + fields * sizeof(Field) + pieces * sizeof(Piece); }
  };
  /// Sums up what the block gets from here on, and what that wakes, apart from what values from before the block have
  /// woken. Until hand_over() only add_words() and add() write to it.
  void begin_scan(Summary& out) {
    wake_none();
    summary_ = &out;
    out.fields = 0;
  }
  /// As set_words() and set(), and to the summary, where there is one.
  void add_words(const ig_word* w, std::uint32_t count);
  void add(ig_field f, ig_value v);
  /// The summary is complete, and the block has nothing of it any more. False where it got too much.
  bool hand_over();
  /// Starts the next block of the file in place of begin(), after hand_over(), and its scan, too. False, with nothing
  /// done, where a value stays.
  bool begin_scan_again(std::uint32_t line, std::string_view text, Summary& out) {
    if (keeps_value_) [[unlikely]]
      return false;
    source.line = line;
    source.text = text;
    codes_seen = 0;
    begin_scan(out);
    return true;
  }
  /// To a block that has only begun.
  [[gnu::always_inline]] void set_summed(const Summary& summary) {
    State* const state = fields_.states.data();
    const Summary::Field* const end = summary.field + summary.fields;
    for (const Summary::Piece *p = summary.piece(), *const last = p + summary.pieces; p != last; ++p) {
      Bits& bits = fields_.bits[p->word];
      if ((bits.watched & p->fields) != 0) [[unlikely]]
        tell_changes(summary.field, summary.fields);
      bits.write(p->fields);
      bits.pointless = p->pointless;
    }
    for (const Summary::Field* f = summary.field; f != end; ++f) state[f->id()] = {f->value, f->place << 16 >> 16};
    active[0] |= summary.wakes[0];
    active[1] |= summary.wakes[1];
    codes_seen = summary.codes;
    if ((summary.wakes[1] & wakes_beyond) != 0) [[unlikely]]
      for (const Summary::Field* f = summary.field; f != end; ++f) wake_far(wake_ + std::size_t{f->id()} * wake_words_);
  }
  /// Nothing has woken a syntax so far.
  void wake_none() { active[0] = active[1] = 0; }
  void rewrite(ig_field f, ig_value v);
  /// From now on every change of the field adds these bits to `changes`.
  void watch(ig_field f, std::uint64_t changes);
  /// From now on no write wakes the syntaxes of these bits.
  void silence(std::span<const std::uint32_t> bits);
  void move(ig_field from, ig_field to);

  /// Starts the next block: `previous` values are copied, modal fields are carried, the others are dropped.
  void begin(const BlockSource& source);
  /// True when something of the block is left over: a word, an unanswered code, or other leftovers.
  bool has_leftovers() const {
    std::uint64_t open = 0;
    const Bits* const end = fields_.bits.data() + (has_far_words() ? far_end_ : far_begin_);
    for (const Bits* bits = fields_.bits.data() + open_begin_; bits != end; ++bits)
      open |= bits->present & bits->words & ~bits->taken;
    return open != 0 || !leftovers.empty();
  }
  /// All of them in the order of their columns.
  std::vector<Leftover> collect_leftovers() const;
  void add_leftover(ig_leftover_kind kind, ig_field field, std::uint32_t begin, std::uint32_t end,
                    std::string_view name);

  void set_frame(ig_field f, const Frame& frame);
  /// An entry that moves with the axes in this block, as it is at the end of the block.
  void move_frame(ig_field f, const double* matrix);
  const Frame& frame(ig_field f) const { return frames_[frame_index(f)]; }
  /// All entries composed in chain order.
  const Frame& composed() {
    if (!composed_valid_) [[unlikely]]
      compose();
    return composed_;
  }
  bool map_to_program(const double (&in)[3], double (&out)[3]);
  bool frame_changed = false;  ///< under a resting tool
  bool frame_moved = false;    ///< in either way
  /// Did the frame move with the axes in this block?
  bool is_moving_frame(ig_field f) const { return present(f) && frame(f).is_moving; }

  /// Values that each frame has for itself, between two blocks: a called program begins without them.
  using FrameValues = std::vector<std::optional<ig_value>>;
  void get_frame_values(FrameValues& out) const;
  void clear_frame_values();
  void set_frame_values(const FrameValues& values);

  std::vector<ListData> lists;
  std::vector<Leftover> leftovers;
  BlockSource source;
  alignas(16) std::uint64_t active[most_wake_words] = {};  ///< syntaxes to call in this block, each with its wake_bit()
  std::uint16_t current = 0;                               ///< chain position + 1 of the syntax that runs; 0: the host
  std::uint64_t changes = 0;                               ///< of watched fields, since the chain looked
  std::uint32_t codes_seen = 0;                            ///< codes that this block got so far, taken ones included
  Chain* chain = nullptr;
  /// Which block gave a field its value. Files are numbered by Chain::file_name; lines count from 1; 0: before the
  /// first block.
  struct Origin {
    std::uint32_t line = 0, since = 0;  ///< set last, and set to another value than before
    std::uint16_t file = 0, since_file = 0;
    bool operator==(const Origin&) const = default;
  };
  std::vector<Origin> origins;    ///< by field; kept in traced mode only
  std::uint16_t file_number = 0;  ///< of this block's file; kept in traced mode only

  std::uint32_t size() const { return size_; }
  std::uint32_t words() const { return words_; }
  /// One bit for each of 64 fields, for tests of many at once.
  struct alignas(64) Bits {
    std::uint64_t present = 0, fresh = 0, taken = 0, pointless = 0;  // of this block
    std::uint64_t modal = 0, words = 0, codes = 0, watched = 0;      // what the fields are; words: codes, too
    void write(std::uint64_t fields) {
      present |= fields;
      fresh |= fields;
      taken &= ~fields;
    }
    /// To the next block.
    void carry() {
      using Pair [[gnu::vector_size(16), gnu::may_alias]] = std::uint64_t;
      Pair* const pairs = reinterpret_cast<Pair*>(this);
      pairs[0] = Pair{present & modal, 0};
      pairs[1] = Pair{};
    }
  };
  const Bits& bits(std::uint32_t word) const { return fields_.bits[word]; }

  /// The same values, words and lists (the checked table verifies a build that returns "unchanged").
  bool same_content(const Document& other) const;

  /// Copies the block's text into the document, so that it outlives the reader's buffer.
  void own_source();
  /// A record was added to this list.
  void wake_by_list(std::size_t list) { wake_by(wake_ + (size_ + list) * wake_words_); }

 private:
  static constexpr std::uint64_t bit(ig_field f) { return std::uint64_t{1} << (f & 63); }
  /// The place of a value that is not a word of the text: the running syntax wrote it.
  std::uint64_t written() const { return std::uint64_t{current} << 32; }
  /// Collects what several fields wake, so that it is stored once.
  struct Woken {
    const std::uint64_t* const wakes;
    const std::size_t stride;
    std::uint64_t low = 0, high = 0;
    explicit Woken(const Document& d) : wakes(d.wake_), stride(d.wake_words_) {}
    void add(ig_field f) {
      const std::uint64_t* const woken = wakes + f * stride;
      low |= woken[0];
      high |= woken[1];
    }
    bool is_far() const { return (high & wakes_beyond) != 0; }
  };
  void wake(ig_field f) { wake_by(wake_ + std::size_t{f} * wake_words_); }
  void wake_by(const std::uint64_t* woken) {
    active[0] |= woken[0];
    active[1] |= woken[1];
    if ((woken[1] & wakes_beyond) != 0) [[unlikely]]
      wake_far(woken);
  }
  [[gnu::cold]] void wake_far(const std::uint64_t* woken);
  /// For fields that lie so many bytes apart.
  [[gnu::cold]] void wake_far_of(const ig_field* fields, std::size_t bytes, std::uint32_t count);
  /// Null where the fields are few or many, or where their bits do not lie in one word.
  const FieldGroup* group_of(const ig_field* f, std::uint32_t count) const {
    if (count < FieldGroup::least_fields || count > FieldGroup::most_fields) return nullptr;
    const FieldGroup* group = &groups_.at(f);
    if (!group->is(f, count)) [[unlikely]]
      group = &find_group(f, count);
    return group->mask != 0 ? group : nullptr;
  }
  const FieldGroup& find_group(const ig_field* f, std::uint32_t count) const;
  /// Of these bits of the group; a bit for each field in the order of the call.
  std::uint32_t get_each(const FieldGroup& group, std::uint64_t these, ig_value* out) const {
    const State* const state = fields_.states.data() + group.word * 64;
    std::uint32_t known = 0;
    for (; these != 0; these &= these - 1) {
      const int bit = std::countr_zero(these);
      const std::uint32_t i = group.index[bit];
      out[i] = state[bit].value;
      known |= 1u << i;
    }
    return known;
  }
  void sum_up(ig_field f);
  bool is_watched(ig_field f) const { return (fields_.bits[f >> 6].watched >> (f & 63) & 1) != 0; }
  [[gnu::noinline]] void compose();
  bool has_value(ig_field f, ig_value v) const {
    return (fields_.bits[f >> 6].present & bit(f)) != 0 && fields_.states[f].value.integer == v.integer;
  }
  [[gnu::cold]] void tell_change(ig_field f);
  /// Of those that are watched and get another value.
  [[gnu::cold]] void tell_changes(const Summary::Field* fields, std::uint32_t count);
  [[gnu::cold]] void change_watched(ig_field f, ig_value v);
  /// From the one on where a watched field changes. Those before it are set, but do not yet wake what is far.
  [[gnu::cold]] void change_many(const ig_field* f, std::uint32_t count, const ig_value* v, std::uint32_t first);
  /// Without `tells` it goes over to change_many() where a watched field changes.
  template <bool tells>
  [[gnu::always_inline]] void set_each(const ig_field* f, std::uint32_t count, const ig_value* v, std::uint32_t first) {
    State* const state = fields_.states.data();
    Bits* const all = fields_.bits.data();
    const std::uint64_t place = written();
    Woken woken(*this);
    // Most of the fields have their bits in one word, which is written once.
    Bits* bits = nullptr;
    std::uint64_t set = 0;
    std::uint32_t codes = 0;
    const auto write = [&] {
      if (set != 0) bits->write(set);
    };
    for (std::uint32_t i = first; i < count; ++i) {
      const ig_field field = f[i];
      if (field >= size_) continue;
      if (Bits* const here = all + (field >> 6); here != bits) {
        write();
        bits = here;
        set = 0;
      }
      const std::uint64_t mask = bit(field);
      if ((bits->watched & mask) != 0 && !has_value(field, v[i])) [[unlikely]] {
        if constexpr (tells) {
          tell_change(field);
        } else {
          write();
          codes_seen += codes;
          active[0] |= woken.low;
          active[1] |= woken.high;
          return change_many(f, count, v, i);
        }
      }
      state[field] = {v[i], place};
      set |= mask;
      codes += static_cast<std::uint32_t>((bits->codes & mask) != 0);
      woken.add(field);
    }
    write();
    codes_seen += codes;
    active[0] |= woken.low;
    active[1] |= woken.high;
    if (woken.is_far() || (tells && (active[1] & wakes_beyond) != 0)) [[unlikely]]
      wake_far_of(f, sizeof *f, count);
  }
  [[gnu::cold]] void set_watched_point(ig_field x, const double* point);
  [[gnu::cold]] std::uint32_t take_watched_point(ig_field x, std::uint32_t known);
  /// For a transform. The field's value is meaningless: a syntax may have set it by mistake.
  std::size_t frame_index(ig_field f) const {
    std::size_t i = 0;
    while (layout_->transforms[i] != f) ++i;
    return i;
  }
  void keep_previous(ig_field field, ig_field copy);
  void find_open_words(std::vector<std::uint64_t>& wake);
  bool has_far_words() const { return (active[1] & holds_far_words) != 0; }
  void mark_pointless(ig_field f, bool pointless);
  const Layout* layout_;
  std::uint32_t size_ = 0, words_ = 0, wake_words_ = 2;
  std::uint32_t points_end_ = 0;  // no three fields begin here or behind
  struct State {
    ig_value value{};
    std::uint64_t place = 0;  // where a word begins and ends (columns), and the writer: 16 bits each, from the lowest
    std::uint16_t begin() const { return static_cast<std::uint16_t>(place); }
    std::uint16_t end() const { return static_cast<std::uint16_t>(place >> 16); }
    std::uint16_t writer() const { return static_cast<std::uint16_t>(place >> 32); }
  };
  static_assert(sizeof(Bits) == sizeof(ig_view_bits) && offsetof(Bits, present) == offsetof(ig_view_bits, present) &&
                offsetof(Bits, fresh) == offsetof(ig_view_bits, fresh));
  static_assert(sizeof(State) == sizeof(ig_view_value) && offsetof(State, value) == offsetof(ig_view_value, value));
  /// Few fields of a block have a value. Blocks are copied while they wait for those that follow, so an assignment
  /// copies the values that are there and leaves the rest of the copy as it was.
  struct Fields {
    std::vector<Bits> bits;
    std::vector<State> states;
    Fields(std::size_t words, std::size_t count) : bits(words), states(count) {}
    Fields(const Fields&) = default;
    Fields& operator=(const Fields& other);
  };
  Fields fields_;
  // The 64-bit words that hold words and codes; from far_begin_ to far_end_ hold nothing but words of codes, looked at
  // where a block holds_far_words.
  std::uint32_t open_begin_ = 0, far_begin_ = 0, far_end_ = 0;
  /// Which syntaxes the writing of a field wakes, wake_words_ for each; and that of three fields, by the first. Copies
  /// of the document share it: blocks are copied while they wait for those that follow.
  struct Wakes {
    std::vector<std::uint64_t> by_field, by_point;
  };
  void share(std::shared_ptr<const Wakes> wakes);
  std::shared_ptr<const Wakes> wakes_;
  const std::uint64_t* wake_ = nullptr;
  const std::uint64_t* point_wake_ = nullptr;
  struct Watcher {
    ig_field field;
    std::uint64_t changes;
  };
  std::vector<Watcher> watchers_;
  /// Fields that follow each other, as do their copies from before the block. The bits of both lie in one word each.
  struct PreviousRun {
    std::uint32_t from, to, count;
    std::uint64_t mask;  // a bit for each field of the run
  };
  std::vector<PreviousRun> previous_;
  std::vector<ig_field> frame_fields_;
  std::vector<Frame> frames_;
  Frame composed_, inverse_;
  bool composed_valid_ = false, inverse_valid_ = false, invertible_ = false;
  std::string arena_;
  std::string own_text_;
  // Of a block that is summed up.
  Summary* summary_ = nullptr;
  bool keeps_value_ = true;  // one that is not of this block alone

 public:
  FoundByPlace<RecordShape> record_shapes;  // last: what every block touches lies together

 private:
  mutable FoundByPlace<FieldGroup> groups_;
};

}  // namespace isogloss
