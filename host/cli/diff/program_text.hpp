/// A program that is read more than once: by both runs, and for its lines. What can be read only once is kept in a
/// temporary file.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "isogloss/engine/runner.hpp"
#include "session.hpp"

namespace isogloss::cli::parting {

class ProgramText {
 public:
  /// Null, and reported, when it cannot be read.
  static std::unique_ptr<ProgramText> open(const std::string& path, Session& session);
  ~ProgramText();
  ProgramText(const ProgramText&) = delete;
  ProgramText& operator=(const ProgramText&) = delete;

  const std::string& path() const { return path_; }
  /// From the beginning; null, and reported, when it can no longer be opened.
  std::unique_ptr<Source> source(Session& session) const;
  /// As much as tells the dialect.
  std::string head(Session& session) const;

 private:
  explicit ProgramText(std::string path) : path_(std::move(path)) {}
  std::string path_;
  std::FILE* kept_ = nullptr;
};

}  // namespace isogloss::cli::parting
