#include "dialect/xml_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>

namespace isogloss {
namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::size_t skip_blanks(std::string_view text, std::size_t i) {
  while (i < text.size() && is_blank(text[i])) ++i;
  return std::min(i, text.size());
}

/// Bytes of the UTF-8 sequence at `i`; 0: none is there.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(i);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || i + size > text.size()) return 0;
  for (std::size_t k = 1; k < size; ++k) {
    if ((byte(i + k) & 0xc0) != 0x80) return 0;
  }
  // Overlong forms, surrogates, and what lies beyond the last plane.
  const unsigned char second = byte(i + 1);
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) || (first == 0xf0 && second < 0x90) ||
      (first == 0xf4 && second > 0x8f))
    return 0;
  return size;
}

/// The encoding of the XML declaration, in capitals; empty without one.
std::string declared_encoding(std::string_view text) {
  if (!text.starts_with("<?xml")) return {};
  const std::string_view declaration = text.substr(0, text.find("?>"));
  const std::size_t at = declaration.find("encoding");
  if (at == std::string_view::npos) return {};
  const std::size_t open = declaration.find_first_of("'\"", at);
  if (open == std::string_view::npos) return {};
  const std::size_t close = declaration.find(declaration[open], open + 1);
  std::string name(declaration.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
  for (char& c : name) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return name;
}

/// The character reference or predefined entity at `i`, an '&'; 0: none.
std::size_t reference_length(std::string_view text, std::size_t i) {
  constexpr std::size_t longest = 12;
  const std::size_t size = text.substr(i, longest).find(';');
  if (size == std::string_view::npos) return 0;
  std::string_view name = text.substr(i + 1, size - 1);
  if (name == "lt" || name == "gt" || name == "amp" || name == "quot" || name == "apos") return size + 1;
  if (!name.starts_with('#')) return 0;
  name.remove_prefix(1);
  const int base = name.starts_with('x') ? 16 : 10;
  if (base == 16) name.remove_prefix(1);
  std::uint32_t code = 0;
  const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), code, base);
  if (error != std::errc{} || stop != name.data() + name.size()) return 0;
  const bool is_character = code == 9 || code == 10 || code == 13 || (code >= 32 && code < 0xd800) ||
                            (code >= 0xe000 && code <= 0x10ffff && code != 0xfffe && code != 0xffff);
  return is_character ? size + 1 : 0;
}

/// Where a reference that XML does not know begins in text[begin, end).
std::optional<std::size_t> bad_reference(std::string_view text, std::size_t begin, std::size_t end) {
  text = text.substr(0, end);
  for (std::size_t i = text.find('&', begin); i < end; i = text.find('&', i)) {
    const std::size_t size = reference_length(text, i);
    if (size == 0) return i;
    i += size;
  }
  return std::nullopt;
}

struct RawAttribute {
  std::string_view name;
  std::size_t begin, value_begin, value_end;
};

/// The attributes of the start tag whose name begins at `name`, one after the other. The parser has found the tag
/// well-formed.
class RawAttributes {
 public:
  RawAttributes(std::string_view text, std::size_t name) : text_(text), next_(name) {
    while (next_ < text_.size() && !is_blank(text_[next_]) && !is_end(text_[next_])) ++next_;
  }
  std::optional<RawAttribute> next() {
    const std::size_t begin = skip_blanks(text_, next_);
    if (begin >= text_.size() || is_end(text_[begin])) return std::nullopt;
    std::size_t name_end = begin;
    while (name_end < text_.size() && !is_blank(text_[name_end]) && text_[name_end] != '=') ++name_end;
    const std::size_t quote = skip_blanks(text_, std::min(text_.find('=', name_end), text_.size() - 1) + 1);
    if (quote >= text_.size()) return std::nullopt;
    const std::size_t close = std::min(text_.find(text_[quote], quote + 1), text_.size());
    next_ = close + 1;
    return RawAttribute{text_.substr(begin, name_end - begin), begin, quote + 1, close};
  }

 private:
  static bool is_end(char c) { return c == '/' || c == '>'; }

  std::string_view text_;
  std::size_t next_;
};

}  // namespace

