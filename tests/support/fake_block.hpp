/// A block outside a host: numbers and frames by field, for the helpers that a plugin's syntaxes are made of.
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <isogloss/sdk.hpp>

namespace isogloss_test {

/// Gives the members that are constructed while it lives ids of their own, in the order of their declaration. Names are
/// numbered, no service is provided, options are not served.
class FakeLink {
 public:
  FakeLink()
      : ids_(64), binding_{&api_, reinterpret_cast<ig_link*>(this), nullptr}, scope_(ig::detail::binding, &binding_) {
    std::iota(ids_.begin(), ids_.end(), ig_field{0});
    binding_.ids = ids_.data();
    api_.struct_size = sizeof api_;
    api_.symbol = [](ig_link* link, ig_text name) {
      auto& names = reinterpret_cast<FakeLink*>(link)->names_;
      const auto next = static_cast<ig_symbol>(names.size() + 1);
      return names.try_emplace(std::string(name.data, name.size), next).first->second;
    };
    api_.service = [](ig_link*, const char*) -> const void* { return nullptr; };
  }

 private:
  ig_link_api api_{};
  std::map<std::string, ig_symbol> names_;
  std::vector<ig_field> ids_;
  ig::detail::Binding binding_;
  ig::detail::Scope<ig::detail::Binding> scope_;
};

class FakeBlock {
 public:
  using Matrix = std::array<double, 16>;

  std::map<ig_field, double> numbers;
  std::map<ig_field, Matrix> frames;  ///< compose in the order of their ids
  bool frame_changed = false;

  FakeBlock() {
    host_.struct_size = sizeof host_;
    host_.get = [](const ig_block* b, ig_field f, ig_value* out) {
      const auto found = self(b).numbers.find(f);
      if (found == self(b).numbers.end()) return std::int32_t{0};
      out->number = found->second;
      return std::int32_t{1};
    };
    host_.get_many = [](const ig_block* b, const ig_field* f, std::uint32_t n, ig_value* out) {
      std::uint32_t mask = 0;
      for (std::uint32_t i = 0; i < n; ++i)
        if (self(b).host_.get(b, f[i], out + i) != 0) mask |= 1u << i;
      return mask;
    };
    host_.set = [](ig_block* b, ig_field f, ig_value v) { self(b).numbers[f] = v.number; };
    host_.set_transform = [](ig_block* b, ig_field f, const double m[16]) {
      std::copy(m, m + 16, self(b).frames[f].begin());
      self(b).frame_changed = true;
    };
    host_.set_translation = [](ig_block* b, ig_field f, const double t[3]) {
      self(b).frames[f] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, t[0], t[1], t[2], 1};
      self(b).frame_changed = true;
    };
    host_.transform = [](const ig_block* b, ig_field f, double m[16]) {
      const auto found = self(b).frames.find(f);
      if (found == self(b).frames.end()) return std::int32_t{0};
      std::copy(found->second.begin(), found->second.end(), m);
      return std::int32_t{1};
    };
    host_.frame_changed = [](const ig_block* b) { return std::int32_t{self(b).frame_changed}; };
    host_.map_point = [](ig_block* b, ig_direction direction, const double in[3], double out[3]) {
      return self(b).map(direction, in, out);
    };
  }

  const ig_host* host() const { return &host_; }
  ig::Block block() { return {&host_, reinterpret_cast<ig_block*>(this)}; }

 private:
  static const FakeBlock& self(const ig_block* b) { return *reinterpret_cast<const FakeBlock*>(b); }
  static FakeBlock& self(ig_block* b) { return *reinterpret_cast<FakeBlock*>(b); }

  /// The inverse is that of rotations and translations.
  std::int32_t map(ig_direction direction, const double in[3], double out[3]) const {
    std::copy(in, in + 3, out);
    std::vector<Matrix> chain;
    for (const auto& [id, m] : frames) chain.push_back(m);
    if (direction == IG_TO_PROGRAM) std::reverse(chain.begin(), chain.end());
    for (const Matrix& m : chain) {
      const double p[3] = {out[0], out[1], out[2]};
      for (std::size_t i = 0; i < 3; ++i) {
        out[i] = direction == IG_TO_MACHINE ? m[12 + i] : 0;
        for (std::size_t k = 0; k < 3; ++k)
          out[i] += direction == IG_TO_MACHINE ? p[k] * m[4 * k + i] : (p[k] - m[12 + k]) * m[4 * i + k];
      }
    }
    return 1;
  }

  ig_host host_{};
};

}  // namespace isogloss_test
