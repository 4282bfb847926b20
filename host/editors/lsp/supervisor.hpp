/// Keeps the session alive when a plugin ends the server: the server works in a child process, and a new child takes
/// over with the texts as they are then.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "lsp/text_document.hpp"
#include "protocol/framing.hpp"

namespace isogloss::editors {

class Supervisor {
 public:
  /// `command`: program and arguments of the child, which speaks on its standard input and output.
  Supervisor(std::vector<std::string> command, FrameReader& from_client, FrameWriter& to_client);
  /// Until the session ends; the status of the process.
  int run();

 private:
  struct OpenText {
    std::string language;
    Json version;
    TextDocument text;
  };
  struct Child {
    pid_t process = -1;
    int in = -1, out = -1;  // our ends of its standard input and output
  };

  bool start();
  void stop_writing();
  void forward(const Json& message);
  void record(const Json& message);
  void change(const Json& params);
  /// The thread that reads what children write.
  void read_children();
  void relay(Json message);
  /// The child has ended unasked. False: the session ends, too.
  bool replace_child(int status);
  void replay(const std::string& guilty, const std::string& why);
  void send_to_child(const Json& message);
  static int status_of(int wait_status);

  std::vector<std::string> command_;
  FrameReader& from_client_;
  FrameWriter& to_client_;
  std::mutex writing_;  // of what goes to the child; locked before mutex_
  Child child_;
  std::mutex mutex_;  // of all that follows
  std::map<std::string, OpenText> documents_;
  std::set<std::string> unanswered_;  // ids of the client's requests as JSON text
  std::string running_;               // URI of the document that the child is at work on; empty: none
  Json initialize_, configuration_;
  bool is_initialized_ = false, is_ending_ = false;
  Columns columns_ = Columns::utf16;
  std::vector<std::chrono::steady_clock::time_point> crashes_;
  int status_ = 0;
};

}  // namespace isogloss::editors
