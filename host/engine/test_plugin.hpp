/// Plugins made by hand, for tests: parts are put together from literals and admitted with Library::add().
#pragma once

#include <cmath>
#include <deque>
#include <string>
#include <vector>

#include "isogloss_import.h"

namespace isogloss::test {

inline ig_field_decl field(const char* path, std::uint32_t access, ig_type type = IG_NUMBER,
                           ig_life life = IG_LIFE_STANDARD) {
  return {sizeof(ig_field_decl), access, type, life, path, "", "", nullptr};
}

inline ig_option_decl option(const char* name, ig_option_type type, const char* fallback, const char* choices = "",
                             double minimum = -HUGE_VAL, double maximum = HUGE_VAL) {
  return {sizeof(ig_option_decl), type, name, fallback, choices, minimum, maximum, "", ""};
}

inline ig_column_decl column(const char* name, const char* fallback = nullptr, double minimum = -HUGE_VAL,
                             double maximum = HUGE_VAL) {
  return {sizeof(ig_column_decl), 0, name, "mm", fallback, minimum, maximum, ""};
}

inline ig_status create_nothing(const ig_link_api*, ig_link*, const ig_field*, void** self) {
  *self = nullptr;
  return IG_CHANGED;
}
inline void destroy_nothing(void*) {}
inline ig_status build_nothing(void*, const ig_host*, ig_block*) { return IG_UNCHANGED; }

/// A list of names for after, before or provides.
using Names = std::vector<const char*>;

struct Syntax {
  explicit Syntax(const char* id) {
    out.struct_size = sizeof out;
    out.id = id;
    out.summary = "A syntax.";
    out.create = create_nothing;
    out.destroy = destroy_nothing;
    out.build = build_nothing;
  }
  std::vector<ig_field_decl> fields;
  std::vector<ig_option_decl> options;
  std::vector<ig_service_decl> services;
  Names after, before;
  ig_syntax out{};

  const ig_syntax* get() {
    out.fields = fields.data();
    out.options = options.data();
    out.services = services.data();
    out.field_count = static_cast<std::uint32_t>(fields.size());
    out.option_count = static_cast<std::uint32_t>(options.size());
    out.service_count = static_cast<std::uint32_t>(services.size());
    out.after = ended(after);
    out.before = ended(before);
    return &out;
  }
  static const char* const* ended(Names& names) {
    if (names.empty()) return nullptr;
    if (names.back() != nullptr) names.push_back(nullptr);
    return names.data();
  }
};

struct Dependency {
  explicit Dependency(const char* id) {
    out.struct_size = sizeof out;
    out.id = id;
    out.summary = "A dependency.";
    out.create = create_nothing;
    out.destroy = destroy_nothing;
    out.service = [](void*, const char*) -> const void* { return nullptr; };
  }
  std::vector<ig_option_decl> options;
  std::vector<ig_column_decl> columns;
  Names provides;
  std::vector<const char*> rows;
  ig_dependency out{};

  const ig_dependency* get() {
    out.options = options.data();
    out.columns = columns.data();
    out.option_count = static_cast<std::uint32_t>(options.size());
    out.column_count = static_cast<std::uint32_t>(columns.size());
    out.provides = Syntax::ended(provides);
    out.default_rows = rows.data();
    out.default_row_count = static_cast<std::uint32_t>(rows.size());
    return &out;
  }
};

struct Importer {
  explicit Importer(const char* id) {
    out.struct_size = sizeof out;
    out.id = id;
    out.summary = "An importer.";
    out.files = "";
    out.recognise = [](ig_text, ig_text) { return 0u; };
    out.read = [](const ig_import_api*, ig_import*) -> ig_status { return IG_UNCHANGED; };
  }
  std::vector<ig_option_decl> options;
  Names dependencies;
  ig_importer out{};

  const ig_importer* get() {
    out.options = options.data();
    out.option_count = static_cast<std::uint32_t>(options.size());
    out.dependencies = Syntax::ended(dependencies);
    return &out;
  }
};

struct Plugin {
  explicit Plugin(const char* name) {
    out.struct_size = sizeof out;
    out.abi_major = IG_ABI_MAJOR;
    out.abi_minor = IG_ABI_MINOR;
    out.name = name;
    out.version = "1.0.0";
    out.vendor = "test";
    out.built_with = "by hand";
  }
  std::deque<Syntax> syntaxes;
  std::deque<Dependency> dependencies;
  std::deque<Importer> importers;
  std::vector<ig_diagnostic_decl> diagnostics;
  ig_plugin out{};

  Syntax& syntax(const char* id) { return syntaxes.emplace_back(id); }
  Dependency& dependency(const char* id) { return dependencies.emplace_back(id); }
  Importer& importer(const char* id) { return importers.emplace_back(id); }

  const ig_plugin* get() {
    syntax_list_.clear();
    dependency_list_.clear();
    importer_list_.clear();
    for (Importer& i : importers) importer_list_.push_back(i.get());
    out.importers = importer_list_.data();
    out.importer_count = static_cast<std::uint32_t>(importer_list_.size());
    for (Syntax& s : syntaxes) syntax_list_.push_back(s.get());
    for (Dependency& d : dependencies) dependency_list_.push_back(d.get());
    out.syntaxes = syntax_list_.data();
    out.dependencies = dependency_list_.data();
    out.diagnostics = diagnostics.data();
    out.syntax_count = static_cast<std::uint32_t>(syntax_list_.size());
    out.dependency_count = static_cast<std::uint32_t>(dependency_list_.size());
    out.diagnostic_count = static_cast<std::uint32_t>(diagnostics.size());
    return &out;
  }

 private:
  std::vector<const ig_syntax*> syntax_list_;
  std::vector<const ig_dependency*> dependency_list_;
  std::vector<const ig_importer*> importer_list_;
};

}  // namespace isogloss::test
