/// Tells the host which row of a table has answered, so that `isogloss explain` shows its line in the XML.
#pragma once

#include <isogloss_provenance.h>

#include "isogloss/block.hpp"

namespace ig {

/// A member of each syntax that asks a table by the names of its rows. `service` is what the table provides.
class AnsweredRows {
 public:
  explicit AnsweredRows(const char* service) : service_(service) {}

  /// The row has answered for this block. Does nothing where nobody listens.
  void add(Block& b, std::string_view row) const {
    if (host_ && host_->is_listening != 0) host_->answered(b.raw(), to_text(service_), to_text(row));
  }

 private:
  std::string_view service_;
  Service<ig_provenance_1> host_{IG_PROVENANCE_SERVICE, Need::optional, "Which rows have answered; the host has it."};
};

}  // namespace ig
