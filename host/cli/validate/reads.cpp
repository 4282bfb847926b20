// Which of the fields that a syntax declares as read does it read? A host that offers no view of its blocks sees it.
#include <map>
#include <set>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// Of the chain at work: whether each field was read. A plugin's fields are ids of its chain.
thread_local std::vector<bool>* reads = nullptr;

void note_read(ig_field field) {
  if (reads != nullptr && field < reads->size()) (*reads)[field] = true;
}

void note_read(const ig_field* fields, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) note_read(fields[i]);
}

/// The functions that read, each noting its fields before the host answers.
ig_host reading_host() {
  ig_host out = host_table(Mode::fast);
  out.flags = 0;
  out.get = [](const ig_block* b, ig_field f, ig_value* v) {
    return note_read(f), host_table(Mode::fast).get(b, f, v);
  };
  out.get_many = [](const ig_block* b, const ig_field* f, std::uint32_t n, ig_value* v) {
    return note_read(f, n), host_table(Mode::fast).get_many(b, f, n, v);
  };
  out.take = [](ig_block* b, ig_field f, ig_value* v) { return note_read(f), host_table(Mode::fast).take(b, f, v); };
  out.take_many = [](ig_block* b, const ig_field* f, std::uint32_t n, ig_value* v) {
    return note_read(f, n), host_table(Mode::fast).take_many(b, f, n, v);
  };
  out.is_fresh = [](const ig_block* b, ig_field f) { return note_read(f), host_table(Mode::fast).is_fresh(b, f); };
  out.fresh_many = [](const ig_block* b, const ig_field* f, std::uint32_t n) {
    return note_read(f, n), host_table(Mode::fast).fresh_many(b, f, n);
  };
  out.take_code = [](ig_block* b, const ig_field* f, std::uint32_t n, std::uint32_t* found) {
    return note_read(f, n), host_table(Mode::fast).take_code(b, f, n, found);
  };
  out.find_code = [](const ig_block* b, const ig_field* f, std::uint32_t n, std::uint32_t* found) {
    return note_read(f, n), host_table(Mode::fast).find_code(b, f, n, found);
  };
  out.text = [](const ig_block* b, ig_field f) { return note_read(f), host_table(Mode::fast).text(b, f); };
  out.move = [](ig_block* b, ig_field from, ig_field to) { note_read(from), host_table(Mode::fast).move(b, from, to); };
  out.rewrite = [](ig_block* b, ig_field f, ig_value v) { note_read(f), host_table(Mode::fast).rewrite(b, f, v); };
  out.word = [](const ig_block* b, ig_field f, ig_word* w) {
    return note_read(f), host_table(Mode::fast).word(b, f, w);
  };
  out.transform = [](const ig_block* b, ig_field f, double* m) {
    return note_read(f), host_table(Mode::fast).transform(b, f, m);
  };
  out.get_point = [](const ig_block* b, ig_field x, double* p) {
    return note_read(x), note_read(x + 1), note_read(x + 2), host_table(Mode::fast).get_point(b, x, p);
  };
  out.take_point = [](ig_block* b, ig_field x, double* p) {
    return note_read(x), note_read(x + 1), note_read(x + 2), host_table(Mode::fast).take_point(b, x, p);
  };
  out.fresh_point = [](const ig_block* b, ig_field x) {
    return note_read(x), note_read(x + 1), note_read(x + 2), host_table(Mode::fast).fresh_point(b, x);
  };
  return out;
}

/// Switches only wake, the host expands patterns to fields that this dialect happens to have, and whoever writes a
/// field may look at it as a precaution.
bool is_checked(const ig_field_decl& declared, ig_field id) {
  return (declared.access & (IG_READ | IG_PREVIOUS)) != 0 && (declared.access & (IG_PATTERN | IG_WRITE)) == 0 &&
         declared.type != IG_SWITCH && id != IG_NO_FIELD && !is_record_field(id);
}

}  // namespace

void check_unread(Examination& e) {
  constexpr std::uint64_t random_ones = 40;
  const ig_host host = reading_host();
  ChainSettings settings;
  settings.host = &host;
  Subject subject(e);
  std::map<const ig_syntax*, std::set<std::uint32_t>> unread;
  for (const Stand& stand : stands_of(subject, e)) {
    const ig_syntax& syntax = *stand.syntax;
    if (syntax.build == nullptr) continue;
    const std::vector<ig_field>& ids = stand.alone.linked->chain[stand.alone.position].ids;
    if (!unread.contains(&syntax))
      for (std::uint32_t i = 0; i < syntax.field_count; ++i)
        if (is_checked(syntax.fields[i], ids[i])) unread[&syntax].insert(i);
    std::vector<bool> seen(stand.alone.linked->layout.fields.size(), false);
    Bench bench(stand.alone, settings);
    for (const TestBlock& block : many_blocks(stand, e, random_ones)) {
      e.attempt(std::string(syntax.id) + ", " + block.name);
      reads = &seen;
      bench.run(block, false);
      reads = nullptr;
    }
    std::erase_if(unread[&syntax], [&](std::uint32_t i) { return ids[i] >= seen.size() || seen[ids[i]]; });
  }
  for (const auto& [syntax, left] : unread) {
    std::string paths;
    for (const std::uint32_t i : left) paths += " " + std::string(syntax->fields[i].path);
    if (!left.empty()) e.find(syntax->id, "no block makes it read these fields, which it declares:" + paths);
  }
}

}  // namespace isogloss::cli
