/* isogloss.h - the contract between the Isogloss host and its plugins.
 *
 * A plugin is a shared library that exports one symbol, ig_plugin_v1(). It returns static const data that describes
 * the plugin's syntaxes, dependencies and diagnostics; the host lists, documents, links and checks a plugin without
 * creating one of them. Conventions (ids, ownership, threads, growth) stand in conventions.md beside this file.
 *
 *   Ownership   What the host passes is borrowed until the call returns; setters copy. Nothing is freed on the other
 *               side. Descriptors, and every string in them, live as long as the library.
 *   Threads     A chain instance belongs to one thread. Plugins keep no mutable globals.
 *   Errors      No exception and no longjmp crosses. A function that can fail returns ig_status.
 *   Growth      Every struct begins with struct_size and only grows at its end. A reader looks at a member only when
 *               struct_size covers it. What cannot grow so gets a new symbol (ig_plugin_v2).
 *   Units       mm, degrees, seconds; feeds as programmed in FeedrateValue, mm/s in Feedrate_mmds. Columns are 0-based
 *               byte offsets into the block's text here, and 1-based where a person reads them.
 */
#ifndef ISOGLOSS_H
#define ISOGLOSS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define IG_ABI_MAJOR 1u
#define IG_ABI_MINOR 8u

#if defined(_WIN32)
#define IG_EXPORT __declspec(dllexport)
#else
#define IG_EXPORT __attribute__((visibility("default")))
#endif

/* ---- Values ------------------------------------------------------------------------------------------------- */

/* Borrowed bytes, not terminated. Program text may hold any byte; names are UTF-8. */
typedef struct ig_text {
  const char* data;
  size_t size;
} ig_text;

/* A field of the block document, or of a list's records. Dense, given by the host at link time, the same for every
 * syntax of one chain, meaningless in another chain. */
typedef uint32_t ig_field;
#define IG_NO_FIELD 0xffffffffu

/* An interned name ("G90", "McLinear"), comparable by value within one chain. 0 is no name. */
typedef uint32_t ig_symbol;

/* Eight bytes; which member counts follows from the field's type. */
typedef union ig_value {
  double number;
  int64_t integer; /* IG_INTEGER; IG_BOOLEAN 0 or 1; IG_CODE: the code's ordinal in its block, from 1 */
  uint64_t symbol; /* an ig_symbol */
} ig_value;

typedef uint32_t ig_type;
enum {
  IG_NUMBER = 1,
  IG_INTEGER = 2,
  IG_BOOLEAN = 3,
  IG_SYMBOL = 4,
  IG_TEXT = 5,
  IG_CODE = 6,      /* a code of the program; present when the block holds it */
  IG_TRANSFORM = 7, /* 4x4, row vectors, translation in elements 12..14 */
  IG_SWITCH = 8     /* presence only, never shown: wakes other syntaxes */
};

/* How long a value lives; IG_LIFE_FRAME: as modal, but a called program begins without it and its caller has it again.
 * Fields of the standard sections and of Parsing have their life from the host: pass 0. */
typedef uint32_t ig_life;
enum { IG_LIFE_STANDARD = 0, IG_LIFE_WORD = 1, IG_LIFE_BLOCK = 2, IG_LIFE_MODAL = 3, IG_LIFE_FRAME = 4 };

typedef int32_t ig_status;
enum { IG_UNCHANGED = 0, IG_CHANGED = 1, IG_FAILED = -1 };

typedef struct ig_host ig_host;         /* the functions that a syntax calls while it runs */
typedef struct ig_block ig_block;       /* the block document; opaque but for isogloss_view.h */
typedef struct ig_link ig_link;         /* one element of a dialect while it is created, opaque */
typedef struct ig_link_api ig_link_api; /* the functions that create() calls */
typedef struct ig_table ig_table;       /* the rows of a dependency, held by the host, opaque */
typedef struct ig_importer ig_importer; /* see isogloss_import.h */

/* ---- Descriptors -------------------------------------------------------------------------------------------- */

