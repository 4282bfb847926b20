#include "isogloss/engine/library.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

// Boost.DLL 1.74 needs <vector> and <string> first; with std::filesystem it needs no boost_filesystem.
#define BOOST_DLL_USE_STD_FS
#include <boost/dll/library_info.hpp>
#include <boost/dll/shared_library.hpp>

#include "contract/descriptor_check.hpp"
#include "contract/descriptor_copy.hpp"
#include "contract/elf_check.hpp"
#include "contract/plugin_trust.hpp"

namespace isogloss {

namespace fs = std::filesystem;

struct Library::Parts {
  std::vector<fs::path> folders;
  PluginTrust trust = PluginTrust::guarded;
  std::vector<boost::dll::shared_library> resident;
  std::vector<LoadedPlugin> plugins;
  std::vector<RefusedPlugin> refused;

  bool load(const fs::path& file);
  bool refuse(const fs::path& file, std::string_view code, std::initializer_list<std::string> arguments);
  bool admit(const fs::path& file, const ig_plugin* original);
  bool is_refused(const fs::path& path) const;
  /// False, and refused, when others can write the path.
  bool is_trusted(const fs::path& path);

  std::vector<std::unique_ptr<PluginCopy>> copies;
};

namespace {

constexpr const char* entry_symbol = "ig_plugin_v1";

thread_local const char* file_being_loaded = nullptr;
thread_local bool entry_is_at_work = false;

/// Code of the plugin may run while one of these lives.
class Loading {
 public:
  explicit Loading(const std::string& file) { file_being_loaded = file.c_str(); }
  ~Loading() {
    file_being_loaded = nullptr;
    entry_is_at_work = false;
  }
  Loading(const Loading&) = delete;
  Loading& operator=(const Loading&) = delete;
};

/// The part of this id in one of the plugins' lists.
template <class T>
const T* find_part(const std::vector<LoadedPlugin>& plugins, std::string_view id, const T* const* ig_plugin::*list,
                   std::uint32_t ig_plugin::*count, const ig_plugin** owner) {
  for (const LoadedPlugin& p : plugins)
    for (std::uint32_t i = 0; i < p.plugin->*count; ++i)
      if (id == (p.plugin->*list)[i]->id) {
        if (owner != nullptr) *owner = p.plugin;
        return (p.plugin->*list)[i];
      }
  return nullptr;
}

/// An id that two plugins declare, or nothing.
template <class T>
const char* shared_id(const ig_plugin& a, const ig_plugin& b, const T* const* ig_plugin::*list,
                      std::uint32_t ig_plugin::*count) {
  for (std::uint32_t i = 0; i < a.*count; ++i)
    for (std::uint32_t j = 0; j < b.*count; ++j)
      if (std::string_view((a.*list)[i]->id) == (b.*list)[j]->id) return (a.*list)[i]->id;
  return nullptr;
}

}  // namespace

const char* Library::loading() { return file_being_loaded; }
bool Library::is_in_entry() { return entry_is_at_work; }

bool Library::Parts::refuse(const fs::path& file, std::string_view code, std::initializer_list<std::string> arguments) {
  refused.push_back({file, std::string(code), host_diagnostic(code, {}, arguments).message});
  return false;
}

bool Library::Parts::is_refused(const fs::path& path) const {
  return std::any_of(refused.begin(), refused.end(), [&](const RefusedPlugin& p) { return p.file == path; });
}

bool Library::Parts::admit(const fs::path& file, const ig_plugin* original) {
  const std::string name = file.string();
  if (original == nullptr) return refuse(file, "IG-0305", {name, "the entry function returned nothing"});
  if (original->struct_size < offsetof(ig_plugin, syntax_count) || original->struct_size > 1u << 20)
    return refuse(file, "IG-0305", {name, "its size cannot be right"});
  if (original->abi_major != IG_ABI_MAJOR)
    return refuse(file, "IG-0304", {name, std::to_string(original->abi_major), std::to_string(IG_ABI_MAJOR)});
  auto copy = std::make_unique<PluginCopy>(*original);
  const ig_plugin* const plugin = copy->get();
  if (const std::optional<std::string> fault = descriptor_fault(*plugin))
    return refuse(file, "IG-0305", {name, *fault});
  // A dialect names a plugin, and the file is found by that name.
  if (file.extension() == ".so" && file.stem() != plugin->name)
    return refuse(file, "IG-0305", {name, "its name is '" + std::string(plugin->name) + "', so the file must be too"});
  for (const LoadedPlugin& other : plugins) {
    if (std::string_view(other.plugin->name) == plugin->name)
      return refuse(file, "IG-0306", {name, plugin->name, other.file.string()});
    const char* id = shared_id(*plugin, *other.plugin, &ig_plugin::syntaxes, &ig_plugin::syntax_count);
    if (id == nullptr) id = shared_id(*plugin, *other.plugin, &ig_plugin::dependencies, &ig_plugin::dependency_count);
    if (id == nullptr) id = shared_id(*plugin, *other.plugin, &ig_plugin::importers, &ig_plugin::importer_count);
    if (id != nullptr) return refuse(file, "IG-0307", {name, id, other.file.string()});
  }
  plugins.push_back({file, plugin, {}});
  copies.push_back(std::move(copy));
  return true;
}

bool Library::Parts::is_trusted(const fs::path& path) {
  if (is_refused(path)) return false;
  const std::optional<OpenPlace> open = trust == PluginTrust::any ? std::nullopt : open_place(path);
  return !open || refuse(path, "IG-0311", {path.string(), open->path.string(), open->who, open->remedy});
}

bool Library::Parts::load(const fs::path& file) {
  if (std::any_of(plugins.begin(), plugins.end(), [&](const LoadedPlugin& p) { return p.file == file; })) return true;
  if (is_refused(file)) return false;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return refuse(file, "IG-0301", {file.string(), "not a regular file"});
  if (!is_trusted(file)) return false;
  // Looks before loading: a file without the entry symbol never gets to run its initializers here.
  std::vector<std::string> exports;
  if (const std::optional<std::string> fault = elf_fault(file)) return refuse(file, "IG-0301", {file.string(), *fault});
  try {
    const boost::dll::library_info format(file);  // throws when the file is no library
    const std::vector<std::string> symbols = elf_exports(file);
    if (std::find(symbols.begin(), symbols.end(), entry_symbol) == symbols.end())
      return refuse(file, "IG-0302", {file.string()});
    const std::set<std::string> unique(symbols.begin(), symbols.end());
    std::copy_if(unique.begin(), unique.end(), std::back_inserter(exports),
                 [](const std::string& symbol) { return symbol != entry_symbol; });
  } catch (const std::exception& e) {
    return refuse(file, "IG-0301", {file.string(), e.what()});
  }
  const std::string name = file.string();
  const Loading loading(name);
  try {
    boost::dll::shared_library library(file, boost::dll::load_mode::rtld_now | boost::dll::load_mode::rtld_local);
    const auto entry = library.get<const ig_plugin*()>(entry_symbol);
    entry_is_at_work = true;
    const ig_plugin* const original = entry();
    entry_is_at_work = false;
    if (!admit(file, original)) return false;
    resident.push_back(std::move(library));
    plugins.back().extra_exports = std::move(exports);
    return true;
  } catch (const std::exception& e) {
    return refuse(file, "IG-0303", {name, e.what()});
  } catch (...) {
    return refuse(file, "IG-0303", {name, "it threw an exception that is no std::exception"});
  }
}

Library::Library(const std::vector<fs::path>& folders, PluginTrust trust) : parts_(std::make_unique<Parts>()) {
  parts_->folders = folders;
  parts_->trust = trust;
}

// Plugins stay resident: their descriptors and code may still be in use by a linked dialect.
Library::~Library() {
  static std::vector<std::unique_ptr<Parts>>& kept = *std::make_unique<std::vector<std::unique_ptr<Parts>>>().release();
  kept.push_back(std::move(parts_));
}

bool Library::load(const std::string& name, const Location& where, DiagnosticSink& sink) {
  if (find(name) != nullptr) return true;
  std::vector<std::string> names;
  for (const fs::path& folder : parts_->folders) {
    std::error_code error;
    const fs::path file = folder / (name + ".so");
    if (name.find('/') == std::string::npos && fs::is_regular_file(file, error)) {
      if (parts_->load(file)) return true;
      for (const RefusedPlugin& r : parts_->refused)
        if (r.file == file) sink.add({Severity::error, r.code, r.reason, where, 0, "see `isogloss doctor`"});
      return false;
    }
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
      if (it->path().extension() == ".so") names.push_back(it->path().stem().string());
  }
  const std::string near = nearest_name(name, names);
  std::string hint = near.empty() ? std::string() : "did you mean " + near + "? ";
  hint += parts_->folders.empty() ? "no folder was searched" : "searched:";
  for (const fs::path& folder : parts_->folders)
    hint += (&folder == &parts_->folders.front() ? " " : ", ") + folder.string();
  sink.add(host_diagnostic("IG-0201", where, {name}, hint));
  return false;
}

bool Library::load_file(const fs::path& file) { return parts_->load(file); }

void Library::load_all() {
  load_until([] { return false; });
}

template <class IsFound>
void Library::load_until(const IsFound& is_found) {
  for (const fs::path& folder : parts_->folders) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
      if (it->path().extension() == ".so") files.push_back(it->path());
    // The folder is refused once, instead of each of its plugins.
    if (files.empty() || !parts_->is_trusted(folder)) continue;
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
      if (parts_->load(file) && is_found()) return;
  }
}

