/// The end of a run by a limit, or by a file that cannot be read.
#pragma once

#include <utility>

#include "isogloss/engine/diagnostic.hpp"

namespace isogloss {

class RunEnd {
 public:
  explicit RunEnd(DiagnosticSink& sink) : sink_(sink) {}
  RunEnd(const RunEnd&) = delete;
  RunEnd& operator=(const RunEnd&) = delete;

  bool is_over() const { return over_; }
  void report(Diagnostic why) {
    sink_.add(std::move(why));
    over_ = true;
  }
  /// For what may follow from another end: only the first is reported.
  void report_first(Diagnostic why) {
    if (!over_) report(std::move(why));
  }

 private:
  DiagnosticSink& sink_;
  bool over_ = false;
};

}  // namespace isogloss