/* What a syntax does with a field. A field that is not declared cannot be reached. */
enum {
  IG_READ = 1u << 0,       /* reads the value of this block, or the carried one */
  IG_REQUIRED = 1u << 1,   /* with IG_READ: linking fails when nothing writes it */
  IG_WRITE = 1u << 2,      /* sets, amends or erases */
  IG_TAKE = 1u << 3,       /* consumes a word or code */
  IG_PREVIOUS = 1u << 4,   /* reads the value from before this block; the id differs from the field's own */
  IG_WAKE = 1u << 5,       /* build() is called when the field is set in this block */
  IG_WAKE_WHILE = 1u << 6, /* build() is called in each block that starts with the field (equal to wake_value) */
  IG_PATTERN = 1u << 7,    /* path: "@name" of an IG_OPTION_FIELDS, or since 1.6 a pattern; the host expands it */
  IG_ENDS_AHEAD = 1u << 8  /* a block that has the field is the last one that build() reads ahead; since 1.8 */
};

/* path: "Section.Field", "Parsing.X" (word), "Parsing.Flags.CODE" (code), "Parsing.CODE" and "Parsing.CODE.X" (a code
 * that owns its words), "ProgramToMcTransform.SOURCE" (transform), "Section.List[].Section.Field" (record of a list).
 */
typedef struct ig_field_decl {
  uint32_t struct_size;
  uint32_t access;
  ig_type type;
  ig_life life;
  const char* path;
  const char* unit; /* "" where it has none or the host knows it */
  const char* doc;
  const char* wake_value; /* NULL, or the symbol that IG_WAKE_WHILE waits for */
} ig_field_decl;

typedef uint32_t ig_option_type;
enum {
  IG_OPTION_TEXT = 1,
  IG_OPTION_NUMBER = 2,
  IG_OPTION_INTEGER = 3,
  IG_OPTION_BOOLEAN = 4,
  IG_OPTION_CHOICE = 5, /* one of choices, "a|b|c" */
  IG_OPTION_FIELDS = 6  /* field patterns, separated by blanks: Parsing.X Parsing.*.X Parsing.**{mm}; since 1.6
                         * Parsing.*{kind}.X, X of all codes whose own unit is "kind" */
};

typedef struct ig_option_decl {
  uint32_t struct_size;
  ig_option_type type;
  const char* name;
  const char* fallback; /* the default, as text; NULL: the option must be given */
  const char* choices;
  double minimum; /* inclusive; -HUGE_VAL and HUGE_VAL where there is no bound */
  double maximum;
  const char* unit;
  const char* doc;
} ig_option_decl;

typedef struct ig_service_decl {
  uint32_t struct_size;
  uint32_t is_optional;
  const char* id; /* "isogloss.tool-offset/1" */
  const char* doc;
} ig_service_decl;

typedef uint32_t ig_severity;
enum { IG_NOTE = 1, IG_WARNING = 2, IG_ERROR = 3 };

/* One row of the plugin's table of diagnostics. The code is a prefix and a number and is never reused. The text holds
 * {0} {1} ... for the arguments. */
typedef struct ig_diagnostic_decl {
  uint32_t struct_size;
  ig_severity severity;
  const char* code;
  const char* text;
  const char* explanation;
  const char* example; /* a block of a program that provokes it */
} ig_diagnostic_decl;

/* The host gives ids[i] for fields[i] (IG_NO_FIELD for a pattern: see ig_link_api.expand). *self is the plugin's. */
typedef ig_status (*ig_create_fn)(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self);
typedef void (*ig_destroy_fn)(void* self);
typedef ig_status (*ig_run_fn)(void* self, const ig_host* host, ig_block* block);
/* Reads text[position..size) and returns the first position that it did not take; position itself: not mine. */
typedef size_t (*ig_scan_fn)(void* self, const ig_host* host, ig_block* block, const char* text, size_t size,
                             size_t position);

typedef struct ig_syntax {
  uint32_t struct_size;
  uint32_t look_ahead; /* executed blocks that build() reads ahead, through ig_host.ahead */
  const char* id;      /* the XML element */
  const char* summary; /* one sentence */
  const char* page;    /* Markdown with the cases that teach, NULL where there is none */
  const ig_field_decl* fields;
  const ig_option_decl* options;
  const ig_service_decl* services;
  uint32_t field_count;
  uint32_t option_count;
  uint32_t service_count;
  uint32_t inspects;        /* 1: build() is called when the block has leftovers */
  const char* const* after; /* ids, NULL at the end; NULL: none */
  const char* const* before;
  const char* exclusive_slot;    /* only one syntax of a chain may claim it; NULL: none */
  const char* first_writer_slot; /* several may, and the first that writes in a block wins; NULL: none */
  const char* triggers;          /* the bytes at which scan() is asked; NULL: no scan() */
  ig_create_fn create;
  ig_destroy_fn destroy;
  ig_run_fn restart;   /* once a run, on the block before the first; NULL: nothing to do */
  ig_scan_fn scan;     /* NULL: no scanner */
  ig_run_fn build;     /* NULL: a scanner only */
  const char* cases;   /* Markdown with all other cases, NULL where there are none; since 1.5 */
  const char* folder;  /* of its page below the plugin's sources: "cycles"; NULL: beside them; since 1.6 */
  uint32_t scan_flags; /* IG_SCANS_AHEAD, see isogloss_scan.h; since 1.8 */
  uint32_t reserved;
} ig_syntax;

