/// The text that DPRNT writes to the output device of the control.
#pragma once

#include <string_view>
#include <utility>

#include <isogloss/cnc/scan.hpp>

#include "macro/macro_environment.hpp"

namespace fanuc {

using namespace ig::cnc;

/// Which of POPEN, PCLOS, BPRNT and SETVN have been reported: each once in a run.
class ReportedOutput {
 public:
  void clear() { said_ = 0; }
  /// True the first time. Two letters tell the words apart, whether shortened or not.
  bool is_first(std::string_view word) {
    const char first = to_upper(ig::cnc::at(word, 0)), second = to_upper(ig::cnc::at(word, 1));
    const unsigned kind = first == 'B' ? 0 : first == 'S' ? 1 : second == 'O' ? 2 : 3;
    return (std::exchange(said_, said_ | 1u << kind) >> kind & 1u) == 0;
  }

 private:
  unsigned said_ = 0;
};

/// Reports the text that DPRNT writes and, once in a run, each of the other words.
void put_out(ig::Block& b, const MacroEnvironment& environment, ReportedOutput& said, std::string_view text,
             std::size_t position, std::size_t behind);

}  // namespace fanuc
