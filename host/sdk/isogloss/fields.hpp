/// Members of a syntax: each one declares what the syntax does with a field of the block document. All are constructed
/// once when the plugin is loaded and once for each chain, and must be the same each time.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "isogloss/declare.hpp"

namespace ig {

/// The name of a word without its section: "G81.J" for "Parsing.G81.J".
constexpr std::string_view word_name(std::string_view path) {
  constexpr std::string_view section = "Parsing.";
  return path.starts_with(section) ? path.substr(section.size()) : path;
}

/// A name that is known when the chain is created; build() compares and writes it without touching text.
class Name {
 public:
  explicit Name(std::string_view text) : symbol_(detail::symbol(text)) {}
  operator Symbol() const { return symbol_; }

 private:
  Symbol symbol_;
};

/// One field of type double, std::int64_t, bool or Symbol. `about` describes a field of a section that the host does
/// not know.
template <class T>
class Field {
 public:
  using value_type = T;
  Field(std::string_view path, Access access, About about = {}, const char* wake_value = nullptr)
      : id_(detail::declare_field({path, detail::ValueOf<T>::type, access, about, wake_value})) {}
  ig_field id() const { return id_; }

 private:
  ig_field id_;
};

/// Reads the value of this block or the carried one. Add ig::wake to run when the field is set, ig::required to refuse
/// a chain in which no syntax writes it.
template <class T>
struct In : Field<T> {
  explicit In(std::string_view path, Access more = read, About about = {}) : Field<T>(path, read | more, about) {}
};

/// Reads a value, and runs the syntax in every block that starts with it (with the value `value`, where one is given).
template <class T>
struct InWhile : Field<T> {
  explicit InWhile(std::string_view path, const char* value = nullptr, Access more = read, About about = {})
      : Field<T>(path, read | wake_while | more, about, value) {}
};

/// Writes (and may read back) a value.
template <class T>
struct Out : Field<T> {
  explicit Out(std::string_view path, About about = {}, Access more = write)
      : Field<T>(path, read | write | more, about) {}
};

/// Reads the value that the field had before this block.
template <class T>
struct Previous : Field<T> {
  explicit Previous(std::string_view path) : Field<T>(path, previous) {}
};

/// A word of the block ("Parsing.S"), taken by the syntax that uses it. Runs the syntax when the block holds the word.
/// Without a unit it has the usual one of its address: mm, deg or mm/min.
struct Word : Field<double> {
  explicit Word(std::string_view path, Access more = wake, const char* unit = nullptr, const char* doc = "")
      : Field<double>(path, take | more,
                      {Life::standard,
                       unit != nullptr            ? unit
                       : detail::is_address(path) ? detail::default_unit(path.back())
                                                  : "",
                       doc}) {}
};

/// A flag between syntaxes, never shown in the document: one syntax raises it, others run.
class Signal {
 public:
  Signal(std::string_view path, Access access, Life life = Life::block)
      : id_(detail::declare_field({path, IG_SWITCH, access, {life, "", ""}})) {}
  ig_field id() const { return id_; }

 private:
  ig_field id_;
};

/// A text field ("Comment.Text").
class TextField {
 public:
  TextField(std::string_view path, Access access, About about = {})
      : id_(detail::declare_field({path, IG_TEXT, access, about})) {}
  ig_field id() const { return id_; }

 private:
  ig_field id_;
};

/// Three fields X, Y, Z of one section.
class Xyz {
 public:
  Xyz(std::string_view section, Access access, About about = {}) {
    if (section == "Parsing") about.unit = "mm";
    for (std::size_t axis = 0; axis < 3; ++axis)
      ids_[axis] =
          detail::declare_field({{section, ".", std::string_view("XYZ").substr(axis, 1)}, IG_NUMBER, access, about});
    if (detail::has_point_calls() && ids_[1] == ids_[0] + 1 && ids_[2] == ids_[0] + 2) point_ = ids_[0];
  }
  const ig_field* ids() const { return ids_.data(); }
  ig_field id(std::size_t axis) const { return ids_[axis]; }
  /// The field X where the three fields are neighbours and the host has calls for points, else IG_NO_FIELD.
  ig_field point() const { return point_; }

 private:
  std::array<ig_field, 3> ids_{};
  ig_field point_ = IG_NO_FIELD;
};

/// Fields of other members, which stand before it: b.has_any(fields) and b.is_any_fresh(fields) ask about all of
/// them as fast as about one or two.
class AnyOf {
 public:
  /// The fields whose bits lie in one word of ig_view.
  struct Bits {
    std::size_t word;
    std::uint64_t mask;
  };

