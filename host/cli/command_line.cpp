// The only file that knows the parser's library: its header costs as much as five of our files.
#include "command_line.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iostream>
#include <limits>
#include <map>

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
    if (option.size() > 1 && option.starts_with('-')) return "no option '" + option.substr(0, 2) + "'";
    if (operand.empty()) operand = word;
  }
  return "'" + operand + "' is one operand too many";
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

  std::string name, example;
  std::map<const CLI::Option*, std::vector<std::string>> words;  // that one_of() allows
};

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

Option& Option::not_empty() {
  option_of(option_).check(
      [](const std::string& text) { return text.empty() ? std::string("its value is empty") : std::string(); }, "");
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
  CLI::Option* const added = parser_->add_option(names, value, description);
  return Option(added, parser_->words[added]);
}

template <class Number>
Option CommandLine::number(const std::string& names, Number& value, const std::string& description) {
  CLI::Option* const added = parser_->add_option(names, value, description)->transform(without_zeros);
  added->check(excess<largest<Number>>, "");
  return Option(added, parser_->words[added]).at_least(0);
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
  CLI::Option* const added = parser_->add_option(names, values, description);
  if (names.starts_with('-')) added->allow_extra_args(false);
  return Option(added, parser_->words[added]);
}

Option CommandLine::flag(const std::string& names, bool& value, const std::string& description) {
  CLI::Option* const added = parser_->add_flag(names, value, description);
  return Option(added, parser_->words[added]);
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
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    return print(fitted(parser_->help(), columns_of(STDOUT_FILENO)), success);
  } catch (const CLI::ParseError& e) {
    const bool is_unexpected = dynamic_cast<const CLI::ExtrasError*>(&e) != nullptr;
    std::cerr << parser_->get_name() << ": " << (is_unexpected ? unexpected(*parser_) : e.what()) << "\n"
              << parser_->get_name() << " --help says more\n";
    return cannot_start;
  }
}

bool CommandLine::is_given(const std::string& option) const { return parser_->count(option) > 0; }

}  // namespace isogloss::cli
