/* isogloss_provenance.h - the host's service "isogloss.provenance/1": which row of a table has answered for a block,
 * which variables of the program the block has read and written, and which conditions it has examined. And
 * "isogloss.row-meaning/1", by which a table says what its rows mean.
 *
 * A syntax asks for it in create() (ig_link_api.service). It tells what a user wants to know when a block is explained:
 * the line of the XML, or of the program, behind a value. A host from before 1.8 does not have it.
 */
#ifndef ISOGLOSS_PROVENANCE_H
#define ISOGLOSS_PROVENANCE_H

#include "isogloss.h"

#ifdef __cplusplus
extern "C" {
#endif

#define IG_PROVENANCE_SERVICE "isogloss.provenance/1"

typedef struct ig_provenance_1 {
  uint32_t struct_size;
  uint32_t is_listening; /* 0: nobody asks in this run; answered() need not be called. It may change between blocks. */
  /* scan() or build(): a row has answered for this block. `service` is that of the table, `row` the name of the row as
   * the user wrote it. Both are copied. */
  void (*answered)(ig_block*, ig_text service, ig_text row);
  /* scan() or build(): the block has read (IG_READ) or written (IG_WRITE) a variable. `name` as a program writes it
   * ("#101", "R5", "Q2"); `scope` tells variables of the same name apart: 0, or a number of the program's own, such as
   * that of a call whose local variable it is. `value`: NULL where it has none. Name and value are copied. */
  void (*variable)(ig_block*, uint32_t access, ig_text name, uint64_t scope, const ig_argument* value);
  /* scan() or build(): the block has examined a condition that decides where the run goes on, or which words count.
   * `text` as the program writes it ("[#101 GT 5]"), or with IG_CONDITION_TELLS a reason in words ("pass 2 of 3"). It
   * is copied. A host from before this member has a shorter struct. */
  void (*condition)(ig_block*, ig_text text, int32_t outcome);
} ig_provenance_1;

enum { IG_CONDITION_FAILS = 0, IG_CONDITION_HOLDS = 1, IG_CONDITION_TELLS = 2 };

/* isogloss.row-meaning/1: what the rows of a table of parameters mean. A dependency provides it; the host asks each
 * dependency for its own rows, outside the blocks of a run. Texts live as long as `self`. */
#define IG_ROW_MEANING_SERVICE "isogloss.row-meaning/1"

typedef struct ig_row_meaning {
  uint32_t struct_size;
  uint32_t reserved;
  ig_text title;  /* "peck clearance": the same words in each table for what has the same effect; size 0: none */
  ig_text prefix; /* what people write before the name of the row: "Pr" */
  ig_text unit;   /* of the value times the scale: "mm"; size 0: none */
  double scale;   /* 0.001: the cell counts thousandths of the unit */
} ig_row_meaning;

typedef struct ig_row_meaning_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  /* 1: the row has a meaning, and `out` holds that of its cell in this column. The caller sets out->struct_size. 0: no
   * syntax acts on the cell, which `isogloss lint` notes. */
  int32_t (*meaning)(void* self, ig_text row, ig_text column, ig_row_meaning* out);
} ig_row_meaning_1;

#ifdef __cplusplus
}
#endif
#endif
