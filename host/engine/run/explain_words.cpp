#include "run/explain_words.hpp"

#include <algorithm>

#include "run/explain_values.hpp"

namespace isogloss {

namespace {

bool is_block_word(const Document& d, ig_field f) {
  const FieldInfo& info = d.layout().fields[f];
  return d.present(f) && d.fresh(f) && d.word_end(f) != 0 && !info.hidden && info.life == IG_LIFE_WORD &&
         (info.type == IG_NUMBER || info.type == IG_CODE);
}

constexpr std::string_view word_blanks = " \t\r\n";

}  // namespace

/// A word that a syntax has moved stands at the same columns in another field.
void WordLog::follow(const Document& d, Seen& seen, std::uint16_t user) {
  const bool is_code = d.layout().fields[seen.field].type == IG_CODE;
  const auto use = [&] {
    if (user != 0) seen.word.users.push_back(linked_->chain[user - 1u].element.alias);
  };
  if (d.present(seen.field) && is_code) {
    if (d.taken(seen.field) && !seen.is_taken) use();
    seen.is_taken = seen.is_taken || d.taken(seen.field);
    return;
  }
  if (d.present(seen.field)) {
    seen.word.value = number_text(d.number(seen.field));
    return;
  }
  use();
  seen.field = IG_NO_FIELD;
  for (ig_field f = 0; f < d.size(); ++f) {
    const bool is_here = is_block_word(d, f) && d.word_begin(f) == seen.begin && d.word_end(f) == seen.end;
    if (is_here && d.writer(f) == user && !is_seen(f)) {
      seen.field = f;
      return;
    }
  }
}

void WordLog::find_new(const Document& d) {
  const Layout& layout = d.layout();
  for (ig_field f = 0; f < d.size(); ++f) {
    if (!is_block_word(d, f) || is_seen(f)) continue;
    const bool is_code = layout.fields[f].type == IG_CODE;
    Seen seen{d.word_begin(f), d.word_end(f), f, d.taken(f), {}};
    constexpr std::string_view parsing = "Parsing.";
    const std::string& path = layout.fields[f].path;
    seen.word.name = is_code                     ? std::string(Layout::code_name(path))
                     : path.starts_with(parsing) ? path.substr(parsing.size())
                                                 : path;
    if (!is_code) seen.word.value = number_text(d.number(f));
    const std::uint16_t writer = d.writer(f);
    if (writer != 0) seen.word.reader = linked_->chain[writer - 1u].element.alias;
    seen_.push_back(std::move(seen));
  }
}

bool WordLog::is_seen(ig_field f) const {
  return std::any_of(seen_.begin(), seen_.end(), [&](const Seen& s) { return s.field == f; });
}

void WordLog::look(const Document& document, std::uint16_t user) {
  for (Seen& seen : seen_)
    if (seen.field != IG_NO_FIELD) follow(document, seen, user);
  find_new(document);
}

void WordLog::add_text(std::string_view text, std::uint32_t begin, std::uint32_t end, const std::string& reader,
                       std::vector<ExplainedWord>& out) const {
  const std::string_view piece = text.substr(begin, end - begin);
  const std::size_t first = piece.find_first_not_of(word_blanks);
  if (first == std::string_view::npos) return;
  const std::size_t last = piece.find_last_not_of(word_blanks);
  const auto column = static_cast<std::uint32_t>(begin + first + 1);
  // What one scanner has read piece by piece is one text to a reader.
  if (!out.empty() && out.back().name.empty() && out.back().reader == reader &&
      out.back().column + out.back().text.size() == column)
    out.back().text += piece.substr(first, last + 1 - first);
  else
    out.push_back({std::string(piece.substr(first, last + 1 - first)), column, "", "", reader, {}});
}

std::vector<ExplainedWord> WordLog::words(std::string_view text) const {
  std::vector<ExplainedWord> out;
  const auto size = static_cast<std::uint32_t>(text.size());
  std::vector<const Seen*> words;
  for (const Seen& s : seen_)
    if (s.begin < s.end && s.end <= size) words.push_back(&s);
  std::stable_sort(words.begin(), words.end(), [](const Seen* a, const Seen* b) { return a->begin < b->begin; });
  // By byte: a long line may have as many pieces as bytes.
  std::vector<const Piece*> readers(size);
  for (const Piece& p : pieces_)
    for (std::uint32_t i = p.begin; i < std::min(p.end, size); ++i)
      if (readers[i] == nullptr) readers[i] = &p;
  const auto fill = [&](std::uint32_t begin, std::uint32_t end) {
    while (begin < end) {
      const Piece* const piece = readers[begin];
      std::uint32_t to = begin + 1;
      while (to < end && readers[to] == piece) ++to;
      add_text(text, begin, to, piece != nullptr ? linked_->chain[piece->reader].element.alias : "", out);
      begin = to;
    }
  };
  std::uint32_t at = 0;
  for (const Seen* s : words) {
    if (s->begin > at) fill(at, s->begin);
    ExplainedWord word = s->word;
    word.text = text.substr(s->begin, s->end - s->begin);
    word.column = s->begin + 1;
    out.push_back(std::move(word));
    at = std::max(at, s->end);
  }
  fill(at, size);
  return out;
}

}  // namespace isogloss
