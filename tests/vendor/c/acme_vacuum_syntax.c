/* Acme's vacuum table: M171 switches it on, M172 off. */
#include <stdlib.h>
#include <string.h>

#include "acme.h"

extern const char acme_vacuum_syntax_page[];

enum { ON, OFF, IS_ON, PUMP, FIELD_COUNT };

typedef struct vacuum {
  ig_field ids[FIELD_COUNT];
  ig_value pump;
} vacuum;

static ig_status refuse(const ig_link_api* api, ig_link* link, const char* reason) {
  api->fail(link, (ig_text){reason, strlen(reason)});
  return IG_FAILED;
}

static ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  const ig_text pump = api->option_text(link, 0);
  const int is_known = pump.size == 5 && (memcmp(pump.data, "north", 5) == 0 || memcmp(pump.data, "south", 5) == 0);
  if (!is_known) return refuse(api, link, "the machine has the pumps north and south");
  vacuum* const made = malloc(sizeof *made);
  if (made == NULL) return refuse(api, link, "out of memory");
  memcpy(made->ids, ids, sizeof made->ids);
  made->pump.symbol = api->symbol(link, pump);
  *self = made;
  return IG_CHANGED;
}

static ig_status build(void* self, const ig_host* host, ig_block* block) {
  const vacuum* const own = self;
  uint32_t found = 0;
  const int32_t code = host->take_code(block, own->ids, 2, &found);
  if (code < 0) return IG_UNCHANGED;
  if (found > 1) host->report(block, ACME_ON_AND_OFF, IG_NO_FIELD, 0, 0, NULL, 0);
  const ig_value is_on = {.integer = code == ON};
  host->set(block, own->ids[IS_ON], is_on);
  host->set(block, own->ids[PUMP], own->pump);
  return IG_CHANGED;
}

#define CODE(its_path)                                                                                            \
  {                                                                                                               \
    .struct_size = sizeof(ig_field_decl), .access = IG_TAKE | IG_WAKE, .type = IG_CODE, .life = IG_LIFE_STANDARD, \
    .path = its_path, .unit = "", .doc = ""                                                                       \
  }

static const ig_field_decl fields[FIELD_COUNT] = {
    [ON] = CODE("Parsing.Flags.M171"),
    [OFF] = CODE("Parsing.Flags.M172"),
    [IS_ON] = {.struct_size = sizeof(ig_field_decl),
               .access = IG_WRITE,
               .type = IG_BOOLEAN,
               .life = IG_LIFE_MODAL,
               .path = "AcmeVacuum.IsOn",
               .unit = "",
               .doc = "The part is held."},
    [PUMP] = {.struct_size = sizeof(ig_field_decl),
              .access = IG_WRITE,
              .type = IG_SYMBOL,
              .life = IG_LIFE_MODAL,
              .path = "AcmeVacuum.Pump",
              .unit = "",
              .doc = "The pump at work."},
};

static const ig_option_decl options[] = {
    {.struct_size = sizeof(ig_option_decl),
     .type = IG_OPTION_TEXT,
     .name = "pump",
     .fallback = "north",
     .choices = "",
     .unit = "",
     .doc = "The pump of the table: north or south."},
};

static const char* const before[] = {"LinearMotionSyntax", NULL};

const ig_syntax acme_vacuum_syntax = {
    .struct_size = sizeof(ig_syntax),
    .id = "AcmeVacuumSyntax",
    .summary = "M171/M172 vacuum table on and off.",
    .page = acme_vacuum_syntax_page,
    .fields = fields,
    .field_count = FIELD_COUNT,
    .options = options,
    .option_count = 1,
    .before = before,
    .create = create,
    .destroy = free,
    .build = build,
};
