// What a dialect gives to a syntax: options and services.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <random>

#include "markup.hpp"
#include "validate/guarded_texts.hpp"
#include "validate/option_values.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

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

/// Blocks for one set of options: with and without words, a text, random values, and the cases of the page.
class OptionBlocks {
 public:
  OptionBlocks(const std::vector<Stand>& stands, const ig_syntax& syntax, std::uint64_t seed) : seed_(seed) {
    constexpr std::size_t most_cases = 6;
    for (const Stand& stand : stands)
      for (const TestBlock& block : stand.blocks)
        if (stand.syntax == &syntax && !block.before.is_null() && cases_.size() < most_cases) cases_.push_back(block);
  }
  std::vector<TestBlock> blocks_for(const ig_syntax& syntax, LinkedAlone& alone) const {
    constexpr std::uint64_t random_ones = 6;
    const std::vector<ig_field> fields = fields_of(alone);
    std::vector<TestBlock> out{{.name = "an empty block"}, full_block(alone, fields)};
    out.push_back({.name = "a block of text alone", .text = "(A) N10 G01 X1. ; #1=2"});
    Stand stand{&syntax, {}, std::move(alone), {}};
    for (std::uint64_t k = 0; k < random_ones; ++k) {
      out.push_back(random_block(stand, fields, seed_, k));
      if (out.back().text.empty()) out.back().text = "/1 N5 (B) X-1";
    }
    alone = std::move(stand.alone);
    out.insert(out.end(), cases_.begin(), cases_.end());
    return out;
  }

 private:
  std::uint64_t seed_;
  std::vector<TestBlock> cases_;
};

/// Option texts with nothing behind them, for the creation under way.
thread_local GuardedTexts* option_texts = nullptr;

