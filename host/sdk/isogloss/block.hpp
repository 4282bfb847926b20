/// The block document as a syntax sees it while it runs: inlined calls of the host's table ig_host.
#pragma once

#include <isogloss_view.h>

#include <optional>
#include <string>

#include "isogloss/diagnostics.hpp"
#include "isogloss/options.hpp"

namespace ig {

/// Where a diagnostic points: at a word, at a range of byte columns (0-based, end exclusive), or at the whole block.
struct Where {
  ig_field field = IG_NO_FIELD;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  /// The whole block, a word (also the code with this field), or columns of the text; in restart() of the program's.
  static Where block() { return {}; }
  static Where word(ig_field id) { return {id, 0, 0}; }
  static Where columns(std::size_t begin, std::size_t end) {
    return {IG_NO_FIELD, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }
};

/// The words that a code owned, after Block::take(Call) has taken them. operator[] gives nothing for a word that the
/// block does not hold.
struct Words {
  std::size_t row = 0;  ///< index of the code in the Call's list
  Symbol code;
  std::string_view letters;
  std::uint32_t mask = 0;
  std::array<ig_value, 32> values;

  std::optional<double> operator[](char letter) const {
    const std::size_t at = letters.find(letter);
    if (at == std::string_view::npos || (mask >> at & 1u) == 0) return std::nullopt;
    return values[at].number;
  }
};

/// A handle: cheap to copy, valid only during the call of build(), scan() or restart() that received it. A field is
/// reached through the member that declares it. Lengths are in mm and angles in degrees, as everywhere in the document.
class Block {
 public:
  Block(const ig_host* host, ig_block* block)
      : host_(host),
        block_(block),
        shown_((host->flags & IG_HOST_SHOWS_BLOCKS) != 0 ? reinterpret_cast<const ig_view*>(block) : nullptr) {}

  /// False where the field has no value.
  bool get(ig_field f, ig_value& out) const {
    const ig_view* const shown = view();
    if (shown == nullptr) [[unlikely]]
      return host_->get(block_, f, &out) != 0;
    if (!shows(shown, f)) return false;
    out = shown->values[f].value;
    return true;
  }
  template <class T>
  std::optional<T> get(const Field<T>& field) const {
    ig_value v;
    if (!get(field.id(), v)) return std::nullopt;
    return detail::ValueOf<T>::read(v);
  }
  template <class T>
  T get_or(const Field<T>& field, T fallback) const {
    ig_value v;
    return get(field.id(), v) ? detail::ValueOf<T>::read(v) : fallback;
  }
  bool is(const Field<Symbol>& field, Symbol name) const {
    ig_value v;
    return get(field.id(), v) && v.symbol == name.id;
  }
  PartialVec3 get(const Xyz& xyz) const {
    if (const ig_view* const shown = view(); shown != nullptr && three(shown, xyz) == 7) [[likely]] {
      const ig_view_value* const v = shown->values + xyz.point();
      return {7, {v[0].value.number, v[1].value.number, v[2].value.number}};
    }
    return get_partial(xyz);
  }
  bool has(ig_field f) const {
    const ig_view* const shown = view();
    if (shown == nullptr) [[unlikely]] {
      ig_value v;
      return host_->get(block_, f, &v) != 0;
    }
    return shows(shown, f);
  }
  template <class F>
  bool has(const F& field) const {
    return has(ig_field{field.id()});
  }
  /// True when at least one of the fields has a value.
  template <class... F>
  bool has_any(const F&... fields) const {
    return (has(fields) || ...);
  }
  bool has_any(const AnyOf& fields) const {
    return any(fields, &ig_view_bits::present, [this](ig_field f) { return has(f); });
  }
  /// Reads at most 32 fields; returns a bit for each that has a value. `out` is left alone for the others.
  std::uint32_t get_many(const ig_field* fields, std::uint32_t count, ig_value* out) const {
    const ig_view* const shown = view();
    if (shown == nullptr) [[unlikely]]
      return host_->get_many(block_, fields, count, out);
    std::uint32_t mask = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!shows(shown, fields[i])) continue;
      out[i] = shown->values[fields[i]].value;
      mask |= 1u << i;
    }
    return mask;
  }
  /// A bit for each of at most 32 fields that was written in this block.
  std::uint32_t fresh_many(const ig_field* fields, std::uint32_t count) const {
    std::uint32_t mask = 0;
    for (std::uint32_t i = 0; i < count; ++i) mask |= static_cast<std::uint32_t>(is_fresh(fields[i])) << i;
    return mask;
  }
  /// True when the field was written in this block; false when its value was carried from an earlier one.
  bool is_fresh(ig_field f) const {
    const ig_view* const shown = view();
    if (shown == nullptr) [[unlikely]]
      return host_->is_fresh(block_, f) != 0;
    return shows_fresh(shown, f);
  }
  bool is_any_fresh(const AnyOf& fields) const {
    return any(fields, &ig_view_bits::fresh, [this](ig_field f) { return is_fresh(f); });
  }
  template <class F>
  bool is_fresh(const F& field) const {
    return is_fresh(ig_field{field.id()});
  }
  bool is_fresh(const Xyz& xyz) const {
    if (const ig_view* const shown = view(); shown != nullptr && lies_in_one_word(xyz)) [[likely]]
      return (shown->bits[xyz.point() / 64].fresh >> (xyz.point() % 64) & 7u) != 0;
    return (xyz.point() != IG_NO_FIELD ? host_->fresh_point(block_, xyz.point())
                                       : host_->fresh_many(block_, xyz.ids(), 3)) != 0;
  }

