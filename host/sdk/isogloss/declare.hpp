/// Turns the members of a syntax into its descriptor. The same constructors run once under a Recorder, which notes what
/// they declare, and once for each instance under a Binding, which gives them their ids in the same order. Included by
/// the other headers; vendors need only the enumerations and About.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/value.hpp"

namespace ig {

/// What a syntax does with a field, combined with |. A field must be declared for each use. read: this block's value or
/// the carried one; required: read, and linking fails where no syntax writes the field; write: set, amend or erase;
/// take: consume a word or code; previous: the value before this block; wake: run build() when the field is set in this
/// block; wake_while: run build() in each block that starts with the field; ends_ahead: a block with the field is the
/// last one that build() reads with Block::ahead().
enum Access : std::uint32_t {
  read = IG_READ,
  required = IG_READ | IG_REQUIRED,
  write = IG_WRITE,
  take = IG_TAKE,
  previous = IG_PREVIOUS,
  wake = IG_WAKE,
  wake_while = IG_WAKE_WHILE,
  ends_ahead = IG_ENDS_AHEAD
};
constexpr Access operator|(Access a, Access b) {
  return static_cast<Access>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}

/// How long a value lives. standard: as the host's list of sections says; word: a word of a block; block: up to the end
/// of the block; modal: until it is changed; frame: like modal, but a called program begins without it and the caller
/// has it again after the return.
enum class Life : ig_life {
  standard = IG_LIFE_STANDARD,
  word = IG_LIFE_WORD,
  block = IG_LIFE_BLOCK,
  modal = IG_LIFE_MODAL,
  frame = IG_LIFE_FRAME
};

/// Describes a field that is not in the host's list of standard sections: how long its value lives, its unit, one
/// sentence.
struct About {
  Life life = Life::standard;
  std::string_view unit = {};
  std::string_view doc = {};
};

namespace detail {

class Recorder {
 public:
  std::vector<ig_field_decl> fields;
  std::vector<ig_option_decl> options;
  std::vector<ig_service_decl> services;
  std::vector<ig_column_decl> columns;

  /// The pieces joined to one text, which lives as long as the recorder.
  template <std::size_t N>
  const char* keep(const std::array<std::string_view, N>& pieces) {
    std::size_t size = 0;
    for (const std::string_view piece : pieces) size += piece.size();
    if (size == 0) return "";
    if (size >= left_) {
      left_ = std::max(chunk_size, size + 1);
      next_ = chunks_.emplace_back(std::make_unique<char[]>(left_)).get();
    }
    char* const text = next_;
    for (const std::string_view piece : pieces) next_ = std::copy(piece.begin(), piece.end(), next_);
    *next_++ = '\0';
    left_ -= size + 1;
    return text;
  }

 private:
  static constexpr std::size_t chunk_size = 1024;
  std::vector<std::unique_ptr<char[]>> chunks_;
  char* next_ = nullptr;
  std::size_t left_ = 0;
};

/// Gives out ids of fields, options, services and columns by position. `declared` is what the same constructors
/// declared when the plugin was loaded. A member that differs now would receive its neighbour's id, so it is refused.
struct Binding {
  const ig_link_api* api;
  ig_link* link;
  const ig_field* ids;
  const Recorder* declared = nullptr;  ///< null: not compared
  std::uint32_t field = 0;
  std::uint32_t option = 0;
  std::uint32_t service = 0;
  std::uint32_t column = 0;

  /// Throws std::logic_error where the next field differs from the declared one.
  void expect_field(const std::array<std::string_view, 4>& pieces) const {
    if (declared == nullptr) return;
    if (field >= declared->fields.size()) refuse("field", {pieces.begin(), pieces.end()}, {});
    const std::string_view known = declared->fields[field].path;
    std::string_view rest = known;
    for (const std::string_view piece : pieces) {
      if (piece.empty()) continue;
      if (!rest.starts_with(piece)) refuse("field", {pieces.begin(), pieces.end()}, known);
      rest.remove_prefix(piece.size());
    }
    if (!rest.empty()) refuse("field", {pieces.begin(), pieces.end()}, known);
  }
  /// The same for options, services and columns; `all` is the recorder's list of them, `id` the member that names one.
  template <class D>
  void expect(const char* kind, const std::vector<D> Recorder::*all, const char* D::*id, std::uint32_t next,
              std::string_view name) const {
    if (declared == nullptr) return;
    const std::vector<D>& list = declared->*all;
    const std::string_view known = next < list.size() ? std::string_view(list[next].*id) : std::string_view();
    if (known != name) refuse(kind, {name}, known);
  }
  /// Throws std::logic_error where fewer members were constructed than declared.
  void expect_all() const {
    if (declared == nullptr) return;
    if (field < declared->fields.size()) refuse("field", {}, declared->fields[field].path);
    if (option < declared->options.size()) refuse("option", {}, declared->options[option].name);
    if (service < declared->services.size()) refuse("service", {}, declared->services[service].id);
    if (column < declared->columns.size()) refuse("column", {}, declared->columns[column].name);
  }

