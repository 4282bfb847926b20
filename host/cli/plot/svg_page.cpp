#include "plot/svg_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "markup.hpp"
#include "palette.hpp"
#include "plot/drawing.hpp"

namespace isogloss::cli::plotting {

namespace {

constexpr double page_width = 1000, head = 92, panel_width = 488, panel_height = 400, gutter = 8;
constexpr std::size_t legend_columns = 3, most_in_legend = 60;

std::string with_thousands(std::uint64_t number) {
  std::string out = std::to_string(number);
  for (std::size_t i = out.size(); i > 3; i -= 3) out.insert(i - 3, 1, ',');
  return out;
}

/// In mm, without zeros at the end.
std::string length_text(double mm) {
  std::string out = fmt::format("{:.3f}", mm);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

double row_of(std::size_t entry) {
  const std::size_t row = entry / legend_columns;
  return static_cast<double>(row);
}

std::string style() {
  std::string out =
      "svg{background:#fff}text{font:12px system-ui,sans-serif;fill:#222}.title{font-size:20px;font-weight:600}"
      ".small{font-size:11px;fill:#666}.paper{fill:#fff}.panel{fill:#fafbfc;stroke:#d8dce2}"
      "path{fill:none;stroke-width:1;stroke-linejoin:round;stroke-linecap:round}"
      ".rapid{stroke:#999;stroke-width:.7;stroke-dasharray:4 3;stroke-linecap:butt}.bar{stroke:#222;stroke-width:1.5}";
  std::string dark =
      "svg{background:#15181d}.paper{fill:#15181d}text{fill:#e6e8eb}.small{fill:#9aa3ad}"
      ".panel{fill:#1b1f26;stroke:#39404a}.rapid{stroke:#7d8590}.bar{stroke:#e6e8eb}";
  for (std::size_t i = 0; i < tool_colours.size(); ++i) {
    out += fmt::format(".c{}{{stroke:{}}}", i, tool_colours[i].on_light);
    dark += fmt::format(".c{}{{stroke:{}}}", i, tool_colours[i].on_dark);
  }
  return out + "@media(prefers-color-scheme:dark){" + dark + "}";
}

std::string text_at(double x, double y, std::string_view text, std::string_view kind = "", bool at_end = false) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}{}>{}</text>\n", x, y,
                     kind.empty() ? "" : fmt::format(" class=\"{}\"", kind), at_end ? " text-anchor=\"end\"" : "",
                     visible_xml(text));
}

/// 1, 2 or 5 times a power of ten that is about 90 px long.
std::string scale_bar(const Projection& view, double left, double bottom) {
  constexpr double wanted_px = 90;
  const double mm = wanted_px / view.scale(), power = std::pow(10, std::floor(std::log10(mm)));
  const double length = power * (mm / power >= 5 ? 5 : mm / power >= 2 ? 2 : 1), px = length * view.scale();
  return fmt::format("<path class=\"bar\" d=\"M{0:.1f} {1:.1f}v6m0-3h{2:.1f}m0-3v6\"/>\n", left, bottom - 6, px) +
         text_at(left + px + 6, bottom + 1, fmt::format("{:.6g} mm", length), "small");
}

class SvgPage {
 public:
  SvgPage(const std::string& program, const PathRun& run)
      : run_(run), path_(run.path), name_(std::filesystem::path(program).filename().string()) {
    thinning_.is_on = path_.moves.size() > most_in_full;
    shown_.resize(path_.moves.size());
    thinning_.shown = &shown_;
  }

