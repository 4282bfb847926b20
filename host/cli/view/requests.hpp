/// What the server answers. It knows three addresses and no file: a page, its version, the explanation of a line.
#pragma once

#include <string>
#include <string_view>

#include "view/viewer.hpp"

namespace isogloss::cli::viewing {

struct Answer {
  unsigned status = 200;
  std::string_view type = "text/plain; charset=utf-8";
  std::string body;
};

class Requests {
 public:
  /// `session`: that of what is shown now.
  Requests(Viewer& viewer, Session& session, std::uint16_t port) : viewer_(viewer), session_(&session), port_(port) {}
  /// `host`: the header of that name. A page of another site may reach the port under its own name, but not read from
  /// it.
  Answer get(std::string_view target, std::string_view host);

 private:
  bool is_our_host(std::string_view host) const;
  Answer page();
  Answer version();
  Answer explain(std::string_view query) const;
  void load();

  Viewer& viewer_;
  Session* session_;
  std::unique_ptr<Session> own_session_;  // of a later version
  const std::uint16_t port_;
  std::string page_;  // of the present version; empty: not made yet
  std::string failure_;
};

}  // namespace isogloss::cli::viewing