  /// Sets a value: the field becomes fresh, and the syntaxes that wake on it run.
  template <class T>
  void set(const Field<T>& field, T value) {
    host_->set(block_, field.id(), detail::ValueOf<T>::write(value));
  }
  void set(const Field<Symbol>& field, const Name& name) { set(field, static_cast<Symbol>(name)); }
  void set(const Xyz& xyz, const Vec3& p) {
    if (xyz.point() != IG_NO_FIELD) {
      const double v[3] = {p.x, p.y, p.z};
      host_->set_point(block_, xyz.point(), v);
      return;
    }
    const ig_value v[3] = {{.number = p.x}, {.number = p.y}, {.number = p.z}};
    host_->set_many(block_, xyz.ids(), 3, v);
  }
  /// Changes a carried value: value and writer change, but no syntax wakes and the field does not become fresh.
  void amend(const Xyz& xyz, const Vec3& p) {
    const ig_value v[3] = {{.number = p.x}, {.number = p.y}, {.number = p.z}};
    host_->amend_many(block_, xyz.ids(), 3, v);
  }
  template <class T>
  void amend(const Field<T>& field, T value) {
    const ig_value v = detail::ValueOf<T>::write(value);
    const ig_field id = field.id();
    host_->amend_many(block_, &id, 1, &v);
  }
  template <class F>
  void erase(const F& field) {
    host_->erase(block_, field.id());
  }
  /// Puts a code, or a signal, into the block for the syntaxes after this one.
  void raise(ig_field code) { host_->set(block_, code, present); }
  void raise(const Signal& signal) { host_->set(block_, signal.id(), ig_value{}); }
  bool is_raised(const Signal& signal) const { return has(signal); }

  /// Takes a word: later syntaxes do not see it, and it is not reported as unused. Nothing where the block does not
  /// hold it.
  std::optional<double> take(const Word& word) {
    if (const ig_view* const shown = view(); shown != nullptr && !shows(shown, word.id())) return std::nullopt;
    ig_value v;
    if (host_->take(block_, word.id(), &v) == 0) return std::nullopt;
    return v.number;
  }
  PartialVec3 take(const Xyz& xyz) {
    if (xyz.point() != IG_NO_FIELD) {
      double v[3];
      const std::uint32_t mask = host_->take_point(block_, xyz.point(), v);
      return {mask, {v[0], v[1], v[2]}};
    }
    ig_value v[3];
    return triple(host_->take_many(block_, xyz.ids(), 3, v), v);
  }

  /// Takes all codes of the group; returns the index of the last one in the block, nothing where there is none. `found`
  /// receives how many there were.
  std::optional<std::size_t> take(const Codes& codes, std::uint32_t* found = nullptr) {
    std::uint32_t n = 0;
    const std::int32_t i = host_->take_code(block_, codes.ids(), codes.size(), found != nullptr ? found : &n);
    return index(i);
  }
  /// Like take(), but takes nothing.
  std::optional<std::size_t> find(const Codes& codes) const {
    std::uint32_t n = 0;
    const std::int32_t i = host_->find_code(block_, codes.ids(), codes.size(), &n);
    return index(i);
  }

