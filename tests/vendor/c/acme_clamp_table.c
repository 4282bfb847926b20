/* The clamps of the machine, by number. The host holds the rows. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "acme.h"

typedef struct clamp_table {
  acme_clamp_1 service;
  const ig_link_api* api;
  ig_table* rows;
} clamp_table;

static int32_t force_of(void* self, double clamp, double* out) {
  const clamp_table* const own = self;
  if (!(clamp >= 0 && clamp < 1000 && clamp == (int)clamp)) return 0;
  char row[8];
  const int size = snprintf(row, sizeof row, "%d", (int)clamp);
  return own->api->value(own->rows, (ig_text){row, (size_t)size}, 0, out);
}

static ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  static const char reason[] = "out of memory";
  (void)ids;
  clamp_table* const made = malloc(sizeof *made);
  if (made == NULL) {
    api->fail(link, (ig_text){reason, sizeof reason - 1});
    return IG_FAILED;
  }
  *made = (clamp_table){{sizeof made->service, 0, made, force_of}, api, api->table(link)};
  *self = made;
  return IG_CHANGED;
}

static const void* service(void* self, const char* id) {
  const clamp_table* const own = self;
  return strcmp(id, ACME_CLAMP_SERVICE) == 0 ? &own->service : NULL;
}

static const ig_column_decl columns[] = {
    {.struct_size = sizeof(ig_column_decl),
     .name = "Force_kN",
     .unit = "kN",
     .minimum = 0,
     .maximum = 50,
     .doc = "The force of the clamp."},
};

static const char* const provides[] = {ACME_CLAMP_SERVICE, NULL};

const ig_dependency acme_clamp_table = {
    .struct_size = sizeof(ig_dependency),
    .id = "AcmeClampTable",
    .summary = "The clamps of the machine and their forces.",
    .row_element = "Clamp",
    .row_key = "id",
    .columns = columns,
    .column_count = 1,
    .provides = provides,
    .create = create,
    .destroy = free,
    .service = service,
};