const ig_dependency* Library::find_dependency(std::string_view id, const ig_plugin** owner) {
  const ig_dependency* found = dependency(id, owner);
  if (found == nullptr) load_until([&] { return (found = dependency(id, owner)) != nullptr; });
  return found;
}

const std::vector<LoadedPlugin>& Library::plugins() const { return parts_->plugins; }
const std::vector<RefusedPlugin>& Library::refused() const { return parts_->refused; }

const ig_plugin* Library::find(std::string_view name) const {
  for (const LoadedPlugin& p : parts_->plugins)
    if (name == p.plugin->name) return p.plugin;
  return nullptr;
}

const ig_syntax* Library::syntax(std::string_view id, const ig_plugin** owner) const {
  return find_part(parts_->plugins, id, &ig_plugin::syntaxes, &ig_plugin::syntax_count, owner);
}

std::vector<std::string> Library::syntax_ids() const {
  std::vector<std::string> ids;
  for (const LoadedPlugin& loaded : parts_->plugins)
    for (std::uint32_t i = 0; i < loaded.plugin->syntax_count; ++i) ids.emplace_back(loaded.plugin->syntaxes[i]->id);
  return ids;
}

const ig_dependency* Library::dependency(std::string_view id, const ig_plugin** owner) const {
  return find_part(parts_->plugins, id, &ig_plugin::dependencies, &ig_plugin::dependency_count, owner);
}

