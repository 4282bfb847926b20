/// A program that is read more than once: by two runs, or for its lines. What can be read only once is kept in a
/// temporary file.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "isogloss/engine/runner.hpp"
#include "session.hpp"

namespace isogloss::cli {

class KeptProgram {
 public:
  /// Null, and reported, when it cannot be read.
  static std::unique_ptr<KeptProgram> open(const std::string& path, Session& session);
  ~KeptProgram();
  KeptProgram(const KeptProgram&) = delete;
  KeptProgram& operator=(const KeptProgram&) = delete;

  const std::string& path() const { return path_; }
  /// From the beginning; null, and reported, when it can no longer be opened.
  std::unique_ptr<Source> source(Session& session) const;
  /// As much as tells the dialect.
  std::string head(Session& session) const;

 private:
  explicit KeptProgram(std::string path) : path_(std::move(path)) {}
  std::string path_;
  std::FILE* kept_ = nullptr;
  int input_ = -1;           // standard input, where that is a file
  std::uint64_t begin_ = 0;  // of the program in it
};

}  // namespace isogloss::cli
