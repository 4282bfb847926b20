/// What must hold between the parts of a linked dialect. Each check is one function, with its own code and test.
#pragma once

#include "isogloss/engine/linker.hpp"

namespace isogloss {

struct LinkFault {
  std::string code;
  Location where;
  std::vector<std::string> arguments;
  std::string hint{};
};

/// Order, required reads, slots, services, writes that nothing reads.
std::vector<LinkFault> check_links(const LinkedDialect& linked);
/// Order and slots alone, which hold of any part of a chain: what is missing may only add to these faults.
std::vector<LinkFault> check_places(const LinkedDialect& linked);
/// Services alone.
std::vector<LinkFault> check_services(const LinkedDialect& linked);

}  // namespace isogloss
