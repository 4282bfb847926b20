#include "motion/corner_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

Value CornerWords::size(ig::Block& b, const Values& values, std::string_view text, std::size_t position,
                        PathFunction function) const {
  std::size_t i = skip(text, position);
  if (function == PathFunction::RND && to_upper(at(text, i)) == 'R') i = skip(text, i + 1);
  return i < text.size() ? values.read(b, text, i) : Value{};
}

std::size_t CornerWords::feed(ig::Block& b, const Values& values, const FeedWords& words, std::string_view text,
                              std::size_t position, PathFunction function) const {
  bool is_rapid = false;
  const std::size_t end = words.scan(b, values, text, position, is_rapid);
  if (is_rapid)
    b.report(ig::diag("HEI-0181"), ig::Where::columns(position, end), piece(text, position, end), name_of(function));
  const auto feed = words.take(b);
  if (!feed) return end;
  const double mmds = feed->value * (feed->is_per_revolution ? b.get_or(speed_, 0.0) : unit_.in_mm(b)) / 60;
  if (mmds > 0)
    b.set(feed_mmds_, mmds);
  else if (!(feed->value > 0))
    b.report(ig::diag("ISO-0210"), ig::Where::columns(position, end), feed->value);
  return end;
}

void CornerWords::set(ig::Block& b, PathFunction function, double size, ig::Where where) const {
  if (size < 0)
    b.report(ig::diag("HEI-0130"), where, name_of(function),
             std::string_view("it is less than 0, the corner stays sharp"));
  else if (size == 0)
    b.report(ig::diag("HEI-0105"), where, std::string_view("0"), name_of(function));
  else
    b.set(function == PathFunction::RND ? radius_ : chamfer_, size * unit_.in_mm(b));
}

}  // namespace heidenhain
