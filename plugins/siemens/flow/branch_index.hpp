/// Which ELSE and ENDIF belong to an IF, and which end to a loop. While the program is indexed, these blocks get labels
/// that name the partner: ENDIF@12 ends the IF of line 12.
#pragma once

#include "flow/flow_words.hpp"

namespace siemens {

class BranchIndex {
 public:
  explicit BranchIndex(const Environment& environment) : environment_(environment) {}

  void restart() { open_.clear(); }

  void note(ig::Block& b, FlowWord word, std::string_view text, std::size_t behind) {
    const std::int64_t line = environment_.flow.here(b).line;
    switch (word) {
      case FlowWord::if_:
        if (!has_jump(text, behind)) open_.push_back({FlowWord::if_, line, 0});
        return;
      case FlowWord::while_:
      case FlowWord::for_:
      case FlowWord::loop: open_.push_back({word, line, 0}); return;
      case FlowWord::else_:
        if (open_.empty() || open_.back().word != FlowWord::if_) return;
        environment_.flow.label(b, named("ELSE@", open_.back().line));
        open_.back().else_line = line;
        return;
      case FlowWord::endif: close(b, FlowWord::if_, "ENDIF@"); return;
      case FlowWord::endwhile: close(b, FlowWord::while_, "ENDWHILE@"); return;
      case FlowWord::endfor: close(b, FlowWord::for_, "ENDFOR@"); return;
      case FlowWord::endloop: close(b, FlowWord::loop, "ENDLOOP@"); return;
      default: return;
    }
  }
  static std::string named(std::string_view name, std::int64_t line) {
    return std::string(name).append(std::to_string(line));
  }

 private:
  void close(ig::Block& b, FlowWord word, std::string_view name) {
    if (open_.empty() || open_.back().word != word) return;
    environment_.flow.label(b, named(name, open_.back().line));
    if (open_.back().else_line != 0) environment_.flow.label(b, named(name, open_.back().else_line));
    open_.pop_back();
  }
  struct Open {
    FlowWord word;
    std::int64_t line, else_line;
  };
  const Environment& environment_;
  std::vector<Open> open_;
};

}  // namespace siemens
