#include "contract/host_records.hpp"

#include <algorithm>

#include "contract/host_access.hpp"
#include "contract/host_table.hpp"

namespace isogloss::calls {

namespace {

/// Has the syntax at work declared the record's field, itself or by a pattern?
bool is_declared(const Document& d, ig_field f) {
  if (d.current == 0 || d.chain == nullptr) return true;
  const LinkedSyntax& s = d.chain->linked().chain[d.current - 1u];
  const auto has = [f](const std::vector<ig_field>& ids) { return std::find(ids.begin(), ids.end(), f) != ids.end(); };
  return has(s.ids) || std::any_of(s.expansions.begin(), s.expansions.end(), has);
}

/// False, and said, where the fields are none of one list, or were not declared, or the values are not of their types.
template <Mode M>
bool may_use(const Document& d, const ListData* list, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  if constexpr (M == Mode::checked) {
    if (list == nullptr) {
      const bool is_absent = std::all_of(fields, fields + count, [](ig_field f) { return f == IG_NO_FIELD; });
      if (!is_absent) violation(d, "it calls a function of records with fields that are not of one list");
      return false;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const FieldInfo& info = d.layout().lists[list_of(fields[i])].fields[index_in_record(fields[i])];
      const std::string path = field_name(d, fields[i]) + "[]." + info.path;
      if (!is_declared(d, fields[i])) {
        violation(d, "it uses " + path + ", which it does not declare");
        return false;
      }
      const std::string fault = v != nullptr && info.type != IG_TEXT ? value_fault(d, info, v[i]) : "";
      if (!fault.empty()) violation(d, "it gives " + path + " " + fault);
    }
  }
  return list != nullptr;
}

/// Fields of one call of append_many(), whose masks have as many bits.
constexpr std::uint32_t most_together = 32;

/// The list that all these record fields belong to, or null.
ListData* list_of_all(Document& d, const ig_field* fields, std::uint32_t count) {
  if (count == 0 || !is_record_field(fields[0]) || list_of(fields[0]) >= d.lists.size()) return nullptr;
  ListData& list = d.lists[list_of(fields[0])];
  for (std::uint32_t i = 0; i < count; ++i)
    if ((fields[i] & ~0xffffu) != (fields[0] & ~0xffffu) || index_in_record(fields[i]) >= list.stride) return nullptr;
  return &list;
}

/// Fields beyond RecordShape::most_fields are counted, but not kept.
bool find_shape(Document& d, const ig_field* fields, std::uint32_t count, RecordShape& out) {
  if (list_of_all(d, fields, count) == nullptr) return false;
  out.count = count;
  out.list = static_cast<std::uint32_t>(list_of(fields[0]));
  for (std::uint32_t i = 0; i < count; ++i) out.mask |= std::uint64_t{1} << index_in_record(fields[i]);
  std::copy_n(fields, std::min(count, RecordShape::most_fields), out.fields.begin());
  return true;
}

[[gnu::cold, gnu::noinline]] void tell_full(Document& d, ListData& list) {
  if (list.count > maximum_items) return;
  const Diagnostic text = host_diagnostic("IG-0405", {}, {std::to_string(maximum_items)});
  d.chain->report(d, text.severity, text.code, text.message, 0, 0);
  if (!list.has_room()) list.make_room();
  list.add(0);  // says it once: an empty record past the limit
}

}  // namespace

template <Mode M>
void add_leftover(ig_block* block, const ig_leftover* l) {
  Document& d = doc(block);
  if constexpr (M == Mode::checked) {
    if (l->kind < IG_LEFT_WORD || l->kind > IG_LEFT_TEXT)
      violation(d, "it adds a leftover of the kind " + std::to_string(l->kind) + ", which does not exist");
    if (l->field != IG_NO_FIELD && l->field >= d.size())
      violation(d, "it adds a leftover of a field that does not exist");
  }
  const std::string_view name(l->name.data, l->name.size);
  d.add_leftover(l->kind, l->field, l->begin, l->end, name);
}

std::int32_t leftover(const ig_block* block, std::uint32_t index, ig_leftover* out) {
  static thread_local std::vector<Leftover> open;
  if (index == 0) open = doc(block).collect_leftovers();
  if (index >= open.size()) return 0;
  const Leftover& l = open[index];
  *out = {l.kind, l.field, l.begin, l.end, {l.name.data(), l.name.size()}};
  return 1;
}

namespace {

[[gnu::always_inline]] inline bool has_room(const ListData& list, std::uint32_t records) {
  return records <= list.room - list.count && records <= maximum_items - std::min(list.count, maximum_items);
}

/// The shape of the record is known, and its list has room. Calls nothing, and so needs no frame on the stack.
[[gnu::always_inline]] inline void append_known(Document& d, const RecordShape& shape, const ig_field* fields,
                                                std::uint32_t count, const ig_value* v) {
  ig_value* const record = d.lists[shape.list].add(shape.mask);
#pragma GCC unroll 8
  for (std::uint32_t i = 0; i < count; ++i) record[index_in_record(fields[i])] = v[i];
  if (d.chain != nullptr) ++d.chain->records;
  d.wake_by_list(shape.list);
}

/// Remembered for the next call; null where the fields do not lie in one list, or are too many to be remembered.
[[gnu::noinline]] const RecordShape* shape_of(Document& d, const ig_field* fields, std::uint32_t count) {
  if (count > RecordShape::most_fields) return nullptr;
  if (const RecordShape& first = d.record_shapes.at(fields); first.is(fields, count)) return &first;
  RecordShape& known = d.record_shapes.beside(fields, count);
  if (known.is(fields, count)) return &known;
  RecordShape found;
  if (!find_shape(d, fields, count, found)) return nullptr;
  known = found;
  return &known;
}

/// A shape that is not at hand, or a list without room.
template <Mode M>
[[gnu::noinline]] std::int32_t append_other(ig_block* block, const ig_field* fields, std::uint32_t count,
                                            const ig_value* v) {
  Document& d = doc(block);
  if constexpr (M == Mode::checked)
    if (!may_use<M>(d, list_of_all(d, fields, count), fields, count, v)) return 0;
  RecordShape shape;
  if (const RecordShape* const known = shape_of(d, fields, count))
    shape = *known;
  else if (!find_shape(d, fields, count, shape))
    return 0;
  ListData& list = d.lists[shape.list];
  if (list.count >= maximum_items) {
    tell_full(d, list);
    return 0;
  }
  if (!list.has_room()) list.make_room();
  append_known(d, shape, fields, count, v);
  return 1;
}

/// A record of a shape that was met here before, while its list has room; false for others.
[[gnu::always_inline]] inline bool append_as_before(Document& d, const ig_field* fields, std::uint32_t count,
                                                    const ig_value* v) {
  const RecordShape& shape = d.record_shapes.at(fields);
  if (!shape.is(fields, count)) [[unlikely]]
    return false;
  if (!has_room(d.lists[shape.list], 1)) [[unlikely]]
    return false;
  append_known(d, shape, fields, count, v);
  return true;
}

/// Most records are steps of a motion: X, Y, Z, the form, and the feed or that it is rapid. With their number known to
/// the compiler no loop is left.
constexpr std::uint32_t usual_count = 5;

/// X, Y, Z, the form, that it is rapid, the feed: steps of both kinds side by side.
constexpr std::uint32_t usual_together = 6;

/// Which fields of a record the mask of a call means. Most records of a call have one of two masks.
class Presence {
 public:
  [[gnu::always_inline]] std::uint64_t of(std::uint32_t mask, const ig_field* fields, std::uint32_t count) {
    if (mask == mask_) return present_;
    if (mask == other_mask_) return other_present_;
    other_mask_ = mask_;
    other_present_ = present_;
    mask_ = mask;
    present_ = 0;
#pragma GCC unroll 8
    for (std::uint32_t i = 0; i < count; ++i) present_ |= std::uint64_t{mask >> i & 1} << index_in_record(fields[i]);
    return present_;
  }