/* A column of a dependency's table. */
typedef struct ig_column_decl {
  uint32_t struct_size;
  uint32_t is_text;
  const char* name;
  const char* unit;
  const char* fallback; /* text of the default, NULL: no value */
  double minimum;
  double maximum;
  const char* doc;
} ig_column_decl;

/* A named part that answers questions. Its data (scalar options, and rows of a table) is held by the host: read from
 * XML, replaced from the command line, cloned for each run, written back. create() gets the table from its link. */
typedef struct ig_dependency {
  uint32_t struct_size;
  uint32_t column_count;
  const char* id;
  const char* summary;
  const char* page;
  const char* row_element; /* NULL: no table */
  const char* row_key;     /* the attribute that names a row */
  const ig_column_decl* columns;
  const ig_option_decl* options;
  const char* const* provides; /* service ids, NULL at the end */
  uint32_t option_count;
  uint32_t default_row_count;
  const char* const* default_rows; /* "key|column=value|..." shipped rows */
  ig_create_fn create;             /* ids is NULL */
  ig_destroy_fn destroy;
  const void* (*service)(void* self, const char* id); /* a service struct, alive as long as self */
  /* May be NULL. Why a row that the user named means nothing, or nothing when it means something. Asked after create()
   * for each row that a dialect, a file or --set gave. Alive until the next call. */
  ig_text (*row_fault)(void* self, ig_text row); /* since 1.4 */
} ig_dependency;

typedef struct ig_plugin {
  uint32_t struct_size;
  uint32_t abi_major;
  uint32_t abi_minor;
  uint32_t syntax_count;
  const char* name;
  const char* version;
  const char* vendor;
  const char* built_with;
  const ig_syntax* const* syntaxes;
  const ig_dependency* const* dependencies;
  const ig_diagnostic_decl* diagnostics;
  uint32_t dependency_count;
  uint32_t diagnostic_count;
  const ig_importer* const* importers; /* since 1.7, as importer_count */
  uint32_t importer_count, reserved;
} ig_plugin;

typedef const ig_plugin* (*ig_plugin_fn)(void);
IG_EXPORT const ig_plugin* ig_plugin_v1(void);

/* ---- While a chain is created ------------------------------------------------------------------------------- */

struct ig_link_api {
  uint32_t struct_size;
  uint32_t host_minor;
  ig_symbol (*symbol)(ig_link*, ig_text name);
  double (*option_number)(ig_link*, uint32_t option);
  int64_t (*option_integer)(ig_link*, uint32_t option); /* IG_OPTION_CHOICE: index of the choice */
  ig_text (*option_text)(ig_link*, uint32_t option);
  /* The fields that a pattern declaration stands for, in the order of the document. Alive as long as the chain, as
   * the texts of field_path and field_unit are. */
  uint32_t (*expand)(ig_link*, uint32_t declaration, const ig_field** ids);
  ig_text (*field_path)(ig_link*, ig_field);
  ig_text (*field_unit)(ig_link*, ig_field);
  /* A service of the nearest dependency that provides it; NULL when there is none. */
  const void* (*service)(ig_link*, const char* id);
  /* A setting of this run ("block-skip", "optional-stop", "program"); size 0 when it was not given. */
  ig_text (*setting)(ig_link*, const char* name);
  /* The table of the dependency that is being created; NULL for a syntax. */
  ig_table* (*table)(ig_link*);
  /* Rows and columns: 1, or 0 (a text: size 0) without such a cell or a value. set_value() adds the row. */
  int32_t (*value)(const ig_table*, ig_text row, uint32_t column, double* out);
  int32_t (*set_value)(ig_table*, ig_text row, uint32_t column, double value);
  ig_text (*text_value)(const ig_table*, ig_text row, uint32_t column);
  uint32_t (*row_count)(const ig_table*);
  ig_text (*row_name)(const ig_table*, uint32_t row);
  void (*fail)(ig_link*, ig_text reason); /* says why create() returns IG_FAILED */
  /* The syntax that is being created has nothing to do in this chain: its build() is not called. */
  void (*idle)(ig_link*);
  int32_t (*set_text_value)(ig_table*, ig_text row, uint32_t column, ig_text value); /* since 1.8: of a text column */
};

