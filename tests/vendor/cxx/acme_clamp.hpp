/// The service of AcmeClampTable.
#pragma once

#include <cstdint>

inline constexpr const char* clamp_service = "acme.clamp/1";

struct AcmeClampService {
  std::uint32_t struct_size;
  std::uint32_t reserved;
  void* self;
  std::int32_t (*force)(void* self, double clamp, double* out);  ///< kN; 0: there is no such clamp
};
