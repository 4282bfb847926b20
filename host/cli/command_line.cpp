// The only file that knows the parser's library: its header costs as much as five of our files.
#include "command_line.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iostream>
#include <limits>
#include <map>
#include <set>

#include "isogloss/engine/diagnostic.hpp"
#include "output_file.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace isogloss::cli {

namespace {

CLI::Option& option_of(void* option) { return *static_cast<CLI::Option*>(option); }

/// The parser's library would read 010 as an octal number.
std::string without_zeros(const std::string& number) {
  return number.substr(std::min(number.find_first_not_of('0'), std::max<std::size_t>(number.size(), 1) - 1));
}

template <class Number>
constexpr std::uint64_t largest = std::numeric_limits<Number>::max();
template <>
constexpr std::uint64_t largest<std::optional<std::uint64_t>> = largest<std::uint64_t>;

/// What is wrong with digits that stand for more than the option's variable holds; the other checks tell of other text.
template <std::uint64_t largest>
std::string excess(const std::string& text) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_large = error == std::errc::result_out_of_range || (error == std::errc() && value > largest);
  return is_large ? "'" + text + "' is more than " + std::to_string(largest) : std::string();
}

/// "a, b or c"
std::string list_of(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return out;
}

std::string did_you_mean(const std::string& near) { return near.empty() ? near : " (did you mean '" + near + "'?)"; }

/// What the command does not know: an option with the nearest one that it has, or an operand.
std::string unexpected(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : parser.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  std::string operand;
  for (const std::string& word : parser.remaining()) {
    const std::string option = word.substr(0, word.find('='));
    if (option.starts_with("--")) return "no option '" + option + "'" + did_you_mean(nearest_name(option, names));
    if (option.size() > 1 && option.starts_with('-'))
      return "no option '" + option.substr(0, 2) + "': write -- before a name that begins with -";
    if (operand.empty()) operand = word;
  }
  return "'" + operand + "' is one operand too many";
}

/// An option that takes one value and was given several; empty: there is none.
std::string repeated(const CLI::App& parser) {
  for (const CLI::Option* const option : parser.get_options())
    if (option->get_items_expected_max() == 1 && option->count() > 1)
      return option->get_name() + " takes one value and is given " + std::to_string(option->count()) + " times";
  return {};
}

/// In place of the library's "TEXT:{a,b}": the words, or what stands for the value.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_type_size() == 0) return {};
    std::string type = option->get_type_name(), words;
    if (const std::size_t colon = type.find(':'); colon != std::string::npos) {
      words = type.substr(colon + 1);
      type.resize(colon);
    }
    if (type == "TEXT" && words.starts_with('{') && words.size() > 2) {
      type = words.substr(1, words.size() - 2);
      std::replace(type.begin(), type.end(), ',', '|');
    }
    std::string out = type.empty() ? "" : " " + type;
    if (!option->get_default_str().empty()) out += "=" + option->get_default_str();
    if (option->get_expected_max() == CLI::detail::expected_max_vector_size) out += " ...";
    if (option->get_required()) out += " REQUIRED";
    return out;
  }
};

}  // namespace

struct CommandLine::Parser : CLI::App {
  using CLI::App::App;

  /// A flag that stands for another option with a value.
  struct Short {
    const CLI::Option *flag, *option;
    std::string* value;
    std::string word;
  };

  std::string name, example;
  std::map<const CLI::Option*, std::vector<std::string>> words;  // that one_of() allows
  std::vector<Option::Rule> rules;
  std::vector<Short> shorts;

  /// What was given and would have no effect; empty: nothing.
  std::string idle_option() const;
  std::string apply_shorts() const;
};

