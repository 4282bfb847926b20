/* Plugins whose descriptor is wrong in one place each; NAME is the file's name, the fault is chosen by FAULT_…. */
#include "sound.h"

static ig_field_decl fields[] = {SOUND_FIELD("Parsing.X", IG_READ | IG_WAKE)};
static ig_option_decl options[] = {
    {sizeof(ig_option_decl), IG_OPTION_NUMBER, "length", "1", "", 0, 10, "mm", "A length."}};
static ig_syntax syntax = SOUND_SYNTAX;
static const ig_syntax* const syntaxes[] = {&syntax, &syntax};
static ig_plugin plugin = SOUND_PLUGIN(NAME, syntaxes);

#ifdef FAULT_newer_minor
/* What a later minor version could look like: a descriptor that has grown at its end, and longer array elements. */
typedef struct later_field_decl {
  ig_field_decl known;
  const char* since;
  double more[3];
} later_field_decl;
static const later_field_decl later_fields[] = {
    {{sizeof(later_field_decl), IG_READ, IG_NUMBER, IG_LIFE_STANDARD, "Feedrate.FeedrateValue", "", "", 0}, "1.7", {1}},
    {{sizeof(later_field_decl), IG_READ | IG_WAKE, IG_NUMBER, IG_LIFE_STANDARD, "Parsing.X", "", "", 0}, "1.7", {1}}};
static struct later_plugin {
  ig_plugin known;
  const char* homepage;
} later_plugin;
#endif

const ig_plugin* ig_plugin_v1(void) {
  syntax.fields = fields;
  syntax.options = options;
#if defined(FAULT_nothing)
  return 0;
#elif defined(FAULT_zero_size)
  plugin.struct_size = 0;
#elif defined(FAULT_huge_size)
  plugin.struct_size = 0xfffffff0u;
#elif defined(FAULT_null_name)
  plugin.name = 0;
#elif defined(FAULT_null_syntaxes)
  plugin.syntaxes = 0;
#elif defined(FAULT_absurd_count)
  syntax.field_count = 4000000000u;
#elif defined(FAULT_long_count)
  syntax.field_count = 900; /* the array has one */
#elif defined(FAULT_null_path)
  fields[0].path = 0;
#elif defined(FAULT_null_build)
  syntax.build = 0;
#elif defined(FAULT_bad_default)
  options[0].fallback = "11";
#elif defined(FAULT_same_id)
  plugin.syntax_count = 2;
#elif defined(FAULT_other_major)
  plugin.abi_major = 2;
  plugin.syntaxes = (const ig_syntax* const*)(uintptr_t)8; /* never to be looked at */
#elif defined(FAULT_newer_minor)
  syntax.fields = (const ig_field_decl*)later_fields;
  syntax.field_count = 2;
  plugin.abi_minor = 7;
  plugin.struct_size = sizeof later_plugin;
  later_plugin.known = plugin;
  return &later_plugin.known;
#elif defined(FAULT_older_minor)
  plugin.abi_minor = 0;
  syntax.struct_size = offsetof(ig_syntax, cases);
  syntax.cases = (const char*)(uintptr_t)8; /* whatever lies behind an older struct is not to be looked at */
#else
#error "which fault?"
#endif
  return &plugin;
}
