#include "protocol/framing.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

namespace isogloss::editors {

namespace {

/// Gives the text in pieces of at most `step` bytes.
FrameReader reader_of(const std::string& text, std::size_t step, FrameLimits limits = {}) {
  auto at = std::make_shared<std::size_t>(0);
  return FrameReader(
      [=](char* buffer, std::size_t size) {
        const std::size_t n = std::min({step, size, text.size() - *at});
        text.copy(buffer, n, *at);
        *at += n;
        return n;
      },
      limits);
}

std::string body(const std::string& text) {
  return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
}

const BadFrame& bad(const Frame& f) {
  REQUIRE(std::holds_alternative<BadFrame>(f));
  return std::get<BadFrame>(f);
}

}  // namespace

TEST_CASE("messages come out whole, in whatever pieces they arrive") {
  const std::string text = body(R"({"id":1})") + frame(Json{{"text", "Fräsen"}}) + body("[]");
  for (std::size_t step = 1; step < 70; ++step) {
    FrameReader reader = reader_of(text, step);
    CHECK(std::get<Json>(reader.next()) == Json{{"id", 1}});
    CHECK(std::get<Json>(reader.next()) == Json{{"text", "Fräsen"}});
    CHECK(std::get<Json>(reader.next()) == Json::array());
    CHECK_FALSE(std::get<EndOfInput>(reader.next()).inside_message);
  }
}

TEST_CASE("other fields, letter case, blanks and LF alone are read in a header") {
  FrameReader reader = reader_of("content-type: x; charset=utf-8\ncontent-length:   2  \n\n{}", 5);
  CHECK(std::get<Json>(reader.next()) == Json::object());
}

TEST_CASE("a header without a usable Content-Length ends the stream") {
  for (const char* const header :
       {"Content-Type: x\r\n\r\n{}", "Content-Length: two\r\n\r\n{}", "Content-Length: -2\r\n\r\n{}",
        "Content-Length: \r\n\r\n{}", "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}", "G1 X1\n\n",
        "Content-Length: 99999999999999999999999\r\n\r\n"})
    CHECK(bad(reader_of(header, 7).next()).is_fatal);
}

TEST_CASE("a header without an end costs no more than its limit") {
  std::size_t given = 0;
  FrameReader reader(
      [&](char* buffer, std::size_t size) {
        std::fill_n(buffer, size, 'x');
        given += size;
        return size;
      },
      {.header_bytes = 100});
  CHECK(bad(reader.next()).is_fatal);
  CHECK(given <= 65536);
}

TEST_CASE("a body that is too long is skipped, and the next message is read") {
  FrameReader reader = reader_of(body(std::string(1000, ' ')) + body("[1]"), 64, {.body_bytes = 100});
  const Frame first = reader.next();
  CHECK_FALSE(bad(first).is_fatal);
  CHECK(bad(first).why.find("1000 bytes") != std::string::npos);
  CHECK(std::get<Json>(reader.next()) == Json{1});
}

TEST_CASE("a body that is no JSON is one bad frame") {
  for (const std::string& text : {std::string("{"), std::string("\0\1\2", 3), std::string("\xff\xfe"), std::string()}) {
    FrameReader reader = reader_of(body(text) + body("7"), 64);
    CHECK_FALSE(bad(reader.next()).is_fatal);
    CHECK(std::get<Json>(reader.next()) == Json(7));
  }
}

TEST_CASE("JSON that nests too deep is refused before it is parsed") {
  FrameReader reader =
      reader_of(body(std::string(1'000'000, '[')) + body(R"(["[[[[[[[[[[\"[[[["])"), 65536, {.depth = 8});
  CHECK(bad(reader.next()).why.find("deeper than 8") != std::string::npos);
  CHECK(std::holds_alternative<Json>(reader.next()));
}

TEST_CASE("the end inside of a message is told apart from the end between two") {
  CHECK(std::get<EndOfInput>(reader_of("Content-Le", 64).next()).inside_message);
  CHECK(std::get<EndOfInput>(reader_of("Content-Length: 10\r\n\r\n{", 64).next()).inside_message);
  CHECK_FALSE(std::get<EndOfInput>(reader_of("", 64).next()).inside_message);
}

TEST_CASE("text that is no UTF-8 is sent as the replacement character") {
  const std::string bytes = frame(Json{{"text", "a\xff"}});
  FrameReader reader = reader_of(bytes, 64);
  CHECK(std::get<Json>(reader.next())["text"] == "a\xEF\xBF\xBD");
}

TEST_CASE("nothing is written after the client has gone") {
  int calls = 0;
  FrameWriter writer([&](std::string_view) { return ++calls < 2; });
  CHECK(writer.send(Json(1)));
  CHECK_FALSE(writer.send(Json(2)));
  CHECK_FALSE(writer.send(Json(3)));
  CHECK(calls == 2);
}

}  // namespace isogloss::editors
