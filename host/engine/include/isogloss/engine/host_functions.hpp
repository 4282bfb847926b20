/// All functions of a host, so that others can stand before each of them, or in their place.
#pragma once

#include <isogloss.h>

#include <cstddef>

namespace isogloss {

template <template <auto> class Call, auto... members>
constexpr void replace_members(ig_host& out) {
  ((out.*members = Call<members>::call), ...);
}

/// Lets `Call<&ig_host::get>::call` answer in place of get(), and so on.
template <template <auto> class Call>
constexpr void replace_functions(ig_host& out) {
  using H = ig_host;
  static_assert(sizeof(H) == offsetof(H, append_many) + sizeof(H::append_many),
                "a new function belongs into this list");
  replace_members<Call, &H::get, &H::get_many, &H::take, &H::take_many, &H::set, &H::set_many, &H::amend_many,
                  &H::erase, &H::is_fresh, &H::take_code, &H::find_code, &H::text, &H::set_text, &H::source,
                  &H::set_words, &H::rewrite, &H::move, &H::word, &H::add_leftover, &H::leftover, &H::set_transform,
                  &H::set_translation, &H::transform, &H::map_point, &H::frame_changed, &H::append, &H::count,
                  &H::record, &H::set_record, &H::map_records, &H::symbol, &H::symbol_text, &H::report, &H::fault,
                  &H::flow, &H::ahead, &H::fresh_many, &H::set_moving_transform, &H::get_point, &H::take_point,
                  &H::set_point, &H::fresh_point, &H::in_turn, &H::append_many>(out);
}

}  // namespace isogloss