  /// Takes the last call in the block with all its words; nothing where the block holds none of its codes.
  std::optional<Words> take(const Call& call) {
    std::uint32_t n = 0;
    const std::int32_t row = host_->take_code(block_, call.codes(), call.code_count(), &n);
    if (row < 0) return std::nullopt;
    Words words;
    words.row = static_cast<std::size_t>(row);
    words.code = call.name(words.row);
    words.letters = call.letters();
    words.mask = host_->take_many(block_, call.row(words.row), static_cast<std::uint32_t>(words.letters.size()),
                                  words.values.data());
    return words;
  }
  std::optional<std::size_t> find(const Call& call) const {
    std::uint32_t n = 0;
    const std::int32_t row = host_->find_code(block_, call.codes(), call.code_count(), &n);
    return index(row);
  }
  /// Puts a call into the block for the syntaxes after this one.
  void set_call(const Call& call, std::size_t row) { raise(call.code(row)); }
  void set_word(const Call& call, std::size_t row, char letter, double value) {
    host_->set(block_, call.word(row, letter), {.number = value});
  }

  // The same functions by id, for members that declare many fields at once.

  void set(ig_field f, double number) { host_->set(block_, f, {.number = number}); }
  void set(ig_field f, ig_value value) { host_->set(block_, f, value); }
  /// Sets at most 32 fields.
  void set_many(const ig_field* fields, std::uint32_t count, const ig_value* values) {
    host_->set_many(block_, fields, count, values);
  }
  void amend_many(const ig_field* fields, std::uint32_t count, const ig_value* values) {
    host_->amend_many(block_, fields, count, values);
  }
  void erase(ig_field f) { host_->erase(block_, f); }
  /// False where the block does not hold the word, or another syntax has taken it.
  bool take(ig_field f, ig_value& out) { return host_->take(block_, f, &out) != 0; }
  /// Takes a word whose value does not matter.
  bool take(ig_field f) {
    ig_value unused;
    return take(f, unused);
  }
  /// Takes at most 32 words; returns a bit for each that the block held.
  std::uint32_t take_many(const ig_field* fields, std::uint32_t count, ig_value* out) {
    return host_->take_many(block_, fields, count, out);
  }
  /// Takes all of these codes; returns the index of the last one in the block, or -1. `found` receives how many there
  /// were.
  std::int32_t take_code(const ig_field* codes, std::uint32_t count, std::uint32_t* found = nullptr) {
    std::uint32_t n = 0;
    return host_->take_code(block_, codes, count, found != nullptr ? found : &n);
  }
  /// Like take_code(), but takes nothing.
  std::int32_t find_code(const ig_field* codes, std::uint32_t count, std::uint32_t* found = nullptr) const {
    std::uint32_t n = 0;
    return host_->find_code(block_, codes, count, found != nullptr ? found : &n);
  }

  // Words, for scanners and for syntaxes that rewrite what scanners wrote.

  /// What a scanner that scans_ahead() asks before it does anything outside the block, or keeps anything for build().
  /// False: return the position. The text will be scanned again in its turn.
  bool is_in_turn() const {
    return host_->struct_size < offsetof(ig_host, in_turn) + sizeof host_->in_turn || host_->in_turn(block_) != 0;
  }
  void set_words(const ig_word* words, std::uint32_t count) { host_->set_words(block_, words, count); }
  void set_word(const ig_word& word) { host_->set_words(block_, &word, 1); }
  /// Replaces the value of a word: its columns, life and mark stay, IG_WORD_WITHOUT_POINT is cleared.
  void rewrite(ig_field word, double number) { host_->rewrite(block_, word, {.number = number}); }
  void rewrite(ig_field word, ig_value value) { host_->rewrite(block_, word, value); }
  /// Makes the word one of another field; its columns and its mark go with it.
  void move(ig_field from, ig_field to) { host_->move(block_, from, to); }
  /// The place of a word; false where it has none in the text.
  bool word(ig_field f, ig_word& out) const { return host_->word(block_, f, &out) != 0; }

