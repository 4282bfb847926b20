/// The host's functions for what a block holds: values, words, codes, texts, and the frames from program to machine.
#pragma once

#include <algorithm>
#include <cstring>

#include "contract/host_access.hpp"

namespace isogloss::calls {

template <Mode M>
std::int32_t get(const ig_block* block, ig_field f, ig_value* out) {
  const Document& d = doc(block);
  if (!may<M>(d, f, Use::read) || !d.present(f)) return 0;
  *out = d.value(f);
  return 1;
}

/// The answer has a bit for each field, so there are no more than its bits.
template <Mode M>
bool fits_mask(const ig_block* block, std::uint32_t count) {
  constexpr std::uint32_t most = 32;
  if (M != Mode::checked || count <= most) return true;
  violation(doc(block), "it asks for " + std::to_string(count) + " fields at once, while the answer has 32 bits");
  return false;
}

template <Mode M>
std::uint32_t get_many(const ig_block* block, const ig_field* fields, std::uint32_t count, ig_value* out) {
  if constexpr (M == Mode::fast) {
    return doc(block).get_many(fields, count, out);
  }
  if (!fits_mask<M>(block, count)) return 0;
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (get<M>(block, fields[i], out + i) != 0) mask |= 1u << (i & 31);
  return mask;
}

template <Mode M>
std::int32_t take(ig_block* block, ig_field f, ig_value* out) {
  Document& d = doc(block);
  return may<M>(d, f, Use::take) && d.take(f, *out) ? 1 : 0;
}

template <Mode M>
std::uint32_t take_many(ig_block* block, const ig_field* fields, std::uint32_t count, ig_value* out) {
  if constexpr (M == Mode::fast) {
    return doc(block).take_many(fields, count, out);
  }
  if (!fits_mask<M>(block, count)) return 0;
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (take<M>(block, fields[i], out + i) != 0) mask |= 1u << (i & 31);
  return mask;
}

template <Mode M>
void set(ig_block* block, ig_field f, ig_value v) {
  Document& d = doc(block);
  if (!may<M>(d, f, Use::write) || !sound<M>(d, f, v)) return;
  const Change change = change_to<M>(d, f, v);
  d.count_code(f);
  d.set(f, v);
  note_line<M>(d, f, change);
}

template <Mode M>
void set_many(ig_block* block, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  if constexpr (M == Mode::fast) {
    doc(block).set_many(fields, count, v);
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i) set<M>(block, fields[i], v[i]);
}

template <Mode M>
void amend_many(ig_block* block, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  Document& d = doc(block);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!may<M>(d, fields[i], Use::write) || !sound<M>(d, fields[i], v[i])) continue;
    const Change change = change_to<M>(d, fields[i], v[i]);
    d.write(fields[i], v[i]);
    d.count_code(fields[i]);
    note_line<M>(d, fields[i], change);
  }
}

template <Mode M>
void erase(ig_block* block, ig_field f) {
  Document& d = doc(block);
  if (may<M>(d, f, Use::write)) d.erase(f);
}

template <Mode M>
std::int32_t is_fresh(const ig_block* block, ig_field f) {
  const Document& d = doc(block);
  return may<M>(d, f, Use::read) && d.fresh(f) ? 1 : 0;
}

template <Mode M>
std::uint32_t fresh_many(const ig_block* block, const ig_field* fields, std::uint32_t count) {
  if (!fits_mask<M>(block, count)) return 0;
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (is_fresh<M>(block, fields[i]) != 0) mask |= 1u << (i & 31);
  return mask;
}

// Three fields side by side. Fields in another layout, and accesses that are checked, go one by one, outside of the
// fast table.

inline ig_field beside(ig_field x, std::uint32_t i) { return x > IG_NO_FIELD - 2 ? IG_NO_FIELD : x + i; }

template <Mode M>
[[gnu::noinline]] std::uint32_t get_three(const ig_block* block, ig_field x, double* out) {
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    ig_value v{};
    if (get<M>(block, beside(x, i), &v) != 0) mask |= 1u << i;
    out[i] = v.number;
  }
  return mask;
}

template <Mode M>
std::uint32_t get_point(const ig_block* block, ig_field x, double* out) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]]
      return doc(block).get_point(x, out);
  return get_three<M>(block, x, out);
}

