/// The parameters of the cycles that are executed, in the order in which a call passes them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/sdk.hpp>

namespace siemens {

/// The unit is in brackets where a parameter is not a length: s, deg, 1 (a count or a mode), mm/min.
struct CycleSignature {
  std::string_view name;
  std::string_view parameters;
};

inline constexpr CycleSignature drilling_signatures[] = {
    {"CYCLE81", "RTP RFP SDIS DP DPR DTB[s] GMODE[1] DMODE[1] AMODE[1]"},
    {"CYCLE82", "RTP RFP SDIS DP DPR DTB[s] GMODE[1] DMODE[1] AMODE[1] VARI[1] S_ZA S_FA[1] S_ZD S_FD[1]"},
    {"CYCLE83",
     "RTP RFP SDIS DP DPR FDEP FDPR DAM DTB[s] DTS[s] FRF[1] VARI[1] AXN[1] MDEP VRT DTD[s] DIS1 GMODE[1] DMODE[1] "
     "AMODE[1]"},
    {"CYCLE84",
     "RTP RFP SDIS DP DPR DTB[s] SDAC[1] MPIT[1] PIT[1] POSS[deg] SST[1] SST1[1] AXN[1] PITA[1] TECHNO[1] VARI[1] DAM "
     "VRT PITM[1] PTAB[1] PTABA[1] GMODE[1] DMODE[1] AMODE[1]"},
    {"CYCLE840",
     "RTP RFP SDIS DP DPR DTB[s] SDR[1] SDAC[1] ENC[1] MPIT[1] PIT[1] AXN[1] PITA[1] TECHNO[1] PITM[1] PTAB[1] "
     "PTABA[1] GMODE[1] DMODE[1] AMODE[1]"},
    {"CYCLE85", "RTP RFP SDIS DP DPR DTB[s] FFR[mm/min] RFF[mm/min] GMODE[1] DMODE[1] AMODE[1]"},
    {"CYCLE86", "RTP RFP SDIS DP DPR DTB[s] SDIR[1] RPA RPO RPAP POSS[deg] GMODE[1] DMODE[1] AMODE[1]"},
    {"CYCLE87", "RTP RFP SDIS DP DPR SDIR[1]"},
    {"CYCLE88", "RTP RFP SDIS DP DPR DTB[s] SDIR[1]"},
    {"CYCLE89", "RTP RFP SDIS DP DPR DTB[s] GMODE[1] DMODE[1] AMODE[1]"}};

inline constexpr CycleSignature swivel_signature{
    "CYCLE800", "FR[1] TC[1] ST[1] MODE[1] X0 Y0 Z0 A[deg] B[deg] C[deg] X1 Y1 Z1 DIR[1] FR_I DMODE[1]"};

/// Patterns: where the cycle that MCALL keeps in force drills.
inline constexpr CycleSignature pattern_signatures[] = {
    {"HOLES1", "SPCA SPCO STA1[deg] FDIS DBH NUM[1] VARI[1] UMODE[1] HIDE[1] NSP[1] DMODE[1]"},
    {"HOLES2", "CPA CPO RAD STA1[deg] INDA[deg] NUM[1] VARI[1] UMODE[1] HIDE[1] NSP[1] DMODE[1]"},
    {"CYCLE801",
     "SPCA SPCO STA[deg] DIS1 DIS2 NUM1[1] NUM2[1] VARI[1] UMODE[1] ANG1[deg] ANG2[deg] HIDE[1] NSP[1] DMODE[1]"},
    {"CYCLE802", "XA[1] YA[1] X0 Y0 X1 Y1 X2 Y2 X3 Y3 X4 Y4 X5 Y5 X6 Y6 X7 Y7 X8 Y8 VARI[1] UMODE[1] DMODE[1]"}};

constexpr const CycleSignature& drilling_signature(std::string_view name) {
  std::size_t i = 0;
  while (drilling_signatures[i].name != name) ++i;
  return drilling_signatures[i];
}

/// The code of a cycle and its parameters, as fields: Parsing.CYCLE81.RTP.
class CycleFields {
 public:
  static constexpr std::size_t most = 24;
  using Values = std::array<std::optional<double>, most>;

  CycleFields(const CycleSignature& signature, ig::Access access)
      : name_(signature.name), code_({signature.name}, "", access) {
    std::string_view rest = signature.parameters;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      std::string_view parameter = rest.substr(0, end);
      std::string_view unit = "mm";
      if (const std::size_t bracket = parameter.find('['); bracket != std::string_view::npos) {
        unit = parameter.substr(bracket + 1, parameter.size() - bracket - 2);
        parameter = parameter.substr(0, bracket);
      }
      if (unit == "1") unit = "";
      names_.push_back(parameter);
      const std::string path = std::string("Parsing.").append(name_).append(".").append(parameter);
      const std::uint32_t no_wake = access & ~static_cast<std::uint32_t>(ig::wake);
      fields_.emplace_back(path, static_cast<ig::Access>(no_wake), ig::About{ig::Life::word, unit, ""});
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  /// Takes the call from the block: `out`, which is empty, receives the values that it passes, in the order of the
  /// parameters. False where the block does not call the cycle.
  bool take(ig::Block& b, Values& out) const {
    if (b.take_code(code_.codes(), 1) < 0) return false;
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (ig_value v; b.take(fields_[i].id(), v)) out[i] = v.number;
    return true;
  }

  std::string_view name() const { return name_; }
  const ig::Call& code() const { return code_; }
  std::size_t size() const { return fields_.size(); }
  const ig::Field<double>& field(std::size_t i) const { return fields_[i]; }
  std::string_view parameter(std::size_t i) const { return names_[i]; }
  std::size_t index_of(std::string_view parameter) const {
    std::size_t i = 0;
    while (i < names_.size() && names_[i] != parameter) ++i;
    return i;
  }

 private:
  std::string_view name_;
  ig::Call code_;
  std::vector<std::string_view> names_;
  std::vector<ig::Field<double>> fields_;
};

}  // namespace siemens
