/// How members become a descriptor: the same constructors run once under a Recorder, which writes down what they
/// declare, and once for each instance under a Binding, which hands them their ids in the same order.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/value.hpp"

namespace ig {

enum Access : std::uint32_t {
  read = IG_READ,
  required = IG_READ | IG_REQUIRED,
  write = IG_WRITE,
  take = IG_TAKE,
  previous = IG_PREVIOUS,
  wake = IG_WAKE,
  wake_while = IG_WAKE_WHILE
};
constexpr Access operator|(Access a, Access b) {
  return static_cast<Access>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}

enum class Life : ig_life {
  standard = IG_LIFE_STANDARD,
  word = IG_LIFE_WORD,
  block = IG_LIFE_BLOCK,
  modal = IG_LIFE_MODAL
};

/// What a vendor says of a field that the host's list of standard sections does not hold.
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

struct Binding {
  const ig_link_api* api;
  ig_link* link;
  const ig_field* ids;
  std::uint32_t field = 0;
  std::uint32_t option = 0;
  std::uint32_t service = 0;
  std::uint32_t column = 0;
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

/// A path in pieces: they are joined only where a descriptor is recorded.
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
  return bound != nullptr ? bound->ids[bound->field++] : IG_NO_FIELD;
}

/// The number of the declaration just made, for expand().
inline std::uint32_t last_field() { return binding != nullptr ? binding->field - 1 : 0; }

inline Symbol symbol(std::string_view name) {
  return binding != nullptr ? Symbol{binding->api->symbol(binding->link, to_text(name))} : Symbol{};
}

/// The unit that an address has unless a syntax says otherwise: lengths in mm, angles, feed.
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
