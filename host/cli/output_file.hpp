/// Where data goes: standard output, or a file that appears only when it is complete.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "isogloss/engine/exporter.hpp"

namespace isogloss::cli {

/// One buffer of 256 KiB over write(2). What is not committed is thrown away with its temporary file.
class OutputFile : public Output {
 public:
  static std::unique_ptr<OutputFile> standard_output();
  /// A regular file is written aside and renamed by commit(); a pipe or character device is written directly; all
  /// else is refused. Null with the reason in `error`.
  static std::unique_ptr<OutputFile> open(const std::string& path, std::string& error);
  ~OutputFile() override;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  bool write(std::string_view bytes) override;
  /// The limit of the output: write() refuses bytes beyond it.
  void allow(std::uint64_t bytes) { allowance_ = bytes; }
  bool is_over_allowance() const { return is_over_allowance_; }
  /// Writes what waits, closes and renames; false with error() set, or when the reader is gone.
  bool commit();

  /// The reader went away, which is no error.
  bool reader_is_gone() const { return reader_is_gone_; }
  /// Why a write failed; empty when none did.
  const std::string& error() const { return error_; }

 private:
  OutputFile(int descriptor, std::string target, std::string temporary);
  bool write_through(std::string_view bytes);
  bool flush();
  void fail(int number);

  int descriptor_;
  std::string target_, temporary_;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
  std::uint64_t allowance_ = UINT64_MAX;
  bool reader_is_gone_ = false, is_over_allowance_ = false;
  std::string error_;
};

/// Writes a command's whole result to standard output; `status`, or cannot_start when it could not be written.
int print(std::string_view text, int status);

}  // namespace isogloss::cli
