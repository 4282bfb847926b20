/// Calls of a plugin outside the blocks of a run: where one is under way, for a crash report, and what one threw.
#pragma once

#include "isogloss/engine/chain.hpp"

namespace isogloss {

/// The function of the contract is at work as long as this object lives.
class Calling {
 public:
  Calling(const ig_plugin& plugin, const char* id, const char* phase);
  ~Calling();
  Calling(const Calling&) = delete;
  Calling& operator=(const Calling&) = delete;

  /// The call that is under way in this thread; without a syntax where there is none.
  static const Breadcrumb& under_way();

 private:
  Breadcrumb before_;
};

/// To be called in a handler: reports an exception that left a function of the contract, which none may.
Diagnostic exception_diagnostic(const ig_plugin& plugin, const std::string& alias, const char* phase, Location where);

}  // namespace isogloss
