// The chain as a page of text, and as a drawing: declared order on the left, fields on the right.
#include <fmt/format.h>

#include <map>

#include "dialect/chain_map.hpp"
#include "markup.hpp"

namespace isogloss::cli {

namespace {

std::string listed(const Json& names, std::size_t most) {
  return isogloss::listed(names.get<std::vector<std::string>>(), most);
}

std::string drawn_place(const Json& syntax) {
  return short_place({syntax["File"].get<std::string>(), syntax["Line"].get<std::uint32_t>(), 0});
}

/// Where a syntax is drawn.
struct Drawn {
  std::string name;
  int y;
};

constexpr int row_height = 22, box_x = 330, box_width = 300, box_middle = 11;

std::string arc(const Drawn& from, const Drawn& to, bool on_left, std::string_view why) {
  const int x = on_left ? box_x : box_x + box_width;
  const int reach = std::min(300, 24 + (to.y - from.y) / 3);
  const int bend = on_left ? x - reach : x + reach;
  return fmt::format("<path class=\"{}\" d=\"M{} {} C{} {} {} {} {} {}\"><title>{} → {}: {}</title></path>\n",
                     on_left ? "order" : "field", x, from.y + box_middle, bend, from.y + box_middle, bend,
                     to.y + box_middle, x, to.y + box_middle, escaped_xml(from.name), escaped_xml(to.name),
                     escaped_xml(why));
}

constexpr std::string_view style =
    "<style>text{font:13px sans-serif;fill:#222}.stage{font-weight:bold}.legend,.place{font-size:11px;fill:#555}"
    "rect{fill:#eef3fa;stroke:#7892b5}path{fill:none;stroke-width:1.2;opacity:.55}path:hover{stroke-width:3;opacity:1}"
    ".order{stroke:#b0412c}.field{stroke:#2c6fb0}</style>\n";

}  // namespace

std::string chain_as_text(const Json& chain) {
  constexpr std::size_t most_names = 8;
  std::string out = fmt::format("{}: {}", chain["Dialect"].get<std::string>(), chain["File"].get<std::string>());
  if (!chain["Extends"].empty()) out += ", extends " + listed(chain["Extends"], most_names);
  out += '\n';
  for (const Json& stage : chain["Stages"]) {
    out += "\n" + stage["Stage"].get<std::string>() + "\n";
    for (const Json& s : stage["Syntaxes"]) {
      const std::string alias = s["As"], id = s["Syntax"];
      out += fmt::format("{:>4} {}  [{}, {}]\n", s["Position"].get<int>(),
                         alias == id ? alias : fmt::format("{} ({})", alias, id), s["Plugin"].get<std::string>(),
                         drawn_place(s));
      if (!s["After"].empty()) out += "       after   " + listed(s["After"], SIZE_MAX) + "\n";
      if (!s["Before"].empty()) out += "       before  " + listed(s["Before"], SIZE_MAX) + "\n";
      if (!s["Takes"].empty()) out += "       takes   " + listed(s["Takes"], most_names) + "\n";
      for (const Json& w : s["Writes"])
        out += fmt::format("       writes  {} for {}\n", w["Field"].get<std::string>(), listed(w["For"], most_names));
    }
  }
  return out;
}

std::string chain_as_svg(const Json& chain, const std::function<std::string(const std::string&)>& link) {
  std::map<std::string, Drawn> drawn;
  std::string boxes;
  int y = 50;
  for (const Json& stage : chain["Stages"]) {
    boxes += fmt::format("<text class=\"stage\" x=\"{}\" y=\"{}\">{}</text>\n", box_x, y + 16,
                         escaped_xml(stage["Stage"].get<std::string>()));
    y += row_height + 2;
    for (const Json& s : stage["Syntaxes"]) {
      const std::string alias = s["As"];
      drawn[alias] = {alias, y};
      const std::string target = link ? link(s["Syntax"].get<std::string>()) : std::string();
      if (!target.empty()) boxes += fmt::format("<a href=\"{}\">", target);
      boxes += fmt::format(
          "<g><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"18\" rx=\"4\"/>"
          "<text x=\"{}\" y=\"{}\">{}</text><title>{} {}</title></g>{}\n",
          box_x, y + 2, box_width, box_x + 8, y + 16, escaped_xml(alias), escaped_xml(drawn_place(s)),
          escaped_xml(listed(s["Takes"], SIZE_MAX)), target.empty() ? "" : "</a>");
      y += row_height;
    }
    y += row_height / 2;
  }
  std::string arcs;
  for (const Json& stage : chain["Stages"])
    for (const Json& s : stage["Syntaxes"]) {
      const Drawn& from = drawn[s["As"].get<std::string>()];
      for (const Json& to : s["Before"]) arcs += arc(from, drawn[to.get<std::string>()], true, "declared");
      std::map<std::string, std::string> fields;  // one arc for all fields between two syntaxes
      for (const Json& w : s["Writes"])
        for (const Json& to : w["For"]) {
          std::string& all = fields[to.get<std::string>()];
          all += (all.empty() ? "" : ", ") + w["Field"].get<std::string>();
        }
      for (const auto& [to, all] : fields) arcs += arc(from, drawn[to], false, all);
    }
  const int width = box_x + box_width + 330;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n", width,
             y + 10) +
         std::string(style) +
         fmt::format("<rect x=\"0\" y=\"0\" width=\"{}\" height=\"{}\" style=\"fill:#fff;stroke:none\"/>\n", width,
                     y + 10) +
         fmt::format("<text class=\"stage\" x=\"10\" y=\"20\">{}</text>\n",
                     escaped_xml(chain["Dialect"].get<std::string>())) +
         "<text class=\"legend\" x=\"10\" y=\"38\">left, red: declared order; right, blue: the upper one writes a "
         "field that the lower one reads</text>\n" +
         arcs + boxes + "</svg>\n";
}

}  // namespace isogloss::cli
