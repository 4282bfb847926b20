/// The files of an archive that is written.
#pragma once

#include <string>
#include <string_view>

#include <isogloss/cnc/file_length.hpp>

#include "archive/data_line.hpp"

namespace siemens {

/// A file of the archive; its head is written with the first line.
class WrittenFile {
 public:
  WrittenFile(ig::Export& out, std::string_view name) : out_(out), name_(name) {}
  ~WrittenFile() {
    if (has_head_) out_.write("M17\n");
  }
  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;
  void line(const std::string& text) {
    const bool defines = name_.ends_with("_DEF");
    if (!has_head_)
      out_.write("%_N_" + std::string(name_) + "\n;$PATH=/_N_" + (defines ? "DEF_DIR\n" : "NC_ACT_DIR\nCHANDATA(1)\n"));
    has_head_ = true;
    out_.write(text + '\n');
  }

 private:
  ig::Export& out_;
  std::string_view name_;
  bool has_head_ = false;
};

/// The number of a cell, in `unit`; empty where there is none.
inline std::string written(std::string_view cell, double unit) {
  const std::optional<double> n = number_of(cell);
  return n ? ig::cnc::fixed_text(ig::cnc::length_in_unit(*n, unit)) : "";
}

/// Writes the macros, the definitions of user data, R parameters and values of user data.
void write_variables(ig::Export& out);

}  // namespace siemens