  AnyOf(std::initializer_list<ig_field> fields) : AnyOf(std::span(fields.begin(), fields.size())) {}
  explicit AnyOf(std::span<const ig_field> fields) : ids_(fields.begin(), fields.end()) {
    for (const ig_field id : ids_) {
      if (id == IG_NO_FIELD) continue;
      const auto same = std::ranges::find(bits_, std::size_t{id} / 64, &Bits::word);
      Bits& bits = same != bits_.end() ? *same : bits_.emplace_back(Bits{id / 64, 0});
      bits.mask |= std::uint64_t{1} << id % 64;
      size_ = std::max(size_, id + 1);
    }
  }
  std::span<const ig_field> ids() const { return ids_; }
  std::span<const Bits> bits() const { return bits_; }
  /// One more than the largest field.
  ig_field size() const { return size_; }

 private:
  ig_field size_ = 0;
  std::vector<ig_field> ids_;
  std::vector<Bits> bits_;
};

/// A modal group or another set of codes: "G17", "G18", "G19". The codes are taken, and the syntax runs when the block
/// holds one.
class Codes {
 public:
  Codes(std::initializer_list<std::string_view> codes, Access access = take | wake) {
    ids_.reserve(codes.size());
    names_.reserve(codes.size());
    for (const std::string_view code : codes) {
      ids_.push_back(detail::declare_field({{"Parsing.Flags.", code}, IG_CODE, access}));
      names_.push_back(detail::symbol(code));
    }
  }
  const ig_field* ids() const { return ids_.data(); }
  std::uint32_t size() const { return static_cast<std::uint32_t>(ids_.size()); }
  ig_field id(std::size_t i) const { return ids_[i]; }
  Symbol name(std::size_t i) const { return names_[i]; }

 private:
  std::vector<ig_field> ids_;
  std::vector<Symbol> names_;
};

/// Codes that own their words: Call{{"G81", "G82"}, "X Y Z R P[s] K[1] F"} declares Parsing.G81.X … Parsing.G82.F. A
/// unit in brackets replaces the address's usual one. `kind` is the unit of the codes themselves, by which patterns
/// find them.
class Call {
 public:
  Call(std::initializer_list<std::string_view> codes, std::string_view words, Access access = take | wake,
       std::string_view kind = {})
      : Call(std::span(codes.begin(), codes.size()), words, access, kind) {}
  Call(std::span<const std::string_view> codes, std::string_view words, Access access = take | wake,
       std::string_view kind = {}) {
    const std::vector<Owned> owned = parse(words);
    for (const Owned& word : owned) letters_ += word.letter;
    names_.reserve(codes.size());
    codes_.reserve(codes.size());
    words_.reserve(codes.size() * owned.size());
    const std::uint32_t no_wake = access & ~static_cast<std::uint32_t>(wake);
    for (const std::string_view code : codes) {
      names_.push_back(detail::symbol(code));
      codes_.push_back(detail::declare_field({{"Parsing.", code}, IG_CODE, access, {Life::standard, kind, ""}}));
      for (const Owned& word : owned)
        words_.push_back(detail::declare_field({{"Parsing.", code, ".", std::string_view(&word.letter, 1)},
                                                IG_NUMBER,
                                                no_wake,
                                                {Life::word, word.unit, ""}}));
    }
  }
  std::uint32_t code_count() const { return static_cast<std::uint32_t>(codes_.size()); }
  const ig_field* codes() const { return codes_.data(); }
  Symbol name(std::size_t row) const { return names_[row]; }
  ig_field code(std::size_t row) const { return codes_[row]; }
  std::string_view letters() const { return letters_; }
  const ig_field* row(std::size_t row) const { return words_.data() + row * letters_.size(); }
  /// The field of the word; IG_NO_FIELD for an address that the code does not own.
  ig_field word(std::size_t row, char letter) const {
    const std::size_t at = letters_.find(letter);
    return at == std::string::npos ? IG_NO_FIELD : words_[row * letters_.size() + at];
  }

 protected:
  /// Adds a code that is found only when the chain is created, with its words in the order of letters().
  void add_row(std::string_view code, ig_field id, std::span<const ig_field> words) {
    names_.push_back(detail::symbol(code));
    codes_.push_back(id);
    words_.insert(words_.end(), words.begin(), words.end());
  }

 private:
  struct Owned {
    char letter;
    std::string_view unit;
  };
  static std::vector<Owned> parse(std::string_view words) {
    std::vector<Owned> owned;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == ' ') continue;
      Owned word{words[i], detail::default_unit(words[i])};
      if (i + 1 < words.size() && words[i + 1] == '[') {
        const std::size_t close = words.find(']', i);
        word.unit = words.substr(i + 2, close - i - 2);
        i = close;
      }
      owned.push_back(word);
    }
    return owned;
  }

  std::vector<Symbol> names_;
  std::vector<ig_field> codes_;
  std::string letters_;
  std::vector<ig_field> words_;
};

/// An entry of the frame: one contribution, named by its source, to the way from program to machine coordinates.
class Transform {
 public:
  explicit Transform(std::string_view source, Access access = write)
      : id_(detail::declare_field({{"ProgramToMcTransform.", source}, IG_TRANSFORM, access})) {}
  ig_field id() const { return id_; }

 private:
  ig_field id_;
};

}  // namespace ig