 private:
  [[noreturn, gnu::cold, gnu::noinline]] static void refuse(const char* kind, std::vector<std::string_view> now,
                                                            std::string_view then) {
    std::string name;
    for (const std::string_view piece : now) name += piece;
    throw std::logic_error("the " + std::string(kind) + " '" + name + "' stands where the descriptor has '" +
                           std::string(then) + "': the members of a syntax must be the same each time it is made");
  }
};

// Set only while a descriptor or an instance is constructed.
inline thread_local Recorder* recorder = nullptr;
inline thread_local Binding* binding = nullptr;

template <class T>
class Scope {
 public:
  Scope(T*& slot, T* value) : slot_(slot), old_(slot) { slot_ = value; }
  ~Scope() { slot_ = old_; }
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  T*& slot_;
  T* old_;
};

/// A path in pieces, which are joined only when a descriptor is recorded.
struct Path {
  Path(std::string_view a, std::string_view b = {}, std::string_view c = {}, std::string_view d = {})
      : pieces{a, b, c, d} {}
  std::array<std::string_view, 4> pieces;
};

struct Declared {
  Path path;
  ig_type type = IG_NUMBER;
  std::uint32_t access = 0;
  About about = {};
  const char* wake_value = nullptr;
};

/// A member that is constructed in build() or as a global would have no id, and nothing that it does would have an
/// effect.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_stray(const char* kind,
                                                                const std::array<std::string_view, 4>& pieces) {
  std::string name;
  for (const std::string_view piece : pieces) name += piece;
  throw std::logic_error("the " + std::string(kind) + " '" + name +
                         "' is declared where no syntax is being made: make it a member of the syntax");
}

inline void record_field(Recorder& to, const Declared& d) {
  ig_field_decl out{};
  out.struct_size = sizeof out;
  out.access = d.access;
  out.type = d.type;
  out.life = static_cast<ig_life>(d.about.life);
  out.path = to.keep(d.path.pieces);
  out.unit = to.keep(std::array{d.about.unit});
  out.doc = to.keep(std::array{d.about.doc});
  out.wake_value = d.wake_value;
  to.fields.push_back(out);
}

inline ig_field declare_field(const Declared& d) {
  if (Recorder* const to = recorder) {
    record_field(*to, d);
    return IG_NO_FIELD;
  }
  Binding* const bound = binding;
  if (bound == nullptr) refuse_stray("field", d.path.pieces);
  bound->expect_field(d.path.pieces);
  return bound->ids[bound->field++];
}

/// True when the host of the chain being created has get_point() and its relatives (ABI 1.2).
inline bool has_point_calls() { return binding != nullptr && binding->api->host_minor >= 2; }

/// The index of the declaration just made, for expand().
inline std::uint32_t last_field() { return binding != nullptr ? binding->field - 1 : 0; }

inline Symbol symbol(std::string_view name) {
  if (binding == nullptr && recorder == nullptr) refuse_stray("name", {name, {}, {}, {}});
  return binding != nullptr ? Symbol{binding->api->symbol(binding->link, to_text(name))} : Symbol{};
}

/// The unit of an address unless a syntax gives another one: mm, degrees or mm/min.
constexpr const char* default_unit(char address) {
  switch (address) {
    case 'X':
    case 'Y':
    case 'Z':
    case 'U':
    case 'V':
    case 'W':
    case 'I':
    case 'J':
    case 'K':
    case 'Q':
    case 'R': return "mm";
    case 'A':
    case 'B':
    case 'C': return "deg";
    case 'F': return "mm/min";
    default: return "";
  }
}

inline bool is_address(std::string_view path) {
  return path.starts_with("Parsing.") && path.size() > 2 && path[path.size() - 2] == '.';
}

}  // namespace detail
}  // namespace ig
