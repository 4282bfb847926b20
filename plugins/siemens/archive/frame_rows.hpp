/// Rows of SiemensCoordinateTable from frames: $P_UIFR, base frames and system frames. Manual Job planning, "Frames".
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "archive/archive_lengths.hpp"
#include "archive/data_line.hpp"

namespace siemens {

class FrameRows {
 public:
  /// `axes` gives the table's letters to axes of the machine: "X1=X, Z1=Z". Throws where it has another form.
  explicit FrameRows(const std::string& axes);
  /// The column Names of the machine's MachineAxes; names of the option axes stay.
  void add_machine_names(const ig::Import& file);

  /// False where the assignment is not to a frame.
  bool assign(ig::Import& file, const Assignment& a);
  /// Gives the rows to the file. `mm` is a unit of the file in mm.
  void give(ig::Import& file, ArchiveLengths& lengths) const;

 private:
  struct Part {
    double coarse = 0, fine = 0, rotation = 0, scale = 1;
    bool is_mirrored = false, is_coarse_given = false;
    double shift() const { return coarse + fine; }
    bool has_shape() const { return rotation != 0 || scale != 1 || is_mirrored; }
  };
  struct Frame {
    std::map<std::string, Part> axes;
    bool is_turned = false;  ///< by CROTS or CRPL, or by links in an order that no row can hold
    bool is_whole = false;   ///< axes that are not named have the shift 0
    std::size_t begin = 0, end = 0;
    bool has_shape() const;
    bool has_shape_of(std::string_view component) const;
    bool is_shifted() const;
    /// Leaves the shift alone.
    void drop_shape();
  };
  using Id = std::pair<std::string, std::int64_t>;

  static std::optional<Frame> read_chain(std::string_view value);
  static bool read_link(Frame& frame, const std::string& link, std::string_view arguments);
  static bool set_component(Part& part, std::string_view component, double value);
  static bool is_within(std::string_view component, double value);
  /// True where columns of the table can hold the shape.
  bool is_expressible(const Frame& frame) const;
  void give_row(ig::Import& file, const std::string& row, const Frame& frame, ArchiveLengths& lengths) const;

  std::map<std::string, std::string> letters_;
  std::map<Id, Frame> frames_;
};

}  // namespace siemens
