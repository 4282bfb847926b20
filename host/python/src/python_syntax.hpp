/// Syntaxes that are written in Python: their descriptors are made while the module runs.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "isogloss/engine/linker.hpp"
#include "workspace.hpp"

namespace isogloss::python {

namespace py = pybind11;

struct FieldSpec {
  std::string path;
  std::uint32_t access = 0;  ///< IG_READ and so on
  std::string type;          ///< empty: as the dialect has it
  std::string life;          ///< empty: as the dialect has it, or the default
};

struct DiagnosticSpec {
  std::string code, severity, text;
};

/// What a decorated function declares. Belongs to the interpreter: destroyed with its lock held.
struct SyntaxSpec {
  std::string name, summary, stage = "logic", after, before;
  std::vector<FieldSpec> fields;
  std::vector<DiagnosticSpec> diagnostics;
  py::object build;
};

/// The first exception of a run. Set and given back with the interpreter's lock held.
class Failure {
 public:
  ~Failure();
  bool is_set() const { return is_set_; }
  void set(const py::error_already_set& error);
  /// Throws what was set, if anything.
  void rethrow();

 private:
  std::atomic<bool> is_set_ = false;
  std::unique_ptr<py::error_already_set> error_;
};

/// A plugin of these syntaxes for one dialect. Outlives each chain that uses it.
class PythonPlugin {
 public:
  /// What is wrong with a declaration is reported to the workspace.
  PythonPlugin(const std::vector<std::shared_ptr<SyntaxSpec>>& specs, const LinkedDialect& dialect, Failure& failure,
               Workspace& workspace);
  ~PythonPlugin();
  PythonPlugin(const PythonPlugin&) = delete;
  PythonPlugin& operator=(const PythonPlugin&) = delete;

  /// Puts the syntaxes into the chain and the plugin into the library; false, and reported, when something is wrong.
  bool add_to(Dialect& dialect, Workspace& workspace);

 private:
  struct Part;
  void add(const std::shared_ptr<SyntaxSpec>& spec, const LinkedDialect& dialect, Failure& failure,
           Workspace& workspace);
  bool insert(const Part& part, Dialect& dialect, Workspace& workspace) const;
  const char* keep(std::string text);
  void wrong(Workspace& workspace, const std::string& syntax, const std::string& why);

  std::deque<std::string> texts_;
  std::deque<Part> parts_;
  std::vector<const ig_syntax*> syntaxes_;
  std::vector<ig_diagnostic_decl> diagnostics_;
  ig_plugin plugin_{};
  bool is_sound_ = true;
};

/// A block while a function looks at it; afterwards each use is a RuntimeError.
class PythonBlock {
 public:
  struct Field {
    ig_field id = IG_NO_FIELD;
    std::uint32_t access = 0;
    ig_type type = IG_NUMBER;
  };
  struct Names {
    std::unordered_map<std::string, Field> fields;
    std::unordered_map<std::string, std::uint32_t> diagnostics;
  };

  PythonBlock(const ig_host* host, ig_block* block, const Names& names) : host_(host), block_(block), names_(names) {}
  void close() { block_ = nullptr; }

  py::object get(const std::string& path) const;  ///< None: the field has no value
  void set(const std::string& path, const py::object& value);
  void erase(const std::string& path);
  py::object take(const std::string& path);
  bool is_fresh(const std::string& path) const;
  py::str text() const;
  void report(const std::string& code, const py::args& arguments, const py::object& at);
  bool has_changed() const { return has_changed_; }

 private:
  ig_block* open() const;
  const Field& field(const std::string& path, std::uint32_t access, const char* verb) const;
  py::object object(const Field& field, ig_value value) const;
  ig_value value(const std::string& path, const Field& field, const py::object& given);

  const ig_host* host_;
  ig_block* block_;
  const Names& names_;
  bool has_changed_ = false;
};

}  // namespace isogloss::python