/* ---- While a block is built --------------------------------------------------------------------------------- */

enum { IG_WORD_WITHOUT_POINT = 1u << 0 };

/* A word or code found by scan(). Codes are numbered in the order in which they are given. */
typedef struct ig_word {
  ig_field field;
  uint16_t begin; /* byte columns in the block's text */
  uint16_t end;
  ig_value value;
  uint32_t flags;
  uint32_t reserved;
} ig_word;

typedef uint32_t ig_leftover_kind;
enum {
  IG_LEFT_WORD = 1,       /* a word that nobody took */
  IG_LEFT_CODE = 2,       /* a code that a linked syntax knows and that nobody answered */
  IG_LEFT_UNKNOWN = 3,    /* a code that no linked syntax knows */
  IG_LEFT_EXPRESSION = 4, /* a word whose value is not a number yet */
  IG_LEFT_STATEMENT = 5,  /* flow or macro text that is not executed */
  IG_LEFT_TEXT = 6        /* text that no scanner took */
};

typedef struct ig_leftover {
  ig_leftover_kind kind;
  ig_field field; /* IG_NO_FIELD where there is none */
  uint32_t begin;
  uint32_t end;
  ig_text name; /* field name ("X", "G84.Q"), code ("G123") or the text itself */
} ig_leftover;

typedef struct ig_argument {
  uint32_t is_text;
  uint32_t reserved;
  double number;
  ig_text text;
} ig_argument;

typedef uint32_t ig_flow;
enum {
  IG_FLOW_END = 1,       /* the program ends after this block */
  IG_FLOW_SPLIT = 2,     /* the block ends at `position`; what follows on the line is the next block */
  IG_FLOW_END_FILE = 3,  /* nothing after this block is program */
  IG_FLOW_SKIP_REST = 4, /* no scanner is asked from `position` on */
  IG_FLOW_ALARM = 5      /* the control would stop here; the run goes on or stops by --on-error */
};

typedef uint32_t ig_direction;
enum { IG_TO_MACHINE = 1, IG_TO_PROGRAM = 2 };

struct ig_host {
  uint32_t struct_size;
  uint32_t flags; /* IG_HOST_SHOWS_BLOCKS, see isogloss_view.h */

  /* Values. get: 1 when the field has a value (a word that was taken has none; a code that was taken has).
   * get_many, take_many: a bit for each of at most 32 fields. set: value, fresh, writer. amend: value and writer, not
   * fresh, wakes nobody. take: get, and the word is gone; 0 when it was not there. */
  int32_t (*get)(const ig_block*, ig_field, ig_value* out);
  uint32_t (*get_many)(const ig_block*, const ig_field*, uint32_t count, ig_value* out);
  int32_t (*take)(ig_block*, ig_field, ig_value* out);
  uint32_t (*take_many)(ig_block*, const ig_field*, uint32_t count, ig_value* out);
  void (*set)(ig_block*, ig_field, ig_value);
  void (*set_many)(ig_block*, const ig_field*, uint32_t count, const ig_value*);
  void (*amend_many)(ig_block*, const ig_field*, uint32_t count, const ig_value*);
  void (*erase)(ig_block*, ig_field);
  int32_t (*is_fresh)(const ig_block*, ig_field);

  /* Codes: the index of the last one in the block of these that it holds, or -1; all that it holds are taken.
   * *found: how many it holds. */
  int32_t (*take_code)(ig_block*, const ig_field*, uint32_t count, uint32_t* found);
  int32_t (*find_code)(const ig_block*, const ig_field*, uint32_t count, uint32_t* found);

  /* Text fields, and the text of the block. */
  ig_text (*text)(const ig_block*, ig_field);
  void (*set_text)(ig_block*, ig_field, ig_text);
  ig_text (*source)(const ig_block*);

