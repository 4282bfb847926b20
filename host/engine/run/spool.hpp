/// A source that can be read only once, such as a pipe, made readable at any place.
#pragma once

#include <string>

#include "isogloss/engine/runner.hpp"

namespace isogloss {

/// Makes a source that can be read only once readable at any place: what was read is kept, the first part in memory and
/// the rest in a temporary file without a name.
class Spool : public Source {
 public:
  explicit Spool(Source& from) : from_(from) {}
  ~Spool() override;
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;
  std::size_t read(char* buffer, std::size_t size) override;
  bool has_places() const override { return true; }
  std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t size) override;
  bool is_lost() const override { return lost_; }
  std::string failure() const override { return from_.failure(); }

 private:
  std::size_t pull(char* buffer, std::size_t size);
  void keep(const char* bytes, std::size_t size);

  Source& from_;
  std::string head_;
  int file_ = -1;
  std::uint64_t size_ = 0, given_ = 0;
  bool ended_ = false, lost_ = false;
};

}  // namespace isogloss
