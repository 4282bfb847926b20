/// Texts at the end of a page behind which no memory is: whoever reads on, or reads them after the call, crashes.
#pragma once

#include <isogloss.h>

#include <cstddef>
#include <deque>

namespace isogloss::cli {

/// Copies of texts for one call of a plugin at a time.
class GuardedTexts {
 public:
  GuardedTexts() = default;
  ~GuardedTexts();
  GuardedTexts(const GuardedTexts&) = delete;
  GuardedTexts& operator=(const GuardedTexts&) = delete;

  ig_text copy(ig_text text);
  /// What was copied so far cannot be read any more. Its place stays taken for a while, so that nothing else is there.
  void end_call();

 private:
  struct Page {
    void* begin;
    std::size_t size;
  };
  std::deque<Page> pages_;
};

}  // namespace isogloss::cli
