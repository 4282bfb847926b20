/* isogloss_axis.h - names and positions that one machine gives its axes, and axes beside X Y Z A B C; since 1.8. */
#ifndef ISOGLOSS_AXIS_H
#define ISOGLOSS_AXIS_H

#include "isogloss.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef uint32_t ig_axis_position;
enum {
  IG_AXIS_HOME = 1,          /* before the first block */
  IG_AXIS_DATUM = 2,         /* the builder's additional datum: M92 of a Heidenhain */
  IG_AXIS_RETRACT = 3,       /* where the axis retracts before others swivel: CYCLE800 of a Siemens */
  IG_AXIS_FIXED_POINT_1 = 4, /* to 7: fixed points 1 to 4, G75 of a Siemens */
  IG_AXIS_FIXED_POINT_4 = 7,
  IG_AXIS_REFERENCE_1 = 8, /* to 11: reference positions 1 to 4, G28 and G30 */
  IG_AXIS_REFERENCE_4 = 11
};

/* isogloss.axis-name/1: axes 0 to 5 are X Y Z A B C, further ones follow in the order of their table. mm and degrees in
 * machine coordinates. Texts are alive as long as the chain. */
typedef struct ig_axis_name_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  /* The axis that programs call by this name, in any case of letters; -1: the machine has none. */
  int32_t (*find)(void* self, ig_text name);
  /* The axis's own name, "X" or "U"; size 0: the machine has no such axis. */
  ig_text (*name)(void* self, uint32_t axis);
  /* What programs call it besides, with one blank between two names: "C1 ROTC". */
  ig_text (*further_names)(void* self, uint32_t axis);
  int32_t (*is_rotary)(void* self, uint32_t axis);
  /* These return 1, or 0 when the machine has no such axis or the value is not known. */
  int32_t (*position)(void* self, uint32_t axis, ig_axis_position which, double* position);
  int32_t (*travel)(void* self, uint32_t axis, double* minimum, double* maximum);
} ig_axis_name_1;

#ifdef __cplusplus
}
#endif
#endif
