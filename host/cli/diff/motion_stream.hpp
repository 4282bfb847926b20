/// Takes the rows that the exporter of motions writes and sends them, block by block, to the comparison.
#pragma once

#include <string>

#include "diff/line_order.hpp"
#include "diff/motions.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss::cli::parting {

/// Written to by the exporter's own thread.
class MotionStream : public Output {
 public:
  MotionStream(int side, const LineOrder* order, std::string program, Channel<MotionBlock>& out)
      : side_(side), order_(order), program_(std::move(program)), out_(out) {}
  bool write(std::string_view bytes) override;
  /// After the run; a fault: why it could not go on.
  void finish(std::string fault);

 private:
  bool read_row(std::string_view row);
  bool send();

  const int side_;
  const LineOrder* const order_;
  const std::string program_;
  Channel<MotionBlock>& out_;
  std::string rest_;
  bool is_first_row_ = true;
  std::unique_ptr<MotionBlock> block_;
  std::uint32_t part_ = 0;  // of a block that is sent in several
};

}  // namespace isogloss::cli::parting
