#include "protocol/framing.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string>

namespace isogloss::editors {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, small, small);
}

/// The value of Content-Length; empty, with a sentence in `why`, when the header is none.
std::optional<std::size_t> content_length(std::string_view header, std::string& why) {
  std::optional<std::size_t> length;
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    std::string_view line = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) {
      why = "a line of the header has no colon: the stream holds no messages with Content-Length";
      return std::nullopt;
    }
    if (!equals_ignoring_case(trimmed(line.substr(0, colon)), "Content-Length")) continue;
    const std::string_view digits = trimmed(line.substr(colon + 1));
    std::size_t value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (digits.empty() || error != std::errc() || stop != digits.data() + digits.size() || length) {
      why = "the header needs one Content-Length with a number of bytes";
      return std::nullopt;
    }
    length = value;
  }
  if (!length) why = "the header has no Content-Length";
  return length;
}

/// Stops the parser where the JSON becomes too deep.
class DepthGuard {
 public:
  explicit DepthGuard(std::size_t depth) : depth_(depth) {}
  bool is_too_deep(std::string_view text) const {
    std::size_t depth = 0;
    bool in_text = false, escaped = false;
    for (const char c : text) {
      if (in_text) {
        if (!escaped && c == '"') in_text = false;
        escaped = !escaped && c == '\\';
      } else if (c == '"') {
        in_text = true;
      } else if (c == '[' || c == '{') {
        if (++depth > depth_) return true;
      } else if ((c == ']' || c == '}') && depth > 0) {
        --depth;
      }
    }
    return false;
  }

 private:
  std::size_t depth_;
};

}  // namespace

std::variant<Json, std::string> parse_json(std::string_view text, std::size_t depth) {
  if (DepthGuard(depth).is_too_deep(text))
    return "the JSON nests deeper than " + std::to_string(depth) + " arrays and objects";
  try {
    return Json::parse(text);
  } catch (const Json::exception& e) {
    return std::string("the body is not JSON: ") + e.what();
  }
}

bool FrameReader::fill() {
  constexpr std::size_t chunk = 65536;
  if (begin_ > 0) {
    buffer_.erase(0, begin_);
    begin_ = 0;
  }
  const std::size_t size = buffer_.size();
  buffer_.resize(size + chunk);
  const std::size_t n = read_(buffer_.data() + size, chunk);
  buffer_.resize(size + n);
  return n > 0;
}

void FrameReader::drop(std::size_t bytes) {
  begin_ += bytes;
  if (begin_ < buffer_.size()) return;
  buffer_.clear();
  begin_ = 0;
}

bool FrameReader::find_header_end(std::size_t& end) {
  const std::string_view text = std::string_view(buffer_).substr(begin_);
  // Some clients end their lines with LF alone.
  const std::size_t crlf = text.find("\r\n\r\n"), lf = text.find("\n\n");
  if (crlf == std::string_view::npos && lf == std::string_view::npos) return false;
  end = crlf < lf ? crlf + 4 : lf + 2;
  return true;
}

bool FrameReader::skip(std::size_t bytes) {
  while (bytes > 0) {
    const std::size_t there = std::min(bytes, buffer_.size() - begin_);
    drop(there);
    bytes -= there;
    if (bytes > 0 && !fill()) return false;
  }
  return true;
}

Frame FrameReader::next() {
  std::size_t end = 0;
  while (!find_header_end(end)) {
    if (buffer_.size() - begin_ > limits_.header_bytes)
      return BadFrame{"the header is longer than " + std::to_string(limits_.header_bytes) + " bytes", true};
    if (!fill()) return EndOfInput{begin_ < buffer_.size()};
  }
  if (end > limits_.header_bytes + 4)
    return BadFrame{"the header is longer than " + std::to_string(limits_.header_bytes) + " bytes", true};
  std::string_view header = std::string_view(buffer_).substr(begin_, end);
  while (header.ends_with('\n') || header.ends_with('\r')) header.remove_suffix(1);
  std::string why;
  const std::optional<std::size_t> length = content_length(header, why);
  if (!length) return BadFrame{why, true};
  drop(end);
  if (*length > limits_.body_bytes) {
    if (!skip(*length)) return EndOfInput{true};
    return BadFrame{"the message has " + std::to_string(*length) + " bytes, more than the " +
                        std::to_string(limits_.body_bytes) + " that are read",
                    false};
  }
  while (buffer_.size() - begin_ < *length)
    if (!fill()) return EndOfInput{true};
  auto parsed = parse_json(std::string_view(buffer_).substr(begin_, *length), limits_.depth);
  drop(*length);
  if (auto* const sentence = std::get_if<std::string>(&parsed)) return BadFrame{std::move(*sentence), false};
  return std::get<Json>(std::move(parsed));
}

std::string frame(const Json& message) {
  const std::string body = message.dump(-1, ' ', false, Json::error_handler_t::replace);
  return "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

bool FrameWriter::send(const Json& message) {
  const std::string bytes = frame(message);
  const std::lock_guard lock(mutex_);
  if (!is_gone_ && !write_(bytes)) is_gone_ = true;
  return !is_gone_;
}

FrameReader::Read read_from(int descriptor) {
  return [descriptor](char* buffer, std::size_t size) -> std::size_t {
    ssize_t n = 0;
    do n = ::read(descriptor, buffer, size);
    while (n < 0 && errno == EINTR);
    return n < 0 ? 0 : static_cast<std::size_t>(n);
  };
}

FrameWriter::Write write_to(int descriptor) {
  return [descriptor](std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  };
}

}  // namespace isogloss::editors
