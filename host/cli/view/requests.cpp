#include "view/requests.hpp"

#include <fmt/format.h>

#include <charconv>

#include "catalogue.hpp"
#include "view/explanations.hpp"

namespace isogloss::cli::viewing {

namespace {

/// A number of a query "path=0&file=1&line=25"; empty where it is none.
std::optional<std::uint32_t> number_in(std::string_view query, std::string_view name) {
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    std::string_view part = query.substr(0, end);
    query.remove_prefix(std::min(end + 1, query.size()));
    if (part.size() <= name.size() || part.substr(0, name.size()) != name || part[name.size()] != '=') continue;
    part.remove_prefix(name.size() + 1);
    std::uint32_t value = 0;
    const auto [last, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error == std::errc() && last == part.data() + part.size()) return value;
  }
  return std::nullopt;
}

}  // namespace

bool Requests::is_our_host(std::string_view host) const {
  const std::string port = std::to_string(port_);
  return host == "127.0.0.1:" + port || host == "localhost:" + port;
}

Answer Requests::get(std::string_view target, std::string_view host) {
  if (!is_our_host(host)) return {403, "text/plain; charset=utf-8", "This address is not served here.\n"};
  const std::size_t mark = std::min(target.find('?'), target.size());
  const std::string_view path = target.substr(0, mark), query = target.substr(std::min(mark + 1, target.size()));
  if (path == "/") return page();
  if (path == "/version") return version();
  if (path == "/explain") return explain(query);
  return {404, "text/plain; charset=utf-8", "There is nothing here. The page is at /.\n"};
}

Answer Requests::page() {
  if (page_.empty()) page_ = viewer_.page(*session_);
  return {200, "text/html; charset=utf-8", page_};
}

/// The version that is shown, and why a newer one cannot be.
Answer Requests::version() {
  if (viewer_.has_changed()) load();
  const Json out{{"version", viewer_.version()}, {"failure", failure_}};
  return {200, "application/json", out.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

void Requests::load() {
  auto session = std::make_unique<Session>(viewer_.options().common);
  viewer_.serve(viewer_.version() + 1);
  page_.clear();
  if (viewer_.load(*session)) {
    failure_.clear();
    session_ = session.get();
    own_session_ = std::move(session);
  } else {
    failure_ = "The program can no longer be run: the terminal says why.";
    viewer_.note_files();
  }
}

Answer Requests::explain(std::string_view query) const {
  const Viewed& viewed = viewer_.viewed();
  const std::optional<std::uint32_t> path = number_in(query, "path"), file = number_in(query, "file"),
                                     line = number_in(query, "line");
  const bool is_known = path && file && line && *path < viewed.runs.size() && *file < viewed.files.size() && *line > 0;
  if (!is_known) return {400, "text/plain; charset=utf-8", "path, file and line are numbers of the page.\n"};
  constexpr std::size_t most_blocks = 20;
  const Sentences sentences = explain_lines(*viewed.runs[*path], *viewed.program, *file == 0 ? "" : viewed.files[*file],
                                            *line, *line, most_blocks, *session_);
  const auto found = sentences.find(*line);
  return {200, "text/plain; charset=utf-8", found == sentences.end() ? "" : found->second};
}

}  // namespace isogloss::cli::viewing
