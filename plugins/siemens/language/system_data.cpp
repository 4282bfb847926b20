// Which system variable a name means, and the values of those that are no frames: the position, the tool and its
// offsets, the codes in force.
#include "language/system_data.hpp"

#include <charconv>
#include <cmath>

#include "frames/settable_frames.hpp"
#include "tool/edge_row.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

/// True for data that move no axis here: names, types and magazine places of tools, clocks, counters.
bool moves_nothing(std::string_view base) {
  for (const std::string_view known :
       {"$AC_TIMER", "$AC_OPERATING_TIME", "$AC_CYCLE_TIME", "$AC_CUTTING_TIME", "$AC_REQUIRED_PARTS",
        "$AC_TOTAL_PARTS", "$AC_ACTUAL_PARTS", "$AC_SPECIAL_PARTS"})
    if (base == known) return true;
  if (base.starts_with("$TC_TP") || base.starts_with("$TC_MPP") || base.starts_with("$TC_DPCE")) return true;
  for (const std::string_view known : {"$TC_DP2", "$TC_DP10", "$TC_DP11", "$TC_DP24", "$TC_DP25"})
    if (base == known) return true;
  return false;
}

}  // namespace

SystemData::Name::Name(std::string_view text) : base(text.substr(0, text.find('['))) {
  if (base.size() == text.size()) return;
  text = text.substr(base.size() + 1, text.size() - base.size() - 2);
  for (;;) {
    const std::size_t end = std::min(text.find(','), text.size());
    if (count < index.size()) index[count] = text.substr(0, end);
    ++count;
    if (end == text.size()) return;
    text.remove_prefix(end + 1);
  }
}

std::optional<std::int64_t> SystemData::Name::number(std::size_t i) const {
  std::int64_t n = 0;
  if (i >= std::min(count, index.size())) return std::nullopt;
  const auto [end, error] = std::from_chars(index[i].data(), index[i].data() + index[i].size(), n);
  return error == std::errc{} && end == index[i].data() + index[i].size() ? std::optional(n) : std::nullopt;
}

std::optional<double> SystemData::read(const ig::Block& b, std::string_view text) const {
  const Name name(text);
  if (const auto p = position(b, name)) return p;
  if (const auto m = measured(b, name)) return m;
  if (const auto frame = frame_of(b, name)) return part_of_frame(b, name, *frame);
  if (name.base == "$P_PFRAME") return part_of_programmed(b, name);
  if (const auto row = offset_row(b, name)) return offset(b, *row, column_of(name));
  if (name.base == "$P_GG" && name.count == 1) return group(b, name.number(0).value_or(0));
  if (name.base == "$P_TOOLL" && name.count == 1)  // 1 lies along the tool; a milling tool has 0 for 2 and 3
    return name.index[0] == "1" ? b.get_or(length_, 0.0) / unit(b) : 0.0;
  return plain(b, name.base);
}

bool SystemData::takes(std::string_view text) {
  const Name name(text);
  return name.base == "$P_UIFR" || name.base == "$P_CHBFR" || name.base == "$P_UBFR" ||
         (name.base != "$P_AD" && column_of(name));
}

Written SystemData::write(const ig::Block& b, std::string_view text, std::optional<double> value) const {
  const Name name(text);
  if (const auto frame = frame_of(b, name); frame && name.base != "$P_IFRAME")
    return value ? write_frame(b, name, *frame, *value) : Written::no;
  if (name.base == "$P_AD") return Written::no;
  if (const auto row = offset_row(b, name); row && value && tools_) {
    const bool is_type = *column_of(name) == IG_TOOL_TYPE;
    const double mm = is_type ? *value : *value * unit(b);
    const bool done = (!is_type || mm == std::floor(mm)) && std::fabs(mm) < 1e9 &&
                      tools_->set(tools_->self, *row, *column_of(name), mm) != 0;
    return done ? Written::taken : Written::no;
  }
  return moves_nothing(name.base) ? Written::without_effect : Written::no;
}

std::optional<double> SystemData::position(const ig::Block& b, const Name& name) const {
  const bool of_machine = name.base == "$AA_IM";
  if (!of_machine && name.base != "$AA_IW" && name.base != "$P_EP" && name.base != "$AA_WCS") return std::nullopt;
  if (const auto further = name.count == 1 ? axes_.find(name.index[0]) : std::nullopt;
      further && is_further_axis(*further)) {
    const auto at = b.get(further_axes_.position(*further));
    return at && !axes_.is_rotary(*further) ? *at / unit(b) : at;
  }
  const std::size_t axis = name.count == 1 ? axis_of(name.index[0]) : std::string_view::npos;
  if (axis == std::string_view::npos) return std::nullopt;
  const auto at = b.get(of_machine || axis > 2 ? machine_[axis] : program_[axis]);
  if (!at) return at;
  if (axis < 3) return *at / unit(b);
  if (of_machine) return at;
  return *at - (turned_.get(b).value[axis - 3] + programmable_.get(b).value[axis - 3]);
}

