/// Scans the lines of a program ahead of the run, on a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "contract/flow_host.hpp"
#include "isogloss/engine/scanned_line.hpp"
#include "run/cursor.hpp"

namespace isogloss {

/// A second instance of the chain reads the text on from a place and scans it. The run takes what is ready for the line
/// whose turn it is and scans by itself what is not, so it never waits for the thread.
class ScanAhead : FlowHost {
 public:
  /// Throws where no thread can be started.
  ScanAhead(const LinkedDialect& linked, const RunOptions& options, std::unique_ptr<Source> source, std::string file);
  ~ScanAhead() override;

  /// What was found in this line; null: scan it. Alive until the next call.
  const ScannedLine* find(const Line& line);
  /// The bytes of the text of the line that begins here, where it has been scanned: a line of its own, and not left.
  std::optional<std::uint32_t> size_at(std::uint64_t offset) const {
    if (at_ >= taken_.size) return std::nullopt;
    const auto& next = *reinterpret_cast<const ScannedLine*>(taken_.bytes + at_);
    return next.offset == offset && !next.is_left ? std::optional(next.size) : std::nullopt;
  }

 private:
  /// Lines go from thread to thread by thousands of bytes: a byte that both use costs as much as many of its own.
  struct Batch {
    static constexpr std::size_t most_bytes = 32 * 1024;
    std::uint32_t epoch = 0;  ///< counts the places from which the thread was to read on
    std::uint32_t size = 0;
    alignas(LineNotes) std::byte bytes[most_bytes];

    bool has_room() const { return most_bytes - size >= sizeof(LineNotes); }
    /// Where the notes of the next line are written, while there is room.
    LineNotes& next() { return *::new (bytes + size) LineNotes; }
    void keep(const LineNotes& next) { size += static_cast<std::uint32_t>(next.line.bytes()); }
    void copy_from(const Batch& other);
  };
  static constexpr std::uint32_t batches = 8;
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
  void read_on_from(std::uint64_t offset);
  void work();
  bool hand_over();
  void seek();
  bool is_useless() const { return scanned_ >= enough_lines && left_ > scanned_ / 4 * 3; }
  void scan(const Line& line);

  static constexpr std::uint64_t enough_lines = 4096;
  static constexpr std::uint32_t least_patience = 256;
  // The run's.
  Batch taken_;
  std::size_t at_ = 0;
  std::uint32_t epoch_ = 0, patience_ = 0, misses_ = 0;
  std::uint64_t from_ = 0, hits_ = 0;
  // The thread's.
  alignas(cache_line) DiagnosticList ignored_;
  const LinkedDialect& linked_;
  ChainSettings settings_;
  std::unique_ptr<Chain> chain_;
  std::unique_ptr<Source> source_;
  std::string file_;
  Cursor cursor_;
  Batch filling_;
  std::uint64_t scanned_ = 0, left_ = 0;
  // Both threads'.
  alignas(cache_line) std::unique_ptr<Batch[]> shared_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<std::uint32_t> ready_ = 0;  // batches so far
  std::uint32_t done_ = 0;                // of these the run has so many
  std::atomic<std::uint32_t> asked_ = 0;  // the epoch that begins at ...
  std::uint64_t asked_offset_ = 0;
  std::atomic<bool> is_built_ = false;  // the thread's chain: it can be asked
  bool stops_ = false, has_ended_ = false;
  std::thread thread_;
};

}  // namespace isogloss
