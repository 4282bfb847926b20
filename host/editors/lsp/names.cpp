#include "lsp/names.hpp"

#include <isogloss_flow.h>

#include <algorithm>
#include <set>

namespace isogloss::editors {

namespace {

bool is_digit_char(char c) { return c >= '0' && c <= '9'; }
bool is_letter_char(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || (c & 0x80) != 0; }
bool is_name_char(char c) { return is_digit_char(c) || is_letter_char(c); }
char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_letters(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, small, small); }

bool is_number(std::string_view text) { return std::ranges::all_of(text, is_digit_char); }

/// Does the name stand at `at` as a word of its own?
bool stands_at(std::string_view text, std::size_t at, std::string_view name) {
  if (at + name.size() > text.size() || !same_letters(text.substr(at, name.size()), name)) return false;
  const bool begins = at == 0 || !is_name_char(name.front()) ||
                      !(is_name_char(text[at - 1]) || text[at - 1] == '#' || text[at - 1] == '$');
  const std::size_t behind = at + name.size();
  return begins && (behind == text.size() || !is_name_char(text[behind]) || !is_name_char(name.back()));
}

std::vector<std::size_t> places_of(std::string_view text, std::string_view name) {
  std::vector<std::size_t> out;
  if (name.empty()) return out;
  const char both[] = {
      small(name.front()),
      static_cast<char>(name.front() >= 'a' && name.front() <= 'z' ? name.front() - 'a' + 'A' : name.front())};
  const std::string_view first(both, 2);
  for (std::size_t at = text.find_first_of(first); at != std::string_view::npos; at = text.find_first_of(first, at + 1))
    if (stands_at(text, at, name)) out.push_back(at);
  return out;
}

const Token* token_at(const ScanMap& map, std::size_t offset) {
  const auto [first, last] = map.between(offset, offset + 1);
  return first < last ? &map.tokens[first] : nullptr;
}

/// Does the syntax that has read the token call or jump?
bool reads_flow(const OpenProgram& program, const Token& token) {
  if (token.reader == 0) return false;
  const ig_syntax& syntax = *program.setup->linked->chain[token.reader - 1].syntax;
  for (std::uint32_t i = 0; i < syntax.service_count; ++i)
    if (std::string_view(syntax.services[i].id) == IG_FLOW_SERVICE) return true;
  return false;
}

std::optional<NameAt> variable_at(const OpenProgram& program, std::size_t offset) {
  if (!program.analysis) return std::nullopt;
  const std::uint32_t line = program.text.run_line_of(offset);
  const std::string_view text = program.text.run_line(line);
  const std::size_t begin = program.text.run_line_begin(line), column = offset - begin;
  std::optional<NameAt> best;
  std::set<std::string_view> looked;
  for (const VariableUse& use : program.analysis->variables) {
    if (use.name.empty() || !looked.insert(use.name).second) continue;
    const std::size_t from = column >= use.name.size() ? column - use.name.size() : 0;
    for (std::size_t at = from; at <= column && at < text.size(); ++at)
      if (stands_at(text, at, use.name) && (!best || use.name.size() > best->name.size()))
        best = NameAt{NameAt::Kind::variable, use.name, {begin + at, begin + at + use.name.size()}, nullptr};
  }
  return best;
}

/// The words before the numbers of references that a run has confirmed: GOTO, LBL.
std::string_view word_before(std::string_view text, std::size_t at) {
  while (at > 0 && text[at - 1] == ' ') --at;
  std::size_t begin = at;
  while (begin > 0 && is_letter_char(text[begin - 1])) --begin;
  return text.substr(begin, at - begin);
}

/// Where the core of a label stands in a line that refers to it, with whatever letters before a number: best behind the
/// word that stands before it in the label itself, as in LBL 5, else last.
std::optional<Span> core_in(const OpenProgram& program, std::uint32_t line, const Span& declared) {
  const std::string_view all = program.text.text(), text = program.text.run_line(line);
  const std::string_view core = all.substr(declared.begin, declared.end - declared.begin);
  const std::string_view wanted = word_before(all, declared.begin);
  const std::size_t begin = program.text.run_line_begin(line);
  const bool number = is_number(core);
  std::optional<Span> last;
  for (std::size_t at = text.size(); at-- > 0;) {
    if (at + core.size() > text.size() || !same_letters(text.substr(at, core.size()), core)) continue;
    const bool begins = at == 0 || (number ? !is_digit_char(text[at - 1]) : !is_name_char(text[at - 1]));
    const std::size_t behind = at + core.size();
    if (!begins || (behind < text.size() && is_name_char(text[behind]))) continue;
    const Span here{begin + at, begin + behind};
    if (!wanted.empty() && same_letters(word_before(text, at), wanted)) return here;
    if (!last) last = here;
  }
  return last;
}

class LabelReferences {
 public:
  LabelReferences(OpenProgram& program, const NamedPlace& place)
      : program_(program), map_(program.scan_map()), place_(place), declared_(core_of(program.text, place)) {
    core_ = std::string_view(program.text.text()).substr(declared_.begin, declared_.end - declared_.begin);
  }

