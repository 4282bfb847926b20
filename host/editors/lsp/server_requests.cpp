// Requests about a document: parameters in, the result of a feature out.
#include "lsp/features.hpp"
#include "lsp/params.hpp"
#include "lsp/server.hpp"

namespace isogloss::editors {

std::function<bool()> Server::while_wanted() {
  return [this, id = request_id_, end = request_end_] {
    return std::chrono::steady_clock::now() < end && !inbox_.is_cancelled(id);
  };
}

/// The program with the run of its present text; null for a file of a dialect.
OpenProgram* Server::analysed(const Json& params) {
  auto* const program = std::get_if<OpenProgram>(&document_of(params));
  if (program == nullptr) return nullptr;
  // A run that takes too long is cut, and serves the request; what follows has as much time again.
  analyse_program(*program, [this] { return !inbox_.is_cancelled(request_id_); });
  if (!program->analysis && program->setup != nullptr) throw Refusal("The request was cancelled.");
  request_end_ = Clock::now() + std::chrono::milliseconds(settings_.budget_ms);
  return program;
}

Json Server::on_hover(const Json& params) {
  const Position at = position_from(member_of(params, "position"));
  if (OpenProgram* const program = analysed(params)) return hover(*program, at, surroundings(while_wanted()));
  return dialect_hover(std::get<OpenDialect>(document_of(params)), at, surroundings(while_wanted()));
}

Json Server::on_definition(const Json& params) {
  const Position at = position_from(member_of(params, "position"));
  OpenProgram* const program = analysed(params);
  return program != nullptr ? definition(*program, at, surroundings(while_wanted())) : Json(nullptr);
}

Json Server::on_references(const Json& params) {
  const Position at = position_from(member_of(params, "position"));
  const Json* const context = find_member(params, "context");
  const Json* const declared = context != nullptr ? find_member(*context, "includeDeclaration") : nullptr;
  OpenProgram* const program = analysed(params);
  if (program == nullptr) return Json::array();
  return references(*program, at, declared == nullptr || *declared != false, surroundings(while_wanted()));
}

Json Server::on_highlight(const Json& params) {
  const Position at = position_from(member_of(params, "position"));
  OpenProgram* const program = analysed(params);
  return program != nullptr ? highlights(*program, at, surroundings(while_wanted())) : Json::array();
}

Json Server::on_prepare_rename(const Json& params) {
  const Position at = position_from(member_of(params, "position"));
  OpenProgram* const program = analysed(params);
  return program != nullptr ? prepare_rename(*program, at, surroundings(while_wanted())) : Json(nullptr);
}

Json Server::on_rename(const Json& params) {
  const Position at = position_from(member_of(params, "position"));
  const std::string name = text_of(params, "newName");
  OpenProgram* const program = analysed(params);
  if (program == nullptr) throw Refusal("Names of a dialect's file are not renamed.");
  return rename(*program, at, name, surroundings(while_wanted()));
}

Json Server::on_symbols(const Json& params) {
  if (OpenProgram* const program = analysed(params)) return symbols(*program);
  return dialect_symbols(std::get<OpenDialect>(document_of(params)));
}

Json Server::on_folding(const Json& params) {
  OpenProgram* const program = analysed(params);
  return program != nullptr ? folding(*program) : Json::array();
}

Json Server::on_completion(const Json& params) {
  const Position at = position_from(member_of(params, "position"));
  if (OpenProgram* const program = analysed(params)) return completion(*program, at, surroundings(while_wanted()));
  return dialect_completion(std::get<OpenDialect>(document_of(params)), at, surroundings(while_wanted()));
}

Json Server::on_inlay_hints(const Json& params) {
  const Range range = range_from(member_of(params, "range"));
  OpenProgram* const program = analysed(params);
  return program != nullptr ? inlay_hints(*program, range, surroundings(while_wanted())) : Json::array();
}

Json Server::on_code_action(const Json& params) {
  const Range range = range_from(member_of(params, "range"));
  const Json& context = member_of(params, "context");
  if (!context.is_object()) throw BadParams("context must be an object.");
  if (OpenProgram* const program = analysed(params))
    return code_actions(*program, range, context, surroundings(while_wanted()));
  return dialect_actions(std::get<OpenDialect>(document_of(params)), range, context, surroundings(while_wanted()));
}

Json Server::on_formatting(const Json& params) {
  OpenProgram* const program = analysed(params);
  return program != nullptr ? formatting(*program, nullptr, surroundings(while_wanted())) : Json::array();
}

Json Server::on_range_formatting(const Json& params) {
  const Range range = range_from(member_of(params, "range"));
  OpenProgram* const program = analysed(params);
  return program != nullptr ? formatting(*program, &range, surroundings(while_wanted())) : Json::array();
}

Json Server::on_tokens(const Json& params) {
  auto* const program = std::get_if<OpenProgram>(&document_of(params));
  return program != nullptr ? semantic_tokens(*program, nullptr) : Json{{"data", Json::array()}};
}

Json Server::on_range_tokens(const Json& params) {
  const Range range = range_from(member_of(params, "range"));
  auto* const program = std::get_if<OpenProgram>(&document_of(params));
  return program != nullptr ? semantic_tokens(*program, &range) : Json{{"data", Json::array()}};
}

Json Server::on_diagnostics(const Json& params) {
  if (OpenProgram* const program = analysed(params))
    return {{"kind", "full"}, {"items", diagnostics_of(*program, surroundings(while_wanted()))}};
  return {{"kind", "full"},
          {"items", dialect_diagnostics(std::get<OpenDialect>(document_of(params)), surroundings(while_wanted()))}};
}

}  // namespace isogloss::editors
