/// The steps of linking, in the order in which link() takes them. Each reports all faults that it finds.
#pragma once

#include <map>
#include <span>
#include <unordered_map>

#include "isogloss/engine/linker.hpp"
#include "link/pattern.hpp"

namespace isogloss {

/// What the steps share: the dialect that is being linked, where its parts come from, and where its faults go.
struct Linking {
  LinkedDialect& out;
  Library& library;
  DiagnosticSink& sink;
  LinkMode mode;
  bool has_failed = false;

  void report(std::string_view code, const Location& where, std::initializer_list<std::string> arguments,
              std::string hint = {});
  /// With the severity that the dialect gives its code; an error stays one.
  void add(Diagnostic d);
};

/// "did you mean X?", or nothing where no name is near.
std::string did_you_mean(const std::string& near);

// ---- parts

/// Loads the plugins and finds the syntaxes and the dependencies, with their options.
void find_parts(Linking& linking);

/// The options of one part by declaration, typed: the given value, or the default.
std::vector<OptionValue> read_options(Linking& linking, const std::string& owner, const Location& where,
                                      std::span<const ig_option_decl> declared, const std::vector<Attribute>& given);

bool is_named(const Dialect& dialect, const ig_plugin& plugin);

std::vector<std::string> syntax_names(const ig_plugin& plugin);
std::vector<std::string> dependency_names(const ig_plugin& plugin);

/// A hint for a name that the dialect's plugins lack: the plugin that has it, or a similar name.
std::string cure(const Linking& linking, const std::string& name,
                 std::vector<std::string> (*names_of)(const ig_plugin&));
/// A hint: the dependencies that provide a service, each with its plugin where the dialect does not name that.
std::string providers(const Linking& linking, std::string_view service);
/// A hint: the syntaxes that write a field, in the same way.
std::string writers(const Linking& linking, std::string_view path);

// ---- fields

const char* type_name(ig_type type);

/// The fields that the standard sections and the chain declare, before they have ids. Its views point into its own
/// patterns, into descriptors and into the standard sections, which outlive it.
class FieldDrafts {
 public:
  struct Draft {
    FieldInfo info;
    std::string_view declared_by;
    bool has_previous = false;
  };

  explicit FieldDrafts(Linking& linking) : linking_(linking) {}

  void collect();
  /// In the order in which they are mentioned first.
  std::vector<Draft>& drafts() { return drafts_; }
  /// For the declarations of the whole chain: the number of the draft, the id of a record's field, or IG_NO_FIELD for a
  /// pattern.
  const std::vector<std::uint32_t>& declared() const { return declared_; }
  /// The patterns that the declaration holds, or the option that it names.
  const std::vector<FieldPattern>& patterns(const LinkedSyntax& s, const ig_field_decl& decl);
  /// "Parsing.Flags.X" is the same field as "Parsing.X" when some syntax lets X own words.
  std::string_view canonical(std::string_view path) const;

 private:
  void collect_owners();
  void add_owner(std::string_view path);
  std::uint32_t add_draft(std::string_view path, Draft draft);
  std::uint32_t declare(const LinkedSyntax& s, const ig_field_decl& decl, std::string_view written);
  ig_field declare_record(const LinkedSyntax& s, const ig_field_decl& decl, std::string_view list,
                          std::string_view path);

  Linking& linking_;
  std::map<std::pair<const LinkedSyntax*, const ig_field_decl*>, std::vector<FieldPattern>> patterns_;
  std::unordered_map<std::string_view, std::string_view> owners_;  // codes that own words, their path by their name
  std::vector<Draft> drafts_;
  std::unordered_map<std::string_view, std::uint32_t> draft_of_;
  std::vector<std::uint32_t> declared_;
};

/// The ids by number of the draft.
struct FieldIds {
  std::vector<ig_field> of;
  std::vector<ig_field> of_previous;  ///< of the copy from before the block, or IG_NO_FIELD
};

/// Gives the drafts their ids and moves them into the layout.
FieldIds order_fields(Linking& linking, FieldDrafts& drafts);

/// Gives each syntax the ids of what it declares, and what its patterns match.
void resolve_fields(Linking& linking, FieldDrafts& drafts, const FieldIds& ids);

// ---- state and masks

void set_initial_state(Linking& linking, const FieldDrafts& drafts);

void make_wake_masks(LinkedDialect& linked);

void find_look_ahead(LinkedDialect& linked);

}  // namespace isogloss
