/// What the scanners of files in MACRO format share: the format of the program, and the text of the block.
#pragma once

#include <array>
#include <set>
#include <utility>
#include <vector>

#include <isogloss/cnc/frame_tag.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_scan.hpp"
#include "macro/macro_store.hpp"

namespace syntec {

/// From ! to the last byte: a scanner that is asked at each beginning.
inline constexpr auto every_byte = [] {
  std::array<char, 224> out{};
  for (std::size_t i = 0; i + 1 < out.size(); ++i) out[i] = static_cast<char>('!' + i);
  return out;
}();

/// ProgramFormat.Term, which has no value before the first file in MACRO format: scanners that read it may be asked
/// ahead.
class FormatField {
 public:
  explicit FormatField(ig::Access access)
      : field_("ProgramFormat.Term", access,
               {ig::Life::modal, "", "Format of the program, MACRO or ISO; absent before the first file in MACRO."}) {}
  bool is_known(const ig::Block& b) const { return b.has(field_); }
  bool is_macro(const ig::Block& b) const { return b.is(field_, macro_); }
  void set_macro(ig::Block& b) const { b.set(field_, macro_); }
  void set_iso(ig::Block& b) const { b.set(field_, iso_); }

 private:
  ig::Field<ig::Symbol> field_;
  ig::Name macro_{"MACRO"}, iso_{"ISO"};
};

/// A call that a block of words asks for.
struct WordCall {
  std::string code{};  ///< G65, G200, M123
  std::string file{};  ///< of a code's macro
  std::size_t begin = 0, end = 0;

  ig::Where where() const { return ig::Where::columns(begin, end); }
};

/// The scanners of a chain, for the block that is scanned.
struct MacroScanState {
  static constexpr std::uint64_t no_frame = ~std::uint64_t{0};
  static constexpr const char* label_of_mark = "%@MACRO";

  MacroComment comment{};
  StatementCollector statement{};
  std::uint32_t statement_line = 0;  ///< in which it began
  // Of a block of words:
  std::string words{};  ///< its text with blanks for comments
  Arguments arguments{};
  std::vector<WordCall> calls{};
  std::string program{};  ///< of P"NAME"
  bool has_refused_p = false;

  // Which program the block belongs to:
  std::set<std::string, std::less<>> macro_files{};
  std::string file{};
  std::uint64_t frame = no_frame;
  std::uint32_t pass = 0;

  void restart() { *this = {}; }
  void begin_words(std::string_view text) {
    words.assign(text);
    arguments = {};
    calls.clear();
    program.clear();
    has_refused_p = false;
  }

  /// The block is the first one of a file in MACRO format.
  void begin_macro(ig::Block& b, const ig::Flow& flow, const FormatField& format) {
    if (flow.is_indexing()) {  // of a file that a call may enter behind the mark, or of the one that runs
      flow.label(b, label_of_mark);
      return format.set_macro(b);
    }
    const ig_frame now = flow.frame(b);
    file = ig::to_view(now.file);
    frame = now.id;
    pass = now.pass;
    macro_files.insert(file);
    format.set_macro(b);
  }
  /// At the beginning of a block: one of another frame than the block before may be of a file in the other format.
  void enter(ig::Block& b, const ig::Flow& flow, const FormatField& format) {
    const ig_frame now = flow.frame(b);
    if (now.id == frame && now.pass == pass) return;
    const bool is_first = std::exchange(frame, now.id) == no_frame;
    pass = now.pass;
    const std::string before = std::exchange(file, std::string(ig::to_view(now.file)));
    const bool is_behind_mark = (now.tag & ig::cnc::begins_inside) != 0 && flow.has_label(b, label_of_mark);
    if (is_behind_mark) macro_files.insert(file);
    if (!is_first) end_program(b, before);
    if (!is_behind_mark && (is_first || !format.is_known(b))) return;
    if (macro_files.contains(file))
      format.set_macro(b);
    else
      format.set_iso(b);
  }

  /// Reports a statement, or a comment, that the end of its program has cut.
  void end_program(ig::Block& b, std::string_view of) {
    if (statement.is_begun())
      b.report(ig::diag("SYN-0053"), ig::Where::block(), static_cast<double>(statement_line), of);
    else if (comment.is_open)
      b.report(ig::diag("SYN-0057"), ig::Where::block(), static_cast<double>(comment.line), of);
    statement.clear();
    comment = {};
  }
};

inline constexpr const char* macro_scan_service = "syntec.macro-scan/1";

/// A member of each of these scanners; a state of its own where the dialect has no SyntecVariables.
class SharedScan {
 public:
  SharedScan() : service_(macro_scan_service, ig::Need::optional, "What scanners of the MACRO format share.") {}
  MacroScanState* operator->() const { return service_ ? const_cast<MacroScanState*>(service_.operator->()) : &own_; }

 private:
  ig::Service<MacroScanState> service_;
  mutable MacroScanState own_;
};

}  // namespace syntec