 private:
  std::uint32_t mask_ = 0, other_mask_ = 0;
  std::uint64_t present_ = 0, other_present_ = 0;
};

/// The list has room for them. A value that the mask does not name is written, too: it is not present. How many were
/// added: all but those without fields.
[[gnu::always_inline]] inline std::uint32_t add_records(ListData& list, const ig_field* fields, std::uint32_t count,
                                                        std::uint32_t records, const std::uint32_t* masks,
                                                        const ig_value* v) {
  Presence presence;
  std::uint64_t* present = list.present.data() + list.count;
  ig_value* record = list.record(list.count);
  const std::size_t stride = list.stride;
  for (const std::uint32_t* const end = masks + records; masks != end; ++masks, v += count) {
    const std::uint64_t held = presence.of(*masks, fields, count);
    if (held == 0) [[unlikely]]
      continue;
    *present++ = held;
#pragma GCC unroll 8
    for (std::uint32_t i = 0; i < count; ++i) record[index_in_record(fields[i])] = v[i];
    record += stride;
  }
  const auto added = static_cast<std::uint32_t>(present - list.present.data()) - list.count;
  list.count += added;
  return added;
}

/// Each as a call of its own.
template <Mode M>
[[gnu::noinline]] std::uint32_t append_each(ig_block* block, const ig_field* fields, std::uint32_t count,
                                            std::uint32_t records, const std::uint32_t* masks, const ig_value* v) {
  std::uint32_t appended = 0;
  for (std::uint32_t r = 0; r < records; ++r, v += count) {
    std::array<ig_field, most_together> some;
    std::array<ig_value, most_together> values;
    std::uint32_t n = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if ((masks[r] >> i & 1) == 0) continue;
      some[n] = fields[i];
      values[n++] = v[i];
    }
    appended += append_other<M>(block, some.data(), n, values.data()) != 0;
  }
  return appended;
}

}  // namespace

