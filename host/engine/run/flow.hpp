/// Where a run is, and where it continues: frames, jumps, and the limits that end endless runs.
#pragma once

#include <set>
#include <utility>

#include "run/program_search.hpp"

namespace isogloss {

class Flow : public FlowHost {
 public:
  Flow(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
       DiagnosticSink& sink);

  Cursor& cursor() { return *cursor_; }
  /// Reports that the running file cannot be read beyond this line, and ends the run.
  void fail_to_read(std::uint32_t line) { programs_.report_unreadable(*frame_->file, line); }
  /// As long-lived as the run: blocks that wait in the look-ahead window keep it.
  const std::string& file_name() const { return frame_->file->name; }
  std::uint64_t bytes() const;
  std::uint64_t jumps() const { return jumps_; }

  /// The run begins at this program of the file; false when there is none.
  bool select_program(const std::string& name);

  /// The block that begins.
  void at(const BlockPlace& place) {
    here_ = place;
    if (is_looping_) count_loop();
    if (repeats_at_ != 0) count_repeat();
  }
  bool is_over() const { return end_.is_over(); }  ///< a limit was reached and reported
  bool has_request() const { return request_ != Go::none; }
  /// What the block asked for does not happen.
  void drop_request() { request_ = Go::none; }
  std::uint32_t depth() const { return depth_; }
  std::uint64_t call() const { return frame_->id; }
  std::uint32_t pass() const { return frame_->pass; }
  /// Executes the request of the block; `next` is where the run would continue otherwise.
  void perform(Document& document, const BlockPlace& next);
  /// The frame's text ends with this block: the caller goes on. False in the main program.
  bool request_end(const Document& document);
  /// The frame's text has ended.
  bool leave_at_end(Document& document);
  /// What the last seek has left to do: the column at which its line begins.
  std::uint32_t take_column() { return std::exchange(column_, 0u); }
  /// True once: the block there is skipped, up to this end.
  bool take_passing() { return std::exchange(passing_, false); }
  std::size_t block_end(std::string_view text) {
    const Chain::Interlude interlude;
    return programs_.indexer().block_end(text);
  }

  /// The first text after the end of the main program that this run did not execute.
  std::optional<BlockPlace> first_not_run();  ///< its column is that of the text

  void label(std::string_view, ig_label_kind) override {}
  std::int32_t go(const Document& document, ig_go& request) override;
  bool frame(std::uint32_t level, ig_frame& out) const override;
  bool is_file(std::string_view name, std::string_view wanted) const override;
  FlowHost::Request requested() const override;
  std::size_t text(std::uint64_t offset, char* buffer, std::size_t size) const override {
    return programs_.main().source->read_at(offset, buffer, size);
  }
  ig_place here() const override { return {frame_->id, here_.offset, here_.line, here_.column}; }

 private:
  using Go = FlowHost::Request::Kind;
  struct Frame {
    ProgramFile* file = nullptr;
    Cursor cursor;
    BlockPlace start;
    BlockPlace called_at, back;  // in the frame below
    std::string program;
    std::uint64_t id = 0, tag = 0;
    std::uint32_t pass = 1, passes = 1;
    bool is_local = false;  // its text is a part of the calling program
    Document::FrameValues below{};
  };

  std::int32_t ask_label(ig_go& request);
  std::int32_t call(const Document& document, ig_go& request);
  std::int32_t leave(ig_go& request);
  std::int32_t jump(ig_go& request);
  std::int32_t not_found(ig_go& request, std::string reason);
  LabelIndex& labels(ProgramFile& file) { return programs_.labels(file, here_.line); }
  void enter(Document& document, const BlockPlace& next);
  void leave_frame(Document& document, std::optional<BlockPlace> to);
  void seek(const BlockPlace& place);
  void tell_move(const BlockPlace& next) const;
  void note_jump(const BlockPlace& to);
  void count_loop();
  void count_repeat();
  void stop(std::string_view code, const BlockPlace& at, std::initializer_list<std::string> arguments);
  std::string shown(const BlockPlace& place) const;
  std::string chain_of_calls() const;

  const LinkedDialect& linked_;
  const RunOptions& options_;
  RunEnd end_;
  ProgramSearch programs_;
  std::vector<std::unique_ptr<Frame>> frames_;
  Frame* frame_ = nullptr;
  Cursor* cursor_ = nullptr;
  std::uint32_t depth_ = 0, column_ = 0;
  std::uint64_t last_id_ = 0, jumps_ = 0, loop_blocks_ = 0, refused_ = 0;
  static constexpr std::uint64_t most_refused = 1'000;  // calls that were nested too deep
  BlockPlace here_;
  bool passing_ = false;

  // The request of this block.
  Go request_ = Go::none;
  ProgramSearch::Target target_{};
  std::optional<BlockPlace> to_;
  std::string called_, reason_, jump_label_;
  std::uint64_t tag_ = 0;
  std::uint32_t repeats_ = 1;
  bool behind_ = false;

  // The loop that the run is in: blocks up to its jump, in its frame and above.
  bool is_looping_ = false;
  struct {
    std::uint64_t frame = 0;
    std::uint32_t depth = 0;
    BlockPlace from, to;
    std::uint64_t times = 0;
  } loop_;

  // The outermost call that repeats its program, and the blocks of all passes after the first.
  std::uint32_t repeats_at_ = 0;  // its depth; 0: none
  std::uint64_t repeat_blocks_ = 0;

  // What of the main file was reached by calls and jumps.
  std::set<BlockPlace> reached_;
  BlockPlace last_reached_{UINT64_MAX, 0, 0};
};

}  // namespace isogloss
