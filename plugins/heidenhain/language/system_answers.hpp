/// What FN 18 reads on one machine, as its user has declared it. The dependency HeidenhainSystemData owns the answers;
/// the syntaxes of this plugin reach them through its service.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace heidenhain {

inline constexpr const char* system_answer_service = "heidenhain.system-data/1";

/// What stands behind SYSREAD Q1 =, or in the name of a row, which may leave out IDX, or NR and IDX.
struct SystemKey {
  static constexpr double any = -std::numeric_limits<double>::infinity();
  double id = any, number = any, index = any;

  /// Of "ID990 NR2 IDX0"; nothing where it is no such key.
  static std::optional<SystemKey> read(std::string_view text);
  friend bool operator<(const SystemKey& a, const SystemKey& b) {
    return std::tie(a.id, a.number, a.index) < std::tie(b.id, b.number, b.index);
  }
};

struct SystemAnswer {
  double value = 0;  ///< as the Q parameter gets it
  std::string row, title;
};

class SystemAnswers {
 public:
  /// The row of ID, NR and IDX goes before that of ID and NR, and this one before that of ID. nullptr: there is none.
  const SystemAnswer* find(const SystemKey& asked) const {
    for (const SystemKey& key : {asked, SystemKey{asked.id, asked.number, SystemKey::any}, SystemKey{asked.id}})
      if (const auto found = answers_.find(key); found != answers_.end()) return &found->second;
    return nullptr;
  }
  /// False where the key has an answer already.
  bool add(const SystemKey& key, SystemAnswer answer) { return answers_.emplace(key, std::move(answer)).second; }

 private:
  std::map<SystemKey, SystemAnswer> answers_;
};

}  // namespace heidenhain
