#include "isogloss/engine/document.hpp"

#include <algorithm>

namespace isogloss {

Document::Fields& Document::Fields::operator=(const Fields& other) {
  if (states.size() != other.states.size()) states = other.states;
  bits = other.bits;
  for (std::size_t k = 0; k < bits.size(); ++k) {
    const Bits& b = bits[k];
    for (std::uint64_t left = b.present | b.fresh | b.taken; left != 0; left &= left - 1) {
      const std::size_t f = k * 64 + static_cast<std::size_t>(std::countr_zero(left));
      states[f] = other.states[f];
    }
  }
  return *this;
}

Document::Document(const Layout& layout, std::vector<std::uint64_t> wake, std::uint32_t wake_words)
    : layout_(&layout),
      size_(static_cast<std::uint32_t>(layout.fields.size())),
      words_((size_ + 63) / 64),
      wake_words_(wake_words),
      points_end_(size_ < 2 ? 0 : size_ - 2),
      fields_(words_, size_),
      frames_(layout.transforms.size()) {
  for (ig_field f = 0; f < size_; ++f) {
    const FieldInfo& info = layout.fields[f];
    Bits& bits = fields_.bits[f >> 6];
    // Copies of `previous` fields are updated before the other values are dropped.
    if (info.life == IG_LIFE_FRAME && info.previous_of == IG_NO_FIELD) frame_fields_.push_back(f);
    if (is_carried(info.life) || info.previous_of != IG_NO_FIELD) bits.modal |= bit(f);
    if (info.type == IG_CODE) bits.codes |= bit(f);
    if (info.type == IG_CODE || info.life == IG_LIFE_WORD) bits.words |= bit(f);
    if (info.previous_of != IG_NO_FIELD) keep_previous(info.previous_of, f);
  }
  wake.resize((size_ + layout.lists.size()) * wake_words_);
  find_open_words(wake);
  Wakes wakes{std::move(wake), std::vector<std::uint64_t>(std::size_t{points_end_} * wake_words_)};
  for (std::size_t i = 0; i < wakes.by_point.size(); ++i)
    wakes.by_point[i] =
        wakes.by_field[i] | wakes.by_field[i + wake_words_] | wakes.by_field[i + 2 * std::size_t{wake_words_}];
  share(std::make_shared<const Wakes>(std::move(wakes)));
  for (const ListInfo& list : layout.lists) {
    ListData data;
    data.stride = static_cast<std::uint32_t>(list.fields.size());
    lists.push_back(std::move(data));
  }
}

/// Words of codes have the highest ids. Where a bit word holds none but them, its bits are looked at in blocks only
/// that have such words: writing one raises a bit that wakes no syntax.
void Document::find_open_words(std::vector<std::uint64_t>& wake) {
  const auto is_far = [&](ig_field f) {
    const FieldInfo& info = layout_->fields[f];
    if (info.previous_of != IG_NO_FIELD) return true;  // only begin() writes it
    return info.life == IG_LIFE_WORD && info.type != IG_CODE && std::count(info.path.begin(), info.path.end(), '.') > 1;
  };
  std::uint32_t open_end = 0;
  far_begin_ = 0;
  for (std::uint32_t w = 0; w < words_; ++w) {
    if (fields_.bits[w].words == 0) continue;
    if (open_end == 0) open_begin_ = w;
    open_end = w + 1;
    bool all_far = true;
    for (ig_field f = w * 64; f < std::min(size_, w * 64 + 64); ++f) all_far = all_far && is_far(f);
    if (!all_far) far_begin_ = w + 1;
  }
  far_end_ = open_end;
  for (ig_field f = far_begin_ * 64; f < std::min(size_, far_end_ * 64); ++f)
    wake[std::size_t{f} * wake_words_ + 1] |= holds_far_words;
}

void Document::share(std::shared_ptr<const Wakes> wakes) {
  wakes_ = std::move(wakes);
  wake_ = wakes_->by_field.data();
  point_wake_ = wakes_->by_point.data();
}

void Document::silence(std::span<const std::uint32_t> bits) {
  if (bits.empty()) return;
  Wakes own = *wakes_;
  for (const std::uint32_t bit : bits) {
    const std::uint64_t others = ~(std::uint64_t{1} << (bit % 64));
    for (std::vector<std::uint64_t>* list : {&own.by_field, &own.by_point})
      for (std::size_t i = bit / 64; i < list->size(); i += wake_words_) (*list)[i] &= others;
  }
  share(std::make_shared<const Wakes>(std::move(own)));
}

void Document::keep_previous(ig_field field, ig_field copy) {
  PreviousRun* const last = previous_.empty() ? nullptr : &previous_.back();
  if (last != nullptr && field == last->from + last->count && copy == last->to + last->count && (field & 63) != 0 &&
      (copy & 63) != 0) {
    last->mask |= std::uint64_t{1} << last->count;
    ++last->count;
  } else {
    previous_.push_back({field, copy, 1, 1});
  }
}

void Document::wake_far(const std::uint64_t* woken) {
  for (std::uint32_t k = 2; k < wake_words_; ++k) active[k] |= woken[k];
}

void Document::wake_far_of(const ig_field* fields, std::size_t bytes, std::uint32_t count) {
  for (; count != 0; --count) {
    ig_field f;
    std::memcpy(&f, fields, sizeof f);
    if (f < size_) wake_far(wake_ + std::size_t{f} * wake_words_);
    fields = reinterpret_cast<const ig_field*>(reinterpret_cast<const char*>(fields) + bytes);
  }
}

void Document::watch(ig_field f, std::uint64_t raised) {
  fields_.bits[f >> 6].watched |= bit(f);
  for (Watcher& w : watchers_)
    if (w.field == f) {
      w.changes |= raised;
      return;
    }
  watchers_.push_back({f, raised});
}

/// Mostly the same field changes from block to block (the motion in force): it moves to the front.
void Document::tell_change(ig_field f) {
  for (Watcher& w : watchers_)
    if (w.field == f) {
      changes |= w.changes;
      std::swap(w, watchers_.front());
      return;
    }
}

void Document::change_watched(ig_field f, ig_value v) {
  tell_change(f);
  fields_.states[f] = {v, written()};
  fields_.bits[f >> 6].write(bit(f));
  wake(f);
}

void Document::change_many(const ig_field* f, std::uint32_t count, const ig_value* v, std::uint32_t first) {
  set_each<true>(f, count, v, first);
}

void Document::set_watched_point(ig_field x, const double* point) {
  for (ig_field i = 0; i < 3; ++i) set(x + i, {.number = point[i]});
}

std::uint32_t Document::take_watched_point(ig_field x, std::uint32_t known) {
  ig_value taken;
  for (ig_field i = 0; i < 3; ++i)
    if ((known >> i & 1u) != 0) take(x + i, taken);
  return known;
}

void Document::own_source() {
  own_text_.assign(source.text);
  source.text = own_text_;
}

bool Document::same_content(const Document& other) const {
  for (std::uint32_t w = 0; w < words_; ++w) {
    const Bits &a = fields_.bits[w], &b = other.fields_.bits[w];
    if (a.present != b.present || a.fresh != b.fresh || a.taken != b.taken) return false;
  }
  for (ig_field f = 0; f < size_; ++f)
    if (present(f) && value(f).integer != other.value(f).integer) return false;
  for (std::size_t i = 0; i < lists.size(); ++i)
    if (!std::ranges::equal(lists[i].masks(), other.lists[i].masks())) return false;
  return leftovers.size() == other.leftovers.size() && arena_ == other.arena_;
}

std::string_view Document::text(ig_field f) const {
  if (!present(f)) return {};
  const auto packed = static_cast<std::uint64_t>(value(f).integer);
  const std::size_t begin = packed >> 32;
  if (begin > arena_.size()) return {};  // a syntax set it as a number
  return std::string_view(arena_).substr(begin, packed & 0xffffffffu);
}

void Document::set_text(ig_field f, std::string_view text) {
  ig_value v;
  v.integer = static_cast<std::int64_t>(std::uint64_t{arena_.size()} << 32 | text.size());
  arena_.append(text);
  set(f, v);
}

const FieldGroup& Document::find_group(const ig_field* f, std::uint32_t count) const {
  FieldGroup& out = groups_.beside(f, count);
  if (out.is(f, count)) [[likely]]
    return out;
  out.count = count;
  std::copy_n(f, count, out.fields.begin());
  out.word = f[0] >> 6;
  out.mask = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (f[i] >= size_ || f[i] >> 6 != out.word || (out.mask & bit(f[i])) != 0) {
      out.mask = 0;
      return out;
    }
    out.mask |= bit(f[i]);
    out.index[f[i] & 63] = static_cast<std::uint8_t>(i);
  }
  return out;
}

