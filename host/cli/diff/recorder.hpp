/// Listens to one of the two runs and sends each finished block to the comparison.
#pragma once

#include "diff/field_map.hpp"
#include "diff/line_order.hpp"
#include "diff/row_reader.hpp"
#include "diff/snapshot.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/exporter.hpp"
#include "isogloss_flow.h"

namespace isogloss::cli::parting {

class Recorder : public Exporter, public DiagnosticSink {
 public:
  /// `order` is null where both sides run the same program.
  Recorder(const LinkedDialect& linked, const FieldMap& map, int side, const LineOrder* order, std::string program,
           Channel<Snapshot>& out)
      : map_(map), side_(side), order_(order), program_(std::move(program)), out_(out), rows_(linked) {}

  void listen(Chain& chain);
  void begin(Document& initial, const SymbolTable& symbols) override;
  bool block(Document& document, const SymbolTable& symbols) override;
  bool end() override { return true; }
  void add(Diagnostic diagnostic) override {
    if (count_ != nullptr) count_->add(diagnostic);
    reported_.push_back(std::move(diagnostic));
  }
  /// From now on every report goes there, too.
  void count(DiagnosticSink& sink) { count_ = &sink; }
  /// After the run: what was reported last, and why it ended early; empty: it did not.
  void finish(std::string fault);

 private:
  /// A block on its way through the chain; with look-ahead several are.
  struct Open {
    std::string file;
    std::uint32_t line = 0, column = 0;
    std::uint64_t way = 0;
    std::uint32_t depth = 0;
    std::vector<std::uint16_t> called, makers;
    std::vector<std::uint32_t> counts;
    std::vector<std::uint64_t> made;  ///< by list: a bit for each field that the maker has given its records
    std::vector<Chain::AnsweredRow> rows;
  };
  void trace(std::uint32_t position, bool before);
  Open& open(Document& document);
  void find_way(Document& document, Open& open) const;
  void copy_cells(const Document& document, const SymbolTable& symbols, Snapshot& out);
  void copy_lists(const Document& document, const SymbolTable& symbols, const Open& open, Snapshot& out);
  std::uint16_t writer_of(const Open& open, std::size_t list, std::uint32_t index) const;
  void copy_rows(const Open& open, Snapshot& out);
  std::unique_ptr<Snapshot> blank();
  /// Kept here: a snapshot may outlive the run and its names.
  std::string_view name_of(ig_symbol symbol, const SymbolTable& symbols);

  const FieldMap& map_;
  const int side_;
  const LineOrder* const order_;
  const std::string program_;
  Channel<Snapshot>& out_;
  RowReader rows_;
  DiagnosticSink* count_ = nullptr;
  Chain* chain_ = nullptr;
  const ig_flow_1* flow_ = nullptr;
  std::vector<Open> open_;
  std::deque<std::string> texts_;
  std::vector<std::string_view> names_;  // by symbol
  std::size_t rows_before_ = 0;
  std::vector<Diagnostic> reported_;
  std::uint64_t last_way_ = 0;  // of the block before, for those of one line
  std::uint32_t last_line_ = 0, last_column_ = 0, ordinal_ = 0;
};

}  // namespace isogloss::cli::parting
