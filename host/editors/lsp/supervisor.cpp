#include "lsp/supervisor.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

#include "lsp/params.hpp"

namespace isogloss::editors {

namespace {

constexpr const char* restart_id = "isogloss/restart";
constexpr std::size_t most_crashes = 5;  // within a minute: then the session ends

std::string method_of(const Json& message) {
  const Json* const method = find_member(message, "method");
  return method != nullptr && method->is_string() ? method->get<std::string>() : std::string();
}

std::string id_text(const Json& id) { return id.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string ending_of(int status) {
  if (WIFSIGNALED(status)) return std::string("a plugin ended the server (") + ::strsignal(WTERMSIG(status)) + ")";
  return "a plugin crashed or did not return";
}

}  // namespace

Supervisor::Supervisor(std::vector<std::string> command, FrameReader& from_client, FrameWriter& to_client)
    : command_(std::move(command)), from_client_(from_client), to_client_(to_client) {}

int Supervisor::run() {
  if (!start()) return 2;
  std::thread reading([this] { read_children(); });
  for (bool goes_on = true; goes_on;) {
    Frame frame = from_client_.next();
    if (const auto* const bad = std::get_if<BadFrame>(&frame)) {
      to_client_.send({{"jsonrpc", "2.0"}, {"id", nullptr}, {"error", {{"code", -32700}, {"message", bad->why}}}});
      goes_on = !bad->is_fatal;
    } else if (const auto* const message = std::get_if<Json>(&frame)) {
      goes_on = method_of(*message) != "exit";
      forward(*message);
    } else {
      goes_on = false;
    }
  }
  stop_writing();
  reading.join();
  return status_;
}

bool Supervisor::start() {
  int to[2], from[2];
  if (::pipe2(to, O_CLOEXEC) != 0) return false;
  if (::pipe2(from, O_CLOEXEC) != 0) {
    ::close(to[0]);
    ::close(to[1]);
    return false;
  }
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, to[0], STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, from[1], STDOUT_FILENO);
  std::vector<char*> arguments;
  for (std::string& argument : command_) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  const int error = ::posix_spawn(&child_.process, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(to[0]);
  ::close(from[1]);
  child_.in = to[1];
  child_.out = from[0];
  if (error == 0) return true;
  ::close(child_.in);
  ::close(child_.out);
  return false;
}

void Supervisor::stop_writing() {
  const std::lock_guard writing(writing_);
  const std::lock_guard lock(mutex_);
  is_ending_ = true;
  if (child_.in >= 0) ::close(child_.in);
  child_.in = -1;
}

void Supervisor::send_to_child(const Json& message) {
  if (child_.in >= 0) write_to(child_.in)(frame(message));
}

void Supervisor::forward(const Json& message) {
  // The child may wait until its output is read, which needs mutex_: it is not held while the child is written to.
  const std::lock_guard writing(writing_);
  {
    const std::lock_guard lock(mutex_);
    try {
      record(message);
    } catch (const std::exception&) {
      // The child answers what is wrong with it.
    }
  }
  send_to_child(message);
}

/// What a new child needs to know.
void Supervisor::record(const Json& message) {
  const std::string method = method_of(message);
  const Json* const id = find_member(message, "id");
  if (id != nullptr && !method.empty()) unanswered_.insert(id_text(*id));
  if (method == "initialize" && initialize_.is_null()) initialize_ = message;
  if (method == "initialized") is_initialized_ = true;
  if (method == "exit" || method == "shutdown") is_ending_ = true;
  if (method == "workspace/didChangeConfiguration") configuration_ = message;
  if (!method.starts_with("textDocument/did")) return;
  const Json& params = member_of(message, "params");
  const Json& document = member_of(params, "textDocument");
  const std::string uri = text_of(document, "uri");
  if (method == "textDocument/didOpen")
    documents_[uri] = {document.value("languageId", std::string()), document.value("version", Json(0)),
                       TextDocument(text_of(document, "text"), columns_)};
  else if (method == "textDocument/didClose")
    documents_.erase(uri);
  else if (method == "textDocument/didChange")
    change(params);
}

void Supervisor::change(const Json& params) {
  const auto found = documents_.find(text_of(params["textDocument"], "uri"));
  if (found == documents_.end()) return;
  OpenText& open = found->second;
  if (const Json* const version = find_member(params["textDocument"], "version")) open.version = *version;
  for (const Json& one : member_of(params, "contentChanges")) {
    const Json* const range = find_member(one, "range");
    if (range != nullptr && !range->is_null())
      open.text.replace(range_from(*range), text_of(one, "text"));
    else
      open.text.replace_all(text_of(one, "text"));
  }
}

void Supervisor::read_children() {
  for (;;) {
    FrameReader reader(read_from(child_.out));
    for (;;) {
      Frame frame = reader.next();
      if (auto* const message = std::get_if<Json>(&frame))
        relay(std::move(*message));
      else if (std::holds_alternative<EndOfInput>(frame))
        break;
      else if (std::get<BadFrame>(frame).is_fatal) {
        ::kill(child_.process, SIGKILL);  // what it writes are no messages any more
        break;
      }
    }
    ::close(child_.out);
    int status = 0;
    while (::waitpid(child_.process, &status, 0) < 0 && errno == EINTR) {
    }
    if (!replace_child(status)) return;
  }
}

void Supervisor::relay(Json message) {
  {
    const std::lock_guard lock(mutex_);
    const std::string method = method_of(message);
    if (method == "$/isogloss/running") {
      running_ = message["params"].value("uri", std::string());
      return;
    }
    const Json* const id = find_member(message, "id");
    if (id != nullptr && method.empty()) unanswered_.erase(id_text(*id));
    if (id != nullptr && *id == restart_id) return;
    if (const Json* const result = find_member(message, "result"); result != nullptr && result->is_object())
      if (const Json* const can = find_member(*result, "capabilities"))
        columns_ = can->value("positionEncoding", std::string()) == "utf-8" ? Columns::utf8 : Columns::utf16;
  }
  to_client_.send(message);
}

int Supervisor::status_of(int wait_status) { return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 3; }

bool Supervisor::replace_child(int status) {
  using Clock = std::chrono::steady_clock;
  const std::lock_guard writing(writing_);
  const std::lock_guard lock(mutex_);
  status_ = status_of(status);
  const bool has_crashed = WIFSIGNALED(status) || status_ > 1;
  const std::string why = ending_of(status);
  for (const std::string& id : std::exchange(unanswered_, {}))
    to_client_.send({{"jsonrpc", "2.0"},
                     {"id", Json::parse(id)},
                     {"error", {{"code", -32603}, {"message", "The request has no answer: " + why + "."}}}});
  if (child_.in >= 0) ::close(child_.in);
  child_.in = -1;
  if (is_ending_ || !has_crashed) return false;
  const Clock::time_point now = Clock::now();
  std::erase_if(crashes_, [&](Clock::time_point at) { return now - at > std::chrono::minutes(1); });
  crashes_.push_back(now);
  const std::string guilty = std::exchange(running_, {});
  const bool ends = crashes_.size() > most_crashes || initialize_.is_null() || !start();
  to_client_.send(
      {{"jsonrpc", "2.0"},
       {"method", "window/showMessage"},
       {"params",
        {{"type", 1},
         {"message", "isogloss: " + why + (guilty.empty() ? "" : " while it ran " + guilty) +
                         (ends ? "; the session ends." : "; a new server goes on. Its log has the details.")}}}});
  if (!ends) replay(guilty, why);
  return !ends;
}

void Supervisor::replay(const std::string& guilty, const std::string& why) {
  Json initialize = initialize_;
  initialize["id"] = restart_id;
  send_to_child(initialize);
  if (is_initialized_) send_to_child({{"jsonrpc", "2.0"}, {"method", "initialized"}, {"params", Json::object()}});
  if (!configuration_.is_null()) send_to_child(configuration_);
  if (!guilty.empty())
    send_to_child(
        {{"jsonrpc", "2.0"}, {"method", "$/isogloss/quarantine"}, {"params", {{"uri", guilty}, {"why", why}}}});
  for (const auto& [uri, open] : documents_)
    send_to_child(
        {{"jsonrpc", "2.0"},
         {"method", "textDocument/didOpen"},
         {"params",
          {{"textDocument",
            {{"uri", uri}, {"languageId", open.language}, {"version", open.version}, {"text", open.text.text()}}}}}});
}

}  // namespace isogloss::editors
