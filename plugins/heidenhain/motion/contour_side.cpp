#include "motion/contour_side.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

const ig::Diagnostics contour_side_diagnostics{
    ig::diagnostic(
        IG_WARNING, "HEI-0391",
        "the tool radius changes while {0} is in force, and acts from the next move: program R0 before it",
        "Manuals do not say what a control does with RL and RR at TOOL CALL. Here the side stays in force, and "
        "the moves after it have the distance of the new radius.",
        "5 TOOL CALL 6 Z S3000 (after L X+10 RL)"),
    ig::diagnostic(IG_WARNING, "HEI-0393",
                   "no TOOL CALL comes before {0}, so a tool radius of 0 is assumed: program TOOL CALL first",
                   "The tool that the program finds in the spindle is not known here. A program that others call may "
                   "be run by itself.",
                   "5 L X+10 RL (without TOOL CALL)"),
};

/// The second letter of an R word ends it.
bool ends_with_second_letter(std::string_view text, std::size_t position) {
  const char behind = at(text, position + 2);
  return !is_digit(behind) && behind != '.' && behind != ',';
}

}  // namespace

bool ContourSide::begins(std::string_view text, std::size_t position) {
  const char d = to_upper(at(text, position + 1));
  return (d == 'L' || d == 'R') && ends_with_second_letter(text, position);
}

bool ContourSide::ends(std::string_view text, std::size_t position) {
  return at(text, position + 1) == '0' && ends_with_second_letter(text, position);
}

std::size_t ContourSide::scan(ig::Block& b, std::string_view text, std::size_t position, bool& is_beside) const {
  const char d = to_upper(at(text, position + 1));
  if (begins(text, position)) {
    is_beside = true;
    set(b, d == 'L' ? left : right, position, position + 2);
    return position + 2;
  }
  if (ends(text, position)) {
    end(b, position, position + 2);
    return position + 2;
  }
  // R+ and R- lengthen or shorten a paraxial block by the radius
  if (d == '+' || d == '-') {
    b.report(ig::diag("HEI-0131"), ig::Where::columns(position, position + 2), piece(text, position, position + 2));
    return position + 2;
  }
  return is_letter(d) || is_digit(d) ? position : position + 1;
}

void ContourSide::change_tool(ig::Block& b, std::int64_t row, bool is_other_delta, std::size_t begin,
                              std::size_t end) const {
  const bool is_other_tool = b.get_or(offset_in_force_, std::int64_t{0}) != row;
  if (!is_in_force(b) || !(is_other_tool || is_other_delta)) return;
  b.report(ig::diag("HEI-0391"), ig::Where::columns(begin, end), std::string_view(b.is(term_, g41_) ? "RL" : "RR"));
  if (is_other_tool) put_word(b, offset_word_.id(), begin, end, static_cast<double>(row));
}

void ContourSide::set(ig::Block& b, Side side, std::size_t begin, std::size_t end) const {
  const std::int64_t tool = b.get_or(tool_, std::int64_t{0});
  if (!b.has(tool_))
    b.report(ig::diag("HEI-0393"), ig::Where::columns(begin, end), std::string_view(side == left ? "RL" : "RR"));
  if (b.is(term_, side == left ? g41_ : g42_) && b.get_or(offset_in_force_, std::int64_t{0}) == tool) return;
  const ig_word words[] = {
      {codes_.id(side), column(begin), column(end), ig_value{}, 0, 0},
      {offset_word_.id(), column(begin), column(end), {.number = static_cast<double>(tool)}, 0, 0}};
  b.set_words(words, 2);
}

}  // namespace heidenhain