inline void Document::sum_up(ig_field f) {
  if (f >= size_) return;
  Summary& out = *summary_;
  if (out.fields >= Summary::most_fields) {  // too much: hand_over() sees it
    out.fields = Summary::most_fields + 1;
    return;
  }
  const State& state = fields_.states[f];
  out.field[out.fields++] = {state.value, state.place | std::uint64_t{f} << Summary::Field::field_at};
}

void Document::add_words(const ig_word* w, std::uint32_t count) {
  set_words(w, count);
  if (summary_ == nullptr) return;
  for (const ig_word& word : std::span(w, count)) sum_up(word.field);
}

void Document::add(ig_field f, ig_value v) {
  if (f >= size_) return;
  count_code(f);
  set(f, v);
  if (summary_ != nullptr) sum_up(f);
}

bool Document::hand_over() {
  Summary& out = *summary_;
  if (size_ > UINT16_MAX || codes_seen > UINT16_MAX || out.fields > Summary::most_fields) return false;
  out.wakes[0] = active[0];
  out.wakes[1] = active[1];
  out.codes = static_cast<std::uint16_t>(codes_seen);
  auto* const pieces = reinterpret_cast<Summary::Piece*>(out.field + out.fields);
  std::uint32_t count = 0;
  std::uint64_t modal = 0;
  for (const Summary::Field& field : std::span(out.field, out.fields)) {
    const std::uint32_t word = field.id() >> 6;
    Bits& bits = fields_.bits[word];
    if (bits.fresh == 0) continue;  // taken out with another field
    if (count == Summary::most_pieces) return false;
    modal |= bits.fresh & bits.modal;
    pieces[count++] = {word, bits.fresh, bits.pointless};
    bits.carry();
  }
  out.pieces = count;
  keeps_value_ = modal != 0;
  return true;
}

