/// Messages of editors: a header with Content-Length, an empty line, and a body of JSON, as the language server
/// protocol and the debug adapter protocol have them.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <variant>

namespace isogloss::editors {

using Json = nlohmann::json;

/// What a client may send: more than that is an error and costs no memory.
struct FrameLimits {
  std::size_t header_bytes = 4096;
  std::size_t body_bytes = std::size_t{256} << 20;
  /// Of arrays and objects within each other: deeper JSON would exhaust the stack.
  std::size_t depth = 256;
};

/// The stream has ended.
struct EndOfInput {
  bool inside_message = false;  ///< in the middle of a header or a body
};

/// A frame that holds no message. The reader continues with the next frame where `is_fatal` is false; otherwise nothing
/// tells where the next one begins.
struct BadFrame {
  std::string why;  ///< a whole sentence
  bool is_fatal = false;
};

using Frame = std::variant<Json, EndOfInput, BadFrame>;

/// JSON of at most this depth, or a sentence that says what is wrong.
std::variant<Json, std::string> parse_json(std::string_view text, std::size_t depth);

/// Cuts a stream of bytes into messages. One thread at a time.
class FrameReader {
 public:
  /// Up to `size` bytes; 0 at the end. May block, and is called only while a message is incomplete.
  using Read = std::function<std::size_t(char* buffer, std::size_t size)>;

  explicit FrameReader(Read read, FrameLimits limits = {}) : read_(std::move(read)), limits_(limits) {}
  /// The next message; blocks until it is there.
  Frame next();

 private:
  bool fill();
  bool find_header_end(std::size_t& end);
  bool skip(std::size_t bytes);
  void drop(std::size_t bytes);

  Read read_;
  FrameLimits limits_;
  std::string buffer_;
  std::size_t begin_ = 0;
};

/// Header and body of a message. Bytes that are no UTF-8 become U+FFFD.
std::string frame(const Json& message);

/// Writes whole messages; any thread may call it.
class FrameWriter {
 public:
  /// Takes all bytes, or returns false when the reader is gone.
  using Write = std::function<bool(std::string_view bytes)>;

  explicit FrameWriter(Write write) : write_(std::move(write)) {}
  /// False: the client is gone, and nothing will be written any more.
  bool send(const Json& message);

 private:
  Write write_;
  std::mutex mutex_;
  bool is_gone_ = false;
};

/// Both ends on file descriptors, which stay the caller's. A signal does not interrupt a call.
FrameReader::Read read_from(int descriptor);
FrameWriter::Write write_to(int descriptor);

}  // namespace isogloss::editors
