// The calls for three fields side by side do what the calls for several do, wherever the three lie. Records get the
// fields that each call names.
#include "contract/host_table.hpp"

#include <catch2/catch.hpp>

#include <initializer_list>
#include <string>
#include <vector>

namespace isogloss {
namespace {

/// 150 numbers, of which every third is not there; the tenth is a word.
struct Numbers {
  static constexpr ig_field count = 150;
  Numbers() {
    for (ig_field f = 0; f < count; ++f)
      layout.fields.push_back({"Test.F" + std::to_string(f), IG_NUMBER, f == 10 ? IG_LIFE_WORD : IG_LIFE_BLOCK, "", "",
                               false, IG_NO_FIELD});
    layout.index();
  }
  Document filled() const {
    Document d(layout, wake(), 2);
    d.begin({"part.nc", 1, 0, ""});
    for (ig_field f = 0; f < count; ++f)
      if (f % 3 != 0) d.set(f, {.number = 1000.0 + f});
    for (std::uint64_t& mask : d.active) mask = 0;
    return d;
  }
  /// Each field wakes a syntax of its own.
  static std::vector<std::uint64_t> wake() {
    std::vector<std::uint64_t> masks(count * std::size_t{2});
    for (ig_field f = 0; f < count; ++f) masks[f * std::size_t{2} + f / 64 % 2] |= std::uint64_t{1} << f % 64;
    return masks;
  }
  Layout layout;
};

ig_block* block(Document& d) { return d.block(); }

bool same(const Document& a, const Document& b) {
  for (ig_field f = 0; f < a.size(); ++f) {
    if (a.present(f) != b.present(f) || a.fresh(f) != b.fresh(f) || a.taken(f) != b.taken(f)) return false;
    if (a.present(f) && (a.number(f) != b.number(f) || a.writer(f) != b.writer(f))) return false;
  }
  return a.active[0] == b.active[0] && a.active[1] == b.active[1];
}

TEST_CASE("three fields side by side are the same as three") {
  const Mode mode = GENERATE(Mode::fast, Mode::checked, Mode::traced);
  const ig_host& host = host_table(mode);
  const Numbers numbers;
  // Also where a word of bits ends between them, and where the document ends.
  for (ig_field x = 0; x < Numbers::count + 3; ++x) {
    CAPTURE(static_cast<int>(mode), x);
    const ig_field three[3] = {x, x + 1, x + 2};
    Document once = numbers.filled(), one_by_one = numbers.filled();
    once.origins.resize(once.size());
    one_by_one.origins.resize(once.size());

    double point[3] = {-1, -1, -1};
    ig_value values[3] = {};
    CHECK(host.get_point(block(once), x, point) == host.get_many(block(one_by_one), three, 3, values));
    for (int i = 0; i < 3; ++i) CHECK(point[i] == values[i].number);
    CHECK(host.fresh_point(block(once), x) == host.fresh_many(block(one_by_one), three, 3));

    ig_value taken[3] = {};
    CHECK(host.take_point(block(once), x, point) == host.take_many(block(one_by_one), three, 3, taken));
    for (int i = 0; i < 3; ++i) CHECK(point[i] == taken[i].number);
    CHECK(same(once, one_by_one));

    const double next[3] = {1, 2, 3};
    const ig_value next_values[3] = {{.number = 1}, {.number = 2}, {.number = 3}};
    host.set_point(block(once), x, next);
    host.set_many(block(one_by_one), three, 3, next_values);
    CHECK(same(once, one_by_one));
    CHECK(once.origins == one_by_one.origins);
  }
}

TEST_CASE("fields that are set or taken together are the same as one by one") {
  const ig_host& host = host_table(GENERATE(Mode::fast, Mode::traced));
  const Numbers numbers;
  // Back and forth between the words of bits, one field twice, one that is not there, one beyond the document.
  const std::vector<ig_field> fields = {1, 130, 2, 70, 70, 3, 1, 64, 10, 149, 128, Numbers::count + 5, 4};
  const auto count = static_cast<std::uint32_t>(fields.size());
  Document together = numbers.filled(), one_by_one = numbers.filled();

  std::vector<ig_value> taken(count, {.number = -1}), taken_alone = taken;
  const std::uint32_t found = host.take_many(block(together), fields.data(), count, taken.data());
  std::uint32_t found_alone = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (host.take(block(one_by_one), fields[i], &taken_alone[i]) != 0) found_alone |= 1u << i;
  CHECK(found == found_alone);
  for (std::uint32_t i = 0; i < count; ++i) CHECK(taken[i].number == taken_alone[i].number);
  CHECK(same(together, one_by_one));
  CHECK(together.taken(130));
  CHECK_FALSE(together.present(1));

  std::vector<ig_value> values(count);
  for (std::uint32_t i = 0; i < count; ++i) values[i].number = i;
  host.set_many(block(together), fields.data(), count, values.data());
  for (std::uint32_t i = 0; i < count; ++i)
    if (fields[i] < Numbers::count) host.set(block(one_by_one), fields[i], values[i]);
  CHECK(same(together, one_by_one));
  CHECK(together.number(70) == 4);
}

TEST_CASE("what a block shows is what the calls answer") {
  const ig_host& host = host_table(Mode::fast);
  REQUIRE((host.flags & IG_HOST_SHOWS_BLOCKS) != 0);
  const Numbers numbers;
  Document original = numbers.filled();
  ig_value taken;
  REQUIRE(host.take(block(original), 10, &taken) == 1);
  host.erase(block(original), 11);
  Document d = original;  // a copy shows its own values
  host.set(block(d), 12, {.number = 12});
  const auto* const view = reinterpret_cast<const ig_view*>(block(d));
  REQUIRE(view->field_count == Numbers::count);
  for (ig_field f = 0; f < Numbers::count; ++f) {
    CAPTURE(f);
    ig_value v{.number = -1};
    const bool present = host.get(block(d), f, &v) != 0;
    CHECK((view->bits[f / 64].present >> (f % 64) & 1) == (present ? 1 : 0));
    CHECK((view->bits[f / 64].fresh >> (f % 64) & 1) == (host.is_fresh(block(d), f) != 0 ? 1 : 0));
    if (present) CHECK(view->values[f].value.number == v.number);
  }
  CHECK(host.get(block(original), 12, &taken) == 0);
}

TEST_CASE("a host that looks at every access shows nothing") {
  CHECK(host_table(Mode::checked).flags == 0);
  CHECK(host_table(Mode::traced).flags == 0);
}

/// Two lists, whose records have so many fields.
Layout two_lists(int fields) {
  Layout layout;
  for (const char* list : {"Test.Items", "Test.Others"}) {
    layout.lists.push_back({list, {}});
    for (int i = 0; i < fields; ++i)
      layout.lists.back().fields.push_back(
          {"Test.F" + std::to_string(i), IG_NUMBER, IG_LIFE_BLOCK, "", "", false, IG_NO_FIELD});
  }
  layout.index();
  return layout;
}

TEST_CASE("a record has the fields that its call names, whatever an earlier call named there") {
  const Layout layout = two_lists(20);
  Document d(layout, {}, 2);
  d.begin({"part.nc", 1, 0, ""});
  const ig_host& host = host_table(Mode::fast);
  std::vector<ig_field> fields;
  std::vector<ig_value> values;
  const auto append = [&](std::size_t list, std::initializer_list<std::size_t> indexes) {
    fields.clear();
    values.clear();
    for (const std::size_t i : indexes) {
      fields.push_back(record_field(list, i));
      values.push_back({.number = static_cast<double>(i)});
    }
    return host.append(block(d), fields.data(), static_cast<std::uint32_t>(fields.size()), values.data());
  };
  fields.reserve(32);  // all calls name their fields in the same place
  CHECK(append(0, {0, 1, 2}) == 1);
  CHECK(append(0, {3, 1, 2}) == 1);
  CHECK(append(1, {3, 1}) == 1);
  CHECK(append(0, {3, 20}) == 0);
  CHECK(append(0, {}) == 0);
  CHECK(append(2, {3, 1}) == 0);
  const std::initializer_list<std::size_t> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19};
  CHECK(append(1, all) == 1);
  CHECK(append(1, all) == 1);
  fields = {record_field(0, 0), record_field(1, 1)};
  CHECK(host.append(block(d), fields.data(), 2, values.data()) == 0);
  REQUIRE(d.lists[0].count == 2);
  CHECK(std::ranges::equal(d.lists[0].masks(), std::vector<std::uint64_t>{7, 14}));
  CHECK(d.lists[0].record(1)[3].number == 3);
  REQUIRE(d.lists[1].count == 3);
  CHECK(std::ranges::equal(d.lists[1].masks(), std::vector<std::uint64_t>{10, 0xfffff, 0xfffff}));
  CHECK(d.lists[1].record(2)[19].number == 19);
}

TEST_CASE("records of one call have the fields that their masks name") {
  const Layout layout = two_lists(40);
  const std::vector<std::uint64_t> wake{0b01, 0, 0b10, 0};  // of the first list, and of the second
  Document d(layout, wake, 2);
  d.begin({"part.nc", 1, 0, ""});
  const Mode mode = GENERATE(Mode::fast, Mode::checked, Mode::traced);
  const ig_host& host = host_table(mode);
  const auto fields_of = [](std::initializer_list<std::size_t> indexes) {
    std::vector<ig_field> out;
    for (const std::size_t i : indexes) out.push_back(record_field(0, i));
    return out;
  };
  const auto append = [&](const std::vector<ig_field>& fields, const std::vector<std::uint32_t>& masks, double first) {
    std::vector<ig_value> values;
    for (std::size_t i = 0; i < fields.size() * masks.size(); ++i)
      values.push_back({.number = first + static_cast<double>(i)});
    return host.append_many(block(d), fields.data(), static_cast<std::uint32_t>(fields.size()),
                            static_cast<std::uint32_t>(masks.size()), masks.data(), values.data());
  };
  const std::vector<ig_field> six = fields_of({5, 4, 3, 2, 1, 0}), two = fields_of({39, 7});
  // Of a shape that is new, then where the list has no room, then where both are known.
  for (std::uint32_t round = 0; round < 30; ++round) {
    CAPTURE(round);
    d.wake_none();
    CHECK(append(six, {0b000001, 0b110000, 0b111111, 0, 1u << 6, 0b000001, 0b000010}, 100 * round) == 5);
    CHECK(append(two, {0b11}, 7) == 1);
    CHECK(d.active[0] == 0b01);
    ListData& list = d.lists[0];
    REQUIRE(list.count == 6 * (round + 1));
    const auto masks = list.masks().last(6);
    CHECK(std::ranges::equal(
        masks, std::vector<std::uint64_t>{0b100000, 0b000011, 0b111111, 0b100000, 0b010000, 1ull << 39 | 1 << 7}));
    CHECK(list.record(6 * round)[5].number == 100 * round);
    CHECK(list.record(6 * round + 1)[1].number == 100 * round + 10);
    CHECK(list.record(6 * round + 2)[0].number == 100 * round + 17);
    CHECK(list.record(6 * round + 4)[4].number == 100 * round + 37);
    CHECK(list.record(6 * round + 5)[39].number == 7);
  }
  d.wake_none();
  CHECK(append({}, {0}, 0) == 0);
  CHECK(append({record_field(0, 1), record_field(1, 1)}, {3}, 0) == 0);
  CHECK(append({record_field(0, 40)}, {1}, 0) == 0);
  CHECK(append(std::vector<ig_field>(33, record_field(0, 1)), {1}, 0) == 0);
  CHECK(append(six, {}, 0) == 0);
  CHECK(append(six, {0, 1u << 6}, 0) == 0);
  CHECK(d.active[0] == 0);
  CHECK(d.lists[0].count == 180);
}

TEST_CASE("three fields of no document are none") {
  const Mode mode = GENERATE(Mode::fast, Mode::checked, Mode::traced);
  const ig_host& host = host_table(mode);
  const Numbers numbers;
  for (const ig_field x : {IG_NO_FIELD, IG_NO_FIELD - 1, IG_NO_FIELD - 2}) {
    Document d = numbers.filled();
    const Document before = d;
    double point[3] = {-1, -1, -1};
    CHECK(host.get_point(block(d), x, point) == 0);
    CHECK(host.take_point(block(d), x, point) == 0);
    CHECK(host.fresh_point(block(d), x) == 0);
    CHECK((point[0] == 0 && point[1] == 0 && point[2] == 0));
    host.set_point(block(d), x, point);
    CHECK(same(d, before));
  }
}

}  // namespace
}  // namespace isogloss