  // Records of a list, CompoundMotion.Items for instance. All fields of one call belong to the same list.

  void append(const ig_field* fields, std::uint32_t count, const ig_value* values) {
    host_->append(block_, fields, count, values);
  }
  std::uint32_t count(ig_field any_of_list) const { return host_->count(block_, any_of_list); }
  /// Reads at most 32 fields of record `index`, from 0; returns a bit for each that the record holds.
  std::uint32_t record(std::uint32_t index, const ig_field* fields, std::uint32_t count, ig_value* out) const {
    return host_->record(block_, index, fields, count, out);
  }
  void set_record(std::uint32_t index, const ig_field* fields, std::uint32_t count, const ig_value* values) {
    host_->set_record(block_, index, fields, count, values);
  }
  /// Computes the three `machine` fields from the three `program` fields, through the frame, in each record that has
  /// the latter and lacks the former.
  void map_records(const ig_field* program, const ig_field* machine) { host_->map_records(block_, program, machine); }

  /// The k-th executed block after this one, k from 1; nothing past the end of the program. The spec must say
  /// looks_ahead().
  std::optional<Block> ahead(std::uint32_t k) {
    ig_block* const next = host_->ahead(block_, k);
    return next != nullptr ? std::optional<Block>(Block(host_, next)) : std::nullopt;
  }

  /// Texts are borrowed: copy a text that must outlive a change of its field or the call of build(). source() is the
  /// text of the block.
  std::string_view text(const TextField& field) const { return to_view(host_->text(block_, field.id())); }
  void set_text(const TextField& field, std::string_view text) { host_->set_text(block_, field.id(), to_text(text)); }
  std::string_view source() const { return to_view(host_->source(block_)); }

  /// Set an entry of the frame, the map from program to machine coordinates. Matrices are 4 x 4, row vectors, with the
  /// translation in mm in elements 12 to 14.
  void set_translation(const Transform& t, const Vec3& offset) {
    const double v[3] = {offset.x, offset.y, offset.z};
    host_->set_translation(block_, t.id(), v);
  }
  void set_transform(const Transform& t, const double (&matrix)[16]) { host_->set_transform(block_, t.id(), matrix); }
  /// Sets an entry of the frame that moves with the axes during the block, with its value at the block's end. The tool
  /// tip moves along, so frame_changed() is not affected.
  void set_moving_transform(const Transform& t, const double (&matrix)[16]) {
    host_->set_moving_transform(block_, t.id(), matrix);
  }
  void set_transform(const Transform& t, const std::array<double, 16>& matrix) {
    host_->set_transform(block_, t.id(), matrix.data());
  }
  void set_moving_transform(const Transform& t, const std::array<double, 16>& matrix) {
    host_->set_moving_transform(block_, t.id(), matrix.data());
  }
  /// One entry of the frame; false, with `matrix` unchanged, where the entry is not set.
  bool get(const Transform& t, double (&matrix)[16]) const { return host_->transform(block_, t.id(), matrix) != 0; }
  bool get(const Transform& t, std::array<double, 16>& matrix) const {
    return host_->transform(block_, t.id(), matrix.data()) != 0;
  }
  /// True when an entry of the frame was set to another value in this block while the tool was at rest.
  bool frame_changed() const { return host_->frame_changed(block_) != 0; }
  /// A point mapped through all entries of the frame; nothing where the frame has no inverse.
  std::optional<Vec3> to_machine(const Vec3& program) { return map(IG_TO_MACHINE, program); }
  std::optional<Vec3> to_program(const Vec3& machine) { return map(IG_TO_PROGRAM, machine); }

  Symbol symbol(std::string_view name) { return {host_->symbol(block_, to_text(name))}; }
  std::string_view text(Symbol symbol) const {
    return to_view(host_->symbol_text(block_, static_cast<ig_symbol>(symbol.id)));
  }

