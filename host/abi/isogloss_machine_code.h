/* isogloss_machine_code.h - codes, cycles and programs that the builder of one machine has added; since 1.7. */
#ifndef ISOGLOSS_MACHINE_CODE_H
#define ISOGLOSS_MACHINE_CODE_H

#include "isogloss.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef uint32_t ig_machine_code_kind;
enum {
  IG_CODE_DOES_NOTHING = 1, /* nothing that a program of moves shows */
  IG_CODE_ACTS = 2,         /* as the codes in `codes` */
  IG_CODE_CALLS = 3,        /* it calls `program` */
  IG_CODE_MOVES = 4,        /* the axes go to `position` by rapid */
  IG_CODE_IS_REFUSED = 5,   /* it is an error, for the reason in `text` */
  IG_CODE_SETS = 6          /* since 1.8: fields of the block get the values in `fields` */
};

/* What one of them does. Texts that its kind does not use have size 0. */
typedef struct ig_machine_code {
  uint32_t struct_size;
  ig_machine_code_kind does;
  ig_text name;       /* canonical: "M08", "G05.1", "CYCL DEF 392", "CYCLE996" */
  ig_text codes;      /* canonical, with one blank between two codes: "M08 M50" */
  ig_text program;    /* as the user wrote it */
  ig_text text;       /* why the code is refused */
  ig_text title;      /* what the builder calls it; size 0: it has no title */
  uint32_t axes;      /* a bit for each of X Y Z A B C that has a position */
  uint32_t when;      /* of cycles: 1 acts where it is defined, 2 where it is called; 0: as its number says */
  double position[6]; /* mm and degrees, machine coordinates */
  /* Since 1.8. */
  ig_text row; /* the name of the row as the user wrote it */
  uint32_t
      arguments; /* of a G or M code that calls: 1 its words are arguments, 2 the user asks for it; 0: they are not */
  uint32_t reserved;
  ig_text fields; /* "Coolant.Mode=FLOOD; Dwell.Time={P}": {P} is the number that the program writes behind P, {P:2} the
                   * same, or 2 where it writes none */
} ig_machine_code;

/* isogloss.machine-code/1 */
typedef struct ig_machine_code_1 {
  uint32_t struct_size;
  uint32_t unknown_programs; /* since 1.8; 1: a call of a program that is not found does nothing, 0: it is an error */
  void* self;
  /* The code of this name, in any case of letters; leading zeros of a number do not count. An empty name stands for
   * any. NULL: the user has said nothing about it. Alive as long as the chain. */
  const ig_machine_code* (*find)(void* self, ig_text name);
  /* Since 1.8: the row of the longest family (its name ends in '*') that the name belongs to; NULL where there is none.
   * Whoever asks does it only for names that have no row of their own and no meaning on the control. */
  const ig_machine_code* (*find_family)(void* self, ig_text name);
} ig_machine_code_1;

#ifdef __cplusplus
}
#endif
#endif
