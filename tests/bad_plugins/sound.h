/* A sound plugin of one syntax, BadSyntax, which takes the word X: what the bad ones spoil in one place. */
#ifndef SOUND_H
#define SOUND_H

#include <isogloss.h>
#include <math.h>

static ig_status sound_create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  (void)api;
  (void)link;
  *self = (void*)ids;
  return IG_CHANGED;
}

static void sound_destroy(void* self) { (void)self; }

static ig_status sound_build(void* self, const ig_host* host, ig_block* block) {
  (void)self;
  (void)host;
  (void)block;
  return IG_UNCHANGED;
}

#define SOUND_FIELD(path, access) \
  { sizeof(ig_field_decl), access, IG_NUMBER, IG_LIFE_STANDARD, path, "", "", 0 }

static const ig_field_decl sound_fields[] = {SOUND_FIELD("Parsing.X", IG_READ | IG_WAKE)};

static const ig_option_decl sound_options[] = {
    {sizeof(ig_option_decl), IG_OPTION_NUMBER, "length", "1", "", 0, 10, "mm", "A length."}};

#define SOUND_SYNTAX                                                                                                 \
  {                                                                                                                  \
    .struct_size = sizeof(ig_syntax), .id = "BadSyntax", .summary = "Misbehaves.", .fields = sound_fields,           \
    .options = sound_options, .field_count = 1, .option_count = 1, .create = sound_create, .destroy = sound_destroy, \
    .build = sound_build                                                                                             \
  }

#define SOUND_PLUGIN(its_name, list)                                                                           \
  {                                                                                                            \
    .struct_size = sizeof(ig_plugin), .abi_major = IG_ABI_MAJOR, .abi_minor = IG_ABI_MINOR, .syntax_count = 1, \
    .name = its_name, .version = "1.0.0", .vendor = "tests", .built_with = "C", .syntaxes = list               \
  }

#endif