template <Mode M>
[[gnu::noinline]] std::uint32_t take_three(ig_block* block, ig_field x, double* out) {
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    ig_value v{};
    if (take<M>(block, beside(x, i), &v) != 0) mask |= 1u << i;
    out[i] = v.number;
  }
  return mask;
}

template <Mode M>
std::uint32_t take_point(ig_block* block, ig_field x, double* out) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]]
      return doc(block).take_point(x, out);
  return take_three<M>(block, x, out);
}

template <Mode M>
[[gnu::noinline]] void set_three(ig_block* block, ig_field x, const double* point) {
  for (std::uint32_t i = 0; i < 3; ++i) set<M>(block, beside(x, i), {.number = point[i]});
}

template <Mode M>
void set_point(ig_block* block, ig_field x, const double* point) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]] {
      doc(block).set_point(x, point);
      return;
    }
  set_three<M>(block, x, point);
}

template <Mode M>
std::uint32_t fresh_point(const ig_block* block, ig_field x) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]]
      return doc(block).fresh_point(x);
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < 3; ++i)
    if (is_fresh<M>(block, beside(x, i)) != 0) mask |= 1u << i;
  return mask;
}

// Nearly all calls find one code or none: apart from the search among several they need no frame on the stack.

template <Mode M>
[[gnu::noinline]] std::int32_t find_code_of_several(const ig_block* block, const ig_field* fields, std::uint32_t count,
                                                    std::uint32_t* found) {
  const Document& d = doc(block);
  std::int32_t last = -1;
  std::int64_t ordinal = -1;
  *found = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!may<M>(d, fields[i], Use::read) || !d.present(fields[i])) continue;
    ++*found;
    if (d.value(fields[i]).integer > ordinal) {
      ordinal = d.value(fields[i]).integer;
      last = static_cast<std::int32_t>(i);
    }
  }
  return last;
}

template <Mode M>
[[gnu::noinline]] std::int32_t find_seen_code(const ig_block* block, const ig_field* fields, std::uint32_t count,
                                              std::uint32_t* found) {
  if constexpr (M == Mode::fast)
    if (const std::int32_t only = doc(block).only_present(fields, count); only != Document::several_present) {
      *found = only >= 0 ? 1 : 0;
      return only;
    }
  return find_code_of_several<M>(block, fields, count, found);
}

template <Mode M>
std::int32_t find_code(const ig_block* block, const ig_field* fields, std::uint32_t count, std::uint32_t* found) {
  *found = 0;
  return doc(block).codes_seen == 0 ? -1 : find_seen_code<M>(block, fields, count, found);
}

template <Mode M>
std::int32_t take_code(ig_block* block, const ig_field* fields, std::uint32_t count, std::uint32_t* found) {
  Document& d = doc(block);
  std::int32_t last = -1;
  std::int64_t ordinal = -1;
  *found = 0;
  if (d.codes_seen == 0) return -1;
  if constexpr (M == Mode::fast)
    if (d.only_present(fields, count) == Document::none_present) return -1;
  for (std::uint32_t i = 0; i < count; ++i) {
    ig_value value;
    if (!d.present(fields[i]) || take<M>(block, fields[i], &value) == 0) continue;
    ++*found;
    if (value.integer <= ordinal) continue;
    ordinal = value.integer;
    last = static_cast<std::int32_t>(i);
  }
  return last;
}

template <Mode M>
ig_text text(const ig_block* block, ig_field f) {
  const Document& d = doc(block);
  if (!may<M>(d, f, Use::read) || !is_of_type<M>(d, f, IG_TEXT, "text()")) return {nullptr, 0};
  const std::string_view t = d.text(f);
  return {t.data(), t.size()};
}

template <Mode M>
void set_text(ig_block* block, ig_field f, ig_text t) {
  Document& d = doc(block);
  if (!may<M>(d, f, Use::write) || !is_of_type<M>(d, f, IG_TEXT, "set_text()")) return;
  d.set_text(f, {t.data, t.size});
  note_line<M>(d, f, Change::value);
}

inline ig_text source(const ig_block* block) { return {doc(block).source.text.data(), doc(block).source.text.size()}; }

/// A word's value may be a text: the bytes between its columns.
template <Mode M>
bool is_word(const Document& d, const ig_word& word) {
  check_columns<M>(d, word.begin, word.end, "a word");
  return d.layout().fields[word.field].type == IG_TEXT || sound<M>(d, word.field, word.value);
}

