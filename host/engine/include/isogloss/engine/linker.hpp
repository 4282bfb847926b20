/// From a dialect and plugins to a chain that can run: ids, wake masks, checks. A linked dialect never changes and may
/// be shared by threads; each run makes its own Chain of it.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/layout.hpp"
#include "isogloss/engine/library.hpp"

namespace isogloss {

/// An option's value, typed.
struct OptionValue {
  std::string text;
  double number = 0;
  std::int64_t integer = 0;  ///< boolean, index of the choice
};

/// A symbol or number that a field must have at the start of a block to wake a syntax.
struct WakeWhile {
  ig_field field;
  ig_symbol value;  ///< 0: any
  std::uint32_t position;
};

class Document;

/// A syntax that reads blocks ahead.
struct LookAhead {
  std::uint32_t position;
  std::uint32_t blocks;        ///< at most
  std::vector<ig_field> ends;  ///< a block that has one of these is the last that it reads
  bool ends_at(const Document& block) const;
  /// True where the syntax needs no block beyond these, which follow the one that it looks ahead from.
  bool is_satisfied_by(std::span<Document* const> following) const;
};

struct LinkedSyntax {
  explicit LinkedSyntax(const ChainElement& named) : element(named) {}

  const ChainElement& element;  ///< of LinkedDialect::dialect
  const ig_syntax* syntax = nullptr;
  const ig_plugin* plugin = nullptr;
  std::vector<ig_field> ids;                      ///< by declaration
  std::vector<std::vector<ig_field>> expansions;  ///< by declaration; only patterns have some
  std::vector<OptionValue> options;
  std::vector<std::uint64_t> may_read, may_write, may_take;  ///< by field, for the checked table
};

struct LinkedDependency {
  explicit LinkedDependency(const DependencyElement& named) : element(named) {}

  const DependencyElement& element;  ///< of LinkedDialect::dialect
  const ig_dependency* dependency = nullptr;
  const ig_plugin* plugin = nullptr;
  std::vector<OptionValue> options;
};

/// Neither copied nor moved: its parts refer to its dialect.
struct LinkedDialect {
  LinkedDialect() = default;
  LinkedDialect(const LinkedDialect&) = delete;
  LinkedDialect& operator=(const LinkedDialect&) = delete;

  Dialect dialect;
  Layout layout;
  SymbolTable symbols;
  std::vector<LinkedSyntax> chain;  ///< in order; parsing first, inspection last
  std::vector<LinkedDependency> dependencies;
  std::vector<std::uint64_t> wake;  ///< wake_words masks a field, then a list; each syntax has its wake_bit()
  std::uint32_t wake_words = 2;     ///< 2 to most_wake_words
  std::uint32_t first_build = 0;    ///< chain position; the scanners before it have no build() and are never awake
  std::vector<WakeWhile> wake_while;
  std::uint32_t post_logic_begin = 0, inspection_begin = 0;  ///< chain positions
  std::vector<LookAhead> look_ahead;                         ///< in the order of the chain
  std::vector<std::pair<ig_field, ig_value>> initial;

  std::optional<std::uint32_t> position(std::string_view alias) const;
};

/// A whole dialect, or a few syntaxes alone (cases, apply): then nothing needs a writer or an order.
enum class LinkMode { whole, parts };

/// Checks and links. Reports every fault that it finds, not only the first; empty when there was an error.
std::unique_ptr<LinkedDialect> link(Dialect dialect, Library& library, DiagnosticSink& sink,
                                    LinkMode mode = LinkMode::whole);

/// A service and the dependencies that offer it, by their places in the dialect: the first one answers.
struct Provision {
  std::string service;
  std::vector<std::size_t> dependencies;
};
std::vector<Provision> provisions(const LinkedDialect& linked);

/// What is not wrong but has no effect, or can never happen: what `lint` reports beyond the faults of link().
std::vector<Diagnostic> review(const LinkedDialect& linked);

/// The positions of the chain that no program can wake: nothing writes what wakes them.
std::vector<std::uint32_t> never_called(const LinkedDialect& linked);

/// An order of the chain that satisfies after/before and moves as few elements as possible, rather the dialect's own
/// than inherited ones; empty when there is none: for `lint --suggest`.
std::vector<std::string> suggest_order(const Dialect& dialect, Library& library);

/// Why there is no such order: the shortest ring of constraints, a sentence for each; empty when there is an order.
std::vector<std::string> order_ring(const Dialect& dialect, Library& library);

}  // namespace isogloss
