// Each frame by axis: coarse and fine offset, rotation, scale, mirror.
#include "archive/frame_rows.hpp"

#include <cmath>
#include <stdexcept>

#include <isogloss/cnc/file_length.hpp>

#include "frames/settable_frames.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr double largest_shift = 1e7;  // mm or degrees; sums of them stay inside the table's range
constexpr std::int64_t most_base_frames = 16;
constexpr const char* base_frames = "$P_CHBFR";

}  // namespace

FrameRows::FrameRows(const std::string& axes) {
  std::string own = "XYZABC";
  for (const std::string_view pair : split(axes)) {
    if (pair.empty()) continue;
    Cursor cursor(pair);
    const std::string machine = upper(cursor.word());
    const bool has_sign = cursor.accept('=');
    const std::string letter = upper(cursor.word());
    if (machine.empty() || !has_sign || letter.size() != 1 || std::string_view("XYZABC").find(letter[0]) > 5 ||
        !cursor.is_at_end())
      throw std::runtime_error("the option axes has the form X1=X, Z1=Z, with X, Y, Z, A, B or C on the right side");
    letters_[machine] = letter;
    std::erase(own, letter[0]);
  }
  for (const char letter : own) letters_.try_emplace(std::string(1, letter), 1, letter);
}

void FrameRows::add_machine_names(const ig::Import& file) {
  static constexpr const char* table = "MachineAxes";
  for (std::uint32_t row = 0; row < file.machine_rows(table); ++row) {
    const std::string letter(file.machine_key(table, row));
    if (letter.size() != 1 || std::string_view("XYZABC").find(letter[0]) > 5) continue;
    const std::string names(file.machine_cell(table, row, "Names"));
    for (std::size_t end = 0, begin = 0; (begin = names.find_first_not_of(" \t\r\n", end)) != std::string::npos;) {
      end = std::min(names.find_first_of(" \t\r\n", begin), names.size());
      letters_.try_emplace(upper(names.substr(begin, end - begin)), letter);
    }
  }
}

bool FrameRows::Frame::has_shape() const {
  bool out = is_turned;
  for (const auto& [axis, part] : axes) out = out || part.has_shape();
  return out;
}

bool FrameRows::Frame::has_shape_of(std::string_view component) const {
  for (const auto& [axis, part] : axes)
    if ((component == "RT" && part.rotation != 0) || (component == "SC" && part.scale != 1) ||
        (component == "MI" && part.is_mirrored))
      return true;
  return false;
}

void FrameRows::Frame::drop_shape() {
  is_turned = false;
  for (auto& [axis, part] : axes) part.rotation = 0, part.scale = 1, part.is_mirrored = false;
}

bool FrameRows::Frame::is_shifted() const {
  bool out = false;
  for (const auto& [axis, part] : axes) out = out || part.shift() != 0;
  return out;
}

bool FrameRows::set_component(Part& part, std::string_view component, double value) {
  if (component == "TR") part.coarse = value;
  if (component == "FI") part.fine = value;
  if (component == "RT") part.rotation = value;
  if (component == "SC") part.scale = value;
  if (component == "MI") part.is_mirrored = value != 0;
  part.is_coarse_given = part.is_coarse_given || component == "TR";
  return component == "TR" || component == "FI" || component == "RT" || component == "SC" || component == "MI";
}

bool FrameRows::is_within(std::string_view component, double value) {
  return std::fabs(value) < largest_shift && (component != "SC" || (value >= 1e-6 && value <= 1e6));
}

bool FrameRows::assign(ig::Import& file, const Assignment& a) {
  if (!a.name.starts_with("$P_") || !a.name.ends_with("FR")) return false;
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  const bool is_numbered = a.name == "$P_UIFR" || a.name == base_frames || a.name == "$P_NCBFR";
  const std::size_t first = is_numbered ? 1 : 0;
  const Id id(a.name == "$P_UBFR" ? base_frames : a.name, is_numbered ? a.number(0) : 0);
  if (id.second < 0 || id.second >= (a.name == "$P_UIFR" ? settable_frames : most_base_frames))
    return file.report(ig::diag("SIE-0344"), begin, end, shown(a.full_name())), true;
  if (a.index.size() == first) {
    std::optional<Frame> frame = read_chain(a.value);
    if (!frame) return file.report(ig::diag("SIE-0343"), begin, end, shown(a.value), shown(a.full_name())), true;
    frame->begin = begin;
    frame->end = end;
    frames_[id] = *std::move(frame);
    return true;
  }
  const std::optional<double> value = number_of(a.value);
  if (a.index.size() != first + 2 || !value || !is_within(a.index[first + 1], *value))
    return file.report(ig::diag("SIE-0342"), begin, end, shown(a.full_name()), shown(a.value)), true;
  Part part;
  if (!set_component(part, a.index[first + 1], *value))
    return file.report(ig::diag("SIE-0343"), begin, end, shown(a.index[first + 1]), shown(a.full_name())), true;
  Frame& frame = frames_[id];
  if (frame.end == 0) frame.begin = begin, frame.end = end;
  return set_component(frame.axes[a.index[first]], a.index[first + 1], *value);
}

std::optional<FrameRows::Frame> FrameRows::read_chain(std::string_view value) {
  Frame out;
  out.is_whole = true;
  Cursor cursor(value);
  do {
    const std::string link = upper(cursor.word());
    if (!cursor.accept('(')) return std::nullopt;
    const std::string_view arguments = cursor.until(")");
    if (!cursor.accept(')') || !read_link(out, link, arguments)) return std::nullopt;
  } while (cursor.accept(':'));
  return cursor.is_at_end() ? std::optional(std::move(out)) : std::nullopt;
}

