/// Lengths of an archive, in the basic system of the machine. Where neither the file nor the user names it, it is
/// assumed to be metric, which is reported once.
#pragma once

#include <isogloss/cnc/file_length.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

class ArchiveLengths {
 public:
  ArchiveLengths(ig::Import& file, double unit_in_mm, bool is_assumed)
      : file_(file), unit_in_mm_(unit_in_mm), is_assumed_(is_assumed) {}

  double mm(double value, std::size_t begin, std::size_t end) {
    if (is_assumed_ && value != 0) {
      file_.report(ig::diag("SIE-0357"), begin, end);
      is_assumed_ = false;
    }
    return ig::cnc::length_in_mm(value, unit_in_mm_);
  }

 private:
  ig::Import& file_;
  double unit_in_mm_;
  bool is_assumed_;
};

}  // namespace siemens
