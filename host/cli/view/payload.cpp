#include "view/payload.hpp"

#include <algorithm>
#include <bit>
#include <map>

#include "palette.hpp"

namespace isogloss::cli::viewing {

namespace {

static_assert(std::endian::native == std::endian::little, "the columns are written as they stand in memory");

template <class Number>
class Column {
 public:
  explicit Column(std::string& out) : out_(out) {}
  void add(Number value) {
    const char* const bytes = reinterpret_cast<const char*>(&value);
    out_.append(bytes, sizeof value);
  }

 private:
  std::string& out_;
};

void append_points(const ToolPath& path, const Point& origin, std::string& out) {
  Column<float> numbers(out);
  for (const Point& p : path.points)
    for (std::size_t i = 0; i < 3; ++i) numbers.add(static_cast<float>(p[i] - origin[i]));
  if (!path.turns_axes) return;
  for (const auto& turn : path.turns)
    for (const float value : turn) numbers.add(value);
}

/// Whether a move begins elsewhere than the one before it ended.
bool jumps(const ToolPath& path, std::size_t move) {
  if (move == 0) return path.moves[0].first != 0;
  const PathMove& before = path.moves[move - 1];
  return path.moves[move].first != before.first + before.segments;
}

std::uint8_t flags_of(const ToolPath& path, std::size_t move) {
  const PathMove& m = path.moves[move];
  constexpr unsigned jump = 4, differs = 8, assumed = 16;
  return static_cast<std::uint8_t>(static_cast<unsigned>(m.kind) | (jumps(path, move) ? jump : 0) |
                                   (m.differs ? differs : 0) | (m.is_time_assumed ? assumed : 0));
}

/// Tool and file of the moves: few pairs, many moves.
class Contexts {
 public:
  std::uint16_t number(const PathMove& m, const std::vector<std::size_t>& files) {
    const std::pair<std::size_t, std::size_t> pair{m.tool, files[m.file]};
    if (pair == last_) return last_number_;
    const auto [found, is_new] = numbers_.try_emplace(pair, static_cast<std::uint16_t>(all.size()));
    if (is_new) all.push_back(Json::array({pair.first, pair.second}));
    last_ = pair;
    return last_number_ = found->second;
  }
  Json all = Json::array();

 private:
  std::map<std::pair<std::size_t, std::size_t>, std::uint16_t> numbers_;
  std::pair<std::size_t, std::size_t> last_{SIZE_MAX, SIZE_MAX};
  std::uint16_t last_number_ = 0;
};

Json tools_of(const ToolPath& path) {
  Json out = Json::array();
  for (std::size_t i = 0; i < path.tools.size(); ++i) {
    const PathTool& tool = path.tools[i];
    const ToolColour& colour = tool_colours[i % tool_colours.size()];
    out.push_back({{"number", tool.number},
                   {"name", tool.name},
                   {"radius", tool.radius_mm},
                   {"length", tool.length_mm},
                   {"moves", tool.moves},
                   {"colour", {colour.on_light, colour.on_dark}}});
  }
  return out;
}

Json json_of_kinematics(const PathKinematics& kinematics) {
  if (!kinematics.is_known) return nullptr;
  Json tables = Json::array();
  for (const TurningTable& table : kinematics.tables)
    tables.push_back({{"axis", table.axis}, {"direction", table.direction}, {"point", table.point}});
  return {{"axes", kinematics.axes}, {"zero", kinematics.zero}, {"tables", std::move(tables)}};
}

}  // namespace

void append_base64(std::string& out, std::string_view bytes) {
  constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  out.reserve(out.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 3; ++k) value = value << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= n ? alphabet[value >> (18 - 6 * k) & 63] : '=';
  }
}

std::string payload(const ToolPath& path, const Point& origin, const std::vector<std::size_t>& files, Json& facts) {
  std::string out;
  constexpr std::size_t bytes_of_move = 17, bytes_of_point = 12;
  out.reserve(path.moves.size() * bytes_of_move + path.points.size() * (path.turns_axes ? 3 : 1) * bytes_of_point);
  append_points(path, origin, out);
  for (const PathMove& m : path.moves) Column<std::uint32_t>(out).add(m.line);
  for (const PathMove& m : path.moves) Column<float>(out).add(m.seconds);
  for (const PathMove& m : path.moves) Column<float>(out).add(m.feed_mm_s);
  for (const PathMove& m : path.moves) Column<std::uint16_t>(out).add(static_cast<std::uint16_t>(m.segments));
  Contexts contexts;
  for (const PathMove& m : path.moves) Column<std::uint16_t>(out).add(contexts.number(m, files));
  for (std::size_t i = 0; i < path.moves.size(); ++i) Column<std::uint8_t>(out).add(flags_of(path, i));
  facts["moves"] = path.moves.size();
  facts["points"] = path.points.size();
  facts["turnsAxes"] = path.turns_axes;
  facts["origin"] = origin;
  facts["contexts"] = std::move(contexts.all);
  facts["tools"] = tools_of(path);
  facts["minimum"] = path.extent.minimum;
  facts["maximum"] = path.extent.maximum;
  facts["isEmpty"] = path.extent.is_empty;
  facts["rapidSeconds"] = path.rapid_seconds;
  facts["feedSeconds"] = path.feed_seconds;
  facts["dwellSeconds"] = path.dwell_seconds;
  facts["assumedRapids"] = path.assumed_rapids;
  facts["assumedFeeds"] = path.assumed_feeds;
  facts["isCut"] = path.is_cut;
  facts["kinematics"] = json_of_kinematics(path.kinematics);
  return out;
}

}  // namespace isogloss::cli::viewing
