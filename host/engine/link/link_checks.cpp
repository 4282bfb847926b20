#include "link/link_checks.hpp"

#include <algorithm>
#include <bitset>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include <fmt/format.h>

#include "isogloss_flow.h"
#include "isogloss_provenance.h"

namespace isogloss {

namespace {

std::string place(const Location& w) { return fmt::format("{}:{}:{}", w.file, w.line, w.column); }

/// A pair that breaks the declarations of both is one fault; so is one syntax that stands wrong relative to several.
void check_order(const LinkedDialect& linked, std::vector<LinkFault>& faults) {
  std::set<std::pair<std::size_t, std::size_t>> said;
  std::map<std::pair<std::string, std::size_t>, std::vector<std::string>> further;  // by code and what stands wrong
  std::vector<std::pair<std::pair<std::string, std::size_t>, LinkFault>> first;
  for (std::size_t i = 0; i < linked.chain.size(); ++i) {
    const LinkedSyntax& s = linked.chain[i];
    const auto complain_of_any = [&](const char* code, std::string_view id, std::size_t begin, std::size_t end) {
      for (std::size_t other = begin; other < end; ++other) {
        const ChainElement& o = linked.chain[other].element;
        if (o.syntax != id || !said.emplace(std::min(i, other), std::max(i, other)).second) continue;
        const std::pair by_other(std::string(code), other);
        const auto same = std::find_if(first.begin(), first.end(), [&](const auto& f) {
          return f.first == by_other || (f.first.first == code && f.second.arguments[0] == s.element.alias);
        });
        if (same != first.end())
          further[same->first].push_back(same->first == by_other ? s.element.alias : o.alias);
        else
          first.push_back({by_other, {code, s.element.where, {s.element.alias, o.alias, place(o.where)}}});
      }
    };
    for (const char* const* id = s.syntax->after; id != nullptr && *id != nullptr; ++id)
      complain_of_any("IG-0206", *id, i + 1, linked.chain.size());
    for (const char* const* id = s.syntax->before; id != nullptr && *id != nullptr; ++id)
      complain_of_any("IG-0207", *id, 0, i);
  }
  for (auto& [key, fault] : first) {
    fault.hint = "move one of them; isogloss lint --suggest prints an order that fits";
    if (const std::vector<std::string>& others = further[key]; !others.empty())
      fault.hint += fmt::format("; the same holds of {}", fmt::join(others, ", "));
    faults.push_back(std::move(fault));
  }
}

/// For each field, whether something writes and something reads it.
struct Traffic {
  explicit Traffic(const LinkedDialect& linked)
      : written(linked.layout.fields.size()), read(linked.layout.fields.size()) {
    std::vector<std::uint64_t> own((written.size() + 63) / 64), writes(own), reads(own);
    for (ig_field f = 0; f < written.size(); ++f)
      if (linked.layout.fields[f].type == IG_SWITCH || linked.layout.fields[f].life == IG_LIFE_MODAL)
        own[f >> 6] |= std::uint64_t{1} << (f & 63);
    for (const LinkedSyntax& s : linked.chain)
      for (std::size_t i = 0; i < own.size(); ++i) {
        writes[i] |= s.may_write[i];
        // A syntax may read its own switches and carried values; other values are for other syntaxes.
        reads[i] |= (s.may_read[i] & (own[i] | ~s.may_write[i])) | s.may_take[i];
      }
    for (ig_field f = 0; f < written.size(); ++f) {
      written[f] = (writes[f >> 6] >> (f & 63) & 1) != 0;
      read[f] = (reads[f >> 6] >> (f & 63) & 1) != 0;
    }
    for (const auto& [field, value] : linked.initial) written[field] = true;
    for (ig_field f = 0; f < written.size(); ++f)
      if (const ig_field of = linked.layout.fields[f].previous_of; of != IG_NO_FIELD && read[f]) read[of] = true;
    // The exporters and the inspection read the standard sections and every word.
    for (const FieldInfo& info : standard_fields())
      if (const auto f = linked.layout.find(info.path)) read[*f] = true;
    for (const ig_field f : linked.layout.transforms) read[f] = true;
    for (ig_field f = 0; f < read.size(); ++f)
      if (linked.layout.fields[f].life == IG_LIFE_WORD) read[f] = true;
  }
  std::vector<bool> written, read;
};

void check_required(const LinkedDialect& linked, const Traffic& traffic, std::vector<LinkFault>& faults) {
  for (const LinkedSyntax& s : linked.chain)
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field f = s.ids[i];
      if ((s.syntax->fields[i].access & IG_REQUIRED) == 0 || f == IG_NO_FIELD || is_record_field(f)) continue;
      const ig_field of = linked.layout.fields[f].previous_of;
      if (!traffic.written[of == IG_NO_FIELD ? f : of])
        faults.push_back({"IG-0208", s.element.where, {s.element.alias, s.syntax->fields[i].path}});
    }
}

void check_unread(const LinkedDialect& linked, const Traffic& traffic, std::vector<LinkFault>& faults) {
  for (const LinkedSyntax& s : linked.chain)
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field f = s.ids[i];
      if ((s.syntax->fields[i].access & IG_WRITE) == 0 || f == IG_NO_FIELD || is_record_field(f)) continue;
      if (!traffic.read[f]) faults.push_back({"IG-0212", s.element.where, {s.element.alias, s.syntax->fields[i].path}});
    }
}

