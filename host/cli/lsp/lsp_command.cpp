// Serves an editor on standard input and output, in the frames of the language server protocol.
#include <unistd.h>

#include <thread>

#include "crash_guard.hpp"
#include "lsp/command_toolbox.hpp"
#include "lsp/server.hpp"
#include "lsp/supervisor.hpp"

namespace isogloss::cli {

namespace {

struct LspCommand {
  CommonOptions common;
  std::uint32_t watchdog = 10;
  bool stdio = false, is_worker = false;

  int run(const Arguments& arguments) const;
  int work() const;
};

/// A plugin may crash, hang or end the process: its work is done in a child, and a new child takes over.
int LspCommand::run(const Arguments& arguments) const {
  if (is_worker) return work();
  std::vector<std::string> command{"/proc/self/exe", "lsp", "--worker"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  editors::FrameReader reader(editors::read_from(STDIN_FILENO));
  editors::FrameWriter writer(editors::write_to(STDOUT_FILENO));
  return editors::Supervisor(std::move(command), reader, writer).run();
}

int LspCommand::work() const {
  Session session(common);
  CommandToolbox toolbox(session);
  // What a plugin prints must not stand between two messages.
  const int out = ::dup(STDOUT_FILENO);
  if (out < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return cannot_start;
  editors::FrameReader reader(editors::read_from(STDIN_FILENO));
  editors::FrameWriter writer(editors::write_to(out));
  editors::Inbox inbox;
  std::thread reading([&] { editors::read_all(reader, inbox); });
  watch_calls(watchdog);
  const int status = editors::Server(toolbox, inbox, writer, editors::Server::Supervision::yes).run();
  inbox.close();
  reading.join();
  return status;
}

}  // namespace

int lsp_command(const Arguments& arguments) {
  CommandLine line("lsp",
                   "Serves an editor: a language server for part programs of every dialect and for files of dialects "
                   "and machines, on standard input and output. The editor starts it; its settings are the section "
                   "isogloss of the editor's configuration.",
                   "isogloss lsp --stdio");
  LspCommand command;
  line.flag("--stdio", command.stdio,
            "Speak on standard input and output; there is no other way, so it may be left out");
  line.flag("--worker", command.is_worker, "Serve in this process; what `isogloss lsp` starts").group("");
  line.option("--watchdog", command.watchdog, "A block that takes longer is a fault of its syntax (0: never)")
      .type_name("SECONDS")
      .shows_default();
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run(arguments);
}

}  // namespace isogloss::cli
