/// The host's functions for what a block has several of: leftovers, and the records of its lists.
#pragma once

#include <cstdint>

#include "isogloss/engine/chain.hpp"

namespace isogloss::calls {

template <Mode M>
void add_leftover(ig_block* block, const ig_leftover* l);
std::int32_t leftover(const ig_block* block, std::uint32_t index, ig_leftover* out);
template <Mode M>
std::int32_t append(ig_block* block, const ig_field* fields, std::uint32_t count, const ig_value* v);
template <Mode M>
std::uint32_t append_many(ig_block* block, const ig_field* fields, std::uint32_t count, std::uint32_t records,
                          const std::uint32_t* masks, const ig_value* v);
template <Mode M>
std::uint32_t count_records(const ig_block* block, ig_field f);
template <Mode M>
std::uint32_t record(const ig_block* block, std::uint32_t index, const ig_field* fields, std::uint32_t count,
                     ig_value* out);
template <Mode M>
void set_record(ig_block* block, std::uint32_t index, const ig_field* fields, std::uint32_t count, const ig_value* v);
template <Mode M>
void map_records(ig_block* block, const ig_field program[3], const ig_field machine[3]);

}  // namespace isogloss::calls
