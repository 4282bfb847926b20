#include "run/summary_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "json_text.hpp"

namespace isogloss::cli {

namespace {

/// At most 3 decimals, zeros trimmed.
std::string number(double value) {
  if (!std::isfinite(value)) return "too large";
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string duration(double seconds) {
  constexpr double longest = 1e15;
  if (!(seconds < longest)) return "too long";
  const auto whole = static_cast<std::uint64_t>(seconds);
  return fmt::format("{}:{:02}:{:04.1f}", whole / 3600, whole / 60 % 60,
                     static_cast<double>(whole % 60) + (seconds - static_cast<double>(whole)));
}

}  // namespace

std::string summary_text(const std::string& program, const std::string& dialect, const Summary& s,
                         const DiagnosticWriter& diagnostics) {
  std::string out;
  const auto line = [&](std::string_view name, const std::string& value) {
    out += fmt::format("{:<14} {}\n", std::string(name) + ":", value);
  };
  line("program", program);
  line("dialect", dialect);
  line("blocks", std::to_string(s.blocks));
  line("events", fmt::format("{} ({} rapids, {} feeds, {} arcs)", s.events, s.rapids, s.feeds, s.arcs));
  line("tool changes", std::to_string(s.tool_changes));
  line("rapid length", number(s.rapid_length_mm) + " mm");
  line("feed length", number(s.feed_length_mm) + " mm");
  for (std::size_t i = 0; s.any_motion && i < 6; ++i)
    if ((s.axes >> i & 1u) != 0)
      line(fmt::format("machine {}", "XYZABC"[i]), fmt::format("{} … {}", number(s.minimum[i]), number(s.maximum[i])));
  for (std::size_t i = 0; s.any_motion && i < 3; ++i)
    if ((s.axes >> (i + 3) & 1u) != 0) line(fmt::format("turned {}", "ABC"[i]), number(s.turned_deg[i]) + " deg");
  for (std::size_t i = 0; s.any_motion && i < 3; ++i)
    line(fmt::format("program {}", "XYZ"[i]),
         fmt::format("{} … {}", number(s.program_minimum[i]), number(s.program_maximum[i])));
  line("rapid time", s.rapid_time_known ? number(s.rapid_seconds) + " s" : "unknown (no rapid rates)");
  line("feed time", number(s.feed_seconds) + " s" + (s.feed_time_known ? "" : " and moves without a feed"));
  if (s.slowed_feeds != 0)
    line("slowed feeds", std::to_string(s.slowed_feeds) + " (an axis would pass its rapid rate)");
  line("dwell time", number(s.dwell_seconds) + " s");
  const double total = s.feed_seconds + s.dwell_seconds + (s.rapid_time_known ? s.rapid_seconds : 0);
  line("time", duration(total) + (s.rapid_time_known && s.feed_time_known ? "" : " and what is unknown"));
  if (diagnostics.by_code().empty()) line("diagnostics", "none");
  for (const auto& [code, count] : diagnostics.by_code())
    line("diagnostics", fmt::format("{} {} [{}]", count.number, to_string(count.severity), code));
  return out;
}

std::string summary_json(const std::string& program, const std::string& dialect, const Summary& s,
                         const DiagnosticWriter& diagnostics) {
  Json out{{"Isogloss", 1},
           {"Program", program},
           {"Dialect", dialect},
           {"Blocks", s.blocks},
           {"Events", s.events},
           {"Rapids", s.rapids},
           {"Feeds", s.feeds},
           {"Arcs", s.arcs},
           {"ToolChanges", s.tool_changes},
           {"SlowedFeeds", s.slowed_feeds},
           {"RapidLength_mm", s.rapid_length_mm},
           {"FeedLength_mm", s.feed_length_mm},
           {"RapidTime_s", s.rapid_time_known ? Json(s.rapid_seconds) : Json()},
           {"FeedTime_s", s.feed_seconds},
           {"FeedTimeIsKnown", s.feed_time_known},
           {"DwellTime_s", s.dwell_seconds},
           {"Time_s", s.feed_seconds + s.dwell_seconds + (s.rapid_time_known ? s.rapid_seconds : 0)},
           {"TimeIsKnown", s.rapid_time_known && s.feed_time_known}};
  Json machine = Json::object(), in_program = Json::object(), turned = Json::object();
  const auto range = [](double minimum, double maximum) { return Json{{"Minimum", minimum}, {"Maximum", maximum}}; };
  for (std::size_t i = 0; s.any_motion && i < 6; ++i) {
    if ((s.axes >> i & 1u) == 0) continue;
    const std::string axis(1, "XYZABC"[i]);
    machine[axis] = range(s.minimum[i], s.maximum[i]);
    if (i >= 3) turned[axis] = s.turned_deg[i - 3];
  }
  for (std::size_t i = 0; s.any_motion && i < 3; ++i)
    in_program[std::string(1, "XYZ"[i])] = range(s.program_minimum[i], s.program_maximum[i]);
  out["Machine"] = std::move(machine);
  out["ProgramXyz"] = std::move(in_program);
  out["Turned_deg"] = std::move(turned);
  Json& reported = out["Diagnostics"] = Json::array();
  for (const auto& [code, count] : diagnostics.by_code())
    reported.push_back({{"Code", code}, {"Severity", to_string(count.severity)}, {"Count", count.number}});
  return out.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace isogloss::cli
