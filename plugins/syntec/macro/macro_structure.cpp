/// Labels that join the parts of IF, CASE and loops.
#include "macro/macro_structure.hpp"

#include <algorithm>

#include <isogloss/cnc/scan.hpp>

namespace syntec {

using namespace ig::cnc;

namespace {

bool is_loop(Keyword k) { return k == Keyword::while_ || k == Keyword::for_ || k == Keyword::repeat; }

/// 007 is the label 7.
std::string_view without_zeros(std::string_view digits) {
  while (digits.size() > 1 && digits[0] == '0') digits.remove_prefix(1);
  return digits;
}

}  // namespace

void MacroStructure::note_level(ig::Block& b, std::size_t level) const {
  flow_.label(
      b, "AT@" + at_place(flow_.here(b)) + '=' + std::to_string(std::min(level, static_cast<std::size_t>(too_deep))));
}

void MacroStructure::note(ig::Block& b, Keyword k, std::string_view label) {
  switch (k) {
    case Keyword::if_:
    case Keyword::case_:
    case Keyword::while_:
    case Keyword::for_:
    case Keyword::repeat:
      open_.push_back({k, flow_.here(b)});
      note_level(b, open_.size());
      put(b, "OPEN", open_.size());
      return;
    case Keyword::elseif:
      if (!open_.empty() && open_.back().keyword == Keyword::if_) branch(b, {});
      return;
    case Keyword::else_:
      if (!open_.empty() && (open_.back().keyword == Keyword::if_ || open_.back().keyword == Keyword::case_))
        branch(b, "ELSE");
      return;
    case Keyword::case_label:
      if (!open_.empty() && open_.back().keyword == Keyword::case_) branch(b, label);
      return;
    case Keyword::end_if: return close(b, Keyword::if_);
    case Keyword::end_case: return close(b, Keyword::case_);
    case Keyword::end_while: return close(b, Keyword::while_);
    case Keyword::end_for: return close(b, Keyword::for_);
    case Keyword::until: return close(b, Keyword::repeat);
    case Keyword::exit:
      for (std::size_t level = open_.size(); level > 0; --level)
        if (is_loop(open_[level - 1].keyword)) return note_level(b, level);
      return;
    default: return;
  }
}

void MacroStructure::branch(ig::Block& b, std::string_view label) {
  note_level(b, open_.size());
  if (open_.back().keyword == Keyword::if_) return put(b, "BRANCH", open_.size());
  if (label == "ELSE") return flow_.label(b, of_case(open_.back().place, label));
  for (std::size_t i = 0; i < label.size();) {
    const std::size_t begin = skip_while(label, i, [](char c) { return !is_digit(c); });
    i = skip_digits(label, begin);
    if (i > begin) flow_.label(b, of_case(open_.back().place, without_zeros(piece(label, begin, i))));
  }
}

void MacroStructure::close(ig::Block& b, Keyword opening) {
  if (open_.empty() || open_.back().keyword != opening) return;
  note_level(b, open_.size());
  if (opening == Keyword::if_) put(b, "BRANCH", open_.size());
  put(b, "CLOSE", open_.size());
  open_.pop_back();
}

int MacroStructure::level(ig::Block& b, const ig_place& place) {
  constexpr std::size_t most_known = 4096;
  const std::array key{place.frame, std::uint64_t{place.line} << 32 | place.column};
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  int found = 0;
  for (int level = 1; level <= too_deep && found == 0; ++level)
    if (flow_.has_label(b, "AT@" + at_place(place) + '=' + std::to_string(level))) found = level;
  if (known_.size() >= most_known) known_.clear();
  known_.emplace(key, found);
  return found;
}

}  // namespace syntec