  /* Scanners. rewrite: another value for a word in its place: columns, life and mark stay, IG_WORD_WITHOUT_POINT goes.
   * move: a word to another field, with columns and mark. word: where it stands; 0 when it has no place. */
  void (*set_words)(ig_block*, const ig_word*, uint32_t count);
  void (*rewrite)(ig_block*, ig_field, ig_value);
  void (*move)(ig_block*, ig_field from, ig_field to);
  int32_t (*word)(const ig_block*, ig_field, ig_word* out);
  void (*add_leftover)(ig_block*, const ig_leftover*);
  /* Inspection: leftover number `index`, from 0; 0 when there are no more. */
  int32_t (*leftover)(const ig_block*, uint32_t index, ig_leftover* out);

  /* Frames. Entries compose in chain order; unset ones are identity. map_point: 1, or 0 when it cannot be inverted.
   * frame_changed: 1 when an entry was set to another value in this block. */
  void (*set_transform)(ig_block*, ig_field, const double matrix[16]);
  void (*set_translation)(ig_block*, ig_field, const double offset[3]);
  int32_t (*transform)(const ig_block*, ig_field, double matrix[16]);
  int32_t (*map_point)(ig_block*, ig_direction, const double in[3], double out[3]);
  int32_t (*frame_changed)(const ig_block*);

  /* Lists. Fields of one list's records. append: a new record with these values. */
  int32_t (*append)(ig_block*, const ig_field*, uint32_t count, const ig_value*);
  uint32_t (*count)(const ig_block*, ig_field any_field_of_list);
  uint32_t (*record)(const ig_block*, uint32_t index, const ig_field*, uint32_t count, ig_value* out);
  void (*set_record)(ig_block*, uint32_t index, const ig_field*, uint32_t count, const ig_value*);
  /* For each record that has the three fields `program` and lacks `machine`: machine = program in the frame. */
  void (*map_records)(ig_block*, const ig_field program[3], const ig_field machine[3]);

  ig_symbol (*symbol)(ig_block*, ig_text name);
  ig_text (*symbol_text)(const ig_block*, ig_symbol);
  /* diagnostic: index in the plugin's table. field: the word it points at, or IG_NO_FIELD for columns begin..end of
   * the text; begin == end: the whole block. */
  void (*report)(ig_block*, uint32_t diagnostic, ig_field field, uint32_t begin, uint32_t end, const ig_argument*,
                 uint32_t count);
  void (*fault)(ig_block*, ig_text message); /* what a trampoline calls when build() threw */
  void (*flow)(ig_block*, ig_flow, size_t position);
  /* Post-logic: the k-th executed block after this one, 1 <= k <= look_ahead; NULL past the end of the program. */
  ig_block* (*ahead)(ig_block*, uint32_t k);
  uint32_t (*fresh_many)(const ig_block*, const ig_field* fields, uint32_t count); /* a bit for each; count <= 32 */

  /* An entry of the frame that moves with the axes during the block (Kind Dynamic), as it is at the block's end. The
   * tool tip moves along: frame_changed() stays as it was. */
  void (*set_moving_transform)(ig_block*, ig_field, const double matrix[16]);

  /* get_many, take_many, set_many and fresh_many for three numbers side by side: the fields x, x + 1 and x + 2, as X Y
   * Z of one section mostly are. What has no value is 0 in out. */
  uint32_t (*get_point)(const ig_block*, ig_field x, double out[3]);
  uint32_t (*take_point)(ig_block*, ig_field x, double out[3]);
  void (*set_point)(ig_block*, ig_field x, const double point[3]);
  uint32_t (*fresh_point)(const ig_block*, ig_field x);
  int32_t (*in_turn)(ig_block*); /* see isogloss_scan.h; since 1.8 */
  uint32_t (*append_many)(ig_block*, const ig_field*, uint32_t count, uint32_t records, const uint32_t* masks,
                          const ig_value*); /* see conventions.md, "Records"; since 1.8 */
};

/* ---- Standard services -------------------------------------------------------------------------------------- */

/* isogloss.work-offset/1: id "G54", "G54.1P12", "EXT" ...; lengths in mm; 1, or 0 when the table has no such set. */
typedef struct ig_work_offset_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  int32_t (*get)(void* self, ig_text id, double offset[3]);
  int32_t (*set)(void* self, ig_text id, const double offset[3]);
  /* The same of A, B and C, in degrees. */
  int32_t (*get_rotary)(void* self, ig_text id, double offset[3]);
  int32_t (*set_rotary)(void* self, ig_text id, const double offset[3]);
} ig_work_offset_1;

