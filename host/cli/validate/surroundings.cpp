// What is around the plugin: the cases of its pages, options, services, and hosts of other versions.
#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// A value for an option that has no default.
std::string any_value(const ig_option_decl& o) {
  switch (o.type) {
    case IG_OPTION_NUMBER:
    case IG_OPTION_INTEGER: return fmt::format("{}", std::isfinite(o.minimum) ? o.minimum : std::fmin(o.maximum, 1));
    case IG_OPTION_BOOLEAN: return "true";
    case IG_OPTION_CHOICE: return std::string(o.choices).substr(0, std::string_view(o.choices).find('|'));
    case IG_OPTION_FIELDS: return "Parsing.X";
    default: return "A";
  }
}

/// In the form of dialect files, which knows no exponent.
std::string number_text(double number) {
  std::string out = fmt::format("{:.17f}", number);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.ends_with('.')) out.pop_back();
  return out;
}

struct Candidate {
  std::string value;
  bool is_allowed = true;       ///< by the declaration
  bool may_be_refused = false;  ///< by create(): the declaration cannot say which texts mean something
};

std::vector<Candidate> candidates(const ig_option_decl& o) {
  std::vector<Candidate> out;
  switch (o.type) {
    case IG_OPTION_NUMBER:
    case IG_OPTION_INTEGER:
      if (std::isfinite(o.minimum)) {
        out.push_back({number_text(o.minimum)});
        out.push_back({number_text(o.minimum - 1), false});
      }
      if (std::isfinite(o.maximum)) {
        out.push_back({number_text(o.maximum)});
        out.push_back({number_text(o.maximum + 1), false});
      }
      out.push_back({"a word", false});
      break;
    case IG_OPTION_BOOLEAN: out = {{"true"}, {"false"}, {"perhaps", false}}; break;
    case IG_OPTION_CHOICE:
      for (std::string_view rest = o.choices; !rest.empty();) {
        const std::size_t end = std::min(rest.find('|'), rest.size());
        out.push_back({std::string(rest.substr(0, end))});
        rest.remove_prefix(std::min(end + 1, rest.size()));
      }
      out.push_back({"no such choice", false});
      break;
    case IG_OPTION_FIELDS: out = {{"", true, true}, {"Parsing.X Parsing.**", true, true}}; break;
    default: out = {{"", true, true}, {"A", true, true}, {std::string(60'000, 'A'), true, true}};
  }
  return out;
}

/// The XML that gives one option a value, and each other option that needs one.
std::string element(const ig_syntax& syntax, const ig_option_decl* option, const std::string& value) {
  std::string out = "<" + std::string(syntax.id);
  for (std::uint32_t i = 0; i < syntax.option_count; ++i) {
    const ig_option_decl& o = syntax.options[i];
    if (&o != option && o.fallback != nullptr) continue;
    out += fmt::format(" {}=\"{}\"", o.name, &o == option ? value : any_value(o));
  }
  return out + "/>";
}

std::vector<TestBlock> blocks_for(const LinkedAlone& alone) {
  return {{.name = "an empty block"}, full_block(alone, fields_of(alone))};
}

void run_blocks(Examination& e, const LinkedAlone& alone, const ChainSettings& settings,
                const std::vector<TestBlock>& blocks, const std::string& where) {
  Bench bench(alone, settings);
  for (const TestBlock& block : blocks) {
    e.attempt(where + ", " + block.name);
    if (const std::string fault = bench.run(block, false).fault(); !fault.empty())
      e.find(where + ", " + block.name, fault);
  }
}

void check_option(Examination& e, Subject& subject, const ig_syntax& syntax, const ig_option_decl& option) {
  for (const Candidate& c : candidates(option)) {
    const std::string shown = c.value.size() > 40 ? fmt::format("a text of {} bytes", c.value.size()) : c.value;
    const std::string where = fmt::format("{}, {}=\"{}\"", syntax.id, option.name, shown);
    e.attempt(where);
    DiagnosticList said;
    const LinkedAlone alone = link_alone(syntax, subject.plugin(), subject.surroundings(),
                                         element(syntax, &option, c.value), subject.library(), said);
    if (!c.is_allowed) {
      if (alone.linked != nullptr) e.find(where, "the value lies outside of the declaration and is accepted");
      continue;
    }
    if (alone.linked == nullptr) {
      if (!c.may_be_refused) e.find(where, said.all.empty() ? "it does not link" : said.all.back().message);
      continue;
    }
    const ChainSettings settings = in_mode(Mode::checked);
    const std::string fault = creation_fault(alone, settings);
    if (fault.empty())
      run_blocks(e, alone, settings, blocks_for(alone), where);
    else if (!c.may_be_refused)
      e.find(where, fault);
  }
}

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

void check_options(Examination& e) {
  Subject subject(e);
  subject.add_own_dependencies();
  for (const ig_syntax* syntax : subject.syntaxes()) {
    e.attempt(syntax->id);
    DiagnosticList said;
    const LinkedAlone alone = link_alone(*syntax, subject.plugin(), subject.surroundings(),
                                         element(*syntax, nullptr, ""), subject.library(), said);
    if (alone.linked == nullptr) {
      e.find(syntax->id,
             "it does not link with its default options" + (said.all.empty() ? "" : ": " + said.all.back().message));
      continue;
    }
    if (const std::string fault = creation_fault(alone, {}); !fault.empty()) {
      e.find(syntax->id, "it is not created with its default options: " + fault);
      continue;
    }
    for (std::uint32_t i = 0; i < syntax->option_count; ++i) check_option(e, subject, *syntax, syntax->options[i]);
  }
}

void check_without_services(Examination& e) {
  Subject subject(e);
  subject.remove_services();
  for (const ig_syntax* syntax : subject.syntaxes()) {
    if (requires_service(*syntax)) continue;  // linking refuses it before create()
    const std::string where = std::string(syntax->id) + " without services";
    e.attempt(where);
    DiagnosticList said;
    const LinkedAlone alone = link_alone(*syntax, subject.plugin(), subject.surroundings(),
                                         element(*syntax, nullptr, ""), subject.library(), said);
    if (alone.linked == nullptr) {
      e.find(where, said.all.empty() ? "it does not link" : said.all.back().message);
      continue;
    }
    const ChainSettings settings = in_mode(Mode::checked);
    if (const std::string fault = creation_fault(alone, settings); !fault.empty())
      e.find(where, fault + "; declare the service as required, or work without it");
    else
      run_blocks(e, alone, settings, blocks_for(alone), where);
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
