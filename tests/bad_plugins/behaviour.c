/* Plugins whose descriptor is sound and whose code is not; the fault is chosen by FAULT_…. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sound.h"

static void hang(void) {
  for (volatile int forever = 1; forever;) {
  }
}
static void crash(void) { *(volatile int*)(uintptr_t)8 = 1; }

static const ig_field_decl fields[] = {SOUND_FIELD("Parsing.X", IG_READ | IG_WAKE),
#if defined(FAULT_sets_a_frame_as_number)
                                       {sizeof(ig_field_decl), IG_READ | IG_WRITE, IG_TRANSFORM, IG_LIFE_STANDARD,
                                        "ProgramToMcTransform.CoordinateOffset", "", "", 0}};
#elif defined(FAULT_sets_a_text_as_number)
                                       {sizeof(ig_field_decl), IG_READ | IG_WRITE, IG_TEXT, IG_LIFE_STANDARD,
                                        "Comment.Text", "", "", 0}};
#elif defined(FAULT_acts_unasked)
                                       SOUND_FIELD("Feedrate.FeedrateValue", IG_READ | IG_WRITE)};
#else
                                       SOUND_FIELD("Feedrate.FeedrateValue", IG_READ)};
#endif
static ig_field ids_of_chain[2];

static ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  (void)api;
  (void)link;
  *self = (void*)ids; /* anything: destroy() is called for what is not null */
  ids_of_chain[0] = ids[0];
  ids_of_chain[1] = ids[1];
#if defined(FAULT_create_nonsense)
  return 77;
#elif defined(FAULT_create_refuses)
  return IG_FAILED; /* without a reason */
#elif defined(FAULT_create_crashes)
  crash();
#elif defined(FAULT_hangs_in_create)
  hang();
#elif defined(FAULT_exits_in_create)
  exit(0);
#endif
  return IG_CHANGED;
}

static ig_status build(void* self, const ig_host* host, ig_block* block) {
  (void)self;
  (void)host;
  (void)block;
#if defined(FAULT_status_nonsense)
  return 77;
#elif defined(FAULT_fails_silently)
  return IG_FAILED;
#elif defined(FAULT_writes_undeclared)
  const ig_value value = {.number = 1};
  host->set(block, ids_of_chain[1], value); /* declared as read */
#elif defined(FAULT_writes_no_field)
  const ig_value value = {.number = 1};
  host->set(block, 123456u, value);
#elif defined(FAULT_takes_undeclared)
  ig_value value;
  host->take(block, ids_of_chain[0], &value); /* declared as read */
#elif defined(FAULT_sets_a_frame_as_number)
  const ig_value value = {.number = -1e300};
  host->set(block, ids_of_chain[1], value);
  double matrix[16];
  host->transform(block, ids_of_chain[1], matrix);
#elif defined(FAULT_sets_a_text_as_number)
  const ig_value value = {.integer = INT64_MAX};
  host->set(block, ids_of_chain[1], value);
  host->text(block, ids_of_chain[1]);
#elif defined(FAULT_acts_unasked)
  const ig_value value = {.number = 1};
  host->set(block, ids_of_chain[1], value);
  return IG_CHANGED;
#elif defined(FAULT_crashes_in_build)
  crash();
#elif defined(FAULT_exits_in_build)
  exit(0);
#elif defined(FAULT_quits_in_build)
  _exit(0);
#elif defined(FAULT_smashes_the_stack)
  volatile char small[8];
  for (int i = 0; i < 4096; ++i) ((volatile char*)small)[i] = 'A';
#elif defined(FAULT_hangs_in_build)
  hang();
#elif defined(FAULT_recurses)
  volatile char page[4096];
  page[0] = 1;
  return build(self, host, block) + page[0];
#endif
  return IG_UNCHANGED;
}

static void destroy(void* self) {
  (void)self;
#if defined(FAULT_crashes_in_destroy)
  crash();
#elif defined(FAULT_hangs_in_destroy)
  hang();
#endif
}

static ig_status restart(void* self, const ig_host* host, ig_block* block) {
  (void)self;
  (void)host;
  (void)block;
#if defined(FAULT_crashes_in_restart)
  crash();
#elif defined(FAULT_hangs_in_restart)
  hang();
#endif
  return IG_UNCHANGED;
}

#if defined(FAULT_scans_beyond)
static size_t scan(void* self, const ig_host* host, ig_block* block, const char* text, size_t size, size_t position) {
  (void)self;
  (void)host;
  (void)block;
  (void)text;
  (void)position;
  return size + 1000000;
}
#endif

static const ig_syntax syntax = {.struct_size = sizeof(ig_syntax),
                                 .id = "BadSyntax",
                                 .summary = "Misbehaves.",
                                 .fields = fields,
                                 .options = sound_options,
                                 .field_count = 2,
                                 .option_count = 1,
                                 .create = create,
                                 .destroy = destroy,
                                 .restart = restart,
#if defined(FAULT_scans_beyond)
                                 .triggers = "G",
                                 .scan = scan,
#endif
                                 .build = build};
static const ig_syntax* const syntaxes[] = {&syntax};
static const ig_plugin plugin = SOUND_PLUGIN(NAME, syntaxes);

const ig_plugin* ig_plugin_v1(void) { return &plugin; }