std::optional<double> SystemData::measured(const ig::Block& b, const Name& name) const {
  if (name.base == "$AC_MEA" && name.count == 1) {
    const auto probe = b.get(measured_.probe());
    return probe ? std::optional(*probe == name.number(0) ? 1.0 : 0.0) : std::nullopt;
  }
  const bool of_machine = name.base == "$AA_MM";
  const std::size_t axis = name.count == 1 ? axis_of(name.index[0]) : std::string_view::npos;
  if ((!of_machine && name.base != "$AA_MW") || axis == std::string_view::npos) return std::nullopt;
  const auto at = b.get(of_machine || axis > 2 ? measured_.machine(axis) : measured_.program(axis));
  if (!at) return at;
  if (axis < 3) return *at / unit(b);
  if (of_machine) return at;
  return *at - (turned_.get(b).value[axis - 3] + programmable_.get(b).value[axis - 3]);
}

// ---- Tools

std::optional<std::uint32_t> SystemData::column_of(const Name& name) {
  std::string_view number = name.base.starts_with("$TC_DP") ? name.base.substr(6) : std::string_view();
  if (name.base == "$P_AD" && name.count == 1) number = name.index[0];
  if (number == "1") return IG_TOOL_TYPE;
  if (number == "3") return IG_TOOL_LENGTH;
  if (number == "12") return IG_TOOL_LENGTH_WEAR;
  if (number == "6") return IG_TOOL_RADIUS;
  if (number == "15") return IG_TOOL_RADIUS_WEAR;
  if (number == "7") return IG_TOOL_CORNER_RADIUS;
  if (number == "16") return IG_TOOL_CORNER_RADIUS_WEAR;
  return std::nullopt;
}

std::optional<std::int64_t> SystemData::offset_row(const ig::Block& b, const Name& name) const {
  if (!column_of(name)) return std::nullopt;
  if (name.base == "$P_AD") return b.get_or(row_, std::int64_t{0});
  const auto tool = name.number(0), edge = name.number(1);
  if (name.count != 2 || !tool || !edge || *tool < 1 || *edge < 1 || *edge > 99 || *tool >= IG_TOOL_INDEX_STEP)
    return std::nullopt;
  return edge_row(tools_, *tool, *edge, edge_step);
}

std::optional<double> SystemData::offset(const ig::Block& b, std::int64_t row,
                                         std::optional<std::uint32_t> column) const {
  double mm = 0;
  if (row == 0) return 0;
  if (!tools_ || !column || tools_->get(tools_->self, row, *column, &mm) == 0) return std::nullopt;
  return *column == IG_TOOL_TYPE ? mm : mm / unit(b);
}

std::optional<double> SystemData::plain(const ig::Block& b, std::string_view name) const {
  const std::int64_t row = b.get_or(row_, std::int64_t{0});
  if (name == "$P_TOOLNO" || name == "$TC_MPP6")
    if (const auto tool = b.get(tool_)) return static_cast<double>(*tool);
  if (name == "$P_TOOLP")  // the preselected tool
    if (const auto tool = b.get(next_tool_)) return static_cast<double>(*tool);
  if (name == "$P_TOOL") return static_cast<double>(b.get_or(edge_, std::int64_t{0}));
  if (name == "$P_TOOLR")
    if (const auto own = offset(b, row, 2), wear = offset(b, row, 3); own && wear) return *own + *wear;
  if (name == "$P_F" || name == "$AC_F") {
    const auto feed = b.get(feed_);
    return feed && !b.is(feed_mode_, g93_) ? std::optional(*feed / unit(b)) : feed;
  }
  if (name == "$P_S") return b.get(speed_);
  if (name == "$P_SDIR") return b.is(direction_, cw_) ? 3 : b.is(direction_, ccw_) ? 4 : 5;
  if (name == "$P_UIFRNUM") return offset_number(b) - 1;
  // The program runs from its beginning as on the machine: no block search, no simulation, no test. Markers and
  // parameters of the channel are 0 until the program writes them.
  for (const std::string_view off : {"$P_SEARCH", "$P_SIM", "$P_ISTEST", "$P_DRYRUN", "$AC_MARKER", "$AC_PARAM"})
    if (name == off) return 0;
  return std::nullopt;
}

// ---- Codes in force

double SystemData::offset_number(const ig::Block& b) const {
  const std::string_view id = b.text(b.get_or(offset_id_, ig::Symbol{}));
  std::int64_t code = 500;
  if (id.size() > 1) std::from_chars(id.data() + 1, id.data() + id.size(), code);
  return static_cast<double>(settable_number(code) + 1);
}

std::optional<double> SystemData::group(const ig::Block& b, std::int64_t group) const {
  const auto index = [&](const ig::In<ig::Symbol>& field, std::initializer_list<std::string_view> codes) {
    double n = 0;
    const std::string_view term = b.text(b.get_or(field, ig::Symbol{}));
    for (const std::string_view code : codes) {
      ++n;
      if (code == term) return std::optional(n);
    }
    return std::optional<double>();
  };
  switch (group) {
    case 1: return index(motion_, {"G00", "G01", "G02", "G03", "CIP"});
    case 6: return index(plane_, {"G17", "G18", "G19"});
    case 7: return index(compensation_, {"G40", "G41", "G42"}).value_or(1);
    case 8: return offset_number(b);
    case 13: return index(unit_term_, {"G70", "G71", "G700", "G710"});
    case 14: return index(positioning_, {"G90", "G91"});
    case 15: return index(feed_mode_, {"G93", "G94", "G95", "G96", "G97"});
    default: return std::nullopt;
  }
}

}  // namespace siemens
