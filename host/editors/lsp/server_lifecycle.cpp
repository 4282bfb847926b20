// How a session begins and ends, and its settings.
#include "lsp/features.hpp"
#include "lsp/params.hpp"
#include "lsp/server.hpp"

namespace isogloss::editors {

namespace {

/// A member some levels down; null where a level is missing.
const Json* find_path(const Json& json, std::initializer_list<const char*> path) {
  const Json* at = &json;
  for (const char* const key : path) {
    at = find_member(*at, key);
    if (at == nullptr) return nullptr;
  }
  return at;
}

bool is_true(const Json* json) { return json != nullptr && json->is_boolean() && json->get<bool>(); }

}  // namespace

Json Server::capabilities() const {
  return {{"positionEncoding", columns_ == Columns::utf8 ? "utf-8" : "utf-16"},
          {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
          {"hoverProvider", true},
          {"definitionProvider", true},
          {"declarationProvider", true},
          {"referencesProvider", true},
          {"documentHighlightProvider", true},
          {"documentSymbolProvider", true},
          {"foldingRangeProvider", true},
          {"completionProvider", {{"triggerCharacters", Json::array({"<", " ", "\"", "#"})}}},
          {"inlayHintProvider", true},
          {"codeActionProvider", {{"codeActionKinds", Json::array({"quickfix"})}}},
          {"documentFormattingProvider", true},
          {"documentRangeFormattingProvider", true},
          {"renameProvider", {{"prepareProvider", true}}},
          {"semanticTokensProvider", {{"legend", semantic_legend()}, {"full", true}, {"range", true}}}};
}

Json Server::initialize(const Json& params) {
  if (is_initialized_) throw Refusal("The server is initialized already.");
  if (!params.is_object()) throw BadParams("initialize needs an object.");
  if (const Json* const list = find_path(params, {"capabilities", "general", "positionEncodings"});
      list != nullptr && list->is_array())
    for (const Json& one : *list)
      if (one == "utf-8") columns_ = Columns::utf8;
  asks_configuration_ = is_true(find_path(params, {"capabilities", "workspace", "configuration"}));
  refreshes_hints_ = is_true(find_path(params, {"capabilities", "workspace", "inlayHint", "refreshSupport"}));
  is_initialized_ = true;
  std::vector<std::string> faults;
  if (const Json* const options = find_member(params, "initializationOptions"))
    settings_ = with(settings_, *options, faults);
  first_settings_ = settings_;
  for (const std::string& fault : faults) show(1, fault);
  return {{"capabilities", capabilities()}, {"serverInfo", {{"name", "isogloss"}, {"version", ISOGLOSS_VERSION}}}};
}

Json Server::shutdown(const Json&) {
  is_shut_down_ = true;
  return nullptr;
}

void Server::initialized(const Json&) {
  if (!asks_configuration_) return;
  configuration_id_ = next_id_++;
  client_.send({{"jsonrpc", "2.0"},
                {"id", configuration_id_},
                {"method", "workspace/configuration"},
                {"params", {{"items", Json::array({Json{{"section", "isogloss"}}})}}}});
}

void Server::change_configuration(const Json& params) {
  // Clients that answer questions send nothing here but that something has changed.
  if (asks_configuration_) return initialized(params);
  const Json* const settings = find_member(params, "settings");
  if (settings == nullptr) return;
  const Json* const own = find_member(*settings, "isogloss");
  apply(own != nullptr ? *own : *settings);
}

void Server::apply(const Json& settings) {
  std::vector<std::string> faults;
  const Settings before = settings_;
  settings_ = with(first_settings_, settings, faults);
  for (const std::string& fault : faults) show(1, fault);
  if (settings_ == before) return;
  set_up_all();
  if (refreshes_hints_)
    client_.send({{"jsonrpc", "2.0"}, {"id", next_id_++}, {"method", "workspace/inlayHint/refresh"}});
}

}  // namespace isogloss::editors
