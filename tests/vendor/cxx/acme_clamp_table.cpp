// The clamps of the machine, by number. The host holds the rows.
#include <isogloss/sdk.hpp>

#include "acme_clamp.hpp"

namespace {

struct AcmeClampTable {
  static constexpr auto spec = ig::dependency("AcmeClampTable", "The clamps of the machine and their forces.")
                                   .rows("Clamp", "id")
                                   .provides(clamp_service);

  ig::Column force{"Force_kN", nullptr, "kN", {0, 50}, "The force of the clamp."};
  ig::Table table;

  const void* service(std::string_view id) const { return id == clamp_service ? &service_ : nullptr; }

 private:
  static std::int32_t force_of(void* self, double clamp, double* out) {
    const auto& own = *static_cast<const AcmeClampTable*>(self);
    if (!(clamp >= 0 && clamp < 1000 && clamp == static_cast<int>(clamp))) return 0;
    const auto force = own.table.value(std::to_string(static_cast<int>(clamp)), own.force);
    if (force) *out = *force;
    return force ? 1 : 0;
  }

  AcmeClampService service_{sizeof(AcmeClampService), 0, this, &force_of};
};

const ig::Register<AcmeClampTable> registered;

}  // namespace
