#include "state/seen_codes.hpp"

#include <algorithm>

namespace isogloss::cli {

void SeenCodes::begin(const Layout& layout) {
  constexpr std::string_view flags = "Parsing.Flags.";
  for (std::size_t i = 0; i < layout.fields.size(); ++i)
    if (const std::string& path = layout.fields[i].path; path.starts_with(flags))
      codes_.push_back({static_cast<ig_field>(i), path.substr(flags.size())});
}

void SeenCodes::block(const Document& document) {
  ++blocks_;
  for (const Code& code : codes_)
    if (document.taken(code.field) || document.fresh(code.field)) seen_[code.name] = blocks_;
}

std::string SeenCodes::last_of(std::string_view codes) const {
  std::string out;
  std::uint64_t last = 0;
  for (std::size_t begin = 0; begin < codes.size();) {
    const std::size_t end = std::min(codes.find(' ', begin), codes.size());
    const auto found = seen_.find(codes.substr(begin, end - begin));
    if (found != seen_.end() && found->second > last) {
      last = found->second;
      out = found->first;
    }
    begin = end + 1;
  }
  return out;
}

}  // namespace isogloss::cli
