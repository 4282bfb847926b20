#include "reproducer.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "crash_guard.hpp"
#include "dialect_guess.hpp"
#include "isogloss/engine/document_json.hpp"

namespace isogloss::cli {

namespace {

/// Keeps the previous block, and writes the case when the build is reached, or when this process crashes too.
class CaseWriter : public Exporter {
 public:
  CaseWriter(const ReproducerRequest& request, std::string dialect) : request_(request), dialect_(std::move(dialect)) {}

  void listen(Chain& chain) {
    chain_ = &chain;
    chain.trace = [this](std::uint32_t position, bool before) {
      const bool is_it = chain_->builds >= request_.build && Chain::breadcrumb().document->source.line == request_.line;
      if (!before || !is_it) return;
      const bool is_written = write(chain_->linked().chain[position].syntax->id, false);
      end_process(is_written ? success : internal_fault);
    };
  }
  void begin(Document& initial, const SymbolTable& symbols) override { keep(initial, symbols); }
  bool block(Document& document, const SymbolTable& symbols) override {
    keep(document, symbols);
    return true;
  }
  bool end() override { return true; }

  bool write(const std::string& syntax, bool scanning) const {
    const Document& document = chain_->document();
    Json before = Json::object();
    if (scanning)
      before["UnparsedText"] = std::string(document.source.text);
    else
      before = show_json(document, chain_->symbols());
    const auto text = [](const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); };
    const Json previous = previous_ ? show_json(*previous_, chain_->symbols()) : Json::object();
    std::ofstream out(request_.file);
    out << "# " << syntax << "\n\nWritten after a fault at " << document.source.file << ":" << document.source.line
        << " under the dialect " << dialect_ << ". The block:\n\n    " << document.source.text
        << "\n\nTo see it again: `isogloss case " << request_.file << " -d " << dialect_
        << "`\n\n## The block at work\n\n#Previous:\n```json\n"
        << text(previous) << "\n```\n#BeforeBuild:\n```json\n"
        << text(before) << "\n```\n#AfterBuild:\n```json\n{}\n```\n#Diagnostics: any\n";
    out.close();
    return out.good();
  }

  bool write_after_crash() const {
    const Breadcrumb crumb = Chain::breadcrumb();
    return crumb.syntax != nullptr && write(crumb.syntax, true);
  }

 private:
  void keep(const Document& document, const SymbolTable&) {
    if (!previous_)
      previous_.emplace(document);
    else
      *previous_ = document;
    previous_->own_source();
  }

  const ReproducerRequest& request_;
  std::string dialect_;
  Chain* chain_ = nullptr;
  std::optional<Document> previous_;
};

const CaseWriter* writer = nullptr;  // for the signal handler, which cannot reach it otherwise

}  // namespace

void ReproducerRequest::add_to(CommandLine& command_line) {
  command_line.option("--reproducer", file).group("");
  command_line.option("--reproducer-build", build).group("");
  command_line.option("--reproducer-line", line).group("");
  command_line.option("--reproducer-program", program).group("");
}

int ReproducerRequest::write(Session& session, const ProgramOptions& program_options, RunOptions options) const {
  const std::unique_ptr<OpenedProgram> source = OpenedProgram::open(program, session);
  if (source == nullptr) return cannot_start;
  std::optional<std::string> dialect = program_options.dialect;
  if (dialect->empty()) dialect = guessed(program, source->head(), session);
  const std::unique_ptr<LinkedDialect> linked = dialect ? session.link(*dialect, options.chain.dependencies) : nullptr;
  if (linked == nullptr) return cannot_start;

  CaseWriter cases(*this, *dialect);
  writer = &cases;
  // A scanner that crashes does so again here; this process has nothing to lose, so its handler may write.
  on_crash([] { end_process(writer->write_after_crash() ? success : internal_fault); });
  add_program_places(program, linked->dialect, options);
  options.chain.mode = Mode::traced;
  options.prepare = [&](Chain& chain) { cases.listen(chain); };
  isogloss::run(*linked, *source, program, options, {&cases}, session.diagnostics());
  return internal_fault;
}

}  // namespace isogloss::cli