std::string CommandLine::Parser::idle_option() const {
  for (const CLI::Option* const option : get_options()) {
    const bool has_empty_value = option->get_items_expected_max() > 0 && option->count() > 0 &&
                                 std::any_of(option->results().begin(), option->results().end(),
                                             [](const std::string& value) { return value.empty(); });
    if (has_empty_value) return option->get_name(option->get_positional()) + ": its value is empty";
  }
  for (const Option::Rule& rule : rules) {
    const CLI::Option& option = *static_cast<const CLI::Option*>(rule.option);
    if (rule.other.empty()) {
      std::set<std::string> given;
      for (const std::string& text : option.results())
        if (const auto [at, is_new] = given.insert(text.substr(0, text.find('='))); !is_new)
          return option.get_name() + " gives " + *at + " two values: leave one of them out";
      continue;
    }
    const CLI::Option* const other = get_option_no_throw(rule.other);
    const bool has_other = other != nullptr && other->count() > 0;
    if (option.count() == 0 || has_other == rule.needs_other) continue;
    const std::string what = option.get_name() + " has no effect ";
    return rule.needs_other ? what + "without " + rule.other
                            : what + "beside " + rule.other + ": leave one of them out";
  }
  return {};
}

std::string CommandLine::Parser::apply_shorts() const {
  const Short* first = nullptr;
  for (const Short& one : shorts) {
    if (one.flag->count() == 0) continue;
    const std::string named = one.option->count() > 0 ? one.option->get_name() + " " + *one.value
                              : first != nullptr      ? first->flag->get_name()
                                                      : std::string();
    if (!named.empty() && *one.value != one.word)
      return one.flag->get_name() + " and " + named + " contradict each other: leave one of them out";
    *one.value = one.word;
    first = &one;
  }
  return {};
}

Option& Option::required() {
  option_of(option_).required();
  return *this;
}

Option& Option::type_name(const std::string& name) {
  option_of(option_).type_name(name);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
  const auto check = [words](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
    return "'" + word + "' is not " + list_of(words) + did_you_mean(nearest_name(word, words));
  };
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "{" : ",") + word;
  option_of(option_).check(check, all + "}");
  *words_ = words;
  return *this;
}

Option& Option::names_once() {
  rules_->push_back({option_, {}, false});
  return *this;
}

Option& Option::only_with(const std::string& other) {
  rules_->push_back({option_, other, true});
  return *this;
}

Option& Option::not_with(const std::string& other) {
  rules_->push_back({option_, other, false});
  return *this;
}

Option& Option::at_least(std::uint64_t minimum) {
  option_of(option_).check(
      [minimum](const std::string& text) {
        std::uint64_t value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (error == std::errc() && stop == end && value >= minimum) return std::string();
        return "'" + text + "' is not a whole number from " + std::to_string(minimum) + " on";
      },
      "");
  return *this;
}

Option& Option::existing_folder() {
  option_of(option_).check(CLI::ExistingDirectory);
  return *this;
}

Option& Option::shows_default() {
  option_of(option_).capture_default_str();
  return *this;
}

Option& Option::group(const std::string& heading) {
  option_of(option_).group(heading);
  return *this;
}

CommandLine::CommandLine(const std::string& name, const std::string& description, const std::string& example)
    : parser_(std::make_unique<Parser>(description, "isogloss " + name)) {
  parser_->name = name;
  parser_->example = example;
  parser_->footer("\nExample:\n  " + example);
  parser_->formatter(std::make_shared<HelpFormatter>());
  parser_->set_help_flag("-h,--help", "What the command does");
}

CommandLine::~CommandLine() = default;

Option CommandLine::option(const std::string& names, std::string& value, const std::string& description) {
  return added(parser_->add_option(names, value, description));
}

template <class Number>
Option CommandLine::number(const std::string& names, Number& value, const std::string& description) {
  CLI::Option* const option = parser_->add_option(names, value, description)->transform(without_zeros);
  option->check(excess<largest<Number>>, "");
  return added(option).at_least(0);
}

Option CommandLine::option(const std::string& names, std::uint32_t& value, const std::string& description) {
  return number(names, value, description);
}

