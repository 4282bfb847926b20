#include "isogloss/engine/stepping.hpp"

#include "isogloss/engine/program_text.hpp"
#include "run/program_files.hpp"

namespace isogloss {

namespace {

/// Anything but a comment: a value of the text, or text that nothing has read.
bool holds_statement(const Document& d) {
  const Layout& layout = d.layout();
  for (ig_field f = 0; f < d.size(); ++f)
    if (d.present(f) && d.fresh(f) && !layout.fields[f].hidden && !layout.fields[f].path.starts_with("Comment."))
      return true;
  for (const ListData& list : d.lists)
    if (list.count != 0) return true;
  return d.has_leftovers();
}

/// Its scanners alone are at work, as where a file is indexed.
class ScanningChain : public FlowHost {
 public:
  ScanningChain(const LinkedDialect& linked, ChainSettings settings) : chain_(linked, std::move(settings), ignored_) {
    chain_.collect_labels();
    chain_.flow = this;
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
      column += std::max<std::size_t>(chain_.scan(), 1);
      found = found || holds_statement(chain_.document());
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
