// What is around the plugin: the cases of its pages, and hosts of other versions.
#include <fmt/format.h>

#include <cstddef>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// The functions of a host, and what another version would give in their place.
struct OtherHost {
  struct Host {
    ig_host known;
    void (*more[16])();
  } host{isogloss::host_table(Mode::fast), {}};
  struct Link {
    ig_link_api known;
    void (*more[16])();
  } link{isogloss::link_api(), {}};

  ChainSettings settings() const {
    ChainSettings out;
    out.host = &host.known;
    out.link_api = &link.known;
    return out;
  }
};

/// The chain gives what it gives with this host, and a crash names the block.
void compare_with(Examination& e, const OtherHost& other, const std::string& version) {
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const std::string id = stand.syntax->id;
    e.attempt(id + " with " + version);
    if (const std::string fault = creation_fault(stand.alone, other.settings()); !fault.empty()) {
      const bool is_old = other.link.known.host_minor < IG_ABI_MINOR;
      const bool has_reason = fault.find("gives no reason") == std::string::npos;
      // Who needs a function that an old host lacks may refuse it.
      if (is_old && has_reason) continue;
      e.find(id, "it is not created with " + version + ": " + fault);
      continue;
    }
    Bench here(stand.alone, {}), there(stand.alone, other.settings());
    for (const TestBlock& block : stand.blocks) {
      e.attempt(id + ", " + block.name + ", with " + version + "; look at struct_size and host_minor before a call");
      if (here.run(block).shown != there.run(block).shown)
        e.find(id + ", " + block.name, "the result with " + version + " is another one");
    }
  }
}

}  // namespace

void check_cases(Examination& e) {
  Subject subject(e);
  DiagnosticList said;
  for (const PageText& text : pages_of(subject, e.options)) {
    const Page page = read_page(text.text, text.name, said);
    for (const Case& one : page.cases) {
      const std::string where = fmt::format("{}:{}: {}", text.name, one.line, one.heading);
      e.attempt(where);
      if (!one.file && (!one.before || !one.after)) continue;  // malformed, which `documented` tells
      std::string difference = run_case(page, one, text.name, subject.surroundings(), subject.library());
      if (!difference.empty()) e.find(where, "the case does not hold:\n" + difference);
    }
  }
}

void check_older_host(Examination& e) {
  OtherHost other;
  other.host.known.struct_size = offsetof(ig_host, get_point);
  other.host.known.flags = 0;
  other.host.known.get_point = nullptr;
  other.host.known.take_point = nullptr;
  other.host.known.set_point = nullptr;
  other.host.known.fresh_point = nullptr;
  other.host.known.in_turn = nullptr;
  other.host.known.append_many = nullptr;
  other.link.known.struct_size = offsetof(ig_link_api, set_text_value);
  other.link.known.host_minor = 0;
  other.link.known.set_text_value = nullptr;
  compare_with(e, other, "a host of minor version 0");
}

void check_newer_host(Examination& e) {
  constexpr std::uint32_t unknown_flag = 1u << 31;
  OtherHost other;
  other.host.known.struct_size = sizeof(OtherHost::Host);
  other.host.known.flags |= unknown_flag;
  other.link.known.struct_size = sizeof(OtherHost::Link);
  other.link.known.host_minor = IG_ABI_MINOR + 1;
  compare_with(e, other, "a host of minor version " + std::to_string(IG_ABI_MINOR + 1));
}

}  // namespace isogloss::cli
