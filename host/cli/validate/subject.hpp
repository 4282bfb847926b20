/// The plugin under test, loaded, and benches on which one of its syntaxes runs alone.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/document_json.hpp"
#include "validate/check.hpp"

namespace isogloss::cli {

/// The plugin is loaded, and so are those of the installation, which give vocabulary and services.
class Subject {
 public:
  /// Throws std::runtime_error with the reason when the plugin does not load.
  explicit Subject(Examination& e);
  const ig_plugin& plugin() const { return *plugin_; }
  const LoadedPlugin& loaded() const { return *loaded_; }
  Library& library() { return session_.library(); }
  const Surroundings& surroundings() const { return surroundings_; }
  /// The plugin's own dependencies answer, too, behind those of the default dialect; a dialect that the user named
  /// stays as it is.
  void add_own_dependencies();
  /// No dependency answers; syntaxes that cannot be without one leave the chain.
  void remove_services();
  std::span<const ig_syntax* const> syntaxes() const { return {plugin_->syntaxes, plugin_->syntax_count}; }

 private:
  Session session_;
  const ig_plugin* plugin_ = nullptr;
  const LoadedPlugin* loaded_ = nullptr;
  Surroundings surroundings_;
};

/// Does linking refuse the syntax when nobody answers?
bool requires_service(const ig_syntax& syntax);

/// A page, from the plugin or from a file of --pages.
struct PageText {
  std::string name, text;
};
std::vector<PageText> pages_of(const Subject& subject, const ValidateOptions& options);

/// One field of a block, and its value.
struct Assignment {
  ig_field field = IG_NO_FIELD;
  ig_value value{};
  std::string text;  ///< of a text field
};

/// A block before the build of a syntax.
struct TestBlock {
  std::string name;
  Json before{}, previous{};  ///< as in a case; may be null
  std::string text{};         ///< of the program, for a scanner
  std::vector<Assignment> assignments{};
  std::vector<ig_field> absent{};
};

/// What one build did.
struct Trial {
  ig_status status = IG_UNCHANGED;
  bool has_changed = false;
  std::vector<Diagnostic> diagnostics;
  std::string shown;  ///< the document afterwards and the codes reported

  /// Why the build broke the contract; empty when it did not. With `reported_only` neither status nor values count.
  std::string fault(bool reported_only = false) const;
};

/// The work of this thread so far, which a busy machine does not change.
double thread_seconds();

/// Of a chain with these functions.
ChainSettings in_mode(Mode mode);

/// A chain of which one syntax is built. The linked dialect stays alive longer.
class Bench {
 public:
  Bench(const LinkedAlone& alone, ChainSettings settings);
  /// Builds on this block, as if nothing had been before it but what the syntax itself keeps.
  Trial run(const TestBlock& block, bool shows = true);
  /// The same, repeatedly and without a look at the result: nanoseconds of one build.
  double time(const TestBlock& block, int repeats);
  /// The block as build() will find it, then one build() and nothing else.
  void prepare(const TestBlock& block);
  /// The text of the block, where the syntax has a scanner.
  void scan() {
    if (read_text) return read_text(*chain_);
    if (alone_.linked->chain[alone_.position].syntax->scan != nullptr) chain_->scan_with(alone_.position);
  }
  ig_status build() { return chain_->build(alone_.position); }
  /// What the build will find, as JSON for `isogloss apply`.
  std::string show(const TestBlock& block);
  void start();
  Chain& chain() { return *chain_; }

  /// Where the text of a block stands while the block is built; empty: in the block.
  std::function<std::string_view(std::string_view)> place_text;
  /// Gives the block what is in its text, in place of the scanner; empty: the scanner does.
  std::function<void(Chain&)> read_text;

 private:
  DiagnosticList said_;
  const LinkedAlone& alone_;
  std::unique_ptr<Chain> chain_;
  std::optional<Document> clean_;
  std::vector<std::pair<DependencyTable*, DependencyTable>> tables_;
};

/// Why a chain cannot be created; empty when it can.
std::string creation_fault(const LinkedAlone& alone, const ChainSettings& settings);

/// One syntax with the blocks of its cases that share their dependencies.
struct Stand {
  const ig_syntax* syntax = nullptr;
  std::string dependencies;  ///< XML
  LinkedAlone alone;
  std::vector<TestBlock> blocks;
};

/// For each syntax one stand with its default options and an empty block, and one for each of the first few
/// dependencies of its cases. What cannot be created is left out: the check of the options tells it, and the others
/// say that they did not look at it.
enum class Missing { is_told, is_told_elsewhere };
std::vector<Stand> stands_of(Subject& subject, Examination& e, Missing what = Missing::is_told);

/// The fields that a syntax has declared, without those of lists' records; patterns as far as a check can go.
std::vector<ig_field> fields_of(const LinkedAlone& alone);
/// Block number k of the seed for this syntax: the same on every machine, whatever came before.
TestBlock random_block(const Stand& stand, const std::vector<ig_field>& fields, std::uint64_t seed, std::uint64_t k);
/// All fields of the syntax, each number being this one.
TestBlock block_of_numbers(const Stand& stand, double number);
/// Numbers that few programs have, and that a syntax may treat in another way.
inline constexpr double rare_numbers[] = {-950.0, 950.0, -1e6, 0.0};
/// The blocks of the stand, one with all declared fields, and the first random ones.
std::vector<TestBlock> many_blocks(const Stand& stand, const Examination& e, std::uint64_t random_ones);
/// Texts that a program can hold and that nobody expects: cut characters, NUL, control characters, open brackets.
const std::vector<std::string>& odd_texts();
/// A block in which each of these fields has an everyday value.
TestBlock full_block(const LinkedAlone& alone, const std::vector<ig_field>& fields);

}  // namespace isogloss::cli
