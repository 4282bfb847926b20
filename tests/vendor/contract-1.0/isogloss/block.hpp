/// The block document as a syntax sees it while it runs: a thin, inlined cover over the host's table.
#pragma once

#include <optional>

#include "isogloss/options.hpp"

namespace ig {

/// Where a diagnostic points: a word, a range of columns (0-based, end exclusive), or the whole block.
struct Where {
  ig_field field = IG_NO_FIELD;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  static Where block() { return {}; }
  static Where word(ig_field id) { return {id, 0, 0}; }
  static Where columns(std::size_t begin, std::size_t end) {
    return {IG_NO_FIELD, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  }
};

/// The words of a code that owned them, taken.
struct Words {
  std::size_t row = 0;  ///< which of the Call's codes
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

class Block {
 public:
  Block(const ig_host* host, ig_block* block) : host_(host), block_(block) {}

  template <class T>
  std::optional<T> get(const Field<T>& field) const {
    ig_value v;
    if (host_->get(block_, field.id(), &v) == 0) return std::nullopt;
    return detail::ValueOf<T>::read(v);
  }
  template <class T>
  T get_or(const Field<T>& field, T fallback) const {
    ig_value v;
    return host_->get(block_, field.id(), &v) != 0 ? detail::ValueOf<T>::read(v) : fallback;
  }
  bool is(const Field<Symbol>& field, Symbol name) const {
    ig_value v;
    return host_->get(block_, field.id(), &v) != 0 && v.symbol == name.id;
  }
  PartialVec3 get(const Xyz& xyz) const { return triple(host_->get_many(block_, xyz.ids(), 3, scratch_), scratch_); }
  template <class F>
  bool has(const F& field) const {
    ig_value v;
    return host_->get(block_, field.id(), &v) != 0;
  }
  /// Written in this block, not carried.
  template <class F>
  bool is_fresh(const F& field) const {
    return host_->is_fresh(block_, field.id()) != 0;
  }
  bool is_fresh(const Xyz& xyz) const { return host_->fresh_many(block_, xyz.ids(), 3) != 0; }

  template <class T>
  void set(const Field<T>& field, T value) {
    host_->set(block_, field.id(), detail::ValueOf<T>::write(value));
  }
  void set(const Field<Symbol>& field, const Name& name) { set(field, static_cast<Symbol>(name)); }
  void set(const Xyz& xyz, const Vec3& p) {
    const ig_value v[3] = {{.number = p.x}, {.number = p.y}, {.number = p.z}};
    host_->set_many(block_, xyz.ids(), 3, v);
  }
  /// A new value for what was carried: writer and value change, nothing wakes, the field does not become fresh.
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
  void raise(const Signal& signal) { host_->set(block_, signal.id(), ig_value{}); }
  bool is_raised(const Signal& signal) const { return has(signal); }

  std::optional<double> take(const Word& word) {
    ig_value v;
    if (host_->take(block_, word.id(), &v) == 0) return std::nullopt;
    return v.number;
  }
  PartialVec3 take(const Xyz& xyz) { return triple(host_->take_many(block_, xyz.ids(), 3, scratch_), scratch_); }

  /// The last code of the group in this block, all of them taken; `found` says how many there were.
  std::optional<std::size_t> take(const Codes& codes, std::uint32_t* found = nullptr) {
    std::uint32_t n = 0;
    const std::int32_t i = host_->take_code(block_, codes.ids(), codes.size(), found != nullptr ? found : &n);
    return i < 0 ? std::nullopt : std::optional<std::size_t>(static_cast<std::size_t>(i));
  }
  /// The same without taking.
  std::optional<std::size_t> find(const Codes& codes) const {
    std::uint32_t n = 0;
    const std::int32_t i = host_->find_code(block_, codes.ids(), codes.size(), &n);
    return i < 0 ? std::nullopt : std::optional<std::size_t>(static_cast<std::size_t>(i));
  }

  /// The last call in this block with all its words, taken.
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
    return row < 0 ? std::nullopt : std::optional<std::size_t>(static_cast<std::size_t>(row));
  }
  /// Raises a call for the syntaxes after this one.
  void set_call(const Call& call, std::size_t row) {
    ig_value v;
    v.integer = 1;
    host_->set(block_, call.code(row), v);
  }
  void set_word(const Call& call, std::size_t row, char letter, double value) {
    host_->set(block_, call.word(row, letter), {.number = value});
  }

  std::string_view text(const TextField& field) const { return to_view(host_->text(block_, field.id())); }
  void set_text(const TextField& field, std::string_view text) { host_->set_text(block_, field.id(), to_text(text)); }
  std::string_view source() const { return to_view(host_->source(block_)); }

  void set_translation(const Transform& t, const Vec3& offset) {
    const double v[3] = {offset.x, offset.y, offset.z};
    host_->set_translation(block_, t.id(), v);
  }
  void set_transform(const Transform& t, const double (&matrix)[16]) { host_->set_transform(block_, t.id(), matrix); }
  /// An entry that moves with the axes during the block, as it is at the block's end; the tool tip moves along.
  void set_moving_transform(const Transform& t, const double (&matrix)[16]) {
    host_->set_moving_transform(block_, t.id(), matrix);
  }
  /// True when an entry of the frame got another value in this block, under a resting tool.
  bool frame_changed() const { return host_->frame_changed(block_) != 0; }
  std::optional<Vec3> to_machine(const Vec3& program) { return map(IG_TO_MACHINE, program); }
  std::optional<Vec3> to_program(const Vec3& machine) { return map(IG_TO_PROGRAM, machine); }

  Symbol symbol(std::string_view name) { return {host_->symbol(block_, to_text(name))}; }
  std::string_view text(Symbol symbol) const {
    return to_view(host_->symbol_text(block_, static_cast<ig_symbol>(symbol.id)));
  }

  template <class... Args>
  void report(std::uint32_t diagnostic, Where where, const Args&... args) {
    const std::array<ig_argument, sizeof...(Args)> list{argument(args)...};
    host_->report(block_, diagnostic, where.field, where.begin, where.end, list.data(), sizeof...(Args));
  }

  void end_program() { host_->flow(block_, IG_FLOW_END, 0); }
  void alarm() { host_->flow(block_, IG_FLOW_ALARM, 0); }
  void flow(ig_flow what, std::size_t position = 0) { host_->flow(block_, what, position); }

  const ig_host* host() const { return host_; }
  ig_block* raw() const { return block_; }

 private:
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
  static ig_argument argument(double number) { return {0, 0, number, {nullptr, 0}}; }
  static ig_argument argument(std::string_view text) { return {1, 0, 0, to_text(text)}; }

  const ig_host* host_;
  ig_block* block_;
  mutable ig_value scratch_[3];
};

}  // namespace ig
