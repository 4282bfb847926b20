/* Libraries that go wrong before their descriptor is read; the fault is chosen by FAULT_…. */
#include <stdlib.h>
#include <unistd.h>

#include "sound.h"

static const ig_syntax syntax = SOUND_SYNTAX;
static const ig_syntax* const syntaxes[] = {&syntax};
static const ig_plugin plugin = SOUND_PLUGIN(NAME, syntaxes);
const ig_plugin* sound_plugin(void);
const ig_plugin* sound_plugin(void) { return &plugin; }

#if defined(FAULT_no_entry)
#elif defined(FAULT_entry_is_data)
IG_EXPORT const char ig_plugin_v1_data[64] __asm__("ig_plugin_v1") = "no code";
#else
const ig_plugin* ig_plugin_v1(void) {
#if defined(FAULT_undefined_symbol)
  extern void nobody_defines_this(void);
  nobody_defines_this();
#elif defined(FAULT_crashes_in_entry)
  *(volatile int*)(uintptr_t)8 = 1;
#elif defined(FAULT_quits_in_entry)
  _exit(0);
#elif defined(FAULT_hangs_in_entry)
  for (volatile int forever = 1; forever;) {
  }
#endif
  return &plugin;
}
#endif

#if defined(FAULT_crashes_at_load)
__attribute__((constructor)) static void at_load(void) { *(volatile int*)(uintptr_t)8 = 1; }
#endif

#if defined(FAULT_exits_at_load)
__attribute__((constructor)) static void at_load(void) { exit(0); }
#elif defined(FAULT_hangs_at_load)
__attribute__((constructor)) static void at_load(void) {
  for (volatile int forever = 1; forever;) {
  }
}
#endif

#if defined(FAULT_exports_too_much)
IG_EXPORT int helper_of_everyone(int x);
int helper_of_everyone(int x) { return x + 1; }
#endif
