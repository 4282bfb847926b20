#include "isogloss/engine/scan.hpp"

#include <algorithm>
#include <bit>

#include "contract/flow_host.hpp"
#include "run/cursor.hpp"

namespace isogloss {

namespace {

class BlockScanner : public FlowHost {
 public:
  BlockScanner(const LinkedDialect& linked, const RunOptions& options)
      : options_(options),
        chain_(linked, settings_of(options), ignored_),
        segmenter_(linked.dialect.segmenter),
        comment_(linked.layout.id("Comment.Text")),
        number_(linked.layout.id("Source.N")) {
    chain_.collect_labels();
    chain_.flow = this;
    chain_.scanned = [this](std::uint32_t reader, std::size_t begin, std::size_t end) {
      add_piece(reader, begin, end);
    };
  }

  void visit(Source& source, const std::string& name, const std::function<bool(const ScannedBlock&)>& visit) {
    chain_.start(name);
    Cursor cursor(source, options_.maximum_line_bytes, segmenter_);
    for (Line line; cursor.next(line);)
      if (!visit_line(line, name, visit) || chain_.ends_file || (line.number == 1 && cursor.is_utf16())) return;
  }

  void label(std::string_view name, ig_label_kind kind) override {
    if (kind != IG_LABEL_PROGRAM || !name.ends_with('/'))
      labels_.push_back({std::string(name), kind == IG_LABEL_PROGRAM, 0, 0});
  }
  std::int32_t go(const Document&, ig_go&) override { return IG_GO_DONE; }
  bool frame(std::uint32_t, ig_frame&) const override { return false; }
  ig_place here() const override { return here_; }
  bool is_file(std::string_view, std::string_view) const override { return false; }

 private:
  static ChainSettings settings_of(const RunOptions& options) {
    ChainSettings out = options.chain;
    out.mode = Mode::fast;
    return out;
  }

  void add_piece(std::uint32_t reader, std::size_t begin, std::size_t end) {
    pieces_.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), reader});
    for (std::size_t i = placed_; i < labels_.size(); ++i) {
      labels_[i].begin = pieces_.back().begin;
      labels_[i].end = pieces_.back().end;
    }
    placed_ = labels_.size();
  }

  bool visit_line(const Line& line, const std::string& name, const std::function<bool(const ScannedBlock&)>& visit) {
    std::size_t column = 0;
    while (column < line.text.size()) {
      const std::string_view rest = line.text.substr(column);
      if (rest.find_first_not_of(" \t\r\n") == std::string_view::npos) break;
      BlockSource source{name, line.number, static_cast<std::uint32_t>(column), rest, line.lines > 1};
      if (source.is_joined && column > 0) {
        const LinePlace place = LinePlace::of(line.text, column);
        source.line += place.line;
        source.column = static_cast<std::uint32_t>(column - place.begin);
      }
      here_ = {0, line.offset, line.number, static_cast<std::uint32_t>(column)};
      pieces_.clear();
      labels_.clear();
      placed_ = 0;
      chain_.begin_block(source);
      const std::size_t end = chain_.scan();
      if (!visit(block_of(source, rest.substr(0, end)))) return false;
      ignored_.all.clear();
      if (chain_.ends_file) return true;
      column += std::max<std::size_t>(end, 1);
    }
    return true;
  }

  ScannedBlock block_of(const BlockSource& source, std::string_view text) {
    const Document& d = chain_.document();
    words_.clear();
    for (std::uint32_t w = 0; w < d.words(); ++w) {
      const Document::Bits& bits = d.bits(w);
      for (std::uint64_t left = bits.present & bits.fresh & bits.words; left != 0; left &= left - 1) {
        const ig_field f = w * 64 + static_cast<ig_field>(std::countr_zero(left));
        if (d.word_end(f) > d.word_begin(f) && d.word_end(f) <= text.size())
          words_.push_back({d.word_begin(f), d.word_end(f), f});
      }
    }
    std::sort(words_.begin(), words_.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
    ScannedBlock out{source.line, source.column, text, pieces_, words_, labels_, {}, 0, 0};
    if (d.fresh(comment_) && d.present(comment_)) {
      out.comment = d.text(comment_);
      out.comment_reader = d.writer(comment_);
    }
    if (d.fresh(number_) && d.present(number_)) out.number_reader = d.writer(number_);
    return out;
  }

  const RunOptions& options_;
  DiagnosticList ignored_;
  Chain chain_;
  const Segmenter& segmenter_;
  ig_field comment_, number_;
  ig_place here_{};
  std::vector<ScannedPiece> pieces_;
  std::vector<ScannedWord> words_;
  std::vector<ScannedLabel> labels_;
  std::size_t placed_ = 0;
};

}  // namespace

void scan_blocks(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
                 const std::function<bool(const ScannedBlock&)>& visit) {
  std::make_unique<BlockScanner>(linked, options)->visit(source, name, visit);
}

}  // namespace isogloss
