// Dense ids: modal fields first, among them those that are read as `previous`, with their copies; then the block's,
// switches, codes, words, words of codes (Parsing.CODE.X), those of each code together. Codes and words each begin a
// word of bits.
#include <algorithm>
#include <array>
#include <tuple>

#include "link/link_steps.hpp"

namespace isogloss {

namespace {

using Drafts = std::vector<FieldDrafts::Draft>;

constexpr std::size_t maximum_previous = 63;
constexpr std::size_t word = 64;  // fields of which one word has the bits

enum Rank : std::size_t {
  previous_rank,
  carried_rank,
  block_rank,
  switch_rank,
  code_rank,
  filling_rank,
  word_rank,
  rest_rank,
  code_word_rank,
  ranks
};
using Order = std::array<std::vector<std::uint32_t>, ranks>;

Rank rank(const FieldDrafts::Draft& draft) {
  const FieldInfo& info = draft.info;
  if (is_carried(info.life)) return draft.has_previous && info.type != IG_TRANSFORM ? previous_rank : carried_rank;
  if (info.type == IG_SWITCH) return switch_rank;
  if (info.type == IG_CODE) return code_rank;
  if (info.life != IG_LIFE_WORD) return block_rank;
  return std::count(info.path.begin(), info.path.end(), '.') > 1 ? code_word_rank : word_rank;
}

bool begins_point(const Drafts& drafts, const std::vector<std::uint32_t>& numbers, std::size_t i) {
  if (numbers.size() - i < 3) return false;
  const auto section = [&](std::size_t k, char axis) -> std::string_view {
    const std::string_view path = drafts[numbers[i + k]].info.path;
    return path.size() > 2 && path[path.size() - 2] == '.' && path.back() == axis ? path.substr(0, path.size() - 1)
                                                                                  : std::string_view();
  };
  const std::string_view x = section(0, 'X');
  return !x.empty() && section(1, 'Y') == x && section(2, 'Z') == x;
}

/// X Y Z of a section are read and written at once where the bits of the three lie in one word. Where three would
/// cross a word, fields that belong to no such group are placed first.
void keep_points_whole(const Drafts& drafts, std::vector<std::uint32_t>& numbers, std::size_t first_id) {
  for (std::size_t i = 0; i < numbers.size();) {
    if (!begins_point(drafts, numbers, i)) {
      ++i;
      continue;
    }
    std::size_t room = word - (first_id + i) % word;
    for (std::size_t single = i + 3; room < 3 && room > 0 && single < numbers.size();) {
      if (begins_point(drafts, numbers, single)) {
        single += 3;
        continue;
      }
      const auto found = numbers.begin() + static_cast<std::ptrdiff_t>(single++);
      if (drafts[*found].info.type == IG_TRANSFORM) continue;  // they compose in their order
      std::rotate(numbers.begin() + static_cast<std::ptrdiff_t>(i), found, found + 1);
      ++i;
      --room;
    }
    i += 3;
  }
}

/// The words of one code, which are mostly read and taken at once, have their bits in one word where there is room: the
/// largest of those that fit into the rest of a word comes next, and where none does the smallest one.
void keep_codes_whole(const Drafts& drafts, std::vector<std::uint32_t>& numbers, std::size_t first_id) {
  std::vector<std::vector<std::uint32_t>> codes;
  std::unordered_map<std::string_view, std::size_t> place_of;
  for (const std::uint32_t number : numbers) {
    const std::string_view path = drafts[number].info.path;
    const auto [found, is_new] = place_of.try_emplace(path.substr(0, path.rfind('.')), codes.size());
    if (is_new) codes.emplace_back();
    codes[found->second].push_back(number);
  }
  std::array<std::vector<std::size_t>, word + 1> by_size;  // the code that is mentioned first is the last one
  for (std::size_t place = codes.size(); place-- > 0;) by_size[std::min(codes[place].size(), word)].push_back(place);
  numbers.clear();
  for (std::size_t left = codes.size(); left > 0; --left) {
    const std::size_t room = word - (first_id + numbers.size()) % word;
    std::size_t size = room;
    while (size > 0 && by_size[size].empty()) --size;
    if (size == 0)
      for (size = room + 1; by_size[size].empty();) ++size;
    const std::vector<std::uint32_t>& code = codes[by_size[size].back()];
    numbers.insert(numbers.end(), code.begin(), code.end());
    by_size[size].pop_back();
  }
}

/// The codes that are mentioned first, such as those of motion, are looked for in nearly every block, and so are the
/// words: the bits of each begin a word, whatever number of fields stands before them, because fields of the block fill
/// the room behind the codes, and the rest of them stand behind the words.
void begin_words_of_bits(const Drafts& drafts, Order& order, std::size_t copies) {
  std::size_t before = copies;
  for (std::size_t r = 0; r < code_rank; ++r) before += order[r].size();
  const std::size_t behind_codes = (word - order[code_rank].size() % word) % word;
  std::size_t moved = before % word;
  if (moved < behind_codes) moved += word;
  std::vector<std::uint32_t> kept, filling;
  std::vector<std::uint32_t>& numbers = order[block_rank];
  for (std::size_t i = 0; i < numbers.size();) {
    const std::size_t size = begins_point(drafts, numbers, i) ? 3 : 1;
    const bool is_moved = filling.size() < moved && size == 1 && drafts[numbers[i]].info.type != IG_TRANSFORM;
    std::vector<std::uint32_t>& to = is_moved ? filling : kept;
    to.insert(to.end(), numbers.begin() + static_cast<std::ptrdiff_t>(i),
              numbers.begin() + static_cast<std::ptrdiff_t>(i + size));
    i += size;
  }
  numbers = std::move(kept);
  const auto middle = filling.begin() + static_cast<std::ptrdiff_t>(std::min(behind_codes, filling.size()));
  order[filling_rank].assign(filling.begin(), middle);
  order[rest_rank].assign(middle, filling.end());
}

/// By section; in a section what is carried first, words last, each in the order in which it is mentioned.
void order_for_show(Layout& layout, const std::vector<ig_field>& id_of) {
  std::unordered_map<std::string_view, std::size_t> sections;
  for (const std::string& s : section_order()) sections.emplace(s, sections.size());
  using Place = std::tuple<std::size_t, int, std::uint32_t>;
  std::vector<std::pair<Place, ig_field>> shown;
  for (std::uint32_t number = 0; number < id_of.size(); ++number) {
    const FieldInfo& info = layout.fields[id_of[number]];
    if (info.hidden || info.type == IG_CODE || info.type == IG_TRANSFORM) continue;
    const std::string_view path = info.path;
    const auto found = sections.find(path.substr(0, path.find('.')));
    const int life = is_carried(info.life) ? 0 : info.life == IG_LIFE_WORD ? 2 : 1;
    shown.push_back({{found != sections.end() ? found->second : sections.size(), life, number}, id_of[number]});
  }
  std::sort(shown.begin(), shown.end());
  for (const auto& [place, field] : shown) layout.shown.push_back(field);
}

}  // namespace

FieldIds order_fields(Linking& linking, FieldDrafts& field_drafts) {
  Layout& layout = linking.out.layout;
  Drafts& drafts = field_drafts.drafts();
  Order order;
  for (std::uint32_t i = 0; i < drafts.size(); ++i) order[rank(drafts[i])].push_back(i);
  std::vector<std::uint32_t> previous;  // in the order of their ids, so that one piece of memory holds them
  for (const std::vector<std::uint32_t>& same_rank : order)
    for (const std::uint32_t number : same_rank)
      if (drafts[number].has_previous) previous.push_back(number);
  if (previous.size() > maximum_previous)
    linking.report("IG-0224", {linking.out.dialect.file.string(), 0, 0},
                   {std::to_string(previous.size()), std::to_string(maximum_previous)});
  begin_words_of_bits(drafts, order, previous.size());

  FieldIds ids{std::vector<ig_field>(drafts.size(), IG_NO_FIELD), std::vector<ig_field>(drafts.size(), IG_NO_FIELD)};
  ig_field next = 0;
  const auto give = [&](std::vector<std::uint32_t>& numbers, std::vector<ig_field>& given) {
    if (&numbers == &order[code_word_rank]) keep_codes_whole(drafts, numbers, next);
    keep_points_whole(drafts, numbers, next);
    for (const std::uint32_t number : numbers) given[number] = next++;
  };
  for (std::vector<std::uint32_t>& same_rank : order) {
    give(same_rank, ids.of);
    if (&same_rank == &order[previous_rank]) give(previous, ids.of_previous);
  }
  layout.fields.resize(next);
  for (const std::vector<std::uint32_t>& same_rank : order)
    for (const std::uint32_t number : same_rank) {
      const ig_field id = ids.of[number];
      if (drafts[number].info.type == IG_TRANSFORM) layout.transforms.push_back(id);
      layout.fields[id] = std::move(drafts[number].info);
    }
  for (const std::uint32_t number : previous) {
    FieldInfo& copy = layout.fields[ids.of_previous[number]];
    copy = layout.fields[ids.of[number]];
    copy.life = IG_LIFE_BLOCK;
    copy.hidden = true;
    copy.previous_of = ids.of[number];
  }
  layout.index();
  order_for_show(layout, ids.of);
  return ids;
}

}  // namespace isogloss