/* isogloss.tool-offset/1: column 0 length geometry (H), 1 length wear, 2 radius geometry (D), 3 radius wear; mm. */
typedef struct ig_tool_offset_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  int32_t (*get)(void* self, int64_t id, uint32_t column, double* mm);
  int32_t (*set)(void* self, int64_t id, uint32_t column, double mm);
} ig_tool_offset_1;

/* isogloss.machine-axis/1: name 'X' 'Y' 'Z' 'A' 'B' 'C'; mm and degrees in machine coordinates, mm/s and deg/s.
 * Each returns 1, or 0 when the machine has no such axis or the value is not known. which: 1 first reference point. */
typedef struct ig_machine_axis_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  int32_t (*home)(void* self, char axis, double* position);
  int32_t (*reference)(void* self, char axis, uint32_t which, double* position);
  int32_t (*travel)(void* self, char axis, double* minimum, double* maximum);
  int32_t (*rapid_rate)(void* self, char axis, double* per_second);
  /* How a rotary axis goes to a position: 0 it counts on beyond 360; 1 the shortest way to that position of the circle;
   * 2 to the position that the value without its sign names, in the direction of the sign. */
  int32_t (*rollover)(void* self, char axis, uint32_t* mode);
} ig_machine_axis_1;

/* isogloss.machine-kinematics/1: the rotary axes of the machine. angles: of A, B and C in degrees as the machine counts
 * them; those of axes that it has not are not looked at. Points and lengths in mm, machine coordinates with all rotary
 * axes at zero. A function returns 0 where there is no answer. */
typedef struct ig_rotary_solution {
  double angles[3]; /* -180 < angle <= 180; limits of the axes are not looked at */
  uint32_t free;    /* a bit for each of A, B, C that the direction leaves undetermined: it has its present angle */
  uint32_t reserved;
} ig_rotary_solution;

typedef struct ig_machine_kinematics_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  /* How many rotary axes there are, 1 or 2, and their names: the one nearer the machine's base first. */
  uint32_t (*axes)(void* self, char names[2]);
  /* The unit vector from the tip of the tool to its holder, as the workpiece sees it. */
  int32_t (*tool_axis)(void* self, const double angles[3], double direction[3]);
  /* The entry PivotTransform of the frame: from the point p + L t, tip p and tool length L along the tool axis t, to X
   * Y Z of the machine. Identity where all angles are 0. */
  int32_t (*pivot)(void* self, const double angles[3], double matrix[16]);
  /* The 0, 1 or 2 pairs of angles that give the tool this direction, whatever its length is. */
  uint32_t (*solve)(void* self, const double direction[3], const double present[3], ig_rotary_solution out[2]);
  /* What the feed of the tip becomes on the axes: the speeds of X, Y and Z of the machine while the tip, at the point
   * `tip` of the workpiece with a tool of `length` along its axis, goes at `tip_speed` in the workpiece and the rotary
   * axes, at `angles`, turn at `turning` (degrees a second). */
  int32_t (*axis_speeds)(void* self, const double angles[3], const double turning[3], const double tip[3],
                         double length, const double tip_speed[3], double speeds[3]);
} ig_machine_kinematics_1;

/* Answers one number by name: isogloss.canned-cycle/1 (PeckRetractionDistance_mm, HighSpeedPeckRetraction_mm,
 * BoringReturnOverride_percent, ShiftDirectionX and so for Y and Z, RigidTapping, TappingSpindleStop, PeckTappingToR,
 * PeckTappingRetraction_mm, TappingExtractionOverride_percent), isogloss.coordinate-system/1 (RotationAngle_deg,
 * RotationIsIncremental, ResetCancelsLocalCoordinate), isogloss.number-format/1 (CalculatorDecimalPoint, StartsInInch,
 * LengthIncrement_mm and _inch, AngleIncrement_deg; of F without a point FeedIncrement_mm and _inch,
 * RevolutionFeedIncrement_mm and _inch, InverseTimeIncrement), isogloss.motion/1 (ArcRadiusTolerance_mm, ScalingUnit,
 * ScalingFactor, UnidirectionalOverrunX_mm and so for Y and Z). 1, or 0 when it has no answer. */
typedef struct ig_config_1 {
  uint32_t struct_size;
  uint32_t reserved;
  void* self;
  int32_t (*number)(void* self, ig_text name, double* out);
} ig_config_1;

#ifdef __cplusplus
}
#endif
#endif
