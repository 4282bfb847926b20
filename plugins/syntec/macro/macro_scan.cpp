/// Finds statements, their ends and their words in the text of a line.
#include "macro/macro_scan.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct Known {
  std::string_view word;
  Keyword keyword;
};
constexpr Known keywords[] = {{"IF", Keyword::if_},
                              {"ELSEIF", Keyword::elseif},
                              {"ELSE", Keyword::else_},
                              {"END_IF", Keyword::end_if},
                              {"ENDIF", Keyword::end_if},
                              {"CASE", Keyword::case_},
                              {"END_CASE", Keyword::end_case},
                              {"ENDCASE", Keyword::end_case},
                              {"WHILE", Keyword::while_},
                              {"END_WHILE", Keyword::end_while},
                              {"ENDWHILE", Keyword::end_while},
                              {"FOR", Keyword::for_},
                              {"END_FOR", Keyword::end_for},
                              {"ENDFOR", Keyword::end_for},
                              {"REPEAT", Keyword::repeat},
                              {"UNTIL", Keyword::until},
                              {"END_REPEAT", Keyword::end_repeat},
                              {"ENDREPEAT", Keyword::end_repeat},
                              {"EXIT", Keyword::exit},
                              {"GOTO", Keyword::go_to}};

}  // namespace

Keyword keyword(std::string_view word) {
  for (const Known& k : keywords)
    if (equals_ignoring_case(word, k.word)) return k.keyword;
  return Keyword::none;
}

std::string_view spelled(Keyword k) {
  for (const Known& known : keywords)
    if (known.keyword == k) return known.word;
  return {};
}

std::string_view closing_word(Keyword k) {
  switch (k) {
    case Keyword::if_:
    case Keyword::elseif: return "THEN";
    case Keyword::while_:
    case Keyword::for_: return "DO";
    case Keyword::case_: return "OF";
    case Keyword::until: return "END_REPEAT";
    default: return {};
  }
}

bool stands_alone(Keyword k) {
  switch (k) {
    case Keyword::else_:
    case Keyword::repeat:
    case Keyword::end_if:
    case Keyword::end_case:
    case Keyword::end_while:
    case Keyword::end_for:
    case Keyword::end_repeat:
    case Keyword::exit: return true;
    default: return false;
  }
}

bool is_word(std::string_view text, std::size_t position, std::string_view word) {
  return position < text.size() && equals_ignoring_case(piece(text, position, name_end(text, position)), word);
}

std::size_t find_word(std::string_view text, std::size_t position, std::string_view word) {
  bool is_quoted = false;
  for (std::size_t i = position; i < text.size(); ++i) {
    if (text[i] == '"') is_quoted = !is_quoted;
    if (is_quoted || !is_letter(text[i]) || (i > 0 && (is_letter(text[i - 1]) || text[i - 1] == '_'))) continue;
    if (is_word(text, i, word)) return i;
  }
  return text.size();
}

std::size_t skip_head(std::string_view text, std::size_t begin, std::size_t end) {
  std::size_t i = begin;
  while (i < end) {
    const char c = text[i];
    if (is_blank(c)) {
      ++i;
    } else if (c == '/') {
      i += is_digit(at(text, i + 1)) ? 2 : 1;
    } else if (c == '(' && at(text, i + 1) == '*') {
      const std::size_t close = text.find("*)", i + 2);
      if (close == std::string_view::npos || close >= end) return i;
      i = close + 2;
    } else if (to_upper(c) == 'N') {
      const std::size_t digits = skip_blanks(text, i + 1), behind = skip_digits(text, digits);
      if (behind == digits) return i;
      i = behind;
    } else {
      return i;
    }
  }
  return i;
}

std::size_t label_end(std::string_view text, std::size_t position) {
  for (std::size_t i = position;; ++i) {
    i = skip_blanks(text, i);
    const std::size_t end = skip_digits(text, i);
    if (end == i) return position;
    i = skip_blanks(text, end);
    if (at(text, i) == ':') return at(text, i + 1) == '=' ? position : i + 1;
    if (at(text, i) != ',') return position;
  }
}

Keyword statement_at(std::string_view text, std::size_t position) {
  const char c = at(text, position);
  if (c == '#' || c == '@') return Keyword::assignment;
  if (is_digit(c)) return label_end(text, position) > position ? Keyword::case_label : Keyword::none;
  if (!is_letter(c)) return Keyword::none;
  const std::size_t end = name_end(text, position);
  if (const Keyword k = keyword(piece(text, position, end)); k != Keyword::none) return k;
  // X1= and SP1= are words of axes, G01 and X#1 words as well.
  const std::size_t letters = skip_name_of(text, position, [](char d) { return is_letter(d) || d == '_'; });
  const std::size_t behind = skip_blanks(text, end);
  const bool is_assigned = at(text, behind) == '=' || (at(text, behind) == ':' && at(text, behind + 1) == '=');
  const bool is_of_app = equals_ignoring_case(piece(text, position, letters), "AR") ||
                         equals_ignoring_case(piece(text, position, letters), "MAR");
  if (letters - position < 2 || (is_assigned && !is_of_app)) return Keyword::none;
  return Keyword::function;
}

std::size_t StatementCollector::add(std::string_view line, std::size_t position, Keyword k, MacroComment& comment) {
  const bool is_first = text_.empty();
  if (is_first) begin_ = position;
  if (!is_first) text_ += ' ';
  offset_ = text_.size();
  text_.append(position, ' ');
  const std::string_view closing = closing_word(k);
  const auto ends_at = [&](std::size_t end) {  // takes a ; that follows
    is_complete_ = true;
    const std::size_t next = skip_blanks(line, end);
    return at(line, next) == ';' ? next + 1 : end;
  };
  std::size_t i = position;
  if (is_first && (stands_alone(k) || k == Keyword::case_label)) {
    const std::size_t end = k == Keyword::case_label ? label_end(line, i) : name_end(line, i);
    text_.append(piece(line, i, end));
    return ends_at(end);
  }
  if (comment.is_open) {
    const std::size_t close = line.find("*)", i);
    if (close == std::string_view::npos) return block_end(line, i);
    comment.is_open = false;
    text_.append(close + 2 - i, ' ');
    i = close + 2;
  }
  while (!is_block_end(line, i)) {
    const char c = line[i], next = at(line, i + 1);
    if (c == ';') {
      is_complete_ = true;
      return i + 1;
    }
    if (c == '/' && next == '/') return block_end(line, i);
    if (c == '(' && next == '*') {
      const std::size_t close = line.find("*)", i + 2);
      comment.is_open = close == std::string_view::npos;
      const std::size_t end = comment.is_open ? block_end(line, i) : close + 2;
      text_.append(end - i, ' ');
      i = end;
      continue;
    }
    if (c == '"') {
      std::size_t end = i + 1;
      while (!is_block_end(line, end) && line[end] != '"') ++end;
      if (at(line, end) == '"') ++end;
      text_.append(piece(line, i, end));
      i = end;
      continue;
    }
    if (is_letter(c)) {
      const std::size_t end = name_end(line, i);
      const std::string_view word = piece(line, i, end);
      text_.append(word);
      i = end;
      if (!closing.empty() &&
          (equals_ignoring_case(word, closing) || (k == Keyword::until && equals_ignoring_case(word, "ENDREPEAT"))))
        return ends_at(end);
      continue;
    }
    text_ += c;
    ++i;
  }
  return i;
}

}  // namespace syntec
