/// The unit of lengths in a file that does not name it: the user gives it, or mm is assumed and reported.
#pragma once

#include <isogloss/cnc/file_length.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

namespace tables {

enum class FileUnit { unknown, mm, inch };

/// Reads the lengths of one file.
class FileLengths {
 public:
  FileLengths(ig::Import& file, FileUnit unit) : file_(file), unit_(unit) {}

  /// Rounded as lengths of all files are. `begin` and `end` are its place.
  double mm(double value, std::size_t begin, std::size_t end) {
    if (unit_ == FileUnit::unknown && value != 0) {
      file_.report(ig::diag("TAB-0112"), begin, end);
      unit_ = FileUnit::mm;
    }
    return ig::cnc::length_in_mm(value, unit_ == FileUnit::inch ? ig::cnc::mm_per_inch : 1);
  }

 private:
  ig::Import& file_;
  FileUnit unit_;
};

}  // namespace tables