/// A wake-while examines a block at its beginning: carried values, previous values and words.
void check_wakes(const LinkedDialect& linked, std::vector<LinkFault>& faults) {
  for (const LinkedSyntax& s : linked.chain)
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field f = s.ids[i];
      if ((s.syntax->fields[i].access & IG_WAKE_WHILE) == 0 || f == IG_NO_FIELD) continue;
      if (!is_record_field(f)) {
        const FieldInfo& field = linked.layout.fields[f];
        if (is_carried(field.life) || field.life == IG_LIFE_WORD || field.previous_of != IG_NO_FIELD) continue;
      }
      faults.push_back({"IG-0242", s.element.where, {s.element.alias, s.syntax->fields[i].path}});
    }
}

void check_slots(const LinkedDialect& linked, std::vector<LinkFault>& faults) {
  std::map<std::string, const LinkedSyntax*> holders;
  for (const LinkedSyntax& s : linked.chain) {
    if (s.syntax->exclusive_slot == nullptr || s.element.override_slot) continue;
    const auto [where, added] = holders.emplace(s.syntax->exclusive_slot, &s);
    if (!added)
      faults.push_back({"IG-0210",
                        s.element.where,
                        {s.element.alias, s.syntax->exclusive_slot, where->second->element.alias,
                         place(where->second->element.where)},
                        "remove one of them, or say override=\"true\" on the second where both are meant"});
  }
}

/// Which syntaxes of the chain know of each other, straight or through others that stand between them.
class Acquaintance {
 public:
  explicit Acquaintance(const LinkedDialect& linked) : behind_(linked.chain.size()) {
    std::unordered_multimap<std::string_view, std::size_t> places;
    for (std::size_t i = 0; i < behind_.size(); ++i) places.emplace(linked.chain[i].syntax->id, i);
    const auto for_each = [&](const char* const* id, auto&& act) {
      for (; id != nullptr && *id != nullptr; ++id)
        for (auto [it, end] = places.equal_range(*id); it != end; ++it) act(it->second);
    };
    for (std::size_t i = 0; i < behind_.size(); ++i) {
      for_each(linked.chain[i].syntax->after, [&](std::size_t k) {
        if (k < i) behind_[k].set(i);
      });
      for_each(linked.chain[i].syntax->before, [&](std::size_t k) {
        if (k > i) behind_[i].set(k);
      });
    }
    for (std::size_t i = behind_.size(); i-- > 0;)
      for (std::size_t k = i + 1; k < behind_.size(); ++k)
        if (behind_[i][k]) behind_[i] |= behind_[k];
  }
  bool knows(std::size_t first, std::size_t second) const { return behind_[first][second]; }

 private:
  std::vector<std::bitset<longest_chain>> behind_;
};

