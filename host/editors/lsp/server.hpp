/// The language server: documents, requests and their answers. One thread works; another one only reads messages.
#pragma once

#include <chrono>
#include <map>
#include <variant>

#include "lsp/dialect_features.hpp"
#include "lsp/inbox.hpp"

namespace isogloss::editors {

class Server {
 public:
  /// All three outlive the server. Supervision::yes: a Supervisor hears which document is at work.
  enum class Supervision : std::uint8_t { no, yes };
  Server(Toolbox& toolbox, Inbox& inbox, FrameWriter& client, Supervision supervision = Supervision::no);
  /// Until the client says exit or is gone. The status of the process: 0 after shutdown, else 1.
  int run();

 private:
  using Clock = std::chrono::steady_clock;
  using Document = std::variant<OpenProgram, OpenDialect>;
  using Request = Json (Server::*)(const Json& params);
  using Notification = void (Server::*)(const Json& params);
  static const std::map<std::string, Request, std::less<>>& requests();
  static const std::map<std::string, Notification, std::less<>>& notifications();

  void handle(Inbox::Item item);
  bool has_waited_long() const;
  void answer(const Json& id, const std::string& method, const Json& params);
  void notify(const std::string& method, const Json& params);
  void take_response(const Json& message);
  void send_error(const Json& id, int code, const std::string& message);
  void show(int type, const std::string& message);

  // Lifecycle and settings.
  Json initialize(const Json& params);
  Json shutdown(const Json& params);
  void initialized(const Json& params);
  void change_configuration(const Json& params);
  void apply(const Json& settings);
  Json capabilities() const;

  // Documents.
  void open(const Json& params);
  void change(const Json& params);
  void close(const Json& params);
  void save(const Json& params);
  void quarantine(const Json& params);
  void tell_running(const std::string& uri);
  void set_text(Document& document, const Json& change);
  Document& document_of(const Json& params);
  void set_up(OpenProgram& program);
  void set_up_all();
  /// Runs the program where its text has changed since. Interrupted: it has no analysis.
  void analyse_program(OpenProgram& program, const std::function<bool()>& goes_on);
  void publish(Document& document);
  void publish_dirty();
  bool is_changed_again(const std::string& uri) const;

  // Requests, each for programs and dialects.
  Json on_hover(const Json& params);
  Json on_definition(const Json& params);
  Json on_references(const Json& params);
  Json on_highlight(const Json& params);
  Json on_prepare_rename(const Json& params);
  Json on_rename(const Json& params);
  Json on_symbols(const Json& params);
  Json on_folding(const Json& params);
  Json on_completion(const Json& params);
  Json on_inlay_hints(const Json& params);
  Json on_code_action(const Json& params);
  Json on_formatting(const Json& params);
  Json on_range_formatting(const Json& params);
  Json on_tokens(const Json& params);
  Json on_range_tokens(const Json& params);
  Json on_diagnostics(const Json& params);
  OpenProgram* analysed(const Json& params);
  Surroundings surroundings(std::function<bool()> goes_on);
  std::function<bool()> while_wanted();

  Toolbox& toolbox_;
  Inbox& inbox_;
  FrameWriter& client_;
  Settings settings_, first_settings_;
  Columns columns_ = Columns::utf16;
  std::map<std::string, Document> documents_;
  struct Dirty {
    std::chrono::steady_clock::time_point since;
  };
  std::map<std::string, Dirty> dirty_;  // by URI: diagnostics are to be published
  Json request_id_;                     // of the request at work
  std::chrono::steady_clock::time_point request_end_;
  bool is_initialized_ = false, is_shut_down_ = false, shall_exit_ = false;
  bool asks_configuration_ = false, refreshes_hints_ = false;
  Supervision supervision_;
  std::string running_;                            // as the supervisor was told
  std::map<std::string, std::string> quarantine_;  // by URI: why this text is not run
  int next_id_ = 1;
  int configuration_id_ = 0;
};

}  // namespace isogloss::editors