Option CommandLine::option(const std::string& names, std::uint64_t& value, const std::string& description) {
  return number(names, value, description);
}

Option CommandLine::option(const std::string& names, std::optional<std::uint64_t>& value,
                           const std::string& description) {
  return number(names, value, description);
}

Option CommandLine::option(const std::string& names, std::vector<std::string>& values, const std::string& description) {
  CLI::Option* const option = parser_->add_option(names, values, description);
  if (names.starts_with('-')) option->allow_extra_args(false);
  return added(option);
}

Option CommandLine::flag(const std::string& names, bool& value, const std::string& description) {
  return added(parser_->add_flag(names, value, description));
}

Option CommandLine::flag_for(const std::string& option, std::string& value, const std::string& word,
                             const std::string& name, const std::string& more) {
  const std::string description = "The same as " + option + " " + word + more;
  CLI::Option* const flag = parser_->add_flag(name, description);
  parser_->shorts.push_back({flag, parser_->get_option(option), &value, word});
  return added(flag);
}

Option CommandLine::added(void* option) {
  return Option(option, parser_->words[static_cast<CLI::Option*>(option)], parser_->rules);
}

void CommandLine::describe(Usage& usage) const {
  usage = {parser_->name, parser_->get_description(), parser_->example, {}, {}};
  for (const CLI::Option* const option : parser_->get_options()) {
    if (option->get_group().empty()) continue;
    UsageItem item;
    const bool is_operand = option->get_positional();
    if (is_operand) item.names.push_back(option->get_name(true));
    for (const std::string& name : option->get_snames()) item.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) item.names.push_back("--" + name);
    if (const auto found = parser_->words.find(option); found != parser_->words.end()) item.words = found->second;
    // The parser appends what checks the value: "DIR:DIR".
    const std::string type = option->get_type_name();
    if (option->get_items_expected_max() > 0) item.value = is_operand ? item.names[0] : type.substr(0, type.find(':'));
    item.description = option->get_description();
    item.group = option->get_group();
    item.default_value = option->get_default_str();
    item.is_required = option->get_required();
    item.is_repeatable = option->get_items_expected_max() > 1;
    (is_operand ? usage.operands : usage.options).push_back(std::move(item));
  }
}

std::optional<int> CommandLine::parse(const Arguments& arguments) {
  if (arguments.describe != nullptr) {
    describe(*arguments.describe);
    return success;
  }
  try {
    parser_->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    for (const std::string& fault : {parser_->idle_option(), parser_->apply_shorts()})
      if (!fault.empty()) return wrong_usage(fault);
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    return print(fitted(parser_->help(), columns_of(STDOUT_FILENO)), success);
  } catch (const CLI::ParseError& e) {
    // What is missing may be the word that was taken for an option: -:12 of standard input.
    const bool is_unexpected =
        dynamic_cast<const CLI::ExtrasError*>(&e) != nullptr ||
        (dynamic_cast<const CLI::RequiredError*>(&e) != nullptr && parser_->remaining_size() > 0);
    const std::string repeated_option = repeated(*parser_);
    return wrong_usage(is_unexpected ? unexpected(*parser_) : !repeated_option.empty() ? repeated_option : e.what());
  }
}

int CommandLine::wrong_usage(const std::string& what) const {
  std::cerr << parser_->get_name() << ": " << what << "\n" << parser_->get_name() << " --help says more\n";
  return cannot_start;
}

bool CommandLine::is_given(const std::string& option) const { return parser_->count(option) > 0; }

std::vector<std::string> CommandLine::given_besides(const std::string& group,
                                                    const std::vector<std::string>& others) const {
  std::vector<std::string> out;
  for (const CLI::Option* const option : parser_->get_options()) {
    const bool is_other = option->get_positional() || option->get_group() == group ||
                          std::find(others.begin(), others.end(), option->get_name()) != others.end();
    if (!is_other && option->count() > 0) out.push_back(option->get_name());
  }
  return out;
}

}  // namespace isogloss::cli