std::string codes_of(const Layout& layout, const std::vector<ig_field>& fields) {
  constexpr std::size_t most = 5;
  constexpr std::string_view flags = "Parsing.Flags.";
  std::vector<std::string> names;
  for (const ig_field field : fields) {
    const std::string& path = layout.fields[field].path;
    names.push_back(path.substr(path.starts_with(flags) ? flags.size() : path.find('.') + 1));
  }
  return listed(names, most);
}

/// Codes that two syntaxes take are answered twice, unless one of them was written with the other in mind.
void check_codes(const LinkedDialect& linked, std::vector<LinkFault>& faults) {
  const std::vector<FieldInfo>& fields = linked.layout.fields;
  std::vector<std::uint64_t> codes((fields.size() + 63) / 64);
  for (ig_field f = 0; f < fields.size(); ++f)
    if (fields[f].type == IG_CODE) codes[f >> 6] |= std::uint64_t{1} << (f & 63);
  std::vector<std::uint64_t> taken(codes.size());
  const Acquaintance acquaintance(linked);
  for (std::size_t i = 0; i < linked.chain.size(); ++i) {
    const LinkedSyntax& second = linked.chain[i];
    std::uint64_t again = 0;
    for (std::size_t w = 0; w < codes.size(); ++w) {
      again |= taken[w] & second.may_take[w];
      taken[w] |= second.may_take[w] & codes[w];
    }
    for (std::size_t k = 0; k < i && again != 0 && !second.element.override_slot; ++k) {
      const LinkedSyntax& first = linked.chain[k];
      std::vector<ig_field> both;
      for (std::size_t w = 0; w < codes.size(); ++w)
        for (std::uint64_t open = first.may_take[w] & second.may_take[w] & codes[w]; open != 0; open &= open - 1)
          both.push_back(static_cast<ig_field>(w * 64 + static_cast<std::size_t>(__builtin_ctzll(open))));
      if (both.empty()) continue;
      if (acquaintance.knows(k, i)) continue;
      faults.push_back({"IG-0241",
                        second.element.where,
                        {second.element.alias, first.element.alias, codes_of(linked.layout, both)}});
    }
  }
}

}  // namespace

std::vector<Provision> provisions(const LinkedDialect& linked) {
  std::vector<Provision> out;
  for (std::size_t i = 0; i < linked.dependencies.size(); ++i)
    for (const char* const* id = linked.dependencies[i].dependency->provides; id != nullptr && *id != nullptr; ++id) {
      auto known = std::find_if(out.begin(), out.end(), [&](const Provision& p) { return p.service == *id; });
      if (known == out.end()) known = out.insert(out.end(), {*id, {}});
      known->dependencies.push_back(i);
    }
  return out;
}

std::vector<LinkFault> check_services(const LinkedDialect& linked) {
  std::vector<LinkFault> faults;
  const auto is_provided = [&](std::string_view id) {
    if (id == IG_FLOW_SERVICE || id == IG_PROVENANCE_SERVICE) return true;  // the host itself
    return std::any_of(linked.dependencies.begin(), linked.dependencies.end(), [&](const LinkedDependency& d) {
      for (const char* const* p = d.dependency->provides; p != nullptr && *p != nullptr; ++p)
        if (id == *p) return true;
      return false;
    });
  };
  for (const LinkedSyntax& s : linked.chain)
    for (std::uint32_t i = 0; i < s.syntax->service_count; ++i) {
      const ig_service_decl& service = s.syntax->services[i];
      if (service.is_optional == 0 && !is_provided(service.id))
        faults.push_back({"IG-0211", s.element.where, {s.element.alias, service.id}});
    }
  return faults;
}

std::vector<LinkFault> check_places(const LinkedDialect& linked) {
  std::vector<LinkFault> faults;
  check_order(linked, faults);
  check_slots(linked, faults);
  return faults;
}

std::vector<LinkFault> check_links(const LinkedDialect& linked) {
  std::vector<LinkFault> faults;
  const Traffic traffic(linked);
  check_order(linked, faults);
  check_required(linked, traffic, faults);
  check_wakes(linked, faults);
  check_slots(linked, faults);
  const std::vector<LinkFault> services = check_services(linked);
  faults.insert(faults.end(), services.begin(), services.end());
  check_codes(linked, faults);
  check_unread(linked, traffic, faults);
  return faults;
}

}  // namespace isogloss
