#include "diff/field_map.hpp"

#include <algorithm>

namespace isogloss::cli::parting {

FieldMap::FieldMap(const LinkedDialect& a, const LinkedDialect& b, const std::vector<std::string>& ignored)
    : ignored_(ignored) {
  number_fields(0, a.layout);
  number_fields(1, b.layout);
  note_reads(0, a);
  note_reads(1, b);
}

std::uint32_t FieldMap::number_of(const std::string& path, const FieldInfo& field) {
  const auto is_in = [&path](const std::string& section) {
    return path == section ||
           (path.starts_with(section) && (path[section.size()] == '.' || path[section.size()] == '['));
  };
  if (const auto found = std::find_if(ignored_.begin(), ignored_.end(), is_in); found != ignored_.end()) {
    found_.insert(*found);
    return no_field;
  }
  const auto [found, is_new] = numbers_.try_emplace(path, static_cast<std::uint32_t>(fields.size()));
  if (is_new)
    fields.push_back({path, field.unit, field.type, !field.hidden && field.type != IG_SWITCH,
                      field.life == IG_LIFE_WORD || field.type == IG_CODE});
  return found->second;
}

void FieldMap::number_fields(int side, const Layout& layout) {
  for (const FieldInfo& field : layout.fields)
    of_field[side].push_back(field.previous_of != IG_NO_FIELD ? no_field : number_of(field.path, field));
  for (const ListInfo& list : layout.lists) {
    auto found = std::find(lists.begin(), lists.end(), list.path);
    if (found == lists.end()) {
      found = lists.insert(found, list.path);
      list_field.push_back(number_of(list.path + "[]", {}));
    }
    of_list[side].push_back(static_cast<std::uint32_t>(found - lists.begin()));
    std::vector<std::uint32_t>& record = of_record[side].emplace_back();
    for (const FieldInfo& field : list.fields) record.push_back(number_of(list.path + "[]." + field.path, field));
  }
}

void FieldMap::note_reads(int side, const LinkedDialect& linked) {
  const std::size_t length = linked.chain.size();
  for (auto* const masks : {&reads, &reads_before, &takes, &writes}) (*masks)[side].resize(length);
  for (std::size_t p = 0; p < length; ++p) {
    const LinkedSyntax& s = linked.chain[p];
    std::vector<bool>& now = reads[side][p];
    std::vector<bool>& before = reads_before[side][p];
    std::vector<bool>& written = writes[side][p];
    std::vector<bool>& taken = takes[side][p];
    for (auto* const mask : {&now, &before, &taken, &written}) mask->resize(fields.size());
    for (ig_field f = 0; f < linked.layout.fields.size(); ++f) {
      if (const std::uint32_t number = of_field[side][f];
          number != no_field && (s.may_write[f >> 6] >> (f & 63) & 1) != 0)
        written[number] = true;
      if (((s.may_read[f >> 6] | s.may_take[f >> 6]) >> (f & 63) & 1) == 0) continue;
      const ig_field source = linked.layout.fields[f].previous_of;
      const std::uint32_t number = of_field[side][source == IG_NO_FIELD ? f : source];
      if (number != no_field && (s.may_take[f >> 6] >> (f & 63) & 1) != 0) taken[number] = true;
      if (number != no_field) (source == IG_NO_FIELD ? now : before)[number] = true;
    }
    for (std::size_t i = 0; i < s.ids.size(); ++i) {
      if (s.ids[i] == IG_NO_FIELD || !is_record_field(s.ids[i])) continue;
      const std::vector<std::uint32_t>& record = of_record[side][list_of(s.ids[i])];
      const std::size_t index = index_in_record(s.ids[i]);
      if (index >= record.size() || record[index] == no_field) continue;
      const std::uint32_t access = s.syntax->fields[i].access;
      if ((access & (IG_READ | IG_TAKE)) != 0) now[record[index]] = true;
      if ((access & IG_WRITE) != 0) written[record[index]] = true;
    }
  }
}

}  // namespace isogloss::cli::parting
