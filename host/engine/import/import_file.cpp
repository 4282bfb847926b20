// Finds the importer of a file and lets it read.
#include <fmt/format.h>

#include <algorithm>

#include "contract/c_text.hpp"
#include "dialect/options.hpp"
#include "import/control_text.hpp"
#include "import/import_host.hpp"
#include "isogloss/engine/runner.hpp"

namespace isogloss {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = std::size_t{64} << 20;
constexpr std::size_t most_files = 10'000;
constexpr std::size_t looked_at = std::size_t{64} << 10;

std::vector<std::string> importer_names(const Library& library) {
  std::vector<std::string> out;
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->importer_count; ++i) out.emplace_back(p.plugin->importers[i]->id);
  return out;
}

/// The importer that `asked` names, or the surest one. Null, and reported, when there is none.
const ig_importer* choose(const Import& asked, const std::string& text, const Library& library, DiagnosticSink& sink) {
  if (!asked.format.empty()) {
    if (const ig_importer* const named = library.importer(asked.format)) return named;
    const std::string near = nearest_name(asked.format, importer_names(library));
    sink.add(host_diagnostic("IG-0129", asked.where, {asked.format}, near.empty() ? "" : "did you mean " + near + "?"));
    return nullptr;
  }
  const std::vector<RecognisedFormat> found = recognise(text, asked.file.filename().string(), library);
  if (found.empty()) {
    sink.add(host_diagnostic("IG-0124", asked.where, {asked.file.string()},
                             "`isogloss list importers` shows the formats; format=\"…\" names one"));
    return nullptr;
  }
  if (found.size() > 1 && found[0].confidence == found[1].confidence)
    sink.add(
        host_diagnostic("IG-0130", asked.where, {asked.file.string(), found[0].importer->id, found[1].importer->id}));
  return found[0].importer;
}

/// At most `most` bytes of a file; empty, with the reason, when it cannot be read.
std::optional<std::string> beginning_of(const fs::path& file, std::size_t most, std::string& reason) {
  const std::unique_ptr<Source> source = open_file(file.string(), reason);
  if (source == nullptr) return std::nullopt;
  std::string out;
  char buffer[16384];
  while (out.size() < most) {
    const std::size_t n = source->read(buffer, std::min(sizeof buffer, most - out.size()));
    if (n == 0) break;
    out.append(buffer, n);
  }
  reason = source->failure();
  return reason.empty() ? std::optional(std::move(out)) : std::nullopt;
}

/// The whole file; empty, with the reason, when it cannot be read or is too large.
std::optional<std::string> bytes_of(const fs::path& file, std::string& reason) {
  std::optional<std::string> out = beginning_of(file, most_bytes + 1, reason);
  if (!out || out->size() <= most_bytes) return out;
  reason = fmt::format("it is larger than {} MiB", most_bytes >> 20);
  return std::nullopt;
}

bool read_import_options(const ig_importer& importer, const Import& asked, std::vector<OptionValue>& values,
                         DiagnosticSink& sink) {
  bool is_sound = true;
  const auto report = [&](std::string_view code, const Location& where, std::initializer_list<std::string> arguments,
                          const std::string& hint) {
    sink.add(host_diagnostic(code, where, arguments, hint));
    is_sound = false;
  };
  const std::span<const ig_option_decl> declared(importer.options, importer.option_count);
  std::vector<Attribute> given = asked.options;
  if (asked.shares_options)
    std::erase_if(given, [&](const Attribute& a) {
      return std::none_of(declared.begin(), declared.end(), [&](const ig_option_decl& o) { return a.name == o.name; });
    });
  values = read_options(report, importer.id, asked.where, declared, given);
  return is_sound;
}

/// What an importer that is wholly sure of the beginning of a file that is no text tells of it; empty where none is.
/// Rows of such a file are never taken.
std::vector<Diagnostic> reports_of_binary(const Import& asked, const std::string& bytes, Library& library) {
  const std::string head = bytes.substr(0, std::min(bytes.find('\0'), looked_at));
  const std::string name = asked.file.filename().string();
  std::string reason;
  const std::optional<std::string> text = text_of_control(head, reason);
  const std::vector<RecognisedFormat> found =
      text && asked.format.empty() ? recognise(*text, name, library) : std::vector<RecognisedFormat>();
  if (found.empty() || found[0].confidence < 100) return {};
  const ig_importer& importer = *found[0].importer;
  const ig_plugin* plugin = nullptr;
  library.importer(importer.id, &plugin);
  std::vector<OptionValue> options;
  DiagnosticList reports;
  if (!read_import_options(importer, {asked.file, {}, {}, asked.where}, options, reports)) return {};
  ig_import in{asked, importer, *plugin, library, reports, *text, name, options, {}, {}, {}, {}, nullptr, {}};
  importer.read(&import_api(), &in);
  return in.out.tables.empty() ? std::move(reports.all) : std::vector<Diagnostic>();
}

}  // namespace

std::vector<RecognisedFormat> recognise(const std::string& text, const std::string& file_name, const Library& library) {
  std::vector<RecognisedFormat> out;
  const std::string_view head = std::string_view(text).substr(0, looked_at);
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->importer_count; ++i) {
      const ig_importer& importer = *p.plugin->importers[i];
      const std::uint32_t sure = importer.recognise(to_text(head), to_text(file_name));
      if (sure > 0) out.push_back({&importer, std::min(sure, 100u)});
    }
  std::stable_sort(out.begin(), out.end(),
                   [](const RecognisedFormat& a, const RecognisedFormat& b) { return a.confidence > b.confidence; });
  return out;
}