void Document::tell_changes(const Summary::Field* fields, std::uint32_t count) {
  for (const Summary::Field& field : std::span(fields, count))
    if (is_watched(field.id()) && !has_value(field.id(), field.value)) tell_change(field.id());
}

void Document::mark_pointless(ig_field f, bool pointless) {
  Bits& bits = fields_.bits[f >> 6];
  bits.pointless = pointless ? bits.pointless | bit(f) : bits.pointless & ~bit(f);
}

void Document::rewrite(ig_field f, ig_value v) {
  if (!present(f)) return;
  if (is_watched(f) && !has_value(f, v)) tell_change(f);
  State& state = fields_.states[f];
  state.value = v;
  state.place = written() | (state.place & 0xffffffffu);
  mark_pointless(f, false);
}

void Document::move(ig_field from, ig_field to) {
  if (!present(from) || to >= size_) return;
  const State moved = fields_.states[from];
  set(to, moved.value);
  fields_.states[to].place = written() | (moved.place & 0xffffffffu);
  mark_pointless(to, without_point(from));
  erase(from);
}

void Document::begin(const BlockSource& where) {
  State* const state = fields_.states.data();
  Bits* const all = fields_.bits.data();
  for (const PreviousRun& run : previous_) {
    // One by one, as they were written: a larger piece would have to wait until the last of them is in memory.
    const State* const from = state + run.from;
    State* const to = state + run.to;
#pragma GCC unroll 4
    for (std::uint32_t i = 0; i < run.count; ++i) to[i].value = from[i].value;
    if (!origins.empty()) [[unlikely]]  // who wrote it is asked in traced mode only
      for (std::uint32_t i = 0; i < run.count; ++i) to[i].place = from[i].place;
    const std::uint64_t known = all[run.from >> 6].present >> (run.from & 63) & run.mask;
    std::uint64_t& copies = all[run.to >> 6].present;
    copies = (copies & ~(run.mask << (run.to & 63))) | known << (run.to & 63);
  }
  const auto carry = [all](std::uint32_t first, std::uint32_t last) {
#pragma GCC unroll 3
    for (Bits* bits = all + first; bits != all + last; ++bits) bits->carry();
  };
  carry(0, far_begin_);
  if (has_far_words()) [[unlikely]]
    carry(far_begin_, far_end_);
  carry(far_end_, words_);
  for (ListData& list : lists) {
    if (list.count != 0) list.clear();
  }
  leftovers.clear();
  arena_.clear();
  source = where;
  codes_seen = 0;
  if (frame_moved)
    for (Frame& f : frames_) f.is_moving = false;
  frame_changed = frame_moved = false;
  if ((active[1] & wakes_beyond) != 0) [[unlikely]]
    std::fill(active + 2, active + wake_words_, 0);
  active[0] = active[1] = 0;
}

