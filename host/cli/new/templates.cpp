// Templates are files of the installation, below the folder `templates` in layers that are put on top of each other. A
// new kind of folder is a new layer. They end with .in, so that no tool takes them for sources of this project.
#include <fmt/format.h>

#include <system_error>

#include "new/folder.hpp"
#include "outputs.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

/// In a build tree the templates stand beside the command, as dialects do.
fs::path template_folder() {
  const fs::path home = folder_of_executable();
  std::error_code ignored;
  const fs::path beside = home / "templates";
  return fs::is_directory(beside, ignored) ? beside : home.parent_path() / "share/isogloss/templates";
}

/// In one pass: what is filled in may look like a mark.
std::string filled(const std::string& text, const TemplateWords& words) {
  std::string out;
  std::size_t at = 0;
  for (std::size_t begin; (begin = text.find('@', at)) != std::string::npos;) {
    const std::size_t end = text.find('@', begin + 1);
    const auto word = end == std::string::npos ? words.end() : words.find(text.substr(begin + 1, end - begin - 1));
    const bool is_mark = word != words.end();
    out += text.substr(at, begin - at) + (is_mark ? word->second : "@");
    at = (is_mark ? end : begin) + 1;
  }
  return out + text.substr(at);
}

/// The templates of the layer, by what they become; false, and reported, when the folder cannot be read.
bool find_templates(const std::string& layer, const TemplateWords& words, std::map<fs::path, fs::path>& sources,
                    Session& session) {
  const fs::path folder = template_folder() / layer;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != ".in" || !it->is_regular_file()) continue;
    const std::string name = it->path().lexically_relative(folder).replace_extension().string();
    sources[filled(name, words)] = it->path();
  }
  if (error) session.report("IG-0510", {folder.string()}, {error.message()});
  return !error;
}

std::optional<std::string> read_template(const fs::path& source, Session& session) {
  std::string reason;
  std::optional<std::string> text = read_text(source.string(), reason);
  if (!text) session.report("IG-0510", {source.string()}, {reason});
  return text;
}

}  // namespace

std::map<std::string, std::string> read_templates(const std::string& layer, Session& session) {
  std::map<fs::path, fs::path> sources;
  std::map<std::string, std::string> out;
  if (!find_templates(layer, {}, sources, session)) return {};
  for (const auto& [name, source] : sources) {
    std::optional<std::string> text = read_template(source, session);
    if (!text) return {};
    out[name.string()] = std::move(*text);
  }
  return out;
}

std::vector<std::string> write_templates(const fs::path& place, const std::vector<std::string>& layers,
                                         const TemplateWords& words, Session& session) {
  std::map<fs::path, fs::path> sources;
  for (const std::string& layer : layers)
    if (!find_templates(layer, words, sources, session)) return {};

  std::vector<std::string> written;
  for (const auto& [name, source] : sources) {
    const fs::path target = place / name;
    const std::optional<std::string> text = read_template(source, session);
    if (!text) return {};
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    if (!write_file(target.string(), filled(*text, words), session)) return {};
    const bool is_script = (fs::status(source, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    const fs::perms execute = fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
    if (is_script) fs::permissions(target, execute, fs::perm_options::add, error);
    written.push_back(target.string());
  }
  return written;
}

}  // namespace isogloss::cli
