/// Which of several codes a run has executed last: of codes that no state tells, such as those of path control.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/document.hpp"

namespace isogloss::cli {

class SeenCodes {
 public:
  void begin(const Layout& layout);
  void block(const Document& document);
  /// Of these codes, separated by blanks, the one that was executed last; empty: none was.
  std::string last_of(std::string_view codes) const;

 private:
  struct Code {
    ig_field field;
    std::string name;
  };
  std::vector<Code> codes_;
  std::map<std::string, std::uint64_t, std::less<>> seen_;  // code, block
  std::uint64_t blocks_ = 0;
};

}  // namespace isogloss::cli