bool FrameRows::read_link(Frame& frame, const std::string& link, std::string_view arguments) {
  const std::string_view component = link == "CTRANS"    ? "TR"
                                     : link == "CFINE"   ? "FI"
                                     : link == "CROT"    ? "RT"
                                     : link == "CSCALE"  ? "SC"
                                     : link == "CMIRROR" ? "MI"
                                                         : "";
  const bool turns = link == "CROTS" || link == "CRPL";
  if (component.empty() && !turns) return false;
  if (trim(arguments).empty()) return true;
  // The control chains the links; a row holds the order shift, rotation, scale and mirror, each of them once.
  const bool is_shift = component == "TR" || component == "FI", scales = component == "SC" || component == "MI";
  const bool is_late = frame.has_shape_of(component) ||
                       (!scales && (frame.has_shape_of("SC") || frame.has_shape_of("MI"))) ||
                       (is_shift && frame.has_shape_of("RT"));
  const std::vector<std::string_view> parts = split(arguments);
  const std::size_t step = component == "MI" ? 1 : 2;
  if (parts.size() % step != 0) return false;
  for (std::size_t i = 0; i < parts.size(); i += step) {
    Cursor cursor(parts[i]);
    const std::string axis = upper(cursor.word());
    const std::optional<double> value = step == 1 ? 1.0 : number_of(parts[i + 1]);
    if ((axis.empty() && !turns) || (!axis.empty() && !cursor.is_at_end()) || !value || !is_within(component, *value))
      return false;
    if (turns || is_late) frame.is_turned = frame.is_turned || *value != (component == "SC" ? 1 : 0);
    if (is_shift || !(turns || is_late)) set_component(frame.axes[axis], component, *value);
  }
  return true;
}

bool FrameRows::is_expressible(const Frame& frame) const {
  if (frame.is_turned) return false;
  for (const auto& [axis, part] : frame.axes) {
    const auto letter = letters_.find(axis);
    if (part.has_shape() && (letter == letters_.end() || letter->second < "X")) return false;
  }
  return true;
}

void FrameRows::give(ig::Import& file, ArchiveLengths& lengths) const {
  std::size_t shifted_base_frames = 0, base_frames_in_use = 0;
  for (const auto& [id, frame] : frames_) {
    if (id.first != base_frames && id.first != "$P_NCBFR") continue;
    base_frames_in_use += frame.has_shape() || frame.is_shifted() ? 1 : 0;
  }
  Frame base;
  for (const auto& [id, frame] : frames_) {
    const auto& [name, number] = id;
    const bool is_base = name == base_frames || name == "$P_NCBFR";
    const bool is_settable = name == "$P_UIFR";
    if (!is_base && !is_settable) {
      if (frame.has_shape() || frame.is_shifted()) file.report(ig::diag("SIE-0347"), frame.begin, frame.end, name);
      continue;
    }
    const std::string row = is_base ? "BASE" : "G" + std::to_string(settable_code(number));
    Frame own = frame;
    // The sum of base frames has no shape of its own: their order would decide where it acts.
    if (!is_expressible(frame) || (is_base && frame.has_shape() && base_frames_in_use > 1)) {
      file.report(ig::diag("SIE-0345"), frame.begin, frame.end, row);
      own.drop_shape();
    }
    if (is_settable) {
      give_row(file, row, own, lengths);
      continue;
    }
    if (frame.is_shifted() && ++shifted_base_frames == 2)
      file.report(ig::diag("SIE-0346"), frame.begin, frame.end, name + '[' + std::to_string(number) + ']');
    base.is_whole = base.is_whole || frame.is_whole;
    if (base.end == 0) base.begin = frame.begin, base.end = frame.end;
    for (const auto& [axis, part] : own.axes) {
      Part& sum = base.axes[axis];
      sum.coarse += part.coarse;
      sum.fine += part.fine;
      sum.is_coarse_given = sum.is_coarse_given || part.is_coarse_given;
      if (!part.has_shape()) continue;
      sum.rotation = part.rotation;
      sum.scale = part.scale;
      sum.is_mirrored = part.is_mirrored;
    }
  }
  if (base.end > 0) give_row(file, "BASE", base, lengths);
}

void FrameRows::give_row(ig::Import& file, const std::string& row, const Frame& frame, ArchiveLengths& lengths) const {
  std::map<std::string, double> cells;
  if (frame.is_whole) cells = {{"X", 0}, {"Y", 0}, {"Z", 0}};
  for (const auto& [axis, part] : frame.axes) {
    const auto found = letters_.find(axis);
    if (found == letters_.end()) {
      if (part.shift() != 0)
        file.unused("shift of axis " + axis, "the table has the axes X, Y, Z, A, B and C: see Names in MachineAxes",
                    frame.begin, frame.end);
      continue;
    }
    const std::string& letter = found->second;
    if (letter < "X") {  // a rotary axis has one column
      if (part.is_coarse_given || part.fine != 0) cells[letter] = part.shift();
      continue;
    }
    if (part.is_coarse_given) cells[letter] = lengths.mm(part.coarse, frame.begin, frame.end);
    if (part.fine != 0) cells["F" + letter] = lengths.mm(part.fine, frame.begin, frame.end);
    if (part.rotation != 0) cells["R" + letter] = part.rotation;
    if (part.scale != 1) cells["S" + letter] = part.scale;
    if (part.is_mirrored) cells["M" + letter] = 1;
  }
  file.row("SiemensCoordinateTable", row, frame.begin);
  for (const char* column :
       {"X", "Y", "Z", "A", "B", "C", "FX", "FY", "FZ", "RX", "RY", "RZ", "SX", "SY", "SZ", "MX", "MY", "MZ"})
    if (const auto cell = cells.find(column); cell != cells.end()) file.cell(column, cell->second, frame.begin);
}

}  // namespace siemens
