// What the document keeps from block to block, and how it knows what changed: with as many fields as real chains have,
// so that they fill several words of bits.
#include "isogloss/engine/document.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>

namespace isogloss {
namespace {

/// 70 modal fields, a code, a word, 200 words of codes; the first modal field has a copy from before the block.
struct ManyFields {
  ManyFields() {
    const auto add = [&](const std::string& path, ig_type type, ig_life life, ig_field previous_of = IG_NO_FIELD) {
      layout.fields.push_back({path, type, life, "", "", previous_of != IG_NO_FIELD, previous_of});
      return static_cast<ig_field>(layout.fields.size() - 1);
    };
    modal = add("Test.M0", IG_NUMBER, IG_LIFE_MODAL);
    for (int i = 1; i < 70; ++i) add("Test.M" + std::to_string(i), IG_NUMBER, IG_LIFE_MODAL);
    code = add("Parsing.Flags.A1", IG_CODE, IG_LIFE_WORD);
    word = add("Parsing.X", IG_NUMBER, IG_LIFE_WORD);
    for (int i = 0; i < 200; ++i) owned = add("Parsing.A2.W" + std::to_string(i), IG_NUMBER, IG_LIFE_WORD);
    copy = add("Test.M0", IG_NUMBER, IG_LIFE_BLOCK, modal);
    layout.index();
  }
  Layout layout;
  ig_field modal, code, word, owned, copy;
};

void begin(Document& d) { d.begin({"part.nc", 1, 0, ""}); }

TEST_CASE("words of a code are found and swept like all words") {
  const ManyFields f;
  const std::uint32_t wake_words = GENERATE(2u, 3u, 16u);
  Document d(f.layout, std::vector<std::uint64_t>(f.layout.fields.size() * wake_words), wake_words);
  begin(d);
  CHECK_FALSE(d.has_leftovers());
  SECTION("set") { d.set(f.owned, {.number = 1}); }
  SECTION("several set") {
    const ig_value v[2] = {{.number = 1}, {.number = 2}};
    const ig_field fields[2] = {f.owned, f.modal};
    d.set_many(fields, 2, v);
  }
  SECTION("moved") {
    d.set(f.word, {.number = 1});
    d.move(f.word, f.owned);
  }
  SECTION("amended") { d.write(f.owned, {.number = 1}); }
  CHECK(d.has_leftovers());
  REQUIRE(d.collect_leftovers().size() == 1);
  CHECK(d.collect_leftovers().front().name == "A2.W199");
  begin(d);
  CHECK_FALSE(d.present(f.owned));
  CHECK_FALSE(d.fresh(f.owned));
  CHECK_FALSE(d.has_leftovers());
}

TEST_CASE("a value from before the block is that of the block's begin") {
  const ManyFields f;
  Document d(f.layout, std::vector<std::uint64_t>(f.layout.fields.size() * 2), 2);
  begin(d);
  CHECK_FALSE(d.present(f.copy));
  d.set(f.modal, {.number = 5});
  CHECK_FALSE(d.present(f.copy));
  begin(d);
  CHECK(d.present(f.copy));
  d.set(f.modal, {.number = 6});
  CHECK(d.number(f.copy) == 5);
  d.erase(f.modal);
  begin(d);
  CHECK_FALSE(d.present(f.copy));
}

TEST_CASE("a block that is assigned has the values of the other one, and none of its own") {
  const ManyFields f;
  const std::vector<std::uint64_t> no_wakes(f.layout.fields.size() * 2);
  Document from(f.layout, no_wakes, 2), to(f.layout, no_wakes, 2);
  begin(to);
  to.set(f.owned, {.number = 8});
  to.set(f.modal + 1, {.number = 9});
  begin(from);
  from.set(f.modal, {.number = 5});
  from.set_word({f.word, 3, 7, {.number = 6}, 0, 0});
  from.set(f.code, {});
  ig_value taken;
  REQUIRE(from.take(f.code, taken));
  to = from;
  CHECK(to.same_content(from));
  CHECK(to.number(f.modal) == 5);
  CHECK(to.number(f.word) == 6);
  CHECK(to.word_begin(f.word) == 3);
  CHECK(to.word_end(f.word) == 7);
  CHECK(to.taken(f.code));
  CHECK_FALSE(to.present(f.owned));
  CHECK_FALSE(to.present(f.modal + 1));
}

TEST_CASE("a watched field tells of a change, and of nothing else") {
  const ManyFields f;
  Document d(f.layout, std::vector<std::uint64_t>(f.layout.fields.size() * 2), 2);
  begin(d);
  d.watch(f.modal, 4);
  d.watch(f.modal, 8);
  const auto changes = [&] { return std::exchange(d.changes, 0); };
  d.set(f.word, {.number = 1});
  CHECK(changes() == 0);
  d.set(f.modal, {.number = 5});
  CHECK(changes() == 12);
  begin(d);
  d.set(f.modal, {.number = 5});
  CHECK(changes() == 0);
  SECTION("another value, by itself") { d.set(f.modal, {.number = 6}); }
  SECTION("with others") {
    const ig_value v[2] = {{.number = 6}, {.number = 6}};
    const ig_field fields[2] = {f.modal + 1, f.modal};
    d.set_many(fields, 2, v);
  }
  SECTION("as one of three") {
    const double v[3] = {6, 6, 6};
    d.set_point(f.modal, v);
  }
  SECTION("amended") { d.write(f.modal, {.number = 6}); }
  SECTION("rewritten") { d.rewrite(f.modal, {.number = 6}); }
  SECTION("erased") { d.erase(f.modal); }
  SECTION("taken") {
    ig_value v;
    REQUIRE(d.take(f.modal, v));
  }
  SECTION("taken as one of three") {
    double v[3];
    d.take_point(f.modal, v);
  }
  SECTION("taken as one of several") {
    ig_value v[2];
    const ig_field fields[2] = {f.word, f.modal};
    d.take_many(fields, 2, v);
  }
  CHECK(changes() == 12);
}

TEST_CASE("several fields written at once wake and count what each of them does") {
  const ManyFields f;
  constexpr std::uint32_t wake_words = 3;
  const std::vector<ig_field> fields{f.word, f.modal, f.code, f.owned, f.modal + 69};
  const std::size_t watched = GENERATE(range(0, 6));  // the last one: none
  std::vector<std::uint64_t> wake(f.layout.fields.size() * wake_words);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    wake[fields[i] * wake_words + i % wake_words] |= std::uint64_t{1} << i;
    if (i % wake_words == 2) wake[fields[i] * wake_words + 1] |= wakes_beyond;
  }
  Document one(f.layout, wake, wake_words), many(f.layout, wake, wake_words);
  for (Document* d : {&one, &many}) {
    begin(*d);
    if (watched < fields.size()) d->watch(fields[watched], 4);
  }
  SECTION("values") {
    std::vector<ig_value> values;
    for (std::size_t i = 0; i < fields.size(); ++i) values.push_back({.number = 1.0 + static_cast<double>(i)});
    for (std::size_t i = 0; i < fields.size(); ++i) {
      one.set(fields[i], values[i]);
      one.count_code(fields[i]);
    }
    many.set_many(fields.data(), static_cast<std::uint32_t>(fields.size()), values.data());
  }
  SECTION("words of the text") {
    std::vector<ig_word> words;
    for (std::uint16_t i = 0; i < fields.size(); ++i)
      words.push_back({fields[i], i, static_cast<std::uint16_t>(i + 1), {.number = 2}, IG_WORD_WITHOUT_POINT, 0});
    for (const ig_word& w : words) one.set_word(w);
    many.set_words(words.data(), static_cast<std::uint32_t>(words.size()));
  }
  CHECK(many.same_content(one));
  CHECK(many.codes_seen == 1);
  CHECK(many.codes_seen == one.codes_seen);
  CHECK(many.changes == one.changes);
  for (std::uint32_t k = 0; k < wake_words; ++k) CHECK(many.active[k] == one.active[k]);
  CHECK((many.active[2] & 0xff) == 4);
  for (const ig_field field : fields) CHECK(many.without_point(field) == one.without_point(field));
}

TEST_CASE("fields that are asked for at once answer as each of them does") {
  const ManyFields f;
  const ig_field owned = f.owned - 199;
  const std::vector<std::vector<ig_field>> calls{
      {owned, owned + 1, owned + 2, owned + 3, owned + 4},  // as they stand
      {f.word, owned + 9, f.code, owned, owned + 3},        // in one word of bits, in another order
      {f.word, owned + 70, f.code, owned, owned + 140},     // in several
      {f.word, owned + 3, f.word, owned},                   // one of them twice
      {f.word, f.code, 4'000'000'000, IG_NO_FIELD},         // some that do not exist
      {f.modal + 64, f.modal + 65, f.modal + 66, f.modal + 67, f.code, f.word},
      {owned + 3, f.word},
      {},
  };
  Document one(f.layout, std::vector<std::uint64_t>(f.layout.fields.size() * 2), 2);
  Document many = one;
  std::vector<ig_field> here;  // all calls name their fields at the same place
  here.reserve(40);
  for (int round = 0; round < 3; ++round)
    for (const std::vector<ig_field>& fields : calls)
      for (std::uint32_t present = 0; present < 64; ++present) {
        here.assign(fields.begin(), fields.end());
        const auto count = static_cast<std::uint32_t>(here.size());
        for (Document* d : {&one, &many}) {
          begin(*d);
          for (ig_field modal = f.modal; modal < f.modal + 70; ++modal) d->erase(modal);
          if (round == 2) d->watch(f.modal + 65, 4);
          if (round == 2) d->watch(f.word, 8);
          d->changes = 0;
          for (std::uint32_t i = 0; i < count; ++i)
            if ((present >> i & 1) != 0 && fields[i] < d->size()) {
              d->count_code(fields[i]);
              d->set(fields[i], {.number = i + 0.5});
            }
        }
        std::vector<ig_value> singly(count), at_once(count);
        std::uint32_t known = 0;
        std::int32_t last = Document::none_present;
        for (std::uint32_t i = 0; i < count; ++i)
          if (one.present(fields[i])) {
            last = known == 0 ? static_cast<std::int32_t>(i) : std::int32_t{Document::several_present};
            known |= 1u << i;
            singly[i] = one.value(fields[i]);
          }
        CAPTURE(round, fields, present);
        if (const std::int32_t only = many.only_present(here.data(), count); only != Document::several_present)
          CHECK(only == last);
        CHECK(many.get_many(here.data(), count, at_once.data()) == known);
        std::uint32_t taken = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
          CHECK(((known >> i & 1) == 0 || at_once[i].number == singly[i].number));
          if (one.take(fields[i], singly[i])) taken |= 1u << i;
        }
        CHECK(many.take_many(here.data(), count, at_once.data()) == taken);
        for (std::uint32_t i = 0; i < count; ++i)
          CHECK(((taken >> i & 1) == 0 || at_once[i].number == singly[i].number));
        CHECK(many.same_content(one));
        CHECK(many.changes == one.changes);
      }
}

TEST_CASE("a block that gets a summary has what the words gave that it sums up") {
  const ManyFields f;
  const ig_field owned = f.owned - 199;
  const std::vector<std::vector<ig_field>> texts{
      {}, {f.word}, {f.code, f.word, f.code}, {f.word, owned + 3, f.word}, {f.code, f.word, owned + 70, f.owned},
  };
  std::vector<std::uint64_t> wake(f.layout.fields.size() * 2);
  for (const ig_field field : {f.code, f.word, owned + 3, owned + 70, f.owned}) {
    wake[field * 2] = std::uint64_t{1} << (field % 61);
    wake[field * 2 + 1] = std::uint64_t{2} << (field % 13);
  }
  Document scanned(f.layout, wake, 2), given = scanned, one = scanned;
  Document::Summary summary;
  begin(scanned);
  scanned.begin_scan(summary);
  REQUIRE(scanned.hand_over());
  for (const std::vector<ig_field>& fields : texts) {
    for (Document* d : {&given, &one}) begin(*d);
    CHECK(scanned.begin_scan_again(2, "X1", summary));
    CHECK(scanned.source.line == 2);
    CHECK(scanned.source.text == "X1");
    CHECK(scanned.same_content(one));
    std::vector<ig_word> words;
    for (std::uint16_t i = 0; i < fields.size(); ++i)
      words.push_back({fields[i],
                       i,
                       static_cast<std::uint16_t>(i + 1),
                       {.number = 2.5 + i},
                       i % 2 == 0 ? std::uint32_t{IG_WORD_WITHOUT_POINT} : 0u,
                       0});
    scanned.current = one.current = 7;
    for (const ig_word& w : words) {
      scanned.add_words(&w, 1);
      one.set_word(w);
    }
    CAPTURE(fields);
    CHECK(scanned.same_content(one));
    REQUIRE(scanned.hand_over());
    CHECK(summary.bytes() <= sizeof summary);
    given.set_summed(summary);
    CHECK(given.same_content(one));
    CHECK(given.codes_seen == one.codes_seen);
    for (int k = 0; k < 2; ++k) CHECK(given.active[k] == one.active[k]);
    for (const ig_field field : fields) {
      CHECK(given.without_point(field) == one.without_point(field));
      CHECK(given.word_begin(field) == one.word_begin(field));
      CHECK(given.word_end(field) == one.word_end(field));
      CHECK(given.writer(field) == 7);
    }
    begin(given);
    begin(one);
    CHECK(given.same_content(one));
    CHECK_FALSE(given.has_leftovers());
  }
}

TEST_CASE("a block takes words and values where nobody sums them up") {
  const ManyFields f;
  Document d(f.layout, std::vector<std::uint64_t>(f.layout.fields.size() * 2), 2), one = d;
  for (Document* const block : {&d, &one}) begin(*block);
  const ig_word word{f.word, 0, 2, {.number = 3}, 0, 0};
  d.add_words(&word, 1);
  d.add(f.modal, {.number = 4});
  d.add(IG_NO_FIELD, {.number = 5});
  one.set_word(word);
  one.set(f.modal, {.number = 4});
  CHECK(d.same_content(one));
}

TEST_CASE("a summary tells of watched fields that change, wakes what is far, and has a limit") {
  const ManyFields f;
  constexpr std::uint32_t wake_words = 3;
  std::vector<std::uint64_t> wake(f.layout.fields.size() * wake_words);
  wake[f.word * wake_words + 1] = wakes_beyond;
  wake[f.word * wake_words + 2] = 5;
  Document scanned(f.layout, wake, wake_words), given = scanned;
  for (const ig_field field : {f.modal, f.modal + 65, f.word}) given.watch(field, std::uint64_t{1} << (field % 64));
  begin(given);
  given.set(f.modal, {.number = 1});
  given.set(f.modal + 65, {.number = 1});
  for (Document* d : {&scanned, &given}) begin(*d);
  given.changes = 0;
  Document::Summary summary;
  scanned.begin_scan(summary);
  scanned.add(f.modal, {.number = 1});
  scanned.add(f.modal + 65, {.number = 2});
  scanned.add(f.word, {.number = 3});
  REQUIRE(scanned.hand_over());
  given.set_summed(summary);
  CHECK(given.changes == (std::uint64_t{1} << ((f.modal + 65) % 64) | std::uint64_t{1} << (f.word % 64)));
  CHECK(given.number(f.modal + 65) == 2);
  CHECK(given.active[2] == 5);
  CHECK_FALSE(scanned.begin_scan_again(2, {}, summary));  // values that stay, with copies from before the block
  CHECK(scanned.number(f.modal + 65) == 2);
  for (const std::uint32_t more : {0u, 1u, 300u}) {
    begin(scanned);
    scanned.begin_scan(summary);
    for (std::uint32_t i = 0; i < Document::Summary::most_fields + more; ++i)
      scanned.add(f.modal + i % 70, {.number = 1});
    CHECK(scanned.hand_over() == (more == 0));
  }
}

TEST_CASE("a summary holds the values of a chain without words") {
  Layout layout;
  for (int i = 0; i < 200; ++i)
    layout.fields.push_back({"Test.V" + std::to_string(i), IG_NUMBER, IG_LIFE_BLOCK, "", "", false, IG_NO_FIELD});
  layout.index();
  Document scanned(layout, std::vector<std::uint64_t>(layout.fields.size() * 2), 2), given = scanned;
  for (Document* d : {&scanned, &given}) begin(*d);
  Document::Summary summary;
  scanned.begin_scan(summary);
  scanned.add(3, {.number = 1});
  scanned.add(190, {.number = 2});
  const Document one = scanned;
  REQUIRE(scanned.hand_over());
  given.set_summed(summary);
  CHECK(given.same_content(one));
  CHECK(given.number(190) == 2);
}

TEST_CASE("a summary has what lies in any of the words of bits of a large chain") {
  Layout layout;
  constexpr ig_field count = 66 * 64 + 5;
  for (ig_field i = 0; i < count; ++i)
    layout.fields.push_back({"Test.V" + std::to_string(i), IG_NUMBER, IG_LIFE_BLOCK, "", "", false, IG_NO_FIELD});
  layout.index();
  Document scanned(layout, std::vector<std::uint64_t>(layout.fields.size() * 2), 2), given = scanned;
  begin(scanned);
  Document::Summary summary;
  scanned.begin_scan(summary);
  REQUIRE(scanned.hand_over());
  for (const std::vector<ig_field>& fields : std::vector<std::vector<ig_field>>{
           {62 * 64}, {63 * 64, 63 * 64 + 63}, {64 * 64 + 1, 66 * 64 + 4}, {0, 63 * 64 - 1, count - 1}, {}}) {
    CAPTURE(fields);
    CHECK(scanned.begin_scan_again(1, {}, summary));
    begin(given);
    CHECK(scanned.same_content(given));
    for (const ig_field field : fields) scanned.add(field, {.number = 0.5 + field});
    const Document one = scanned;
    REQUIRE(scanned.hand_over());
    CHECK(summary.fields == fields.size());
    given.set_summed(summary);
    CHECK(given.same_content(one));
    for (const ig_field field : fields) CHECK(given.number(field) == 0.5 + field);
  }
  for (ig_field word = 0; word <= Document::Summary::most_pieces; ++word) scanned.add(word * 64, {.number = 1});
  CHECK_FALSE(scanned.hand_over());
}

}  // namespace
}  // namespace isogloss