template <Mode M>
void set_words(ig_block* block, const ig_word* words, std::uint32_t count) {
  Document& d = doc(block);
  if constexpr (M == Mode::fast) {
    d.set_words(words, count);
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!may<M>(d, words[i].field, Use::write) || !is_word<M>(d, words[i])) continue;
    d.set_words(words + i, 1);
    note_line<M>(d, words[i].field, Change::value);
  }
}

template <Mode M>
void rewrite(ig_block* block, ig_field f, ig_value v) {
  Document& d = doc(block);
  if (!may<M>(d, f, Use::write) || !sound<M>(d, f, v)) return;
  d.rewrite(f, v);
  note_line<M>(d, f, Change::value);
}

template <Mode M>
void move(ig_block* block, ig_field from, ig_field to) {
  Document& d = doc(block);
  if (!may<M>(d, from, Use::take) || !may<M>(d, to, Use::write)) return;
  if constexpr (M == Mode::checked)
    if (d.layout().fields[from].type != d.layout().fields[to].type)
      violation(d, "it moves " + field_name(d, from) + " to " + field_name(d, to) + ", which is of another type");
  d.move(from, to);
  note_line<M>(d, to, Change::value);
}

template <Mode M>
std::int32_t word(const ig_block* block, ig_field f, ig_word* out) {
  const Document& d = doc(block);
  if (!may<M>(d, f, Use::read) || !d.present(f)) return 0;
  *out = {f,
          static_cast<std::uint16_t>(d.word_begin(f)),
          static_cast<std::uint16_t>(d.word_end(f)),
          d.value(f),
          d.without_point(f) ? std::uint32_t{IG_WORD_WITHOUT_POINT} : 0u,
          0};
  return d.word_end(f) != 0 ? 1 : 0;
}

template <Mode M>
bool is_transform(const Document& d, ig_field f, Use use) {
  return may<M>(d, f, use) && is_of_type<M>(d, f, IG_TRANSFORM, "a function of transforms");
}

template <Mode M>
bool is_finite(const Document& d, ig_field f, const double matrix[16]) {
  if constexpr (M == Mode::checked)
    if (!std::all_of(matrix, matrix + 16, [](double m) { return std::isfinite(m); })) {
      violation(d, "it gives " + field_name(d, f) + " a value that is not a number");
      return false;
    }
  return true;
}

template <Mode M>
void set_transform(ig_block* block, ig_field f, const double matrix[16]) {
  Document& d = doc(block);
  if (!is_transform<M>(d, f, Use::write) || !is_finite<M>(d, f, matrix)) return;
  const Change change = M == Mode::traced && d.present(f) && d.frame(f).is_same(matrix) ? Change::none : Change::value;
  d.set_frame(f, Frame::from(matrix));
  note_line<M>(d, f, change);
}

template <Mode M>
void set_moving_transform(ig_block* block, ig_field f, const double matrix[16]) {
  Document& d = doc(block);
  if (!is_transform<M>(d, f, Use::write) || !is_finite<M>(d, f, matrix)) return;
  const Change change = M == Mode::traced && d.present(f) && d.frame(f).is_same(matrix) ? Change::none : Change::value;
  d.move_frame(f, matrix);
  note_line<M>(d, f, change);
}

template <Mode M>
void set_translation(ig_block* block, ig_field f, const double offset[3]) {
  const double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, offset[0], offset[1], offset[2], 1};
  set_transform<M>(block, f, m);
}

template <Mode M>
std::int32_t transform(const ig_block* block, ig_field f, double matrix[16]) {
  const Document& d = doc(block);
  if (!is_transform<M>(d, f, Use::read) || !d.present(f)) return 0;
  std::memcpy(matrix, d.frame(f).matrix, sizeof d.frame(f).matrix);
  return 1;
}

inline std::int32_t map_point(ig_block* block, ig_direction direction, const double in[3], double out[3]) {
  Document& d = doc(block);
  const double from[3] = {in[0], in[1], in[2]};
  double to[3];
  if (direction == IG_TO_MACHINE)
    d.composed().map(from, to);
  else if (!d.map_to_program(from, to))
    return 0;
  std::memcpy(out, to, sizeof to);
  return 1;
}

inline std::int32_t frame_changed(const ig_block* block) { return doc(block).frame_changed ? 1 : 0; }

}  // namespace isogloss::calls