const ig_importer* Library::importer(std::string_view id, const ig_plugin** owner) const {
  return find_part(parts_->plugins, id, &ig_plugin::importers, &ig_plugin::importer_count, owner);
}

void Library::add(const ig_plugin* plugin) { parts_->admit("(built in)", plugin); }

std::vector<Diagnostic> Library::shared_codes() const {
  struct Owner {
    std::string_view name, text;
    Severity severity;
  };
  std::map<std::string_view, Owner> owners;
  for (const DiagnosticInfo& info : host_diagnostics())
    owners.emplace(info.code, Owner{"the host", info.text, info.severity});
  std::vector<Diagnostic> out;
  for (const LoadedPlugin& p : plugins())
    for (std::uint32_t i = 0; i < p.plugin->diagnostic_count; ++i) {
      const ig_diagnostic_decl& row = p.plugin->diagnostics[i];
      const auto [owner, added] =
          owners.emplace(row.code, Owner{p.plugin->name, row.text, static_cast<Severity>(row.severity)});
      // The headers of the SDK put the same diagnostics into each plugin that includes them.
      if (!added && (owner->second.text != row.text || owner->second.severity != static_cast<Severity>(row.severity)))
        out.push_back(host_diagnostic("IG-0310", {}, {p.plugin->name, row.code, std::string(owner->second.name)}));
    }
  return out;
}

}  // namespace isogloss
