/// Values of a hole, collected for one call of the host: a cycle block writes a dozen of them.
#pragma once

#include <isogloss/sdk.hpp>

namespace iso {

class FieldWrites {
 public:
  static constexpr std::size_t most = 16;  ///< that one call writes

  void add(ig_field field, ig_value value) {
    fields_[count_] = field;
    values_[count_++] = value;
  }
  void add(ig_field field, double number) { add(field, ig_value{.number = number}); }
  template <class T>
  void add(const ig::Field<T>& field, T value) {
    add(field.id(), ig::detail::ValueOf<T>::write(value));
  }

  /// The fields become fresh, and what they wake runs.
  void set(ig::Block& b) const { b.set_many(fields_.data(), count_, values_.data()); }
  /// The values change, and nothing wakes.
  void amend(ig::Block& b) const { b.amend_many(fields_.data(), count_, values_.data()); }

 private:
  std::array<ig_field, most> fields_;
  std::array<ig_value, most> values_;
  std::uint32_t count_ = 0;
};

}  // namespace iso
