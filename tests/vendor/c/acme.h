/* What the files of the plugin know of each other. It needs members of version 1.0 of the contract alone. */
#ifndef ACME_H
#define ACME_H

#include <isogloss.h>

/* The rows of the table of diagnostics in plugin.c. */
enum { ACME_ON_AND_OFF, ACME_NO_CLAMP };

#define ACME_CLAMP_SERVICE "acme.clamp/1"

typedef struct acme_clamp_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  int32_t (*force)(void* self, double clamp, double* out); /* kN; 0: there is no such clamp */
} acme_clamp_1;

extern const ig_syntax acme_vacuum_syntax;
extern const ig_syntax acme_clamp_syntax;
extern const ig_dependency acme_clamp_table;

#endif
