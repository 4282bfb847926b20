/* isogloss_provenance.h - the host's service "isogloss.provenance/1": which row of a table has answered for a block,
 * and which variables of the program the block has read and written.
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
} ig_provenance_1;

#ifdef __cplusplus
}
#endif
#endif
