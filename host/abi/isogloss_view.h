/* isogloss_view.h - where the values of a block lie, for reads that make no call.
 *
 * Where ig_host.flags has IG_HOST_SHOWS_BLOCKS, an ig_block begins with an ig_view: its bits and values answer what
 * get(), get_point(), is_fresh() and their kin answer. A host that checks or traces what a syntax does, and one that
 * keeps its values in another way, does not set the flag: whoever reads here must be able to call, too. Nothing is
 * ever written here. A pointer is good until the call ends for which the host handed out the block.
 */
#ifndef ISOGLOSS_VIEW_H
#define ISOGLOSS_VIEW_H

#include "isogloss.h"

#ifdef __cplusplus
extern "C" {
#endif

#define IG_HOST_SHOWS_BLOCKS 1u

/* Of 64 fields: field f is bit f % 64 of bits[f / 64]. */
typedef struct ig_view_bits {
  uint64_t present;
  uint64_t fresh;
  uint64_t others[6]; /* the host's */
} ig_view_bits;

/* The value means something while the field is present. */
typedef struct ig_view_value {
  ig_value value;
  uint64_t other; /* the host's */
} ig_view_value;

typedef struct ig_view {
  const ig_view_bits* bits;
  const ig_view_value* values; /* by field */
  uint32_t field_count;        /* no other field has bits or a value: IG_NO_FIELD, fields of records */
  uint32_t reserved;
} ig_view;

#ifdef __cplusplus
}
#endif

#endif
