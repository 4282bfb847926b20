/// Reads JSON into values that keep their places in the text.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tables {

struct JsonMember;

struct JsonValue {
  enum class Kind { nothing, number, text, list, object };

  Kind kind = Kind::nothing;  // of null, true and false too
  double number = 0;
  std::string text;
  std::vector<JsonMember> members;
  std::size_t begin = 0, end = 0;  // bytes of the file

  inline const JsonValue* find(std::string_view name) const;
  bool is(Kind k) const { return kind == k; }
};

struct JsonMember {
  std::string name;  // empty in a list
  JsonValue value;
};

const JsonValue* JsonValue::find(std::string_view name) const {
  for (const JsonMember& member : members)
    if (kind == Kind::object && member.name == name) return &member.value;
  return nullptr;
}

class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}

  /// Nothing where the text is no JSON or too large; place() then is where that shows.
  std::optional<JsonValue> read() {
    JsonValue out;
    if (!read_value(out, 0)) return std::nullopt;
    skip_blanks();
    return at_ == text_.size() ? std::optional(std::move(out)) : std::nullopt;
  }
  std::size_t place() const { return at_; }

 private:
  static constexpr unsigned deepest = 64;
  static constexpr std::size_t most_values = 2'000'000;  // each needs a hundred bytes or two

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  bool skip(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  bool read_value(JsonValue& out, unsigned depth) {
    skip_blanks();
    out.begin = at_;
    if (at_ == text_.size() || depth > deepest || ++count_ > most_values) return false;
    const char c = text_[at_];
    bool is_read = false;
    if (c == '{' || c == '[')
      is_read = read_members(out, depth);
    else if (c == '"')
      is_read = read_text(out);
    else
      is_read = read_number(out) || read_word();
    out.end = at_;
    return is_read;
  }

  bool read_members(JsonValue& out, unsigned depth) {
    const bool is_object = text_[at_++] == '{';
    out.kind = is_object ? JsonValue::Kind::object : JsonValue::Kind::list;
    const char close = is_object ? '}' : ']';
    if (skip(close)) return true;
    do {
      JsonValue name, value;
      if (is_object && !(read_value(name, depth + 1) && name.is(JsonValue::Kind::text) && skip(':'))) return false;
      if (!read_value(value, depth + 1)) return false;
      out.members.push_back({std::move(name.text), std::move(value)});
    } while (skip(','));
    return skip(close);
  }

  bool read_number(JsonValue& out) {
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, out.number);
    if (error != std::errc{} || !std::isfinite(out.number)) return false;
    at_ = static_cast<std::size_t>(stop - text_.data());
    out.kind = JsonValue::Kind::number;
    return true;
  }
  bool read_word() {
    for (const std::string_view word : {"null", "true", "false"})
      if (text_.substr(at_).starts_with(word)) {
        at_ += word.size();
        return true;
      }
    return false;
  }

  bool read_text(JsonValue& out) {
    out.kind = JsonValue::Kind::text;
    ++at_;
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"') return true;
      if (c != '\\')
        out.text += c;
      else if (!read_escape(out.text))
        return false;
    }
    return false;
  }
  bool read_escape(std::string& out) {
    if (at_ == text_.size()) return false;
    const char c = text_[at_++];
    constexpr std::string_view letters = "bfnrt", meanings = "\b\f\n\r\t";
    if (const std::size_t i = letters.find(c); i != std::string_view::npos) {
      out += meanings[i];
    } else if (c != 'u') {
      out += c;
    } else {
      std::uint32_t code = 0;
      if (!read_unit(code)) return false;
      std::uint32_t low = 0;
      if (code >= 0xd800 && code < 0xdc00 && text_.substr(at_).starts_with("\\u")) {
        at_ += 2;
        if (!read_unit(low)) return false;
        code = low >= 0xdc00 && low < 0xe000 ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : unknown;
      }
      append(out, code >= 0xd800 && code < 0xe000 ? unknown : code);
    }
    return true;
  }
  bool read_unit(std::uint32_t& code) {
    const std::string_view digits = text_.substr(at_, 4);
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    at_ += digits.size();
    return error == std::errc{} && digits.size() == 4 && stop == digits.data() + 4;
  }
  static void append(std::string& out, std::uint32_t c) {
    const auto put = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
    if (c < 0x80) return put(c);
    if (c < 0x800) put(0xc0 | c >> 6);
    if (c >= 0x800 && c < 0x10000) put(0xe0 | c >> 12);
    if (c >= 0x10000) {
      put(0xf0 | c >> 18);
      put(0x80 | (c >> 12 & 0x3f));
    }
    if (c >= 0x800) put(0x80 | (c >> 6 & 0x3f));
    put(0x80 | (c & 0x3f));
  }

  static constexpr std::uint32_t unknown = 0xfffd;
  std::string_view text_;
  std::size_t at_ = 0, count_ = 0;
};

}  // namespace tables
