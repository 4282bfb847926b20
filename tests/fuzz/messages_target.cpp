// Messages of an editor, one in each line, to the language server in which a program is open: each request has an
// answer or an error.
#include <map>

#include "lsp/server.hpp"
#include "lsp/toolbox.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

using editors::Json;

constexpr const char* program_uri = "file:///fuzz/part.nc";
constexpr std::string_view edited_program =
    "O1000 (PART)\nG21 G90 G54 G17\nT1 M6 (MILL)\nG43 H1 Z50.\nN10 G0 X1. Y2.\n#1=3.\nWHILE [#1 GT 0] DO1\nG81 X#1 "
    "Z-1. R1. F100.\n"
    "#1=#1-1\nEND1\nM98 P2000\nM30\nO2000\nG1 X5.\nM99\n";

/// Without what the command adds: no catalogue, no sentences.
class Tools : public editors::Toolbox {
 public:
  Tools() { workspace().library().load_all(); }
  std::shared_ptr<const editors::Setup> setup(const std::string&, std::string_view, const editors::Settings&,
                                              DiagnosticSink&) override {
    auto out = std::make_shared<editors::Setup>();
    out->linked = std::shared_ptr<const LinkedDialect>(&dialect("fanuc"), [](const LinkedDialect*) {});
    out->dialect = "fanuc";
    return out;
  }
  void forget_dialects() override {}
  std::string sentence(const ExplainedBlock&, const std::string&, const std::string&) override { return "A block."; }
  std::string why_no_block(const ExplainReach&, const ExplainTarget&, const std::string&) override { return "None."; }
  std::vector<editors::CodeInfo> codes(const LinkedDialect&) override {
    return {{"G81", true, "DrillingCycleSyntax", "", {"Z", "R"}}, {"F", false, "WordSyntax", "mm/min", {}}};
  }
  const DiagnosticInfo* diagnostic(const std::string&) override { return nullptr; }
  std::vector<Diagnostic> lint(const std::string&, const std::string&) override { return {}; }
  const Library& library() override { return workspace().library(); }
};

Json opened() {
  return {
      {"jsonrpc", "2.0"},
      {"method", "textDocument/didOpen"},
      {"params",
       {{"textDocument", {{"uri", program_uri}, {"languageId", "gcode"}, {"version", 1}, {"text", edited_program}}}}}};
}

bool is_request(const Json& message) {
  if (!message.is_object() || !message.contains("id") || !message.contains("method")) return false;
  const Json& id = message["id"];
  return (id.is_string() || id.is_number_integer()) && message["method"].is_string();
}

class MessagesTarget : public Target {
 public:
  void run(std::string_view bytes) override {
    editors::Inbox inbox;
    std::map<std::string, int> asked, answered;
    editors::FrameWriter client([&](std::string_view frame) {
      const Json message = Json::parse(frame.substr(frame.find("\r\n\r\n") + 4), nullptr, false);
      if (message.is_discarded()) fail("each message to the editor is JSON");
      if (message.contains("id") && !message.contains("method")) ++answered[message["id"].dump()];
      return true;
    });
    inbox.put(Json{
        {"jsonrpc", "2.0"}, {"id", "first"}, {"method", "initialize"}, {"params", {{"capabilities", Json::object()}}}});
    inbox.put(Json{{"jsonrpc", "2.0"}, {"method", "initialized"}, {"params", Json::object()}});
    inbox.put(opened());
    bool has_ended = false;
    constexpr std::size_t most_messages = 40, depth = 256;
    std::size_t messages = 0;
    while (!bytes.empty() && ++messages <= most_messages && !has_ended) {
      const std::string_view line = bytes.substr(0, bytes.find('\n'));
      bytes.remove_prefix(std::min(bytes.size(), line.size() + 1));
      auto parsed = editors::parse_json(line, depth);
      if (std::string* const why = std::get_if<std::string>(&parsed)) {
        inbox.put(editors::BadFrame{*why, false});
        continue;
      }
      const Json& message = std::get<Json>(parsed);
      if (is_request(message)) ++asked[message["id"].dump(-1, ' ', false, Json::error_handler_t::replace)];
      has_ended = message.is_object() && message.value("method", Json()) == "exit";
      inbox.put(message);
    }
    inbox.put(editors::EndOfInput{});
    editors::Server(tools_, inbox, client).run();
    if (!asked.empty()) accept();
    for (const auto& [id, count] : asked)
      if (answered[id] < count) fail("each request has an answer or an error: " + id);
  }

  std::vector<std::string> samples() const override {
    std::string all;
    std::vector<std::string> out;
    int id = 0;
    const auto add = [&](const std::string& method, Json params) {
      params["textDocument"] = {{"uri", program_uri}, {"version", 2}};
      const Json message{{"jsonrpc", "2.0"}, {"id", ++id}, {"method", method}, {"params", std::move(params)}};
      all += message.dump() + "\n";
      out.push_back(message.dump() + "\n");
    };
    const Json place{{"position", {{"line", 7}, {"character", 2}}}};
    for (const char* const what : {"hover", "definition", "completion", "documentHighlight", "prepareRename"})
      add("textDocument/" + std::string(what), place);
    add("textDocument/references",
        {{"position", {{"line", 4}, {"character", 0}}}, {"context", {{"includeDeclaration", true}}}});
    add("textDocument/rename", {{"position", {{"line", 5}, {"character", 1}}}, {"newName", "#7"}});
    for (const char* const what : {"documentSymbol", "foldingRange", "semanticTokens/full"})
      add("textDocument/" + std::string(what), Json::object());
    add("textDocument/formatting", {{"options", {{"tabSize", 2}, {"insertSpaces", true}}}});
    const Json range{{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 9}, {"character", 0}}}};
    add("textDocument/inlayHint", {{"range", range}});
    add("textDocument/codeAction", {{"range", range}, {"context", {{"diagnostics", Json::array()}}}});
    const Json change{{"jsonrpc", "2.0"},
                      {"method", "textDocument/didChange"},
                      {"params",
                       {{"textDocument", {{"uri", program_uri}, {"version", 3}}},
                        {"contentChanges", {{{"range", range}, {"text", "G91\n"}}}}}}};
    out.push_back(change.dump() + "\n" + all);
    return out;
  }

 private:
  Tools tools_;
};

}  // namespace

std::unique_ptr<Target> make_messages_target() { return std::make_unique<MessagesTarget>(); }

}  // namespace isogloss::fuzz
