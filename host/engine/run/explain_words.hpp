/// Who reads and uses the words of a block: watches them while it is scanned and built.
#pragma once

#include "isogloss/engine/explain.hpp"

namespace isogloss {

class WordLog {
 public:
  explicit WordLog(const LinkedDialect& linked) : linked_(&linked) {}

  /// The scanner at this position of the chain has read a piece of the text.
  void scanned(std::uint32_t position, std::size_t begin, std::size_t end) {
    pieces_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), position});
  }
  /// Compares the words with those seen last: the syntax at this position of the chain + 1 (0: the scanners) has used
  /// those that are gone.
  void look(const Document& document, std::uint16_t user);
  /// All words, and the text between them, by column.
  std::vector<ExplainedWord> words(std::string_view text) const;

 private:
  struct Seen {
    std::uint32_t begin, end;
    ig_field field;
    bool is_taken;
    ExplainedWord word;
  };
  struct Piece {
    std::uint32_t begin, end;
    std::uint32_t reader;
  };
  void follow(const Document& document, Seen& seen, std::uint16_t user);
  void find_new(const Document& document);
  bool is_seen(ig_field f) const;
  void add_text(std::string_view text, std::uint32_t begin, std::uint32_t end, const std::string& reader,
                std::vector<ExplainedWord>& out) const;

  const LinkedDialect* linked_;
  std::vector<Seen> seen_;
  std::vector<Piece> pieces_;
};

}  // namespace isogloss
