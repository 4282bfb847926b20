// The section is a loop of its own kind, which runs from its first label; the end label or number sends the run back
// to the REPEAT.
#include "flow/repeated_section.hpp"

#include <algorithm>
#include <cmath>

namespace siemens {

using namespace ig::cnc;

std::optional<Loop> RepeatedSections::section_of(ig::Block& b, const FlowStatement& s) const {
  const std::string_view text = s.text;
  const std::size_t name = skip_blanks(text, s.behind);
  const ig_frame f = environment_.flow.frame(b);
  Loop found{.kind = LoopKind::section,
             .frame = f.id,
             .pass = f.pass,
             .line = s.line,
             .place = environment_.flow.here(b),
             .left = 1,
             .until = "ENDLABEL"};
  std::size_t next = skip_name(text, name);
  std::string first = upper(piece(text, name, next));
  drop_zeros(first);
  next = skip_blanks(text, next);
  if (s.word == FlowWord::repeatb) {
    found.until = first;
  } else if (s.word == FlowWord::block && !is_word(text, next, "TO")) {
    b.report(ig::diag("SIE-0141"), columns(text, s.begin), text.substr(s.begin));
    return std::nullopt;
  } else if (is_name_start(at(text, next)) && !is_word(text, next, "P")) {
    if (s.word == FlowWord::block) next = skip_blanks(text, skip_name(text, next));
    const std::size_t last = skip_name(text, next);
    found.until = upper(piece(text, next, last));
    drop_zeros(found.until);
    next = skip_blanks(text, last);
  }
  if (is_word(text, next, "P") && at(text, skip_blanks(text, next + 1)) == '=') {
    Expression e(b, environment_, text, skip_blanks(text, next + 1) + 1);
    const auto times = e.number();
    if (!times) return std::nullopt;
    found.left = std::max(std::floor(*times), 0.0);
    if (!(found.left >= 1) || found.left != *times)
      environment_.report_once(b, ig::diag("SIE-0309"), columns(text, next), next, *times, found.left);
    next = e.position();
  }
  if (first.empty()) {
    b.report(ig::diag("SIE-0141"), columns(text, name), text.substr(std::min(name, text.size())));
    return std::nullopt;
  }
  if (!ends(b, text, next)) return std::nullopt;
  if (found.until[0] == 'N') b.raise(numbers_end_);
  found.until += ' ' + first;  // "END BEGIN"
  return found;
}

void RepeatedSections::repeat(ig::Block& b, const FlowStatement& s) {
  const std::uint64_t frame = environment_.flow.frame(b).id;
  Loop* section = loops_.at_line(frame, s.line, LoopKind::section);
  if (section == nullptr) {
    auto found = section_of(b, s);
    if (!found || !enter_loop(b, s, loops_, std::move(*found))) return;
    section = loops_.innermost(frame);
  }
  if (section->left < 1) {
    environment_.examined().add_reason(b, "all repeats are made");
    loops_.pop();
    return;
  }
  section->left -= 1;
  if (environment_.examined().is_heard())
    environment_.examined().add_reason(
        b, section->left < 1
               ? "the last repeat follows"
               : "a repeat follows, and then " + std::to_string(static_cast<std::int64_t>(section->left)) + " more");
  const std::string from = section->until.substr(section->until.find(' ') + 1);
  if (!environment_.flow.jump(b, from, IG_SEARCH_BACKWARD).is_not_found()) return;
  const ig::Flow::Answer ahead = environment_.flow.jump(b, from, IG_SEARCH_FORWARD);
  if (!ahead.is_not_found()) return;
  b.report(ig::diag("SIE-0147"), s.where(), std::string_view(from), ahead.reason);
  loops_.pop();
}

void RepeatedSections::end(ig::Block& b, std::string_view label) {
  const ig_frame frame = environment_.flow.frame(b);
  loops_.enter(frame);
  const Loop* const section = loops_.innermost(frame.id);
  if (section == nullptr || section->kind != LoopKind::section) return;
  const std::string_view until = section->until;
  if (until.substr(0, until.find(' ')) == label) environment_.flow.go_to(b, section->place);
}

}  // namespace siemens
