/// The programs of `isogloss run`, one after the other into one output.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "dialect_guess.hpp"
#include "isogloss/engine/exporter.hpp"
#include "run/run_arguments.hpp"

namespace isogloss::cli {

class Runs {
 public:
  Runs(const RunArguments& request, Session& session, const RunOptions& options, OutputFile* output)
      : request_(request), session_(session), options_(options), output_(output) {}
  ~Runs();
  Runs(const Runs&) = delete;
  Runs& operator=(const Runs&) = delete;

  int run(const std::string& path);
  bool output_is_gone() const { return output_is_gone_; }
  bool wrote() const { return wrote_; }

 private:
  std::string parting_of(const std::string& path, const OpenedProgram& source, const Guess& guess);
  int run_linked(const std::string& path, OpenedProgram& source);
  void doubt(const std::string& path, std::uint64_t errors, std::uint64_t blocks);
  void write_summary(const std::string& path, const Summary& summary);

  const RunArguments& request_;
  Session& session_;
  const RunOptions& options_;
  OutputFile* output_;
  std::unique_ptr<LinkedDialect> linked_;
  std::string linked_name_;
  std::unique_ptr<Exporter> data_;
  std::map<std::string, std::unique_ptr<LinkedDialect>> likely_;
  bool wrote_ = false, output_is_gone_ = false;
  int summary_status_ = success;
};

}  // namespace isogloss::cli
