#include "cycles/cycle_number.hpp"

#include <array>
#include <charconv>

#include "language/klartext_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

std::optional<CycleNumber> CycleNumber::at(std::string_view text, std::size_t i) {
  CycleNumber out;
  const auto read = [&](std::size_t from, std::uint32_t& value) {
    const std::size_t behind = skip_digits(text, from);
    const bool is_read =
        behind != from && std::from_chars(text.data() + from, text.data() + behind, value).ec == std::errc{};
    return is_read ? behind : from;
  };
  out.end = read(i, out.cycle);
  if (out.end == i) return std::nullopt;
  const std::size_t point = skip_blanks(text, out.end);
  std::uint32_t number_of_part = 0;
  const std::size_t digits = skip_blanks(text, point + 1);
  if (ig::cnc::at(text, point) != '.') return out;
  if (const std::size_t part_end = read(digits, number_of_part); part_end != digits) {
    out.part = number_of_part;
    out.end = part_end;
  }
  return out;
}

bool acts_where_defined(std::uint32_t cycle) {
  constexpr std::array<std::uint32_t, 27> all{7,   8,   9,   10,  11,  13,  14,  19,  20,  26,  30,  32,  220, 221,
                                              224, 238, 239, 247, 270, 271, 285, 291, 332, 392, 800, 801, 892};
  for (const std::uint32_t c : all)
    if (c == cycle) return true;
  return false;
}

bool waits_for_call(std::uint32_t cycle) {
  struct Range {
    std::uint32_t first, last;
  };
  constexpr std::array all{Range{1, 6},     Range{12, 12},   Range{15, 18},   Range{21, 29},   Range{39, 39},
                           Range{200, 215}, Range{225, 225}, Range{230, 233}, Range{240, 241}, Range{251, 258},
                           Range{262, 267}, Range{270, 277}, Range{290, 292}, Range{810, 883}};
  for (const Range& r : all)
    if (r.first <= cycle && cycle <= r.last) return true;
  return false;
}

std::span<const std::uint16_t> parameters_of(std::int64_t cycle) {
  static constexpr std::uint16_t c200[] = {200, 201, 206, 202, 210, 203, 204, 211, 395};
  static constexpr std::uint16_t c201[] = {200, 201, 206, 211, 208, 203, 204};
  static constexpr std::uint16_t c202[] = {200, 201, 206, 211, 208, 203, 204, 214, 336};
  static constexpr std::uint16_t c203[] = {200, 201, 206, 202, 210, 203, 204, 212, 213, 205, 211, 208, 256, 395};
  static constexpr std::uint16_t c204[] = {200, 249, 250, 251, 252, 253, 254, 255, 203, 204, 214, 336};
  static constexpr std::uint16_t c205[] = {200, 201, 206, 202, 203, 204, 212, 205, 258,
                                           259, 257, 256, 211, 379, 253, 208, 395, 373};
  static constexpr std::uint16_t c206[] = {200, 201, 206, 211, 203, 204};
  static constexpr std::uint16_t c207[] = {200, 201, 239, 203, 204};
  static constexpr std::uint16_t c208[] = {200, 201, 206, 334, 203, 204, 335, 342, 351, 370};
  static constexpr std::uint16_t c209[] = {200, 201, 239, 203, 204, 257, 256, 336, 403};
  static constexpr std::uint16_t c220[] = {216, 217, 244, 245, 246, 247, 241, 200, 203, 204, 301, 365};
  static constexpr std::uint16_t c221[] = {225, 226, 237, 238, 242, 243, 224, 200, 203, 204, 301};
  static constexpr std::uint16_t c240[] = {200, 343, 201, 344, 206, 211, 203, 204, 342, 253};
  static constexpr std::uint16_t c241[] = {200, 201, 206, 211, 203, 204, 379, 253, 208, 426,
                                           427, 428, 429, 430, 435, 401, 202, 212, 205};
  static constexpr std::uint16_t c247[] = {339};
  switch (cycle) {
    case 200: return c200;
    case 201: return c201;
    case 202: return c202;
    case 203: return c203;
    case 204: return c204;
    case 205: return c205;
    case 206: return c206;
    case 207: return c207;
    case 208: return c208;
    case 209: return c209;
    case 220: return c220;
    case 221: return c221;
    case 240: return c240;
    case 241: return c241;
    case 247: return c247;
    default: return {};
  }
}

}  // namespace heidenhain
