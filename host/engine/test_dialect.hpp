/// A dialect put together by hand for a test, and what is reported while it is linked and run.
#pragma once

#include <catch2/catch.hpp>

#include "isogloss/engine/chain.hpp"
#include "test_plugin.hpp"

namespace isogloss::test {

/// A dialect put together by hand. Each element stands on a line of its own, in the order in which it is added.
struct Hand {
  Dialect dialect;
  std::uint32_t line = 0;

  explicit Hand(std::initializer_list<const char*> plugins) {
    dialect.name = "hand";
    dialect.file = "hand.xml";
    for (const char* name : plugins) dialect.plugins.push_back({name, next()});
  }
  Location next() { return {"hand.xml", ++line, 7}; }
  ChainElement& add(const char* syntax, std::vector<std::pair<const char*, const char*>> options = {},
                    Stage stage = Stage::logic) {
    ChainElement element{stage, syntax, syntax, {}, false, next()};
    for (const auto& [name, value] : options) element.options.push_back({name, value, next()});
    return dialect.chain.emplace_back(std::move(element));
  }
  DependencyElement& depend(const char* id) {
    return dialect.dependencies.emplace_back(DependencyElement{id, id, {}, {}, {}, next()});
  }
  void initial(const char* path, const char* value) { dialect.initial.push_back({path, value, next()}); }
};

/// "code line" of each diagnostic, in order.
inline std::vector<std::string> faults(Hand& hand, std::initializer_list<Plugin*> plugins,
                                       DiagnosticList* kept = nullptr) {
  Library library({});
  for (Plugin* plugin : plugins) library.add(plugin->get());
  DiagnosticList found;
  const auto linked = link(hand.dialect, library, found);
  CHECK((linked == nullptr) == found.has_errors());
  std::vector<std::string> all;
  for (const Diagnostic& d : found.all) {
    CHECK(d.where.file == "hand.xml");
    all.push_back(d.code + " " + std::to_string(d.where.line));
  }
  if (kept != nullptr) *kept = found;
  return all;
}

/// What is said when the chain runs one empty block.
inline DiagnosticList run_one_block(Hand& hand, Plugin& plugin) {
  DiagnosticList found;
  Library library({});
  library.add(plugin.get());
  const auto linked = link(hand.dialect, library, found);
  REQUIRE(linked != nullptr);
  Chain chain(*linked, {}, found);
  chain.start();
  chain.begin_block({"part.nc", 1, 0, ""});
  chain.run(chain.document(), 0, static_cast<std::uint32_t>(linked->chain.size()));
  return found;
}

using Strings = std::vector<std::string>;

}  // namespace isogloss::test