template <Mode M>
std::int32_t append(ig_block* block, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  if constexpr (M != Mode::checked) {
    Document& d = doc(block);
    if (count == usual_count ? append_as_before(d, fields, usual_count, v) : append_as_before(d, fields, count, v))
      return 1;
  }
  return append_other<M>(block, fields, count, v);
}

template <Mode M>
std::uint32_t append_many(ig_block* block, const ig_field* fields, std::uint32_t count, std::uint32_t records,
                          const std::uint32_t* masks, const ig_value* v) {
  Document& d = doc(block);
  if (count > most_together) {
    if constexpr (M == Mode::checked) violation(d, "it appends records with more fields than one call can name");
    return 0;
  }
  if constexpr (M != Mode::checked) {
    const RecordShape* shape = &d.record_shapes.at(fields);
    if (!shape->is(fields, count)) [[unlikely]]
      shape = shape_of(d, fields, count);
    if (shape != nullptr && has_room(d.lists[shape->list], records)) [[likely]] {
      ListData& list = d.lists[shape->list];
      const std::uint32_t added = count == usual_together ? add_records(list, fields, usual_together, records, masks, v)
                                                          : add_records(list, fields, count, records, masks, v);
      if (d.chain != nullptr) d.chain->records += added;
      if (added != 0) d.wake_by_list(shape->list);
      return added;
    }
  }
  return append_each<M>(block, fields, count, records, masks, v);
}

template <Mode M>
std::uint32_t count_records(const ig_block* block, ig_field f) {
  const Document& d = doc(block);
  if constexpr (M == Mode::checked)
    if (f != IG_NO_FIELD && !is_record_field(f))
      violation(d, "it counts the records of " + field_name(d, f) + ", which is of no list");
  return is_record_field(f) && list_of(f) < d.lists.size() ? d.lists[list_of(f)].count : 0;
}