  /// Reports a diagnostic that the plugin declares. The arguments, numbers or texts, replace {0}, {1} … in its text. A
  /// code that no file of the plugin declares is a fault of the syntax.
  template <class... Args>
  void report(DiagnosticCode diagnostic, Where where, const Args&... args) {
    const std::uint32_t number = detail::diagnostic_table().find(diagnostic.code);
    if (number == detail::DiagnosticTable::no_such_row) return report_undeclared(diagnostic);
    report(number, where, args...);
  }
  /// Reports a diagnostic by its index in the array given to ISOGLOSS_PLUGIN().
  template <class... Args>
  void report(std::uint32_t diagnostic, Where where, const Args&... args) {
    const std::array<ig_argument, sizeof...(Args)> list{detail::argument(args)...};
    host_->report(block_, diagnostic, where.field, where.begin, where.end, list.data(), sizeof...(Args));
  }

  /// end_program(): the run ends after this block. alarm(): the control would stop here; whether the run goes on is
  /// decided by --on-error. flow(): see ig_flow.
  void end_program() { host_->flow(block_, IG_FLOW_END, 0); }
  void alarm() { host_->flow(block_, IG_FLOW_ALARM, 0); }
  void flow(ig_flow what, std::size_t position = 0) { host_->flow(block_, what, position); }

  /// The C interface, for what this class does not cover.
  const ig_host* host() const { return host_; }
  ig_block* raw() const { return block_; }

 private:
  [[gnu::cold, gnu::noinline]] void report_undeclared(DiagnosticCode diagnostic) const {
    const std::string fault = "no file of the plugin declares the diagnostic " + std::string(diagnostic.code);
    host_->fault(block_, to_text(fault));
  }
  static std::optional<std::size_t> index(std::int32_t row) {
    if (row < 0) return std::nullopt;
    return static_cast<std::size_t>(row);
  }
  /// Null where this host does not show where the values are stored; then its functions are called.
  const ig_view* view() const { return shown_; }
  /// `ask` about each where the block is not shown, or where one is no field of the block.
  template <class Ask>
  [[gnu::always_inline]] bool any(const AnyOf& fields, std::uint64_t ig_view_bits::*which, const Ask& ask) const {
    const ig_view* const shown = view();
    if (shown == nullptr || fields.size() > shown->field_count) [[unlikely]]
      return std::ranges::any_of(fields.ids(), ask);
    for (const AnyOf::Bits& bits : fields.bits())
      if ((shown->bits[bits.word].*which & bits.mask) != 0) return true;
    return false;
  }
  static bool shows(const ig_view* shown, ig_field f) {
    return f < shown->field_count && (shown->bits[f / 64].present >> (f % 64) & 1) != 0;
  }
  static bool shows_fresh(const ig_view* shown, ig_field f) {
    return f < shown->field_count && (shown->bits[f / 64].fresh >> (f % 64) & 1) != 0;
  }
  static bool lies_in_one_word(const Xyz& xyz) { return xyz.point() != IG_NO_FIELD && xyz.point() % 64 <= 61; }
  /// Which of the three fields are present; 0 also where their bits do not lie in one word.
  static std::uint32_t three(const ig_view* shown, const Xyz& xyz) {
    if (!lies_in_one_word(xyz)) return 0;
    return static_cast<std::uint32_t>(shown->bits[xyz.point() / 64].present >> (xyz.point() % 64)) & 7u;
  }
  /// Not inlined, so that the common case of get() stays small.
  [[gnu::noinline]] PartialVec3 get_partial(const Xyz& xyz) const {
    if (xyz.point() != IG_NO_FIELD) {
      if (const ig_view* const shown = view(); shown != nullptr && lies_in_one_word(xyz) && three(shown, xyz) == 0)
        return {};
      double v[3];
      const std::uint32_t mask = host_->get_point(block_, xyz.point(), v);
      return {mask, {v[0], v[1], v[2]}};
    }
    ig_value v[3];
    return triple(get_many(xyz.ids(), 3, v), v);
  }
  static PartialVec3 triple(std::uint32_t mask, const ig_value* v) {
    PartialVec3 out{mask, {}};
    for (std::size_t i = 0; i < 3; ++i)
      if ((mask >> i & 1u) != 0) out.value[i] = v[i].number;
    return out;
  }
  std::optional<Vec3> map(ig_direction direction, const Vec3& p) {
    const double in[3] = {p.x, p.y, p.z};
    double out[3];
    if (host_->map_point(block_, direction, in, out) == 0) return std::nullopt;
    return Vec3{out[0], out[1], out[2]};
  }
  const ig_host* host_;
  ig_block* block_;
  const ig_view* shown_;
};

}  // namespace ig