  std::string text() {
    const std::string panels = make_panels();
    const std::string legend = make_legend();
    const double height = head + 2 * (panel_height + gutter) + legend_height_ + 30;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\">\n"
        "<title>{2}</title>\n<style>{3}</style>\n<rect class=\"paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n",
        page_width, height, visible_xml(name_), style());
    return out + make_head() + panels + legend + make_notes(height) + "</svg>\n";
  }

 private:
  std::string make_head() const {
    std::string out = text_at(20, 34, name_ == "-" ? "standard input" : name_, "title");
    out += text_at(980, 34, run_.linked->dialect.name, "", true);
    if (path_.extent.is_empty) return out + text_at(20, 62, "The program moves nothing.");
    std::string extents;
    for (std::size_t i = 0; i < 3; ++i)
      extents += fmt::format("{}{} {} to {} mm ({})", i == 0 ? "" : ",  ", "XYZ"[i],
                             length_text(path_.extent.minimum[i]), length_text(path_.extent.maximum[i]),
                             length_text(path_.extent.maximum[i] - path_.extent.minimum[i]));
    out += text_at(20, 58, extents);
    const double all = path_.rapid_seconds + path_.feed_seconds + path_.dwell_seconds;
    std::string time = fmt::format("Tip of the tool, machine coordinates. {} moves, {}",
                                   with_thousands(path_.moves.size()), duration(all));
    if (path_.assumed_rapids > 0) time += "; rapids assumed at 10,000 mm/min, as the machine declares no rapid rate";
    if (path_.assumed_feeds > 0)
      time += fmt::format("; {} moves without a feed at 1,000 mm/min", with_thousands(path_.assumed_feeds));
    return out + text_at(20, 78, time + ".", "small");
  }

  std::string make_panels() {
    constexpr double third = 0.7071067811865476, sixth = 0.408248290463863;
    Projection views[] = {{"XY, from above", {1, 0, 0}, {0, 1, 0}},
                          {"isometric", {third, third, 0}, {-sixth, sixth, 2 * sixth}},
                          {"XZ, from the front", {1, 0, 0}, {0, 0, 1}},
                          {"YZ, from the right", {0, 1, 0}, {0, 0, 1}}};
    std::string out;
    for (std::size_t i = 0; i < std::size(views); ++i) {
      const Frame panel{gutter + static_cast<double>(i % 2) * (panel_width + gutter),
                        head + (i < 2 ? 0 : panel_height + gutter), panel_width, panel_height};
      constexpr double margin = 24, foot = 34, top = 34;
      views[i].fit(path_.extent,
                   {panel.x + margin, panel.y + top, panel.width - 2 * margin, panel.height - top - foot});
      out += fmt::format("<rect class=\"panel\" x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" rx=\"4\"/>\n",
                         panel.x, panel.y, panel.width, panel.height);
      out += text_at(panel.x + 12, panel.y + 20, views[i].name());
      if (path_.extent.is_empty) continue;
      out += axes_of(views[i], panel) + draw(views[i]) + scale_bar(views[i], panel.x + 12, panel.y + panel.height - 10);
    }
    return out;
  }

  /// The directions of the axes, in the corner of the panel.
  static std::string axes_of(const Projection& view, const Frame& panel) {
    std::string out;
    const Spot origin{panel.x + panel.width - 46, panel.y + panel.height - 30};
    for (std::size_t i = 0; i < 3; ++i) {
      Point unit{};
      unit[i] = 18 / view.scale();
      const Spot to = view.vector(unit);
      if (std::hypot(to.x, to.y) < 1) continue;
      out += fmt::format("<path class=\"bar\" d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}\"/>\n", origin.x, origin.y, to.x, to.y);
      out += text_at(origin.x + to.x * 1.5 - 4, origin.y + to.y * 1.5 + 4, std::string(1, "XYZ"[i]), "small");
    }
    return out;
  }

  std::string draw(const Projection& view) {
    std::vector<std::unique_ptr<Pen>> pens(tool_colours.size() + 1);
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      const PathMove& m = path_.moves[i];
      if (m.kind == PathMove::Kind::dwell) continue;
      const std::size_t pen = m.kind == PathMove::Kind::rapid ? pens.size() - 1 : m.tool % tool_colours.size();
      if (pens[pen] == nullptr) pens[pen] = std::make_unique<Pen>(view, thinning_);
      pens[pen]->draw(path_, i);
    }
    std::string out;
    if (pens.back() != nullptr) out += fmt::format("<path class=\"rapid\" d=\"{}\"/>\n", pens.back()->data());
    for (std::size_t i = 0; i + 1 < pens.size(); ++i)
      if (pens[i] != nullptr) out += fmt::format("<path class=\"c{}\" d=\"{}\"/>\n", i, pens[i]->data());
    return out;
  }

  std::string make_legend() {
    std::string out;
    std::size_t entries = 0;
    const double top = head + 2 * (panel_height + gutter) + 22;
    const auto add = [&](const std::string& pen, const std::string& text) {
      const double x = 20 + static_cast<double>(entries % legend_columns) * 320, y = top + row_of(entries) * 20;
      if (!pen.empty()) out += fmt::format("<path class=\"{}\" d=\"M{:g} {:g}h28\"/>\n", pen, x, y - 4);
      out += text_at(x + (pen.empty() ? 0 : 36), y, text);
      ++entries;
    };
    add("rapid", "rapid");
    for (std::size_t i = 0; i < path_.tools.size() && entries < most_in_legend; ++i) {
      const PathTool& tool = path_.tools[i];
      if (tool.moves == 0) continue;
      std::string name = tool.number == 0 ? "no tool called" : fmt::format("T{}", tool.number);
      if (!tool.name.empty()) name += " " + tool.name;
      add(fmt::format("c{}", i % tool_colours.size()), fmt::format("{}, {} moves", name, with_thousands(tool.moves)));
    }
    if (path_.tools.size() > most_in_legend) add("", fmt::format("{} tools in all", path_.tools.size()));
    legend_height_ = row_of(entries + legend_columns - 1) * 20 + 16;
    return out;
  }

  std::string make_notes(double height) const {
    std::string out;
    if (path_.tools.size() > tool_colours.size() + 1)
      out += fmt::format("The colours begin anew after {} tools. ", tool_colours.size());
    if (thinning_.is_on) {
      const auto drawn = static_cast<std::uint64_t>(std::count(shown_.begin(), shown_.end(), true));
      out += fmt::format("Thinned to what can be seen: {} of {} moves are left out, which others cover.",
                         with_thousands(path_.moves.size() - drawn), with_thousands(path_.moves.size()));
    }
    if (path_.is_cut) out += " The program has more moves than this picture holds.";
    return out.empty() ? out : text_at(20, height - 14, out, "small");
  }

  static constexpr std::size_t most_in_full = 20'000;
  const PathRun& run_;
  const ToolPath& path_;
  const std::string name_;
  Thinning thinning_;
  std::vector<bool> shown_;
  double legend_height_ = 0;
};

}  // namespace

std::string duration(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds < minute) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<std::uint64_t>(std::llround(std::min(seconds, 1e12)));
  if (seconds < hour) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string svg_page(const std::string& program, const PathRun& run) { return SvgPage(program, run).text(); }

}  // namespace isogloss::cli::plotting
