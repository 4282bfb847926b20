/* isogloss_tool.h - tools that are called by name, and tools with several lengths; since 1.7. */
#ifndef ISOGLOSS_TOOL_H
#define ISOGLOSS_TOOL_H

#include "isogloss.h"

#ifdef __cplusplus
extern "C" {
#endif

/* isogloss.tool-name/1: the names of tools; since 1.7. Numbers are those of isogloss.tool-offset/1. A tool with several
 * lengths has an index for each: index i of tool t, "5.1", is the number t + 100000 i. */
typedef struct ig_tool_name_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  /* The first tool of this name behind the tool `after` in the table (0: from its beginning), for sister tools have one
   * name; an empty name stands for any. 0: there is none. */
  int64_t (*find)(void* self, ig_text name, int64_t after);
  /* size 0: the tool has no name. Alive as long as the chain. */
  ig_text (*name)(void* self, int64_t id);
} ig_tool_name_1;
#define IG_TOOL_INDEX_STEP 100000

/* Columns of isogloss.tool-offset/1; those from IG_TOOL_CORNER_RADIUS on since 1.7. A table gives 0 for a column that
 * it does not have, and for a value that is not known. mm; the tip angle of a drill in degrees, its whole angle; the
 * highest speed of the spindle in rpm. Since 1.8 the number that the control has for the type of the tool, the largest
 * plunge angle in degrees, and in minutes the life of the tool, that at which a call no longer takes it, and the part
 * that is used. */
enum {
  IG_TOOL_LENGTH = 0,
  IG_TOOL_LENGTH_WEAR = 1,
  IG_TOOL_RADIUS = 2,
  IG_TOOL_RADIUS_WEAR = 3,
  IG_TOOL_CORNER_RADIUS = 4,
  IG_TOOL_CORNER_RADIUS_WEAR = 5,
  IG_TOOL_TIP_ANGLE = 6,
  IG_TOOL_TEETH = 7,
  IG_TOOL_MAXIMUM_SPEED = 8,
  IG_TOOL_TYPE = 9,
  IG_TOOL_CUTTING_LENGTH = 10,
  IG_TOOL_PLUNGE_ANGLE = 11,
  IG_TOOL_LIFE = 12,
  IG_TOOL_LIFE_AT_CALL = 13,
  IG_TOOL_USED_LIFE = 14
};

#ifdef __cplusplus
}
#endif
#endif