std::optional<std::string> head_of_control_file(const fs::path& file) {
  std::string reason;
  std::optional<std::string> bytes = beginning_of(file, 2 * looked_at, reason);  // a character may have two bytes
  return bytes ? text_of_control(std::move(*bytes), reason) : std::nullopt;
}

std::string what_is_no_text(const fs::path& file, Library& library) {
  std::string reason;
  const std::optional<std::string> bytes = beginning_of(file, 2 * looked_at, reason);
  if (!bytes || text_of_control(*bytes, reason)) return {};
  const std::vector<Diagnostic> reports = reports_of_binary({file, {}, {}, {}}, *bytes, library);
  return reports.empty() ? std::string() : reports[0].message;
}

std::vector<fs::path> files_of(const Import& asked, DiagnosticSink& sink) {
  std::error_code error;
  if (!fs::is_directory(asked.file, error)) return {asked.file};
  const fs::path folder = fs::canonical(asked.file, error);
  std::vector<fs::path> out;
  fs::recursive_directory_iterator it(asked.file, error);
  for (; !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    std::error_code ignored;
    if (!it->is_regular_file(ignored)) continue;
    const fs::path real = it->is_symlink(ignored) ? fs::canonical(it->path(), ignored) : folder;
    if (std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first != folder.end()) {
      sink.add(host_diagnostic("IG-0117", asked.where, {it->path().string(), asked.file.string()}));
    } else if (out.size() == most_files) {
      sink.add(host_diagnostic("IG-0126", asked.where,
                               {asked.file.string(), fmt::format("it holds more than {} files", most_files)}));
      break;
    } else {
      out.push_back(it->path());
    }
  }
  if (error) sink.add(host_diagnostic("IG-0126", asked.where, {asked.file.string(), error.message()}));
  std::sort(out.begin(), out.end());
  return out;
}

std::optional<ImportedFile> import_bytes(const Import& asked, std::string bytes, Library& library,
                                         DiagnosticSink& sink) {
  library.load_all();
  std::string reason;
  const std::optional<std::string> text = text_of_control(bytes, reason);
  if (!text) {
    std::vector<Diagnostic> reports = reports_of_binary(asked, bytes, library);
    if (reports.empty()) reports = {host_diagnostic("IG-0126", asked.where, {asked.file.string(), reason})};
    for (Diagnostic& d : reports) sink.add(std::move(d));
    return std::nullopt;
  }
  const ig_importer* const importer = choose(asked, *text, library, sink);
  if (importer == nullptr) return std::nullopt;
  const ig_plugin* plugin = nullptr;
  library.importer(importer->id, &plugin);
  std::vector<OptionValue> options;
  if (!read_import_options(*importer, asked, options, sink)) return std::nullopt;
  const std::string name = asked.file.filename().string();
  ig_import in{asked, *importer, *plugin, library, sink, *text, name, options, {}, {}, {}, {}, nullptr, {}};
  in.out.importer = importer;
  if (importer->read(&import_api(), &in) == IG_FAILED && in.is_sound) {
    sink.add(host_diagnostic("IG-0127", asked.where, {asked.file.string(), importer->id, in.failure}));
    return std::nullopt;
  }
  if (!in.is_sound) return std::nullopt;
  report_replaced(in);
  return std::move(in.out);
}

std::optional<ImportedFile> import_file(const Import& asked, Library& library, DiagnosticSink& sink) {
  std::string reason;
  std::error_code ignored;
  // A pipe that a user names is read; one that a machine's file names would block each run.
  const bool may_block = !asked.where.file.empty() && fs::exists(asked.file, ignored) &&
                         !fs::is_regular_file(asked.file, ignored) && !fs::is_directory(asked.file, ignored);
  if (may_block) reason = "it is no regular file";
  std::optional<std::string> bytes = may_block ? std::nullopt : bytes_of(asked.file, reason);
  if (bytes) return import_bytes(asked, std::move(*bytes), library, sink);
  sink.add(host_diagnostic("IG-0126", asked.where, {asked.file.string(), reason}));
  return std::nullopt;
}

std::optional<std::string> export_tables(const Import& asked, const std::vector<DependencyElement>& given,
                                         Library& library, std::vector<UnusedPart>& unused, DiagnosticSink& sink) {
  library.load_all();
  const ig_importer* const importer = choose(asked, {}, library, sink);
  if (importer == nullptr) return std::nullopt;
  if (importer->write == nullptr) {
    sink.add(host_diagnostic("IG-0131", asked.where, {importer->id}));
    return std::nullopt;
  }
  std::vector<OptionValue> options;
  if (!read_import_options(*importer, asked, options, sink)) return std::nullopt;
  ig_export out{given, library, options, unused, {}, {}};
  if (importer->write(&export_api(), &out) != IG_FAILED) {
    name_unasked(out, importer->dependencies);
    return std::move(out.out);
  }
  sink.add(host_diagnostic("IG-0127", asked.where, {asked.file.string(), importer->id, out.failure}));
  return std::nullopt;
}

}  // namespace isogloss
