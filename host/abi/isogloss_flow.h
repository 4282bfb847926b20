/* isogloss_flow.h - the host's service "isogloss.flow/1": calls, returns, jumps and loops.
 *
 * A syntax asks for it in create() (ig_link_api.service; the host always has it). In scan() it says which names lines
 * have; in build() it asks where the run goes on after the block. Names are compared byte by byte: the plugin writes
 * them in one form ("O3" for O0003). A file is indexed, by the scanners alone, at the first request that needs it: so
 * scan() has no effect but on its block.
 *
 *   Frame       One activation of a called program: the main program is frame 0; a call enters a frame, a return leaves
 *               it. A repeated call enters it anew: the same id, the next pass.
 *   Program     What an IG_LABEL_PROGRAM begins; it reaches to the next one, or to the end of the file. Other labels
 *               are looked for in the program that asks alone.
 */
#ifndef ISOGLOSS_FLOW_H
#define ISOGLOSS_FLOW_H

#include "isogloss.h"

#ifdef __cplusplus
extern "C" {
#endif

#define IG_FLOW_SERVICE "isogloss.flow/1"

/* Where a block begins. It stays good as long as the frame in which here() gave it, in all passes of it. */
typedef struct ig_place {
  uint64_t frame; /* ig_frame.id */
  uint64_t offset;
  uint32_t line;
  uint32_t column;
} ig_place;

/* The caller sets struct_size. Texts are good to the end of the call of build(). */
typedef struct ig_frame {
  uint32_t struct_size;
  uint32_t depth; /* 0: the main program */
  uint64_t id;    /* of this run, never used again */
  uint64_t tag;   /* from the call; 0 for the main program */
  uint32_t pass;  /* from 1 */
  uint32_t passes;
  ig_text program; /* the name by which it was called; size 0 for the main program */
  ig_text file;
  uint32_t call_line; /* the line of the calling block, in the file of the frame below */
  uint32_t reserved;
} ig_frame;
#define IG_CURRENT_FRAME 0xffffffffu

typedef uint32_t ig_label_kind;
enum { IG_LABEL_PLACE = 0, IG_LABEL_PROGRAM = 1 };

typedef uint32_t ig_go_kind;
enum {
  IG_GO_CALL = 1,   /* the program `label`, `repeats` times */
  IG_GO_RETURN = 2, /* behind the calling block, or to `label` of the caller's program */
  IG_GO_LABEL = 3,  /* the block `label` of this program */
  IG_GO_PLACE = 4,  /* `place`, of this frame */
  IG_GO_START = 5,  /* the first block of this frame */
  IG_ASK_LABEL = 6  /* nowhere: IG_GO_DONE where IG_GO_LABEL with the same `search` would find `label`, IG_GO_REFUSED
                     * where the text cannot be read again; the block may still ask for something */
};

/* Where a called program may be; 0: IG_IN_FILES | IG_IN_FOLDERS. */
enum {
  IG_IN_FILES = 1u << 0,   /* the programs of the caller's file, then of the others that were entered */
  IG_IN_FOLDERS = 1u << 1, /* files of the folder of the main program, and of the places that the user named */
  IG_IN_PROGRAM = 1u << 2  /* a place of the calling program itself */
};

typedef uint32_t ig_search;
enum {
  IG_SEARCH_AROUND = 0, /* forward from the block, then from the top of the program */
  IG_SEARCH_FORWARD = 1,
  IG_SEARCH_BACKWARD = 2, /* the nearest before the block */
  IG_SEARCH_TOP = 3
};

enum {
  IG_GO_BEHIND = 1u << 0,      /* IG_GO_LABEL, IG_GO_PLACE: to the block behind that one */
  IG_GO_DROP_REPEATS = 1u << 1 /* IG_GO_RETURN: passes that are left are not made */
};

/* What go() answers. */
enum {
  IG_GO_DONE = 1,      /* the run goes there after this block */
  IG_GO_NOT_FOUND = 0, /* there is no such label, program, file or frame: `reason` says where it looked */
  IG_GO_REFUSED = -1,  /* a limit of the run is reached: the host has said so */
  IG_GO_TAKEN = -2     /* another request of this block comes first */
};

/* Members that a kind does not name are not looked at; 0 is their plain value. */
typedef struct ig_go {
  uint32_t struct_size;
  ig_go_kind kind;
  ig_text label;
  ig_text start; /* IG_GO_CALL: a label of the called program at which it begins; size 0: at its beginning */
  /* IG_GO_CALL: names of the file, without folder and extension, the best first; any case. A name that ends in '/' is a
   * folder ("CUS.DIR/", "WKS.DIR/PART.WPD/"): before the other names, the only place to look where it is there; after
   * them, one more place, where the dialect's SearchOrder has ProgramPath. */
  const ig_text* files;
  uint32_t file_count;
  uint32_t scope;   /* IG_GO_CALL: IG_IN_... */
  uint32_t repeats; /* IG_GO_CALL: 0 counts as 1 */
  ig_search search;
  uint32_t flags;
  uint32_t reserved;
  uint64_t tag; /* IG_GO_CALL: shown in ig_frame, for whoever calls */
  ig_place place;
  ig_text reason; /* out, alive to the end of the block */
} ig_go;

typedef struct ig_flow_1 {
  uint32_t struct_size;
  uint32_t is_indexing; /* 1: this chain only collects labels; its build() functions are never called */
  /* scan(): this block has a name. Nothing happens unless is_indexing. A name of a program that ends in '/' is the
   * folder of the program that began last ("CUS.DIR/"). */
  void (*label)(ig_block*, ig_text name, ig_label_kind);
  /* scan() or build(), but not in post-logic: the first request of a block counts. Where no program runs (a case of a
   * page) each request is answered IG_GO_DONE. */
  int32_t (*go)(ig_block*, ig_go*);
  /* Frame `level`, from 0 to the depth, or IG_CURRENT_FRAME; 0 when there is no such frame. */
  int32_t (*frame)(const ig_block*, uint32_t level, ig_frame* out);
  void (*here)(const ig_block*, ig_place* out);
  /* Copies bytes of the main program's text, from `offset` on, and returns their number: 0 at its end, while a file is
   * indexed, and where no program runs. restart() may look at the text before the first block is read. A host from
   * before this member has a shorter struct. */
  size_t (*text)(const ig_block*, uint64_t offset, char* buffer, size_t size);
} ig_flow_1;

#ifdef __cplusplus
}
#endif
#endif
