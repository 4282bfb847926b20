#include "view/view_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "view/assets.hpp"
#include "view/explanations.hpp"
#include "view/payload.hpp"

namespace isogloss::cli::viewing {

namespace {

/// The whole program; what can no longer be read is empty.
std::string bytes_of(Source& source) {
  std::string out;
  char buffer[1 << 16];
  while (const std::size_t n = source.read(buffer, sizeof buffer)) out.append(buffer, n);
  return out;
}

std::string text_of_file(const Viewed& viewed, std::size_t file, Session& session) {
  if (file == 0) {
    const std::unique_ptr<Source> source = viewed.program->source(session);
    return source == nullptr ? std::string() : bytes_of(*source);
  }
  std::string error;
  const std::optional<std::string> text = read_text(viewed.files[file], error);
  return text ? *text : "";
}

std::size_t place_of(const std::vector<std::string>& files, std::string_view name) {
  return static_cast<std::size_t>(std::find(files.begin(), files.end(), name) - files.begin());
}

/// Of all that is shown: near it single precision is enough, and both sides stand where they are.
Point middle_of(const Viewed& viewed) {
  Extent all;
  for (const auto& run : viewed.runs)
    if (!run->path.extent.is_empty) {
      all.add(run->path.extent.minimum);
      all.add(run->path.extent.maximum);
    }
  Point out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = (all.minimum[i] + all.maximum[i]) / 2;
  return out;
}

Json diagnostics_of(const Viewed& viewed) {
  Json out = Json::array();
  for (std::size_t side = 0; side < viewed.runs.size(); ++side)
    for (const Diagnostic& d : viewed.runs[side]->reports.kept) {
      const std::size_t file = place_of(viewed.files, d.where.file);
      Json one{{"path", side},        {"line", d.where.line}, {"column", d.where.column},
               {"end", d.end_column}, {"code", d.code},       {"severity", to_string(d.severity)},
               {"message", d.message}};
      one["file"] = file < viewed.files.size() ? Json(file) : Json();
      if (!d.hint.empty()) one["hint"] = d.hint;
      out.push_back(std::move(one));
    }
  return out;
}

Json differences_of(const Viewed& viewed) {
  Json out = Json::array();
  for (const PathDifference& d : viewed.differences)
    out.push_back({{"file", place_of(viewed.files, d.file)}, {"line", d.line}, {"what", d.what}});
  return out;
}

/// By path, file and line; null where a program has too many lines.
Json explanations_of(const Viewed& viewed, const PageOptions& options, std::size_t lines_of_main, Session& session) {
  if (lines_of_main > options.explained_lines) return nullptr;
  constexpr std::size_t most_files = 8;
  const std::size_t most_blocks = std::size_t{2} * options.explained_lines;
  Json out = Json::array();
  for (const auto& run : viewed.runs) {
    Json by_file = Json::object();
    for (std::size_t file = 0; file < std::min(viewed.files.size(), most_files); ++file) {
      Json& lines = by_file[std::to_string(file)] = Json::object();
      for (auto& [line, text] : explain_lines(*run, *viewed.program, file == 0 ? "" : viewed.files[file], 1,
                                              options.explained_lines, most_blocks, session))
        lines[std::to_string(line)] = std::move(text);
    }
    out.push_back(std::move(by_file));
  }
  return out;
}

/// What a script element may hold: no "<" of a program can end it.
std::string script_text(const Json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

void append_data(std::string& out, const std::string& id, std::string_view bytes) {
  out += fmt::format("<script type=\"application/base64\" id=\"{}\">", id);
  append_base64(out, bytes);
  out += "</script>\n";
}

void append_modules(std::string& out) {
  for (const std::string_view name : modules)
    out += fmt::format("<script type=\"text/x-module\" data-module=\"{}\">{}</script>\n", name, asset(name));
  out += fmt::format("<script>{}</script>\n", asset("loader.js"));
}

}  // namespace

std::string security_policy(bool is_served) {
  return fmt::format(
      "default-src 'none'; script-src '{}' blob:; style-src '{}'; img-src data:{}; base-uri 'none'; form-action 'none'",
      asset("loader.js.hash"), asset("page.css.hash"), is_served ? "; connect-src 'self'" : "");
}

std::string make_page(const Viewed& viewed, const PageOptions& options, Session& session) {
  Json facts{{"program", std::filesystem::path(viewed.program->path()).filename().string()}, {"files", viewed.files}};
  std::string data;
  const Point origin = middle_of(viewed);
  Json paths = Json::array();
  std::uint64_t reported = 0;
  for (const auto& run : viewed.runs) {
    std::vector<std::size_t> places;
    for (const std::string& file : run->path.files) places.push_back(place_of(viewed.files, file));
    Json path{{"dialect", run->linked->dialect.name}};
    append_data(data, fmt::format("path-{}", paths.size()), payload(run->path, origin, places, path));
    paths.push_back(std::move(path));
    reported += run->reports.number;
  }
  std::size_t lines_of_main = 0;
  for (std::size_t i = 0; i < viewed.files.size(); ++i) {
    const std::string text = text_of_file(viewed, i, session);
    if (i == 0) lines_of_main = 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    append_data(data, fmt::format("text-{}", i), text);
  }
  facts["paths"] = std::move(paths);
  facts["diagnostics"] = diagnostics_of(viewed);
  facts["reported"] = reported;
  facts["differences"] = differences_of(viewed);
  facts["explanations"] = explanations_of(viewed, options, lines_of_main, session);
  facts["explainedLines"] = options.explained_lines;
  facts["version"] = options.version ? Json(*options.version) : Json();
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Isogloss</title>\n"
      "<style>{}</style>\n</head>\n{}",
      security_policy(options.version.has_value()), asset("page.css"), asset("page.html"));
  out += fmt::format("<script type=\"application/json\" id=\"facts\">{}</script>\n", script_text(facts));
  out += data;
  append_modules(out);
  return out + "</body>\n</html>\n";
}

}  // namespace isogloss::cli::viewing
