// What a dialect gives to a syntax: options and services.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <random>

#include "markup.hpp"
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

/// A value inside of the declared bounds, for options that are tried together.
std::string random_value(const ig_option_decl& o, std::mt19937_64& random) {
  switch (o.type) {
    case IG_OPTION_NUMBER:
    case IG_OPTION_INTEGER: {
      const double least = std::isfinite(o.minimum) ? std::ceil(o.minimum) : std::fmin(-10, o.maximum);
      const double most = std::isfinite(o.maximum) ? std::floor(o.maximum) : std::fmax(1000, o.minimum);
      const double range = std::fmin(std::fmax(most - least, 0), 1e9);
      // Small numbers mean something more often than large ones.
      const double end = random() % 2 == 0 ? std::fmin(range, 20) : range;
      return number_text(least + static_cast<double>(random() % (static_cast<std::uint64_t>(end) + 1)));
    }
    case IG_OPTION_BOOLEAN: return random() % 2 == 0 ? "true" : "false";
    case IG_OPTION_CHOICE: {
      const std::vector<Candidate> all = candidates(o);
      return all[random() % (all.size() - 1)].value;  // the last one is no choice
    }
    default: return o.fallback != nullptr ? o.fallback : any_value(o);
  }
}

/// Options that are right one by one may be wrong together, and a number between its bounds may be a rare one.
void check_options_together(Examination& e, Subject& subject, const ig_syntax& syntax, std::size_t tries) {
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
    const LinkedAlone alone =
        link_alone(syntax, subject.plugin(), subject.surroundings(), element + "/>", subject.library(), said);
    const ChainSettings settings = in_mode(Mode::checked);
    // create() may refuse what contradicts itself.
    if (alone.linked == nullptr || !creation_fault(alone, settings).empty()) continue;
    const std::size_t before = e.findings();
    run_blocks(e, alone, settings, blocks_for(alone), where);
    if (e.findings() > before) return;
  }
}

}  // namespace

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
    check_options_together(e, subject, *syntax, std::clamp<std::size_t>(1000 / subject.syntaxes().size(), 4, 80));
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

}  // namespace isogloss::cli
