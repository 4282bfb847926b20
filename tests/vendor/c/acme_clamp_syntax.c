/* E puts the force of a clamp in force. */
#include <stdlib.h>
#include <string.h>

#include "acme.h"

extern const char acme_clamp_syntax_page[];

enum { CLAMP, FORCE, FIELD_COUNT };

typedef struct clamp {
  ig_field ids[FIELD_COUNT];
  const acme_clamp_1* table; /* alive as long as the chain */
} clamp;

static ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  static const char reason[] = "out of memory";
  clamp* const made = malloc(sizeof *made);
  if (made == NULL) {
    api->fail(link, (ig_text){reason, sizeof reason - 1});
    return IG_FAILED;
  }
  memcpy(made->ids, ids, sizeof made->ids);
  made->table = api->service(link, ACME_CLAMP_SERVICE);
  *self = made;
  return IG_CHANGED;
}

static ig_status build(void* self, const ig_host* host, ig_block* block) {
  const clamp* const own = self;
  ig_value number, force;
  if (host->take(block, own->ids[CLAMP], &number) == 0) return IG_UNCHANGED;
  if (own->table->force(own->table->self, number.number, &force.number) != 0) {
    host->set(block, own->ids[FORCE], force);
  } else {
    const ig_argument argument = {.number = number.number};
    host->report(block, ACME_NO_CLAMP, own->ids[CLAMP], 0, 0, &argument, 1);
  }
  return IG_CHANGED;
}

static const ig_field_decl fields[FIELD_COUNT] = {
    [CLAMP] = {.struct_size = sizeof(ig_field_decl),
               .access = IG_TAKE | IG_WAKE,
               .type = IG_NUMBER,
               .life = IG_LIFE_STANDARD,
               .path = "Parsing.E",
               .unit = "",
               .doc = ""},
    [FORCE] = {.struct_size = sizeof(ig_field_decl),
               .access = IG_WRITE,
               .type = IG_NUMBER,
               .life = IG_LIFE_MODAL,
               .path = "AcmeClamp.Force_kN",
               .unit = "kN",
               .doc = "The force of the clamp that E named last."},
};

static const ig_service_decl services[] = {
    {.struct_size = sizeof(ig_service_decl), .id = ACME_CLAMP_SERVICE, .doc = "The forces of the clamps."},
};

static const char* const before[] = {"LinearMotionSyntax", NULL};

const ig_syntax acme_clamp_syntax = {
    .struct_size = sizeof(ig_syntax),
    .id = "AcmeClampSyntax",
    .summary = "E puts the force of a clamp in force.",
    .page = acme_clamp_syntax_page,
    .fields = fields,
    .field_count = FIELD_COUNT,
    .services = services,
    .service_count = 1,
    .before = before,
    .create = create,
    .destroy = free,
    .build = build,
};