  std::vector<Occurrence> find() {
    out_.push_back({declared_, true});
    add_confirmed();
    add_written();
    std::ranges::sort(out_, {}, [](const Occurrence& o) { return o.span.begin; });
    return std::move(out_);
  }

 private:
  /// Those that a run has come through.
  void add_confirmed() {
    if (!program_.analysis) return;
    for (const Move& m : program_.analysis->moves) {
      if (m.file != program_.path || m.to_file != program_.path || m.to_line != place_.line || m.label.empty())
        continue;
      const std::optional<Span> span = core_in(program_, m.line, declared_);
      if (span) confirmed_.insert(std::string(word_before(program_.text.text(), span->begin)));
      add(span.value_or(Span{program_.text.run_line_begin(m.line), program_.text.run_line_begin(m.line)}));
    }
  }

  /// Those in lines that no run has come to. A number refers to the label behind a confirmed word alone.
  void add_written() {
    const std::string_view text = program_.text.text();
    const bool number = is_number(core_);
    if (number && confirmed_.empty()) return;
    for (const std::size_t at : places_of(text, core_)) {
      const Token* const token = token_at(map_, at);
      if (token == nullptr || token->kind == TokenKind::comment || !reads_flow(program_, *token)) continue;
      if (number && !confirmed_.contains(std::string(word_before(text, at)))) continue;
      add({at, at + core_.size()});
    }
  }

  void add(const Span& span) {
    if (std::ranges::none_of(out_, [&](const Occurrence& o) { return o.span == span; })) out_.push_back({span, false});
  }

  OpenProgram& program_;
  const ScanMap& map_;
  const NamedPlace& place_;
  Span declared_;
  std::string_view core_;
  std::set<std::string, std::less<>> confirmed_;
  std::vector<Occurrence> out_;
};

std::vector<Occurrence> variable_occurrences(OpenProgram& program, const std::string& name) {
  std::vector<Occurrence> out;
  const ScanMap& map = program.scan_map();
  std::set<std::uint32_t> writes;
  for (const VariableUse& use : program.analysis->variables)
    if (use.is_write && use.name == name && use.file == program.path) writes.insert(use.line);
  for (const std::size_t at : places_of(program.text.text(), name)) {
    const Token* const token = token_at(map, at);
    if (token != nullptr && token->kind == TokenKind::comment) continue;
    const bool is_write = writes.erase(program.text.run_line_of(at)) > 0;
    out.push_back({{at, at + name.size()}, is_write});
  }
  // A line may name its variable by another one: #[100+#1].
  for (const std::uint32_t line : writes) {
    const std::size_t begin = program.text.run_line_begin(line);
    out.push_back({{begin, begin}, true});
  }
  return out;
}

}  // namespace

Span core_of(const TextDocument& text, const NamedPlace& place) {
  const std::string_view all = text.text();
  std::size_t end = place.end;
  while (end > place.begin && !is_name_char(all[end - 1])) --end;
  std::size_t begin = end;
  while (begin > place.begin && is_name_char(all[begin - 1])) --begin;
  std::size_t digits = end;
  while (digits > begin && is_digit_char(all[digits - 1])) --digits;
  return digits == begin + 1 && digits < end ? Span{digits, end} : Span{begin, end};
}

std::optional<NameAt> name_at(OpenProgram& program, std::size_t offset) {
  if (program.setup == nullptr) return std::nullopt;
  const ScanMap& map = program.scan_map();
  const Token* const token = token_at(map, offset);
  if (token != nullptr && token->kind == TokenKind::comment) return std::nullopt;
  if (auto variable = variable_at(program, offset)) return variable;
  const auto label = [&](const NamedPlace& place, Span span) {
    return NameAt{NameAt::Kind::label, place.name, span, &place};
  };
  for (const NamedPlace& place : map.labels)
    if (place.begin <= offset && offset <= place.end) return label(place, core_of(program.text, place));
  const std::uint32_t line = program.text.run_line_of(offset);
  if (program.analysis)
    for (const Move& m : program.analysis->moves)
      if (m.file == program.path && m.line == line && m.to_file == program.path && !m.label.empty())
        for (const NamedPlace& place : map.labels)
          if (place.line == m.to_line && place.name == m.label) {
            const Span core = core_of(program.text, place);
            return label(place, core_in(program, line, core).value_or(core));
          }
  if (token == nullptr || !reads_flow(program, *token)) return std::nullopt;
  for (const NamedPlace& place : map.labels) {
    const Span core = core_of(program.text, place);
    const std::size_t size = core.end - core.begin;
    const std::string_view all = program.text.text();
    for (std::size_t at = offset >= size ? offset - size : 0; at <= offset && size > 0; ++at)
      if (at >= token->begin && stands_at(all, at, all.substr(core.begin, size))) return label(place, {at, at + size});
  }
  return std::nullopt;
}

std::vector<Occurrence> occurrences(OpenProgram& program, const NameAt& name) {
  if (name.kind == NameAt::Kind::variable) return variable_occurrences(program, name.name);
  return LabelReferences(program, *name.place).find();
}

}  // namespace isogloss::editors