std::unique_ptr<XmlSource> XmlSource::open(const std::filesystem::path& file, const Location& asked_at,
                                           XmlBudget& budget, DiagnosticSink& sink, Pipes pipes) {
  std::error_code error;
  if (budget.unsaved != nullptr && !budget.unsaved->empty())
    if (const auto found = budget.unsaved->find(std::filesystem::weakly_canonical(file, error).string());
        found != budget.unsaved->end())
      return parse(file.string(), found->second, sink);
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  const bool is_pipe = std::filesystem::is_fifo(status) && pipes == Pipes::read;
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) && !is_pipe) {
    const char* const what = std::filesystem::is_directory(status) ? "it is a folder" : "it is not a regular file";
    sink.add(host_diagnostic("IG-0102", asked_at, {file.string(), what}));
    return nullptr;
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    sink.add(host_diagnostic("IG-0102", asked_at, {file.string(), std::strerror(errno)}));
    return nullptr;
  }
  const std::size_t limit = std::min(XmlBudget::file_bytes, budget.bytes_left);
  std::string text;
  // The first piece is one byte longer than the file, so that its end is found with it: unused memory costs time.
  constexpr std::size_t usual_piece = std::size_t{1} << 16;
  const std::uintmax_t file_size = is_pipe ? usual_piece : std::filesystem::file_size(file, error);
  auto piece = static_cast<std::size_t>(std::min<std::uintmax_t>(file_size, usual_piece - 1) + 1);
  while (in && text.size() <= limit) {
    const std::size_t size = text.size();
    text.resize(size + piece);
    in.read(text.data() + size, static_cast<std::streamsize>(piece));
    text.resize(size + static_cast<std::size_t>(in.gcount()));
    piece = usual_piece;  // of a file that grows, or does not tell its size
  }
  if (text.size() > limit) {
    sink.add(host_diagnostic("IG-0105", asked_at, {file.string(), fmt::format("{} bytes", limit)}));
    return nullptr;
  }
  budget.bytes_left -= text.size();
  return parse(file.string(), std::move(text), sink);
}

/// Both tags of a mismatch: `offset` is in the name of the end tag.
std::string XmlSource::mismatch(const XmlSource& source, std::string_view text, std::size_t offset) {
  const auto name_at = [&](std::size_t at) {
    return std::string(text.substr(at, std::min(text.find_first_of(" \t\r\n/>", at), text.size()) - at));
  };
  std::size_t end_tag = std::min(text.rfind("</", offset), text.size());
  std::vector<std::size_t> open;
  for (std::size_t at = 0; (at = text.find('<', at)) < end_tag; ++at) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = std::min(text.find("-->", at), end_tag);
    } else if (text.compare(at, 2, "</") == 0) {
      if (!open.empty()) open.pop_back();
    } else if (text[at + 1] != '?' && text[at + 1] != '!') {
      const std::size_t begin = at;
      for (char quote = '\0'; at < end_tag && (quote != '\0' || text[at] != '>'); ++at)
        if (quote == '\0' ? text[at] == '"' || text[at] == '\'' : text[at] == quote)
          quote = quote == '\0' ? text[at] : '\0';
      if (text[at - 1] != '/') open.push_back(begin);
    }
  }
  if (end_tag == text.size() || open.empty()) return "an end tag without its start tag";
  return fmt::format("</{}> stands where <{}> of line {} is open", name_at(end_tag + 2), name_at(open.back() + 1),
                     source.at_offset(open.back()).line);
}

std::unique_ptr<XmlSource> XmlSource::parse(std::string file, std::string text, DiagnosticSink& sink) {
  std::unique_ptr<XmlSource> source(new XmlSource(std::move(file), std::move(text)));
  if (!source->check_text(sink)) return nullptr;
  // Parsed as a fragment, so that content outside the root is found too.
  const unsigned options = pugi::parse_default | pugi::parse_doctype | pugi::parse_fragment;
  const pugi::xml_parse_result result =
      source->document_.load_buffer(source->text_.data(), source->text_.size(), options, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    sink.add(
        host_diagnostic("IG-0103", source->at_offset(offset),
                        {result.status == pugi::status_end_element_mismatch ? mismatch(*source, source->text_, offset)
                                                                            : std::string(result.description())}));
    return nullptr;
  }
  if (!source->check_nodes(sink)) return nullptr;
  return source;
}

XmlSource::XmlSource(std::string file, std::string text) : file_(std::move(file)), text_(std::move(text)) {
  if (text_.starts_with("\xef\xbb\xbf")) text_.erase(0, 3);
  lines_.push_back(0);
  if (text_.find('\r') == std::string::npos) {
    for (std::size_t end = 0; (end = text_.find('\n', end)) != std::string::npos;) lines_.push_back(++end);
    return;
  }
  for (std::size_t i = 0; i < text_.size(); ++i) {
    const bool lone_return = text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n');
    if (text_[i] == '\n' || lone_return) lines_.push_back(i + 1);
  }
}

Location XmlSource::at_offset(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const auto line = std::upper_bound(lines_.begin(), lines_.end(), offset) - 1;
  return {file_, static_cast<std::uint32_t>(line - lines_.begin() + 1), static_cast<std::uint32_t>(offset - *line + 1)};
}

