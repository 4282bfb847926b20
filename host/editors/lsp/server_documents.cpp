// Open files: their texts, their runs and what is published about them.
#include <fstream>
#include <iterator>

#include "lsp/features.hpp"
#include "lsp/params.hpp"
#include "lsp/server.hpp"

namespace isogloss::editors {

namespace {

template <class F>
decltype(auto) visit_both(std::variant<OpenProgram, OpenDialect>& document, F&& f) {
  return std::visit(std::forward<F>(f), document);
}

}  // namespace

void Server::open(const Json& params) {
  const Json& document = member_of(params, "textDocument");
  const std::string uri = text_of(document, "uri");
  std::string text = text_of(document, "text");
  const Json* const version = find_member(document, "version");
  const bool is_xml = text.find("<?xml") < 16 || uri.ends_with(".xml");
  const std::string path = path_of(uri).empty() ? uri : path_of(uri);
  const std::int64_t number = version != nullptr && version->is_number_integer() ? version->get<std::int64_t>() : 0;
  if (is_xml && is_dialect(text)) {
    OpenDialect dialect;
    dialect.uri = uri;
    dialect.path = path;
    dialect.text = TextDocument(std::move(text), columns_);
    dialect.version = number;
    documents_.insert_or_assign(uri, std::move(dialect));
  } else {
    OpenProgram program;
    program.uri = uri;
    program.path = path;
    program.text = TextDocument(std::move(text), columns_);
    program.version = number;
    set_up(program);
    documents_.insert_or_assign(uri, std::move(program));
  }
  dirty_[uri] = {Clock::now()};
}

Server::Document& Server::document_of(const Json& params) {
  const std::string uri = text_of(member_of(params, "textDocument"), "uri");
  const auto found = documents_.find(uri);
  if (found == documents_.end()) throw BadParams("The document " + uri + " is not open.");
  return found->second;
}

void Server::set_text(Document& document, const Json& change) {
  visit_both(document, [&](auto& open) {
    const Json* const range = find_member(change, "range");
    if (range != nullptr && !range->is_null())
      open.text.replace(range_from(*range), text_of(change, "text"));
    else
      open.text.replace_all(text_of(change, "text"));
  });
}

void Server::change(const Json& params) {
  Document& document = document_of(params);
  const Json& changes = member_of(params, "contentChanges");
  if (!changes.is_array()) throw BadParams("contentChanges must be a list.");
  for (const Json& one : changes) set_text(document, one);
  const Json* const version = find_member(params["textDocument"], "version");
  visit_both(document, [&](auto& open) {
    if (version != nullptr && version->is_number_integer()) open.version = *version;
    dirty_.try_emplace(open.uri, Dirty{Clock::now()});
  });
  auto* const program = std::get_if<OpenProgram>(&document);
  if (program == nullptr) return;
  program->forget();
  if (quarantine_.erase(program->uri) > 0) set_up(*program);
}

/// The text of this document has ended the server before this one.
void Server::quarantine(const Json& params) { quarantine_[text_of(params, "uri")] = text_of(params, "why"); }

void Server::close(const Json& params) {
  const std::string uri = text_of(member_of(params, "textDocument"), "uri");
  documents_.erase(uri);
  dirty_.erase(uri);
  client_.send({{"jsonrpc", "2.0"},
                {"method", "textDocument/publishDiagnostics"},
                {"params", {{"uri", uri}, {"diagnostics", Json::array()}}}});
}

/// Another dialect may fit the program now; and programs stand on the dialect that was saved.
void Server::save(const Json& params) {
  Document& document = document_of(params);
  if (std::holds_alternative<OpenDialect>(document)) {
    toolbox_.forget_dialects();
    set_up_all();
  } else {
    set_up(std::get<OpenProgram>(document));
    dirty_[std::get<OpenProgram>(document).uri] = {Clock::now()};
  }
}

void Server::set_up(OpenProgram& program) {
  program.forget();
  if (const auto why = quarantine_.find(program.uri); why != quarantine_.end()) {
    program.setup = nullptr;
    program.setup_faults = {host_diagnostic("IG-0663", {program.path, 1, 1}, {why->second})};
    return;
  }
  DiagnosticList list;
  program.setup = toolbox_.setup(program.path, program.text.text(), settings_, list);
  program.setup_faults = std::move(list.all);
  if (program.setup != nullptr && !program.setup->why.empty())
    show(3, program.path + ": dialect " + program.setup->dialect + " (" + program.setup->why + ")");
}

void Server::set_up_all() {
  for (auto& [uri, document] : documents_) {
    if (auto* const program = std::get_if<OpenProgram>(&document)) set_up(*program);
    dirty_[uri] = {Clock::now()};
  }
}

void Server::analyse_program(OpenProgram& program, const std::function<bool()>& goes_on) {
  if (program.analysis || program.setup == nullptr) return;
  Analysis analysis = analyse(*program.setup, program.path, program.text.text(), settings_, goes_on);
  if (!analysis.is_interrupted) program.analysis = std::move(analysis);
}

bool Server::is_changed_again(const std::string& uri) const { return inbox_.holds_change_of(uri); }

void Server::publish_dirty() {
  const auto first = dirty_.begin();
  const auto document = documents_.find(first->first);
  const std::string uri = first->first;
  dirty_.erase(first);
  if (document == documents_.end()) return;
  tell_running(uri);
  try {
    publish(document->second);
  } catch (const std::exception& e) {
    show(1, uri + " cannot be checked: " + e.what());
  }
}

void Server::publish(Document& document) {
  const Surroundings around = surroundings([] { return true; });
  visit_both(document, [&](auto& open) {
    Json list;
    if constexpr (std::is_same_v<std::decay_t<decltype(open)>, OpenProgram>) {
      analyse_program(open, [&] { return !is_changed_again(open.uri); });
      if (!open.analysis && open.setup != nullptr) {
        dirty_[open.uri] = {Clock::now()};  // the change that interrupted the run comes next
        return;
      }
      list = diagnostics_of(open, around);
    } else {
      list = dialect_diagnostics(open, around);
    }
    client_.send({{"jsonrpc", "2.0"},
                  {"method", "textDocument/publishDiagnostics"},
                  {"params", {{"uri", open.uri}, {"version", open.version}, {"diagnostics", std::move(list)}}}});
  });
}

Surroundings Server::surroundings(std::function<bool()> goes_on) {
  const auto text_of_file = [this](const std::string& path) -> std::shared_ptr<const TextDocument> {
    for (auto& [uri, document] : documents_) {
      const TextDocument* found = nullptr;
      visit_both(document, [&](auto& open) {
        if (open.path == path) found = &open.text;
      });
      if (found != nullptr) return {std::shared_ptr<void>(), found};
    }
    std::error_code error;
    constexpr std::uintmax_t most = std::uintmax_t{64} << 20;
    if (!std::filesystem::is_regular_file(path, error) || std::filesystem::file_size(path, error) > most)
      return nullptr;
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    return std::make_shared<TextDocument>(std::move(text), columns_);
  };
  return {toolbox_, settings_, std::move(goes_on), text_of_file, columns_};
}

}  // namespace isogloss::editors
