#include "docs/addresses.hpp"

#include <fmt/format.h>

namespace isogloss::cli::docs {

namespace {

/// What is safe in the name of a file, and in a link without an escape.
std::string plain_name(std::string_view name, bool in_small_letters) {
  std::string out;
  for (const char c : name) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    const bool is_kept = is_capital || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
                         (c == '.' && !out.empty());
    out += !is_kept ? '-' : is_capital && in_small_letters ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out.empty() ? "-" : out;
}

/// `make(suffix)` until it is not among `taken`, where it then is.
template <class Make>
std::string unique(std::set<std::string>& taken, const Make& make) {
  std::string out = make("");
  for (int n = 2; !taken.insert(out).second; ++n) out = make(fmt::format("-{}", n));
  return out;
}

}  // namespace

std::string file_stem(std::string_view name) { return plain_name(name, true); }

const Address& Addresses::add(Kind kind, const std::string& name, const std::string& folder, const std::string& stem) {
  if (const auto known = by_name_.find(std::pair(kind, name)); known != by_name_.end()) return known->second;
  const std::string base = folder + "/" + file_stem(stem);
  const std::string file = unique(files_, [&](const std::string& suffix) { return base + suffix; });
  return by_name_.emplace(std::pair(kind, name), Address{file, {}}).first->second;
}

const Address& Addresses::add_on(const std::string& file, Kind kind, const std::string& name) {
  if (const auto known = by_name_.find(std::pair(kind, name)); known != by_name_.end()) return known->second;
  files_.insert(file);
  const std::string base = plain_name(name, false), page = file + "#";
  const std::string whole = unique(anchors_, [&](const std::string& suffix) { return page + base + suffix; });
  return by_name_.emplace(std::pair(kind, name), Address{file, whole.substr(page.size())}).first->second;
}

const Address* Addresses::find(Kind kind, std::string_view name) const {
  const auto found = by_name_.find(std::pair(kind, std::string(name)));
  return found == by_name_.end() ? nullptr : &found->second;
}

std::string relative_link(const std::string& from_file, const Address& to, std::string_view extension) {
  const auto folder = [](const std::string& file) { return file.substr(0, file.rfind('/') + 1); };
  std::string out;
  if (from_file != to.file || to.anchor.empty()) {
    const std::string own = folder(from_file), other = folder(to.file);
    if (own != other && !own.empty()) out = "../";
    out += fmt::format("{}{}", own == other ? to.file.substr(own.size()) : to.file, extension);
  }
  return to.anchor.empty() ? out : out + "#" + to.anchor;
}

}  // namespace isogloss::cli::docs
