// Which line of an archive is what: heads of files, channels, tools, frames, variables, and data without a table.
#include "archive/archive_reader.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

const char* kind_of_system_variable(std::string_view name) {
  if (name.starts_with("$M")) return "machine data";
  if (name.starts_with("$S")) return "setting data";
  if (name.starts_with("$AN_CEC") || name.starts_with("$AA_ENC") || name.starts_with("$AA_QEC"))
    return "compensation data";
  return "other system variables";
}

}  // namespace

void ArchiveReader::read() {
  for (const ig::TextLine& line : file_.lines())
    if (const auto head = read_head(line.text))
      begin_file(line, *head);
    else if (const std::string_view code = code_of(line.text); is_read_ && !code.empty() && !is_file_end(code))
      read_line(code);
}
void ArchiveReader::give(ArchiveLengths& lengths, std::int64_t edge_step) const {
  tools_.give(file_, lengths, edge_step);
  frames_.give(file_, lengths);
  variables_.give(file_);
}

void ArchiveReader::begin_file(const ig::TextLine& line, const FileHead& head) {
  flow_.restart();
  present_channel_ = 0;
  is_read_ = head.holds_data();
  if (is_read_) return;
  const std::string name = head.extension.empty() ? head.name : head.name + '.' + head.extension;
  const std::size_t end = line.begin + line.text.size();
  if (head.holds_programs())
    file_.unused("program " + shown(name), "tables are read here, and programs are not", line.begin, end);
  else
    file_.unused("file " + shown(name), no_place, line.begin, end);
}

void ArchiveReader::read_line(std::string_view code) {
  const std::size_t begin = place_in(file_, code);
  Cursor cursor(code);
  if (equals_ignoring_case(cursor.word(), "CHANDATA") && cursor.accept('(')) {
    const std::optional<double> n = number_of(cursor.until(")"));
    if (!n || !(*n >= 1 && *n <= 99)) return report_no_assignment(code);
    present_channel_ = static_cast<std::int64_t>(*n);
    return;
  }
  for (const char* const unit : {"METRIC", "INCH"})
    if (equals_ignoring_case(code, unit)) {
      is_inch_ = *unit == 'I';
      return;
    }
  if (present_channel_ != 0 && present_channel_ != channel_)
    return file_.unused("data of channel " + std::to_string(present_channel_),
                        "the option channel names another channel", begin, begin + code.size());
  if (flow_.leaves_out(file_, code) || variables_.define(file_, code)) return;
  for (cursor = Cursor(code); !cursor.is_at_end();) {
    const std::string_view rest = cursor.rest();
    const std::optional<Assignment> a = read_assignment(cursor);
    if (!a) return report_no_assignment(trim(rest));
    assign(*a);
  }
}

void ArchiveReader::assign(const Assignment& a) {
  const bool is_r = a.name == "$R" || (a.name.starts_with("$R") && is_digit(a.name[2]));
  if (!a.name.starts_with('$') || is_r) return variables_.assign(file_, a);
  if (a.name.starts_with("$TC_")) return tools_.assign(file_, a);
  if (frames_.assign(file_, a)) return;
  if (a.name == "$MN_SCALING_SYSTEM_IS_METRIC") is_inch_ = number_of(a.value) == 0.0;
  const std::size_t begin = place_in(file_, a.written);
  file_.unused(kind_of_system_variable(a.name), no_place, begin, begin + a.written.size());
}

void ArchiveReader::report_no_assignment(std::string_view code) {
  const std::size_t begin = place_in(file_, code);
  file_.report(ig::diag("SIE-0340"), begin, begin + code.size(), shown(code));
}

}  // namespace siemens