Location XmlSource::at(pugi::xml_node node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  if (offset < 0) return at_offset(0);
  const auto begin = static_cast<std::size_t>(offset);
  return at_offset(node.type() == pugi::node_element ? begin - 1 : skip_blanks(text_, begin));
}

Location XmlSource::at(pugi::xml_node element, std::string_view attribute) const {
  RawAttributes attributes(text_, static_cast<std::size_t>(element.offset_debug()));
  while (const std::optional<RawAttribute> raw = attributes.next()) {
    if (raw->name == attribute) return at_offset(raw->begin);
  }
  return at(element);
}

bool XmlSource::check_text(DiagnosticSink& sink) const {
  const auto fault = [&](std::size_t offset, const std::string& what) {
    sink.add(host_diagnostic("IG-0104", at_offset(offset), {what}, "save the file as UTF-8"));
    return false;
  };
  if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) return fault(0, "UTF-16");
  const std::string encoding = declared_encoding(text_);
  if (!encoding.empty() && encoding != "UTF-8" && encoding != "US-ASCII" && encoding != "ASCII")
    return fault(text_.find("encoding"), encoding);
  for (std::size_t i = 0; i < text_.size();) {
    const auto byte = static_cast<unsigned char>(text_[i]);
    if (byte >= 0x20 && byte < 0x80) {  // most of a file
      ++i;
      continue;
    }
    const std::size_t size = utf8_length(text_, i);
    if (size == 0) return fault(i, fmt::format("a file with the byte 0x{:02X}", byte));
    if (byte < 0x20 && !is_blank(text_[i])) {
      sink.add(host_diagnostic("IG-0103", at_offset(i), {fmt::format("the control character 0x{:02X}", byte)}));
      return false;
    }
    i += size;
  }
  return true;
}

bool XmlSource::check_nodes(DiagnosticSink& sink) const {
  const auto fault = [&](pugi::xml_node node, const char* what) {
    sink.add(host_diagnostic("IG-0103", at(node), {what}));
    return false;
  };
  bool has_root = false;
  for (const pugi::xml_node node : document_.children()) {
    if (node.type() == pugi::node_doctype) {
      sink.add(host_diagnostic("IG-0103", at_offset(text_.find("<!DOCTYPE")), {"a document type is not accepted"}));
      return false;
    }
    if (node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata)
      return fault(node, "text outside the root element");
    if (node.type() != pugi::node_element) continue;
    if (has_root) return fault(node, "a second root element");
    has_root = true;
  }
  if (!has_root) {
    sink.add(host_diagnostic("IG-0103", at_offset(text_.size()), {"no root element"},
                             "is it the file that was meant? isogloss new dialect NAME writes a whole one"));
    return false;
  }
  // Without recursion: the file chooses the depth.
  int depth = 1;
  for (pugi::xml_node node = root(); node;) {
    if (depth > XmlBudget::depth) {
      sink.add(host_diagnostic("IG-0105", at(node), {"the nesting", fmt::format("{} elements", XmlBudget::depth)}));
      return false;
    }
    if (node.type() == pugi::node_element && !check_tag(node, sink)) return false;
    if (node.first_child()) {
      node = node.first_child();
      ++depth;
      continue;
    }
    while (node != root() && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    if (node == root()) return true;
    node = node.next_sibling();
  }
  return true;
}

bool XmlSource::check_tag(pugi::xml_node element, DiagnosticSink& sink) const {
  std::set<std::string_view> names;
  std::vector<RawAttribute> attributes;
  RawAttributes in_text(text_, static_cast<std::size_t>(element.offset_debug()));
  while (const std::optional<RawAttribute> raw = in_text.next()) attributes.push_back(*raw);
  if (attributes.size() > XmlBudget::attributes) {
    const std::string limit = fmt::format("{} attributes", XmlBudget::attributes);
    sink.add(host_diagnostic("IG-0105", at(element), {"the element", limit}));
    return false;
  }
  for (const RawAttribute& raw : attributes) {
    std::string what;
    std::size_t offset = raw.begin;
    if (!names.insert(raw.name).second) what = fmt::format("attribute '{}' stands twice", raw.name);
    if (const auto bad = bad_reference(text_, raw.value_begin, raw.value_end)) {
      offset = *bad;
      what = "'&' begins no character reference that is known";
    }
    const std::size_t less = text_.find('<', raw.value_begin);
    if (less < raw.value_end) {
      offset = less;
      what = "'<' in an attribute's value";
    }
    if (what.empty()) continue;
    sink.add(host_diagnostic("IG-0103", at_offset(offset), {what}));
    return false;
  }
  return true;
}

}  // namespace isogloss
