/// The motions of some blocks, for tests of what an exporter writes.
#pragma once

#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "test_document.hpp"

namespace isogloss::test {

using Json = nlohmann::ordered_json;

/// The stream of some blocks, filled one after the other.
class Stream {
 public:
  explicit Stream(MotionOptions options) : exporter_(make_motion_exporter(output_, options)) {}
  Stream(MotionOptions options, const std::function<void(TestDocument&)>& initial) : Stream(options) {
    initial(t);
    begin();
  }

  void begin() {
    exporter_->begin(t.d, t.symbols);
    begun_ = true;
  }
  template <class Fill>
  void block(std::uint32_t line, Fill fill) {
    if (!begun_) begin();
    t.block(line);
    fill();
    CHECK(exporter_->block(t.d, t.symbols));
  }
  std::string text() {
    CHECK(exporter_->end());
    return output_.text;
  }
  std::vector<Json> events() {
    std::vector<Json> all;
    std::istringstream lines(text());
    for (std::string line; std::getline(lines, line);) all.push_back(Json::parse(line));
    return all;
  }
  std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Json& e : events()) all.push_back(e["Event"]);
    return all;
  }

  TestDocument t;

 private:
  StringOutput output_;
  std::unique_ptr<Exporter> exporter_;
  bool begun_ = false;
};

using EventNames = std::vector<std::string>;

}  // namespace isogloss::test
