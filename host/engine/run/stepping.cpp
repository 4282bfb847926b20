#include "isogloss/engine/stepping.hpp"

#include "isogloss/engine/program_text.hpp"
#include "run/program_files.hpp"

namespace isogloss {

namespace {

/// A syntax that shows nothing but comments and tape marks.
bool reads_remarks(const LinkedSyntax& syntax, const Layout& layout) {
  bool writes = false;
  for (ig_field f = 0; f < layout.fields.size(); ++f) {
    if (f / 64 >= syntax.may_write.size() || (syntax.may_write[f / 64] >> (f % 64) & 1) == 0) continue;
    const FieldInfo& info = layout.fields[f];
    if (info.hidden) continue;
    if (!info.path.starts_with("Comment.") && !info.path.starts_with("TapeBoundary.")) return false;
    writes = true;
  }
  return writes;
}

/// Its scanners alone are at work, as where a file is indexed.
class ScanningChain : public FlowHost {
 public:
  ScanningChain(const LinkedDialect& linked, ChainSettings settings) : chain_(linked, std::move(settings), ignored_) {
    chain_.collect_labels();
    chain_.flow = this;
    for (const LinkedSyntax& syntax : linked.chain) reads_remarks_.push_back(reads_remarks(syntax, linked.layout));
    chain_.scanned = [this](std::uint32_t position, std::size_t begin, std::size_t end) {
      has_statement_ = has_statement_ || (end > begin && !reads_remarks_[position]);
    };
    chain_.start();
  }

  /// Does a statement begin on the line? False in `goes_on` when the text ends here.
  bool holds_statement_in(const Line& line, bool& goes_on) {
    bool found = false;
    for (std::size_t column = 0; column < line.text.size();) {
      const std::string_view rest = line.text.substr(column);
      if (rest.find_first_not_of(" \t\r\n") == std::string_view::npos) break;
      at_ = {0, line.offset, line.number, static_cast<std::uint32_t>(column)};
      chain_.begin_block({{}, line.number, static_cast<std::uint32_t>(column), rest, line.lines > 1});
      has_statement_ = false;
      column += std::max<std::size_t>(chain_.scan(), 1);
      found = found || has_statement_ || chain_.document().has_leftovers();
      ignored_.all.clear();
      goes_on = !chain_.ends_file;
      if (!goes_on) break;
    }
    return found;
  }

  void label(std::string_view, ig_label_kind) override {}
  std::int32_t go(const Document&, ig_go&) override { return IG_GO_DONE; }
  bool frame(std::uint32_t, ig_frame&) const override { return false; }
  ig_place here() const override { return at_; }
  bool is_file(std::string_view, std::string_view) const override { return false; }

 private:
  DiagnosticList ignored_;
  Chain chain_;
  std::vector<bool> reads_remarks_;  // by chain position
  bool has_statement_ = false;       // in the present block
  ig_place at_{};
};

}  // namespace

std::string assignment_text(Chain& chain, std::string_view name, std::string_view value) {
  const ProgramText texts = ProgramText::of(chain);
  std::string out;
  const auto values = [&](std::string_view wanted, std::string_view, std::string& to) {
    to += wanted == "NAME" ? name : wanted == "VALUE" ? value : std::string_view();
    return wanted == "NAME" || wanted == "VALUE";
  };
  const ProgramText::Row* const row = texts.find("assign variable");
  if (row != nullptr && row->block.fill(values, out)) return out;
  return std::string(name) + "=" + std::string(value);
}

std::vector<BlockLine> find_block_lines(const LinkedDialect& linked, Source& source, const RunOptions& options) {
  ChainSettings settings = options.chain;
  settings.mode = Mode::fast;
  ScanningChain chain(linked, settings);
  Cursor cursor(source, options.maximum_line_bytes, linked.dialect.segmenter);
  std::vector<BlockLine> out;
  bool goes_on = true;
  for (Line line; goes_on && cursor.next(line);)
    if (chain.holds_statement_in(line, goes_on)) out.push_back({line.number, line.lines});
  return out;
}

}  // namespace isogloss
