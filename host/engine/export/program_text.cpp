#include "isogloss/engine/program_text.hpp"

#include <charconv>

#include "isogloss/engine/chain.hpp"

namespace isogloss {

BlockTemplate::BlockTemplate(std::string_view text) {
  const auto add_text = [&](std::string_view literal) {
    if (!literal.empty()) pieces_.push_back({Piece::Kind::text, std::string(literal)});
  };
  std::size_t begin = 0;
  for (std::size_t at = text.find_first_of("{[]"); at != std::string_view::npos;
       at = text.find_first_of("{[]", begin)) {
    add_text(text.substr(begin, at - begin));
    begin = at + 1;
    if (text[at] != '{') {
      pieces_.push_back({text[at] == '[' ? Piece::Kind::open : Piece::Kind::close, {}});
      continue;
    }
    const std::size_t end = std::min(text.find('}', at), text.size());
    const std::string_view name = text.substr(begin, end - begin);
    const std::size_t colon = std::min(name.find(':'), name.size());
    pieces_.push_back({Piece::Kind::value, std::string(name.substr(0, colon)),
                       std::string(name.substr(std::min(colon + 1, name.size())))});
    begin = std::min(end + 1, text.size());
  }
  add_text(text.substr(begin));
}

bool BlockTemplate::fill(const Values& values, std::string& out) const {
  const std::size_t start = out.size();
  std::size_t group = std::string::npos;  // where the optional part began
  bool is_left_out = false;
  for (const Piece& piece : pieces_) {
    switch (piece.kind) {
      case Piece::Kind::open:
        group = out.size();
        is_left_out = false;
        break;
      case Piece::Kind::close:
        group = std::string::npos;
        is_left_out = false;
        break;
      case Piece::Kind::text:
        if (!is_left_out) out += piece.text;
        break;
      case Piece::Kind::value:
        if (is_left_out || values(piece.text, piece.format, out)) break;
        is_left_out = group != std::string::npos;
        out.resize(is_left_out ? group : start);
        if (!is_left_out) return false;
        break;
    }
  }
  return true;
}

ProgramText ProgramText::of(Chain& chain) {
  ProgramText out;
  const auto place = chain.answering("isogloss.program-text/1");
  const DependencyTable* const table = place ? chain.table(chain.linked().dependencies[*place].element.alias) : nullptr;
  if (table == nullptr) return out;
  const auto text = table->column("text"), when = table->column("when");
  if (!text || !when) return out;
  for (const std::string& row : table->rows())
    out.rows.push_back({row, std::string(table->text(row, static_cast<std::uint32_t>(*when))),
                        BlockTemplate(table->text(row, static_cast<std::uint32_t>(*text)))});
  return out;
}

const ProgramText::Row* ProgramText::find(std::string_view name) const {
  for (const Row& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

std::string block_number(double value, bool exact, bool is_plain) {
  char text[400];
  const auto done = exact ? std::to_chars(text, text + sizeof text, value, std::chars_format::fixed)
                          : std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 6);
  std::string out(text, done.ptr);
  if (const std::size_t point = out.find('.'); point != std::string::npos)
    out.erase(std::max(out.find_last_not_of('0'), point) + 1);
  else
    out += '.';
  if (out == "-0.") out = "0.";
  if (is_plain && out.back() == '.') out.pop_back();
  return out;
}

}  // namespace isogloss
