/// Reads the files of a text archive line by line and collects their rows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "archive/frame_rows.hpp"
#include "archive/tool_rows.hpp"
#include "archive/variable_rows.hpp"

namespace siemens {

class ArchiveReader {
 public:
  ArchiveReader(ig::Import& file, std::int64_t channel, const std::string& axes)
      : file_(file), channel_(channel), frames_(axes) {
    frames_.add_machine_names(file);
  }

  void read();
  /// Gives the rows to the file. `edge_step` is 0 where edges are indices.
  void give(ArchiveLengths& lengths, std::int64_t edge_step) const;
  /// As the file tells it, by METRIC, INCH or machine data; nothing where it does not.
  std::optional<bool> is_inch() const { return is_inch_; }

 private:
  void begin_file(const ig::TextLine& line, const FileHead& head);
  void read_line(std::string_view code);
  void assign(const Assignment& a);
  void report_no_assignment(std::string_view code);

  ig::Import& file_;
  std::int64_t channel_, present_channel_ = 0;  // 0: what all channels share
  bool is_read_ = true;
  std::optional<bool> is_inch_;
  FlowFilter flow_;
  ToolRows tools_;
  FrameRows frames_;
  VariableRows variables_;
};

}  // namespace siemens
