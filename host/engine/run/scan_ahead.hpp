/// Scans the lines of a program ahead of the run, on a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "contract/flow_host.hpp"
#include "isogloss/engine/scanned_line.hpp"
#include "run/apart.hpp"
#include "run/cursor.hpp"

namespace isogloss {

/// A second instance of the chain reads the text on from a place and scans it. The run takes what is ready for the line
/// whose turn it is and scans by itself what is not, so it never waits for the thread. Where it finds nothing it asks,
/// and the thread goes on at some distance before it, so that few lines are scanned by both.
class ScanAhead : FlowHost {
 public:
  /// Throws where no thread can be started.
  ScanAhead(const LinkedDialect& linked, const RunOptions& options, std::unique_ptr<Source> source, std::string file);
  ~ScanAhead() override;

  /// What was found in the line that begins here, where it is the next one that was scanned: a line of its own, and not
  /// left. Alive until the next call, as is what find() gives; null: ask find().
  const ScannedLine* next_at(std::uint64_t offset) const {
    if (next_ == end_) return nullptr;
    const auto& next = *reinterpret_cast<const ScannedLine*>(next_);
    return next.offset == offset && !next.is_left ? &next : nullptr;
  }
  /// The run has come to that line.
  void take(const ScannedLine& next) {
    next_ += next.bytes();
    ++hits_;
    misses_ = 0;
  }
  /// What was found in this line; null: scan it.
  const ScannedLine* find(const Line& line);

 private:
  /// Lines go from thread to thread by thousands of bytes: a byte that both use costs as much as many of its own. A
  /// batch belongs to one thread at a time, so nothing is copied.
  struct Batch {
    static constexpr std::size_t most_bytes = 16 * 1024;
    std::uint32_t asked = 0;  ///< the last question that the thread knew
    std::uint32_t size = 0;
    alignas(LineNotes) std::byte bytes[most_bytes];

    bool has_room() const { return most_bytes - size >= sizeof(LineNotes); }
    /// Where the notes of the next line are written, while there is room.
    LineNotes& next() { return *::new (bytes + size) LineNotes; }
    void keep(const LineNotes& next) { size += static_cast<std::uint32_t>(next.line.bytes()); }
  };
  static constexpr std::uint32_t batches = 16;
  static constexpr std::size_t cache_line = 64;

  // isogloss.flow/1 answers in its turn only.
  void label(std::string_view, ig_label_kind) override { leave(); }
  std::int32_t go(const Document&, ig_go&) override { return leave(), IG_GO_DONE; }
  bool frame(std::uint32_t, ig_frame&) const override { return leave(), false; }
  ig_place here() const override { return leave(), ig_place{}; }
  std::size_t text(std::uint64_t, char*, std::size_t) const override { return leave(), 0; }
  bool is_file(std::string_view, std::string_view) const override { return false; }
  void leave() const { chain_->notes->leave(); }

  bool take_batch();
  void give_back();
  void ask(std::uint64_t place);
  void work();
  bool answer();
  bool hand_over();
  bool is_useless() const { return scanned_ >= enough_lines && left_ > scanned_ / 4 * 3; }
  void begin(const Line& line, Document::Summary& out);
  void scan(const Line& line);

  static constexpr std::uint64_t enough_lines = 4096;
  static constexpr std::uint32_t least_patience = 4, most_patience = 1u << 24;  // in lines
  static constexpr std::uint64_t enough_hits = 64;  // that an answer has to give, for the next question to come at once
  // The run's.
  const std::byte *next_ = nullptr, *end_ = nullptr;  // of the batch that it reads
  bool has_batch_ = false;
  std::uint32_t questions_ = 0;
  std::uint32_t patience_ = least_patience, misses_ = 0;  // lines in a row for which nothing was ready
  std::uint64_t from_ = 0;                                // where the answer to the last question may begin
  std::uint64_t hits_ = 0;                                // since then
  // The thread's.
  alignas(cache_line) DiagnosticList ignored_;
  const LinkedDialect& linked_;
  ChainSettings settings_;
  std::unique_ptr<Chain> chain_;
  std::optional<Apart> apart_;
  std::unique_ptr<Source> source_;
  std::string file_;
  Cursor cursor_;
  Batch* filling_ = nullptr;
  std::uint64_t scanned_ = 0, left_ = 0;
  bool is_plain_ = false;  ///< the line before: nothing but what was summed up has to be undone
  // Both threads'.
  alignas(cache_line) std::unique_ptr<Batch[]> shared_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<std::uint32_t> ready_ = 0;  // batches so far
  std::uint32_t done_ = 0;                // of these the run has so many
  std::atomic<std::uint32_t> asked_ = 0;  // questions so far
  std::atomic<int> run_on_ = -1;          // the processor of the run
  std::atomic<bool> is_built_ = false;    // the thread's chain: it can be asked
  bool stops_ = false, has_ended_ = false;
  std::thread thread_;
  // Where nothing was ready last: often written, seldom read, and so apart from the others.
  alignas(cache_line) std::atomic<std::uint64_t> run_at_ = 0;
};

}  // namespace isogloss