template <Mode M>
std::uint32_t record(const ig_block* block, std::uint32_t index, const ig_field* fields, std::uint32_t count,
                     ig_value* out) {
  Document& d = const_cast<Document&>(doc(block));
  ListData* const list = list_of_all(d, fields, count);
  if (!may_use<M>(d, list, fields, count, nullptr) || index >= list->count) return 0;
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((list->present[index] >> index_in_record(fields[i]) & 1) == 0) continue;
    out[i] = list->record(index)[index_in_record(fields[i])];
    mask |= 1u << (i & 31);
  }
  return mask;
}

template <Mode M>
void set_record(ig_block* block, std::uint32_t index, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  Document& d = doc(block);
  ListData* const list = list_of_all(d, fields, count);
  if (!may_use<M>(d, list, fields, count, v) || index >= list->count) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    list->record(index)[index_in_record(fields[i])] = v[i];
    list->present[index] |= std::uint64_t{1} << index_in_record(fields[i]);
  }
}

template <Mode M>
[[gnu::noinline]] void map_some_records(ig_block* block, const ig_field program[3], const ig_field machine[3]) {
  Document& d = doc(block);
  const ig_field all[6] = {program[0], program[1], program[2], machine[0], machine[1], machine[2]};
  ListData* const list = list_of_all(d, all, 6);
  if (!may_use<M>(d, list, all, 6, nullptr)) return;
  std::size_t at[6];
  for (int i = 0; i < 6; ++i) at[i] = index_in_record(all[i]);
  const std::uint64_t wanted = std::uint64_t{1} << at[0] | std::uint64_t{1} << at[1] | std::uint64_t{1} << at[2];
  const std::uint64_t given = std::uint64_t{1} << at[3] | std::uint64_t{1} << at[4] | std::uint64_t{1} << at[5];
  const auto each = [&](const auto& map) {
    ig_value* v = list->values.data();
    for (std::uint64_t& present : list->masks()) {
      if ((present & (wanted | given)) == wanted) {
        map(v);
        present |= given;
      }
      v += list->stride;
    }
  };
  const Frame& frame = d.composed();
  if (frame.kind == Frame::Kind::general)
    each([&](ig_value* v) {
      const double from[3] = {v[at[0]].number, v[at[1]].number, v[at[2]].number};
      double to[3];
      frame.map(from, to);
      for (int i = 0; i < 3; ++i) v[at[3 + i]].number = to[i];
    });
  else
    each([&at, x = frame.matrix[12], y = frame.matrix[13], z = frame.matrix[14]](ig_value* v) {
      v[at[3]].number = v[at[0]].number + x;
      v[at[4]].number = v[at[1]].number + y;
      v[at[5]].number = v[at[2]].number + z;
    });
}

/// Most blocks have no records, and each block with a point asks.
template <Mode M>
void map_records(ig_block* block, const ig_field program[3], const ig_field machine[3]) {
  if (count_records<M>(block, program[0]) != 0) map_some_records<M>(block, program, machine);
}

#define ISOGLOSS_RECORDS_OF(mode)                                                                                 \
  template void add_leftover<mode>(ig_block*, const ig_leftover*);                                                \
  template std::int32_t append<mode>(ig_block*, const ig_field*, std::uint32_t, const ig_value*);                 \
  template std::uint32_t append_many<mode>(ig_block*, const ig_field*, std::uint32_t, std::uint32_t,              \
                                           const std::uint32_t*, const ig_value*);                                \
  template std::uint32_t count_records<mode>(const ig_block*, ig_field);                                          \
  template std::uint32_t record<mode>(const ig_block*, std::uint32_t, const ig_field*, std::uint32_t, ig_value*); \
  template void set_record<mode>(ig_block*, std::uint32_t, const ig_field*, std::uint32_t, const ig_value*);      \
  template void map_records<mode>(ig_block*, const ig_field*, const ig_field*);
ISOGLOSS_RECORDS_OF(Mode::fast)
ISOGLOSS_RECORDS_OF(Mode::checked)
ISOGLOSS_RECORDS_OF(Mode::traced)
#undef ISOGLOSS_RECORDS_OF

}  // namespace isogloss::calls