ig_link_api guarding_api() {
  ig_link_api out = link_api();
  out.option_text = [](ig_link* link, std::uint32_t option) {
    return option_texts->copy(link_api().option_text(link, option));
  };
  return out;
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

void check_option(Examination& e, Subject& subject, const ig_syntax& syntax, const ig_option_decl& option,
                  const OptionBlocks& blocks) {
  const ig_link_api api = guarding_api();
  for (const Candidate& c : candidates(option)) {
    GuardedTexts texts;
    option_texts = &texts;
    const std::string shown = c.value.size() > 40 ? fmt::format("a text of {} bytes", c.value.size()) : c.value;
    const std::string where = fmt::format("{}, {}=\"{}\"", syntax.id, option.name, shown);
    e.attempt(where);
    DiagnosticList said;
    LinkedAlone alone = link_alone(syntax, subject.plugin(), subject.surroundings(), element(syntax, &option, c.value),
                                   subject.library(), said);
    if (!c.is_allowed) {
      if (alone.linked != nullptr) e.find(where, "the value lies outside of the declaration and is accepted");
      continue;
    }
    if (alone.linked == nullptr) {
      if (!c.may_be_refused) e.find(where, said.all.empty() ? "it does not link" : said.all.back().message);
      continue;
    }
    ChainSettings settings = in_mode(Mode::checked);
    settings.link_api = &api;
    const std::string fault = creation_fault(alone, settings);
    if (fault.empty())
      run_blocks(e, alone, settings, blocks.blocks_for(syntax, alone), where);
    else if (!c.may_be_refused)
      e.find(where, fault);
  }
}

/// Options that are right one by one may be wrong together, and a number between its bounds may be a rare one.
void check_options_together(Examination& e, Subject& subject, const ig_syntax& syntax, std::size_t tries,
                            const OptionBlocks& blocks) {
  std::seed_seq sequence{e.options.seed, e.options.seed >> 32, std::uint64_t{std::strlen(syntax.id)}};
  std::mt19937_64 random(sequence);
  constexpr auto patience = std::chrono::seconds(5);
  const Clock::time_point end = Clock::now() + patience;
  for (std::size_t i = 0; i < tries && syntax.option_count > 0 && Clock::now() < end; ++i) {
    std::string element = "<" + std::string(syntax.id), shown;
    for (std::uint32_t k = 0; k < syntax.option_count; ++k) {
      const std::string value = random_value(syntax.options[k], random);
      element += fmt::format(" {}=\"{}\"", syntax.options[k].name, escaped_xml(value));
      shown += fmt::format(", {}=\"{}\"", syntax.options[k].name, value);
    }
    const std::string where = syntax.id + shown;
    e.attempt(where);
    DiagnosticList said;
    LinkedAlone alone =
        link_alone(syntax, subject.plugin(), subject.surroundings(), element + "/>", subject.library(), said);
    const ChainSettings settings = in_mode(Mode::checked);
    // create() may refuse what contradicts itself.
    if (alone.linked == nullptr || !creation_fault(alone, settings).empty()) continue;
    const std::size_t before = e.findings();
    run_blocks(e, alone, settings, blocks.blocks_for(syntax, alone), where);
    if (e.findings() > before) return;
  }
}

/// What each setting of the run is for one syntax of the chain, whatever its name is.
thread_local std::string_view any_setting, told_syntax;

/// Settings come from the user, so a syntax may refuse one, with a reason.
void check_settings(Examination& e, const ig_syntax& syntax, LinkedAlone& alone, const OptionBlocks& blocks) {
  ig_link_api api = link_api();
  api.setting = [](ig_link*, const char*) {
    const char* const asking = Chain::breadcrumb().syntax;
    const bool is_told = asking != nullptr && told_syntax == asking;
    return is_told ? ig_text{any_setting.data(), any_setting.size()} : ig_text{nullptr, 0};
  };
  told_syntax = alone.linked->chain[alone.position].element.alias;
  ChainSettings settings = in_mode(Mode::checked);
  settings.link_api = &api;
  const std::string huge(60'000, '9');
  for (const std::string_view value :
       {"1", "on", "off", "0", "-1", "1,3", "O1234", "99999999999999999999", "\xc3", huge.c_str()}) {
    any_setting = value;
    const std::string where = fmt::format("{}, each setting is {}", syntax.id,
                                          value.size() > 40 ? "a text of 60000 bytes" : fmt::format("{:?}", value));
    e.attempt(where);
    const std::string fault = creation_fault(alone, settings);
    if (fault.empty())
      run_blocks(e, alone, settings, blocks.blocks_for(syntax, alone), where);
    else if (fault.find("gives no reason") != std::string::npos)
      e.find(where, fault);
  }
}

}  // namespace

void check_options(Examination& e) {
  Subject subject(e);
  const std::vector<Stand> stands = stands_of(subject, e, Missing::is_told_elsewhere);
  for (const ig_syntax* syntax : subject.syntaxes()) {
    e.attempt(syntax->id);
    DiagnosticList said;
    const OptionBlocks blocks(stands, *syntax, e.options.seed);
    LinkedAlone alone = link_alone(*syntax, subject.plugin(), subject.surroundings(), element(*syntax, nullptr, ""),
                                   subject.library(), said);
    if (alone.linked == nullptr) {
      e.find(syntax->id,
             "it does not link with its default options" + (said.all.empty() ? "" : ": " + said.all.back().message));
      continue;
    }
    if (const std::string fault = creation_fault(alone, in_mode(Mode::checked)); !fault.empty()) {
      e.find(syntax->id, "it is not created with its default options: " + fault);
      continue;
    }
    for (std::uint32_t i = 0; i < syntax->option_count; ++i)
      check_option(e, subject, *syntax, syntax->options[i], blocks);
    check_options_together(e, subject, *syntax, std::clamp<std::size_t>(1000 / subject.syntaxes().size(), 4, 80),
                           blocks);
    check_settings(e, *syntax, alone, blocks);
  }
}

void check_without_services(Examination& e) {
  Subject subject(e);
  subject.remove_services();
  const std::vector<Stand> no_cases;
  for (const ig_syntax* syntax : subject.syntaxes()) {
    if (requires_service(*syntax)) continue;  // linking refuses it before create()
    const std::string where = std::string(syntax->id) + " without services";
    e.attempt(where);
    DiagnosticList said;
    LinkedAlone alone = link_alone(*syntax, subject.plugin(), subject.surroundings(), element(*syntax, nullptr, ""),
                                   subject.library(), said);
    if (alone.linked == nullptr) {
      e.find(where, said.all.empty() ? "it does not link" : said.all.back().message);
      continue;
    }
    const ChainSettings settings = in_mode(Mode::checked);
    if (const std::string fault = creation_fault(alone, settings); !fault.empty())
      e.find(where, fault + "; declare the service as required, or work without it");
    else
      run_blocks(e, alone, settings, OptionBlocks(no_cases, *syntax, e.options.seed).blocks_for(*syntax, alone), where);
  }
}

}  // namespace isogloss::cli
