#include "batch/program_list.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "batch/content_hash.hpp"
#include "isogloss/engine/byte_order_mark.hpp"

namespace isogloss::cli::batch {

namespace fs = std::filesystem;

namespace {

bool matches(const std::vector<std::string>& patterns, const fs::path& below, ProgramList& out) {
  bool matches_any = false;
  for (const std::string& pattern : patterns) {
    if (fnmatch(pattern.c_str(), below.c_str(), 0) != 0 && fnmatch(pattern.c_str(), below.filename().c_str(), 0) != 0)
      continue;
    out.used_patterns.insert(pattern);
    matches_any = true;
  }
  return matches_any;
}

std::string head_of(const fs::path& file) {
  constexpr std::size_t looked_at = 4096;
  std::ifstream in(file, std::ios::binary);
  std::string head(looked_at, ' ');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

/// Without what a path does not need. Behind a link to a folder, .. leads elsewhere than the text of the path.
fs::path plain_path(const fs::path& path) {
  std::error_code error;
  const fs::path plain = path.lexically_normal();
  const bool goes_up = std::find(path.begin(), path.end(), "..") != path.end();
  return !goes_up || fs::equivalent(path, plain, error) ? plain : path;
}

/// The name of a program as it is told and given on: none begins as an option does, or as a formula of a sheet.
std::string name_of(const fs::path& file) {
  std::string name = plain_path(file).string();
  const bool is_plain = !name.empty() && std::string_view("=+-@\t\r").find(name.front()) == std::string_view::npos;
  return is_plain ? name : "./" + name;
}

/// Tables and dialects are XML; drawings, archives and sheets have bytes that no part program has.
bool is_text_of_program(const fs::path& file) {
  return file.extension() != ".xml" && head_of(file).find('\0') == std::string::npos;
}

/// Takes the next line off the text, without its end.
std::string_view next_line(std::string_view& text) {
  std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Whether the first line is the path of another file or folder. A bare name does not count: O0001 is the first line of
/// a program, and may be a file beside it. Nor does a line of signs: / skips a block, and is the root of all folders.
bool is_list(const std::string& place) {
  const std::string head = head_of(place);
  std::string_view rest = behind_byte_order_mark(head), line;
  while (!rest.empty() && line.empty()) line = next_line(rest);
  std::error_code ignored;
  return line.find_first_of("/.") != std::string_view::npos &&
         line.find_first_not_of("/.; \t") != std::string_view::npos && fs::exists(std::string(line), ignored) &&
         !fs::equivalent(std::string(line), place, ignored);
}

bool is_program(const fs::directory_entry& entry, const fs::path& below, const ProgramPlaces& wanted,
                ProgramList& out) {
  std::error_code ignored;
  if (entry.is_symlink(ignored) || !entry.is_regular_file(ignored)) return false;
  const bool is_included = wanted.include.empty() || matches(wanted.include, below, out);
  if (matches(wanted.exclude, below, out) || !is_included) return false;
  return !wanted.include.empty() || is_text_of_program(entry.path());
}

/// Results of another batch are no programs, wherever they lie. A journal may be empty, where its process was killed
/// before it had finished a program.
bool holds_results(const fs::path& folder) {
  std::error_code error;
  bool has_journal = false;
  for (fs::directory_iterator at(folder / "journal", error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() != ".jsonl" || !at->is_regular_file(error)) continue;
    const std::string head = head_of(at->path());
    if (!head.empty() && !head.starts_with("{\"Program\":")) return false;
    has_journal = true;
  }
  return has_journal;
}

void add_folder(const fs::path& folder, const fs::path& below, const ProgramPlaces& wanted, ProgramList& out,
                Session& session) {
  std::error_code error, ignored;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const fs::path name = at->path().filename();
    if (fs::equivalent(at->path(), wanted.results, ignored)) continue;
    const bool is_hidden = name.string().starts_with('.');
    if (!is_hidden && at->is_directory(ignored) && !at->is_symlink(ignored) && !holds_results(at->path()))
      add_folder(at->path(), below / name, wanted, out, session);
    else if (!is_hidden && is_program(*at, below / name, wanted, out))
      out.programs.push_back(name_of(at->path()));
    else
      ++out.left_out;
  }
  if (error) session.report("IG-0510", {folder.string()}, {error.message()});
}

bool add_place(const std::string& place, const ProgramPlaces& wanted, ProgramList& out, Session& session) {
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if (!fs::exists(status)) {
    session.report("IG-0510", {place}, {"no such file or folder"});
    return false;
  }
  if (!fs::is_directory(status) && !fs::is_regular_file(status)) {
    session.report("IG-0510", {place}, {"a batch reads programs from files, and this is none"});
    return false;
  }
  if (!fs::is_directory(status)) {
    out.programs.push_back(name_of(place));
  } else if (fs::equivalent(place, wanted.results, error)) {
    session.report("IG-0513", {}, {"the results need a folder of their own, and " + place + " holds the programs"});
    return false;
  } else {
    out.has_folders = true;
    add_folder(plain_path(place), {}, wanted, out, session);
  }
  return true;
}

bool add_list(const std::string& list, const ProgramPlaces& wanted, ProgramList& out, Session& session) {
  std::string error;
  const std::optional<std::string> text = read_text(list, error);
  if (!text) {
    session.report("IG-0510", {list}, {error});
    return false;
  }
  bool sound = true;
  std::uint32_t number = 0;
  std::string_view rest = behind_byte_order_mark(*text);
  while (!rest.empty()) {
    const std::string_view line = next_line(rest);
    ++number;
    if (line.empty()) continue;
    if (std::error_code ignored; fs::exists(std::string(line), ignored)) {
      sound = add_place(std::string(line), wanted, out, session) && sound;
    } else {
      constexpr std::size_t most_shown = 1000;
      session.report("IG-0510", {list, number, 1},
                     {"no such file or folder: " + std::string(line.substr(0, most_shown))});
      sound = false;
    }
  }
  return sound;
}

/// False where there is no folder for --include and --exclude; a pattern that fits nothing there may do so another
/// time.
bool have_effect(const ProgramPlaces& wanted, const ProgramList& list, Session& session) {
  for (const auto& [option, patterns] :
       {std::pair{"--include", &wanted.include}, std::pair{"--exclude", &wanted.exclude}})
    for (const std::string& pattern : *patterns) {
      if (!list.has_folders) {
        session.report("IG-0513", {},
                       {std::string(option) + " has no effect: it chooses files of folders, and only files are named"});
        return false;
      }
      if (!list.used_patterns.contains(pattern))
        session.report("IG-0519", {}, {option + (" " + pattern), "no file of the folders has such a name or path"});
    }
  return true;
}

}  // namespace

std::optional<ProgramList> list_programs(const ProgramPlaces& wanted, Session& session) {
  ProgramList out;
  bool sound = true;
  for (const std::string& place : wanted.places) {
    std::error_code ignored;
    const bool names_others = fs::is_regular_file(place, ignored) && is_list(place);
    if (names_others && wanted.are_strangers) {
      session.report("IG-0513", {place, 1, 1},
                     {"its first line is a path: with --untrusted only --list takes a file for a list, since it tells "
                      "which files are read"});
      sound = false;
      continue;
    }
    if (names_others) session.report("IG-0676", {place, 1, 1}, {});
    sound = (names_others ? add_list : add_place)(place, wanted, out, session) && sound;
  }
  if (!wanted.list.empty()) sound = add_list(wanted.list, wanted, out, session) && sound;
  std::sort(out.programs.begin(), out.programs.end());
  // One that was named twice, once perhaps with its whole path.
  std::set<fs::path> seen;
  std::erase_if(out.programs, [&](const std::string& program) {
    std::error_code error;
    const fs::path whole = fs::absolute(program, error);
    return !seen.insert(error ? fs::path(program) : plain_path(whole)).second;
  });
  sound = sound && have_effect(wanted, out, session);
  if (sound && out.programs.empty()) session.report("IG-0670", {}, {std::to_string(out.left_out)});
  return sound && !out.programs.empty() ? std::optional(std::move(out)) : std::nullopt;
}

std::vector<std::string> part_of(const std::vector<std::string>& programs, std::uint64_t number, std::uint64_t count) {
  std::vector<std::string> out;
  for (const std::string& program : programs)
    if (hash_of(program).low % count == number - 1) out.push_back(program);
  return out;
}

}  // namespace isogloss::cli::batch
