// Descriptors for functions in Python. create() gets no data of its own, so an option holds the number of the part.
#include "python_syntax.hpp"

#include <algorithm>
#include <map>
#include <mutex>

namespace isogloss::python {

struct PythonPlugin::Part {
  std::shared_ptr<SyntaxSpec> spec;
  Failure* failure = nullptr;
  std::vector<ig_field_decl> fields;
  std::vector<std::string> paths;  // of the fields, as the function names them
  std::string number;
  std::uint32_t first_diagnostic = 0;
  ig_option_decl option{};
  ig_syntax syntax{};
  std::uint32_t key = 0;
};

namespace {

constexpr const char* plugin_name = "python";

/// What lives as long as a chain.
struct Instance {
  const SyntaxSpec& spec;
  Failure& failure;
  PythonBlock::Names names;
};

template <class Part>
struct Registry {
  std::mutex mutex;
  std::map<std::uint32_t, const Part*> parts;
  std::uint32_t next = 1;
};

/// Parts by the number in their option, of all plugins that live. Kept to the end of the process.
template <class Part>
Registry<Part>& registry() {
  static auto& all = *std::make_unique<Registry<Part>>().release();
  return all;
}

void destroy(void* self) { delete static_cast<Instance*>(self); }

/// Called without the interpreter's lock. No exception leaves it.
ig_status build(void* self, const ig_host* host, ig_block* block) {
  auto& instance = *static_cast<Instance*>(self);
  if (instance.failure.is_set()) return IG_UNCHANGED;
  const py::gil_scoped_acquire lock;
  try {
    // The function may keep what it was given.
    const auto seen = std::make_shared<PythonBlock>(host, block, instance.names);
    struct Close {
      PythonBlock& block;
      ~Close() { block.close(); }
    };
    const Close close{*seen};
    instance.spec.build(seen);
    return seen->has_changed() ? IG_CHANGED : IG_UNCHANGED;
  } catch (py::error_already_set& error) {
    instance.failure.set(error);
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
    instance.failure.set(py::error_already_set());
  }
  return IG_UNCHANGED;
}

std::optional<Stage> stage_of(const std::string& name) {
  static const std::map<std::string, Stage> stages{{"parsing", Stage::parsing},
                                                   {"evaluation", Stage::evaluation},
                                                   {"logic", Stage::logic},
                                                   {"post_logic", Stage::post_logic},
                                                   {"inspection", Stage::inspection}};
  const auto found = stages.find(name);
  return found == stages.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::uint32_t> named(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - names.begin());
}

}  // namespace

Failure::~Failure() {
  if (error_ == nullptr) return;
  const py::gil_scoped_acquire lock;
  error_.reset();
}

void Failure::set(const py::error_already_set& error) {
  if (is_set_) return;
  error_ = std::make_unique<py::error_already_set>(error);
  is_set_ = true;
}

void Failure::rethrow() {
  if (error_ == nullptr) return;
  const py::error_already_set error = *error_;
  error_.reset();
  throw error;
}

PythonPlugin::PythonPlugin(const std::vector<std::shared_ptr<SyntaxSpec>>& specs, const LinkedDialect& dialect,
                           Failure& failure, Workspace& workspace) {
  for (const auto& spec : specs) add(spec, dialect, failure, workspace);
  plugin_ = {sizeof plugin_,
             IG_ABI_MAJOR,
             IG_ABI_MINOR,
             static_cast<std::uint32_t>(syntaxes_.size()),
             plugin_name,
             "1",
             "the Python script",
             "pybind11",
             syntaxes_.data(),
             nullptr,
             diagnostics_.data(),
             0,
             static_cast<std::uint32_t>(diagnostics_.size()),
             nullptr,
             0,
             0};
}

PythonPlugin::~PythonPlugin() {
  Registry<Part>& all = registry<Part>();
  const std::lock_guard lock(all.mutex);
  for (const Part& part : parts_) all.parts.erase(part.key);
}

const char* PythonPlugin::keep(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }

void PythonPlugin::wrong(Workspace& workspace, const std::string& syntax, const std::string& why) {
  workspace.report("IG-0646", {}, {syntax, why});
  is_sound_ = false;
}

void PythonPlugin::add(const std::shared_ptr<SyntaxSpec>& spec, const LinkedDialect& dialect, Failure& failure,
                       Workspace& workspace) {
  static const std::vector<std::string> types{"",     "number", "integer",   "boolean", "symbol",
                                              "text", "code",   "transform", "switch"};
  static const std::vector<std::string> lives{"", "word", "block", "modal", "frame"};
  Part& part = parts_.emplace_back();
  part.spec = spec;
  part.failure = &failure;
  for (const FieldSpec& f : spec->fields) {
    const ig_field known = dialect.layout.id(f.path);
    const auto type = named(f.type, types), life = named(f.life, lives);
    ig_field_decl decl{sizeof decl, f.access, type.value_or(0), life.value_or(0), keep(f.path), "", "", nullptr};
    if (!type || !life) wrong(workspace, spec->name, f.path + " has an unknown type or life");
    if (f.path.find("[]") != std::string::npos) wrong(workspace, spec->name, f.path + " is a list");
    if (decl.type == 0 && known != IG_NO_FIELD) decl.type = dialect.layout.fields[known].type;
    if (decl.type == 0 && f.path.starts_with("Parsing."))
      decl.type = f.path.starts_with("Parsing.Flags.") ? IG_CODE : IG_NUMBER;
    if (decl.type == 0) wrong(workspace, spec->name, f.path + " is no field of the dialect: give its type");
    part.fields.push_back(decl);
    part.paths.push_back(f.path);
  }
  part.first_diagnostic = static_cast<std::uint32_t>(diagnostics_.size());
  for (const DiagnosticSpec& d : spec->diagnostics) {
    const ig_severity severity = d.severity == "note" ? IG_NOTE : d.severity == "warning" ? IG_WARNING : IG_ERROR;
    diagnostics_.push_back({sizeof(ig_diagnostic_decl), severity, keep(d.code), keep(d.text), "", ""});
  }
  {
    Registry<Part>& all = registry<Part>();
    const std::lock_guard lock(all.mutex);
    part.key = all.next++;
    all.parts.emplace(part.key, &part);
  }
  part.number = std::to_string(part.key);
  part.option = {sizeof part.option,
                 IG_OPTION_INTEGER,
                 "Part",
                 part.number.c_str(),
                 nullptr,
                 0,
                 4e9,
                 "",
                 "Which function of the script this is."};
  ig_syntax& s = part.syntax;
  s.struct_size = sizeof s;
  s.id = keep(spec->name);
  s.summary = keep(spec->summary);
  s.fields = part.fields.data();
  s.field_count = static_cast<std::uint32_t>(part.fields.size());
  s.options = &part.option;
  s.option_count = 1;
  s.inspects = 0;
  s.create = [](const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) -> ig_status {
    Registry<Part>& all = registry<Part>();
    const std::lock_guard lock(all.mutex);
    const auto found = all.parts.find(static_cast<std::uint32_t>(api->option_integer(link, 0)));
    if (found == all.parts.end()) return IG_FAILED;
    const Part& p = *found->second;
    auto instance = std::make_unique<Instance>(Instance{*p.spec, *p.failure, {}});
    for (std::size_t i = 0; i < p.paths.size(); ++i)
      instance->names.fields[p.paths[i]] = {ids[i], p.fields[i].access, p.fields[i].type};
    for (std::uint32_t i = 0; i < p.spec->diagnostics.size(); ++i)
      instance->names.diagnostics[p.spec->diagnostics[i].code] = p.first_diagnostic + i;
    *self = instance.release();
    return IG_UNCHANGED;
  };
  s.destroy = destroy;
  s.build = build;
  syntaxes_.push_back(&s);
}

bool PythonPlugin::insert(const Part& part, Dialect& dialect, Workspace& workspace) const {
  const SyntaxSpec& spec = *part.spec;
  const auto fails = [&](const std::string& why) {
    workspace.report("IG-0646", {}, {spec.name, why});
    return false;
  };
  const std::string& anchor = spec.after.empty() ? spec.before : spec.after;
  ChainElement element{Stage::logic, spec.name, spec.name, {}, false, {}};
  auto place = dialect.chain.end();
  if (anchor.empty()) {
    const std::optional<Stage> stage = stage_of(spec.stage);
    if (!stage) return fails("there is no stage " + spec.stage);
    element.stage = *stage;
    place = std::find_if(dialect.chain.begin(), dialect.chain.end(),
                         [&](const ChainElement& e) { return e.stage > element.stage; });
  } else {
    place = std::find_if(dialect.chain.begin(), dialect.chain.end(),
                         [&](const ChainElement& e) { return e.alias == anchor; });
    if (place == dialect.chain.end()) {
      std::vector<std::string> names;
      for (const ChainElement& e : dialect.chain) names.push_back(e.alias);
      const std::string near = nearest_name(anchor, names);
      return fails("the chain of " + dialect.name + " has no " + anchor + (near.empty() ? "" : "; it has " + near));
    }
    element.stage = place->stage;
    if (!spec.after.empty()) ++place;
  }
  dialect.chain.insert(place, std::move(element));
  return true;
}

bool PythonPlugin::add_to(Dialect& dialect, Workspace& workspace) {
  if (!is_sound_) return false;
  for (const Part& part : parts_)
    if (!insert(part, dialect, workspace)) return false;
  const std::size_t refused = workspace.library().refused().size();
  workspace.library().add(&plugin_);
  if (workspace.library().refused().size() > refused) {
    const RefusedPlugin& reason = workspace.library().refused().back();
    workspace.sink().add({Severity::error, reason.code, reason.reason, {}, 0, {}});
    return false;
  }
  dialect.plugins.push_back({plugin_name, {}});
  return true;
}

}  // namespace isogloss::python
