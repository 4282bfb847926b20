/// Runs what `view` shows, as often as something of it changes.
#pragma once

#include <filesystem>
#include <map>

#include "view/view_page.hpp"

namespace isogloss::cli::viewing {

struct ViewOptions {
  CommonOptions common;
  ProgramOptions program;
  std::array<std::string, 2> dialects, machines;  ///< of the sides A and B
  std::string path;
  ToolPathOptions moves;
  PageOptions page;
};

class Viewer {
 public:
  explicit Viewer(ViewOptions options) : options_(std::move(options)) {}
  /// Runs the program; false, and reported, when it cannot start. What was shown before stays then. The session must
  /// outlive what is shown.
  bool load(Session& session);
  std::string page(Session& session) const { return make_page(viewed_, options_.page, session); }
  const Viewed& viewed() const { return viewed_; }
  int status() const { return status_; }
  /// From now on pages ask for explanations and reload when `version` rises.
  void serve(std::uint64_t version) { options_.page.version = version; }
  std::uint64_t version() const { return options_.page.version.value_or(0); }
  /// Looks at the files as they are now.
  void note_files();
  /// Whether a file that the last load() read is another one now.
  bool has_changed() const;
  const ViewOptions& options() const { return options_; }

 private:
  bool has_two_sides() const;

  ViewOptions options_;
  Viewed viewed_;
  int status_ = success;
  struct State {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const State&) const = default;
  };
  static State state_of(const std::filesystem::path& file);
  std::map<std::filesystem::path, State> files_;
};

}  // namespace isogloss::cli::viewing
