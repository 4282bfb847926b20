/* isogloss_import.h - importers: the controls' own table and backup files become rows of dependencies; since 1.7.
 *
 * A plugin lists its importers in ig_plugin.importers. The host reads the file, asks each importer how sure it is that
 * the file is of its format, and lets the surest one read it. An importer gives rows of the tables of any plugin's
 * dependencies, in their units; whatever it does not read it names, so that nothing is lost in silence.
 *
 *   Text      UTF-8, also of a file in UTF-16 or Latin-1, and without the NUL, DC1 to DC4 and 1A of a serial line.
 *   Places    Byte offsets into that text. The host shows line and column.
 *   Threads   Importers have no state: their functions may be called on any thread.
 */
#ifndef ISOGLOSS_IMPORT_H
#define ISOGLOSS_IMPORT_H

#include "isogloss.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ig_import ig_import; /* a file while it is read, opaque */
typedef struct ig_export ig_export; /* a file while it is written, opaque */

typedef struct ig_import_api {
  uint32_t struct_size;
  uint32_t host_minor;
  ig_text (*text)(const ig_import*);
  ig_text (*file_name)(const ig_import*); /* without its folder */
  double (*option_number)(const ig_import*, uint32_t option);
  int64_t (*option_integer)(const ig_import*, uint32_t option); /* IG_OPTION_CHOICE: index of the choice */
  ig_text (*option_text)(const ig_import*, uint32_t option);
  /* What follows belongs to the row `key` of the table of this dependency. A row that comes again is the same row. */
  void (*row)(ig_import*, ig_text dependency, ig_text key, size_t place);
  /* A cell of the row, as text or as a finite number. A cell that comes again has the later value. */
  void (*text_cell)(ig_import*, ig_text column, ig_text value, size_t place);
  void (*number_cell)(ig_import*, ig_text column, double value, size_t place);
  /* An option of a dependency. */
  void (*option)(ig_import*, ig_text dependency, ig_text name, ig_text value, size_t place);
  /* begin..end has no effect: what it is ("column LAST_USE"), and why. The host counts those with the same two texts
   * and shows the first one. */
  void (*unused)(ig_import*, ig_text what, ig_text why, size_t begin, size_t end);
  /* diagnostic: index in the plugin's table. */
  void (*report)(ig_import*, uint32_t diagnostic, size_t begin, size_t end, const ig_argument*, uint32_t count);
  /* Says why read() returns IG_FAILED. */
  void (*fail)(ig_import*, ig_text reason);
  /* Since 1.8: the rows that the machine's own file has for a table, which tell how the file is meant (names of axes).
   * A cell is a text; size 0 where there is none. A file that is imported without a machine has no such rows. */
  uint32_t (*machine_row_count)(const ig_import*, ig_text dependency);
  ig_text (*machine_row_key)(const ig_import*, ig_text dependency, uint32_t row);
  ig_text (*machine_cell)(const ig_import*, ig_text dependency, uint32_t row, ig_text column);
} ig_import_api;

typedef struct ig_export_api {
  uint32_t struct_size;
  uint32_t host_minor;
  double (*option_number)(const ig_export*, uint32_t option);
  int64_t (*option_integer)(const ig_export*, uint32_t option);
  ig_text (*option_text)(const ig_export*, uint32_t option);
  /* The rows of a dependency's table, in their order, and a cell as text; size 0 where there is none. */
  uint32_t (*row_count)(const ig_export*, ig_text dependency);
  ig_text (*row_key)(const ig_export*, ig_text dependency, uint32_t row);
  ig_text (*cell)(const ig_export*, ig_text dependency, uint32_t row, ig_text column);
  void (*write)(ig_export*, ig_text bytes);
  /* What the format has no place for, and why; counted as in ig_import_api. */
  void (*unused)(ig_export*, ig_text what, ig_text why);
  void (*fail)(ig_export*, ig_text reason);
} ig_export_api;

struct ig_importer {
  uint32_t struct_size;
  uint32_t option_count;
  const char* id;      /* the format that a user names: "HeidenhainToolTable" */
  const char* summary; /* one sentence */
  const char* page;    /* Markdown with the cases that teach, NULL where there is none */
  const char* cases;   /* Markdown with all other cases, NULL where there are none */
  const char* folder;  /* of its page below the plugin's sources; NULL: beside them */
  const char* files;   /* shell patterns of usual file names, separated by blanks: "*.t TOOL*.T"; for people */
  const char* const* dependencies; /* ids of those that it gives rows for, NULL at the end */
  const ig_option_decl* options;
  /* How sure it is that the text is of its format: 0 it is not, 100 no other format begins so. It looks at the first
   * 64 KiB at most, and reports nothing. */
  uint32_t (*recognise)(ig_text text, ig_text file_name);
  ig_status (*read)(const ig_import_api*, ig_import*);
  /* NULL: the format is only read. */
  ig_status (*write)(const ig_export_api*, ig_export*);
  /* 1: the file gives values that the control begins with, as definitions do. Of the files in a folder such are read
   * before the others, whose values replace theirs. */
  uint32_t is_initial;
  uint32_t reserved;
};

#ifdef __cplusplus
}
#endif
#endif
