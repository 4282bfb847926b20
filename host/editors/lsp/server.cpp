#include "lsp/server.hpp"

#include <exception>

#include "lsp/features.hpp"
#include "lsp/params.hpp"

namespace isogloss::editors {

namespace {

/// From the last change to the run: what is typed in one go is run once.
constexpr std::chrono::milliseconds debounce{40};

// Errors of JSON-RPC and of the protocol.
enum : int {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  not_initialized = -32002,
  request_cancelled = -32800,
  request_failed = -32803
};

bool is_id(const Json& id) { return id.is_string() || id.is_number_integer(); }

}  // namespace

Server::Server(Toolbox& toolbox, Inbox& inbox, FrameWriter& client, Supervision supervision)
    : toolbox_(toolbox), inbox_(inbox), client_(client), supervision_(supervision) {}

int Server::run() {
  while (!shall_exit_) {
    std::optional<std::chrono::milliseconds> wait;
    if (!dirty_.empty()) wait = debounce;
    std::optional<Inbox::Item> item = inbox_.take(wait);
    if (item) handle(std::move(*item));
    if (!dirty_.empty() && (!item || has_waited_long())) publish_dirty();
    if (dirty_.empty()) tell_running({});
  }
  return is_shut_down_ ? 0 : 1;
}

/// A client that asks without a pause still hears of its faults.
bool Server::has_waited_long() const {
  constexpr std::chrono::milliseconds long_enough{300};
  for (const auto& [uri, dirty] : dirty_)
    if (Clock::now() - dirty.since > long_enough) return true;
  return false;
}

void Server::handle(Inbox::Item item) {
  if (std::holds_alternative<EndOfInput>(item)) {
    shall_exit_ = true;
    return;
  }
  if (const BadFrame* const bad = std::get_if<BadFrame>(&item)) {
    send_error(nullptr, parse_error, bad->why);
    shall_exit_ = bad->is_fatal;
    return;
  }
  const Json& message = std::get<Json>(item);
  const Json* const id = find_member(message, "id");
  const Json* const method = find_member(message, "method");
  if (method == nullptr && id != nullptr) return take_response(message);
  if (method == nullptr || !method->is_string() || (id != nullptr && !is_id(*id)))
    return send_error(nullptr, invalid_request, "A message needs a method, and an id that is a number or a text.");
  const Json* const params = find_member(message, "params");
  const Json none = Json::object();
  if (const Json* const document = params != nullptr ? find_member(*params, "textDocument") : nullptr)
    if (const Json* const uri = find_member(*document, "uri"); uri != nullptr && uri->is_string()) tell_running(*uri);
  if (id != nullptr)
    answer(*id, *method, params != nullptr ? *params : none);
  else
    notify(*method, params != nullptr ? *params : none);
}

/// The supervisor knows whose text is run, for the case that nothing comes back.
void Server::tell_running(const std::string& uri) {
  if (supervision_ == Supervision::no || running_ == uri) return;
  running_ = uri;
  client_.send({{"jsonrpc", "2.0"}, {"method", "$/isogloss/running"}, {"params", {{"uri", uri}}}});
}

void Server::answer(const Json& id, const std::string& method, const Json& params) {
  const bool was_cancelled = inbox_.is_cancelled(id);
  request_id_ = id;
  request_end_ = Clock::now() + std::chrono::milliseconds(settings_.budget_ms);
  try {
    const auto found = requests().find(method);
    if (was_cancelled)
      send_error(id, request_cancelled, "The request was cancelled.");
    else if (found == requests().end())
      send_error(id, method_not_found, "This server has no method '" + method + "'.");
    else if (!is_initialized_ && method != "initialize")
      send_error(id, not_initialized, "The first request must be initialize.");
    else if (is_shut_down_)
      send_error(id, invalid_request, "After shutdown only exit may come.");
    else
      client_.send({{"jsonrpc", "2.0"}, {"id", id}, {"result", (this->*found->second)(params)}});
  } catch (const BadParams& e) {
    send_error(id, invalid_params, e.what());
  } catch (const Json::exception& e) {
    send_error(id, invalid_params, std::string("A parameter has another type than the protocol says: ") + e.what());
  } catch (const Refusal& e) {
    send_error(id, request_failed, e.what());
  } catch (const std::exception& e) {
    send_error(id, internal_error, std::string("An internal fault ended the request: ") + e.what());
  }
  request_id_ = nullptr;
  inbox_.forget_cancelled(id);
}

void Server::notify(const std::string& method, const Json& params) {
  if (method == "exit") {
    shall_exit_ = true;
    return;
  }
  const auto found = notifications().find(method);
  if (found == notifications().end() || !is_initialized_ || is_shut_down_) return;
  try {
    (this->*found->second)(params);
  } catch (const std::exception& e) {
    show(1, method + " was not carried out: " + e.what());
  }
}

void Server::send_error(const Json& id, int code, const std::string& message) {
  client_.send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}});
}

void Server::show(int type, const std::string& message) {
  client_.send({{"jsonrpc", "2.0"},
                {"method", type == 1 ? "window/showMessage" : "window/logMessage"},
                {"params", {{"type", type}, {"message", message}}}});
}

void Server::take_response(const Json& message) {
  const Json* const result = find_member(message, "result");
  if (configuration_id_ == 0 || member_of(message, "id") != configuration_id_) return;
  configuration_id_ = 0;
  if (result != nullptr && result->is_array() && !result->empty()) apply((*result)[0]);
}

const std::map<std::string, Server::Request, std::less<>>& Server::requests() {
  static const std::map<std::string, Request, std::less<>> table{
      {"initialize", &Server::initialize},
      {"shutdown", &Server::shutdown},
      {"textDocument/hover", &Server::on_hover},
      {"textDocument/definition", &Server::on_definition},
      {"textDocument/declaration", &Server::on_definition},
      {"textDocument/references", &Server::on_references},
      {"textDocument/documentHighlight", &Server::on_highlight},
      {"textDocument/prepareRename", &Server::on_prepare_rename},
      {"textDocument/rename", &Server::on_rename},
      {"textDocument/documentSymbol", &Server::on_symbols},
      {"textDocument/foldingRange", &Server::on_folding},
      {"textDocument/completion", &Server::on_completion},
      {"textDocument/inlayHint", &Server::on_inlay_hints},
      {"textDocument/codeAction", &Server::on_code_action},
      {"textDocument/formatting", &Server::on_formatting},
      {"textDocument/rangeFormatting", &Server::on_range_formatting},
      {"textDocument/semanticTokens/full", &Server::on_tokens},
      {"textDocument/semanticTokens/range", &Server::on_range_tokens},
      {"textDocument/diagnostic", &Server::on_diagnostics},
  };
  return table;
}

const std::map<std::string, Server::Notification, std::less<>>& Server::notifications() {
  static const std::map<std::string, Notification, std::less<>> table{
      {"initialized", &Server::initialized},
      {"workspace/didChangeConfiguration", &Server::change_configuration},
      {"textDocument/didOpen", &Server::open},
      {"textDocument/didChange", &Server::change},
      {"textDocument/didClose", &Server::close},
      {"textDocument/didSave", &Server::save},
      {"$/isogloss/quarantine", &Server::quarantine},
  };
  return table;
}

}  // namespace isogloss::editors
