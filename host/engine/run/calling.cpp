#include "run/calling.hpp"

namespace isogloss {

namespace {

thread_local Breadcrumb outside_blocks;

}  // namespace

Calling::Calling(const ig_plugin& plugin, const char* id, const char* phase) : before_(outside_blocks) {
  outside_blocks = {plugin.name, id, phase, nullptr};
}
Calling::~Calling() { outside_blocks = before_; }

const Breadcrumb& Calling::under_way() { return outside_blocks; }

[[gnu::cold]] Diagnostic exception_diagnostic(const ig_plugin& plugin, const std::string& alias, const char* phase,
                                              Location where) {
  std::string words;
  try {
    throw;
  } catch (const std::exception& e) {
    words = e.what();
  } catch (...) {
    words = "no std::exception";
  }
  return host_diagnostic("IG-0350", std::move(where), {alias, plugin.name, phase, words});
}

}  // namespace isogloss