void Document::get_frame_values(FrameValues& out) const {
  out.clear();
  for (const ig_field f : frame_fields_)
    out.push_back(present(f) ? std::optional(fields_.states[f].value) : std::nullopt);
}

void Document::clear_frame_values() {
  for (const ig_field f : frame_fields_) erase(f);
}

void Document::set_frame_values(const FrameValues& values) {
  for (std::size_t i = 0; i < frame_fields_.size(); ++i) {
    erase(frame_fields_[i]);
    if (values[i]) write(frame_fields_[i], *values[i]);
  }
}

void Document::add_leftover(ig_leftover_kind kind, ig_field field, std::uint32_t begin, std::uint32_t end,
                            std::string_view name) {
  if (kind == IG_LEFT_TEXT && !leftovers.empty() && leftovers.back().kind == IG_LEFT_TEXT &&
      leftovers.back().end == begin) {
    leftovers.back().end = end;
    leftovers.back().name.append(name);
    return;
  }
  leftovers.push_back({kind, field, begin, end, std::string(name)});
}

std::vector<Leftover> Document::collect_leftovers() const {
  std::vector<Leftover> all = leftovers;
  constexpr std::string_view flags = "Parsing.Flags.", parsing = "Parsing.";
  for (std::uint32_t w = 0; w < words_; ++w) {
    std::uint64_t open = fields_.bits[w].present & fields_.bits[w].words & ~fields_.bits[w].taken;
    for (; open != 0; open &= open - 1) {
      const ig_field f = w * 64 + static_cast<ig_field>(__builtin_ctzll(open));
      std::string_view name = layout_->fields[f].path;
      if (name.starts_with(flags))
        name.remove_prefix(flags.size());
      else if (name.starts_with(parsing))
        name.remove_prefix(parsing.size());
      const bool is_code = (fields_.bits[w].codes & bit(f)) != 0;
      all.push_back({is_code ? IG_LEFT_CODE : IG_LEFT_WORD, f, word_begin(f), word_end(f), std::string(name)});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Leftover& a, const Leftover& b) { return a.begin < b.begin; });
  return all;
}

void Document::set_frame(ig_field f, const Frame& frame) {
  Frame& slot = frames_[frame_index(f)];
  const bool same = present(f) ? std::equal(std::begin(slot.matrix), std::end(slot.matrix), std::begin(frame.matrix))
                               : frame.kind == Frame::Kind::identity;
  slot = frame;
  set(f, fields_.states[f].value);
  if (same) return;
  frame_changed = frame_moved = true;
  composed_valid_ = false;
}

void Document::move_frame(ig_field f, const double* matrix) {
  Frame& slot = frames_[frame_index(f)];
  slot.assign(matrix);
  slot.is_moving = true;
  set(f, fields_.states[f].value);
  frame_moved = true;
  composed_valid_ = false;
}

void Document::compose() {
  bool is_first = true;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Frame& entry = frames_[i];
    if (entry.kind == Frame::Kind::identity || !present(layout_->transforms[i])) continue;
    if (is_first)
      composed_ = entry;
    else
      composed_.append(entry);
    is_first = false;
  }
  if (is_first) composed_ = Frame{};
  composed_valid_ = true;
  inverse_valid_ = false;
}

bool Document::map_to_program(const double (&in)[3], double (&out)[3]) {
  const Frame& forward = composed();
  if (!inverse_valid_) {
    const std::optional<Frame> inverse = forward.inverse();
    invertible_ = inverse.has_value();
    if (inverse) inverse_ = *inverse;
    inverse_valid_ = true;
  }
  if (!invertible_) return false;
  inverse_.map(in, out);
  return true;
}

}  // namespace isogloss
