// Answers the completion functions of shells; what they cannot know, such as a vendor's dialects, the command knows.
#include <algorithm>
#include <cctype>

#include "completion/completion.hpp"

namespace isogloss::cli {

namespace {

/// Upper and lower case do not matter: who types `drill` means DrillingCycleSyntax.
bool begins(std::string_view text, std::string_view typed) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return text.size() >= typed.size() && std::equal(typed.begin(), typed.end(), text.begin(), same);
}

/// The first line alone, without what would break the form.
std::string on_one_line(std::string_view text) {
  std::string out(text.substr(0, text.find('\n')));
  std::replace(out.begin(), out.end(), '\t', ' ');
  return out;
}

}  // namespace

int complete_command(const Arguments& arguments) {
  CommandLine command(
      "complete",
      "Prints what may stand at the end of a command line, for the completion functions of shells: one candidate on a "
      "line, with a tab and its description where it has one. A line that begins with a colon is none: ':files "
      "PATTERN' "
      "says that files whose names match fit, too, ':folders' that folders do, and ':open' that more of the word "
      "follows what "
      "was printed. The words behind -- are those behind "
      "isogloss; the last one is completed, and may be empty. A value behind '=' is completed without what stands "
      "before "
      "it. Exit status: 0, also where nothing fits; 2 for wrong usage.",
      "isogloss complete -- run -d ''\n  isogloss complete -- inspect Drill");
  std::vector<std::string> shown;
  command.option("WORD", shown, "The words of the command line, behind --");
  // The words are not this command's own: its parser must not see them.
  const auto mark = std::find(arguments.begin(), arguments.end(), "--");
  Arguments own(arguments.begin(), mark);
  own.describe = arguments.describe;
  if (const auto done = command.parse(own)) return *done;

  TypedLine line;
  read_typed(mark == arguments.end() ? shown : std::vector<std::string>(mark + 1, arguments.end()), line);
  std::string out;
  bool is_open = false;
  const auto write = [&](const std::vector<Completion>& candidates) {
    for (const Completion& c : candidates) {
      if (!begins(c.text, line.word)) continue;
      out += c.text + (c.description.empty() ? "" : "\t" + on_one_line(c.description)) + "\n";
      is_open = is_open || !c.is_whole;
    }
  };
  write(words_of(line));
  write(names_of(line));
  if (is_open) out += ":open\n";
  if (const std::string_view files = files_of(line); files == "/")
    out += ":folders\n";
  else if (!files.empty())
    out += ":files " + std::string(files) + "\n";
  return print(out, success);
}

}  // namespace isogloss::cli
