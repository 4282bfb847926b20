/// Where data goes: standard output, or a file that appears only when it is complete.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/exporter.hpp"

namespace isogloss::cli {

/// One buffer of 256 KiB over write(2). What is not committed is thrown away with its temporary file.
class OutputFile : public Output {
 public:
  static std::unique_ptr<OutputFile> standard_output();
  /// A regular file is written aside and renamed by commit(); a pipe or character device is written directly; all
  /// else is refused. Null with the reason in `error`.
  static std::unique_ptr<OutputFile> open(const std::string& path, std::string& error);
  /// A file that another process has opened for this one, which cannot; commit() tells it so, and it renames the file.
  struct Prepared {
    std::string path;
    int descriptor = -1;  ///< -1: it cannot be opened, which `error` explains
    std::string error;
    std::atomic<bool>* is_complete = nullptr;
  };
  /// From now on open() gives these and no others.
  static void use_prepared(std::vector<Prepared> files);
  /// For the one who prepares.
  int descriptor() const { return descriptor_; }
  ~OutputFile() override;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  bool write(std::string_view bytes) override;
  /// The limit of the output: write() refuses bytes beyond it.
  void allow(std::uint64_t bytes) { allowance_ = bytes; }
  bool is_over_allowance() const { return is_over_allowance_; }
  /// Writes what waits and closes, so that nothing but the new name can fail in commit(); false as that.
  bool complete();
  /// Completes and renames; false with error() set, or when the reader is gone.
  bool commit();
  /// Removes the temporary files of `path` that killed processes have left. The caller knows that none is at work.
  static void remove_left_behind(const std::string& path);

  /// The reader went away, which is no error.
  bool reader_is_gone() const { return reader_is_gone_; }
  /// Why a write failed; empty when none did.
  const std::string& error() const { return error_; }

 private:
  OutputFile(int descriptor, std::string target, std::string temporary);
  bool write_through(std::string_view bytes);
  bool flush();
  static std::unique_ptr<OutputFile> open_prepared(const std::string& path, std::string& error);
  void fail(int number);

  int descriptor_;
  std::string target_, temporary_;
  std::atomic<bool>* is_complete_ = nullptr;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
  std::uint64_t allowance_ = UINT64_MAX;
  bool reader_is_gone_ = false, is_over_allowance_ = false;
  std::string error_;
};

/// Writes a command's whole result to standard output; `status`, or cannot_start when it could not be written.
int print(std::string_view text, int status);

}  // namespace isogloss::cli
