/* A canned cycle in C11: what isogloss/cnc/canned_cycle.hpp is for C++. CannedCycleResolveSyntax, which a dialect must
 * have before the cycle, finds the code by its kind and resolves modality, G91, G98 and G99, repeats, planes and
 * inches.
 *
 *   static const ig_field_decl fields[] = {IG_CYCLE_FIELDS("G181")};              own fields follow, from
 *                                                                                IG_CYCLE_FIELD_COUNT on
 *   static const ig_diagnostic_decl diagnostics[] = {IG_CYCLE_DIAGNOSTICS, ...};  of the plugin; own rows follow, from
 *                                                                                IG_CYCLE_DIAGNOSTIC_COUNT on
 *   create()   ig_cycle_create()
 *   build()    ig_cycle_take(); the steps of each hole by ig_cycle_rapid_to(), ig_cycle_feed_to() and ig_cycle_dwell();
 *              ig_cycle_end()
 *
 * Points and levels in mm of program coordinates, feeds in mm/s, dwells in seconds. The plugin links with libm. */
#ifndef ISOGLOSS_C_CANNED_CYCLE_H
#define ISOGLOSS_C_CANNED_CYCLE_H

#include <isogloss.h>

#include <math.h>
#include <string.h>

/* ---- What the descriptors hold ------------------------------------------------------------------------------ */

/* The words that the code owns, in the order of their fields. */
enum {
  IG_CYCLE_X,
  IG_CYCLE_Y,
  IG_CYCLE_Z,
  IG_CYCLE_R,
  IG_CYCLE_Q,
  IG_CYCLE_P,
  IG_CYCLE_I,
  IG_CYCLE_J,
  IG_CYCLE_K,
  IG_CYCLE_L,
  IG_CYCLE_F,
  IG_CYCLE_WORD_COUNT
};

/* The fields of IG_CYCLE_FIELDS. Three in a row are X, Y and Z; `kept` are P Q I J K. */
enum {
  IG_CYCLE_CODE,
  IG_CYCLE_WORDS,
  IG_CYCLE_INCREMENT = IG_CYCLE_WORDS + IG_CYCLE_WORD_COUNT,
  IG_CYCLE_KEPT = IG_CYCLE_INCREMENT + 3,
  IG_CYCLE_RETURN_MODE = IG_CYCLE_KEPT + 5,
  IG_CYCLE_INITIAL_LEVEL,
  IG_CYCLE_PROGRAM,
  IG_CYCLE_FEED = IG_CYCLE_PROGRAM + 3,
  IG_CYCLE_FEED_TERM,
  IG_CYCLE_FEED_UNIT,
  IG_CYCLE_ENDED_UNIT,
  IG_CYCLE_SPINDLE_SPEED,
  IG_CYCLE_PLANE,
  IG_CYCLE_TURN,
  IG_CYCLE_POLE,
  IG_CYCLE_PATTERN_TURN = IG_CYCLE_POLE + 3,
  IG_CYCLE_PATTERN_CENTER,
  IG_CYCLE_SCALING_CENTER = IG_CYCLE_PATTERN_CENTER + 3,
  IG_CYCLE_SCALING_FACTOR = IG_CYCLE_SCALING_CENTER + 3,
  IG_CYCLE_MIRROR = IG_CYCLE_SCALING_FACTOR + 3,
  IG_CYCLE_LAST_PROGRAM = IG_CYCLE_MIRROR + 3,
  IG_CYCLE_LAST_MACHINE = IG_CYCLE_LAST_PROGRAM + 3,
  IG_CYCLE_PIVOT_START = IG_CYCLE_LAST_MACHINE + 3,
  IG_CYCLE_TERM = IG_CYCLE_PIVOT_START + 3,
  IG_CYCLE_ITEM_POINT,
  IG_CYCLE_ITEM_FORM = IG_CYCLE_ITEM_POINT + 3,
  IG_CYCLE_ITEM_IS_RAPID,
  IG_CYCLE_ITEM_FEED,
  IG_CYCLE_ITEM_DWELL,
  IG_CYCLE_FIELD_COUNT
};

#define IG_CYCLE_ROW(access_, type_, life_, path_, unit_, doc_)                                                   \
  {                                                                                                               \
    .struct_size = sizeof(ig_field_decl), .access = (access_), .type = (type_), .life = (life_), .path = (path_), \
    .unit = (unit_), .doc = (doc_)                                                                                \
  }
#define IG_CYCLE_NUMBER(access_, path_) IG_CYCLE_ROW(access_, IG_NUMBER, IG_LIFE_STANDARD, path_, "", "")
#define IG_CYCLE_NAME(access_, path_) IG_CYCLE_ROW(access_, IG_SYMBOL, IG_LIFE_STANDARD, path_, "", "")
#define IG_CYCLE_POINT(access_, section_)                                           \
  IG_CYCLE_NUMBER(access_, section_ ".X"), IG_CYCLE_NUMBER(access_, section_ ".Y"), \
      IG_CYCLE_NUMBER(access_, section_ ".Z")
#define IG_CYCLE_OWN_POINT(section_, doc_)                                        \
  IG_CYCLE_ROW(IG_READ, IG_NUMBER, IG_LIFE_BLOCK, section_ ".X", "mm", doc_),     \
      IG_CYCLE_ROW(IG_READ, IG_NUMBER, IG_LIFE_BLOCK, section_ ".Y", "mm", doc_), \
      IG_CYCLE_ROW(IG_READ, IG_NUMBER, IG_LIFE_BLOCK, section_ ".Z", "mm", doc_)
#define IG_CYCLE_WORD(code_, letter_, unit_) \
  IG_CYCLE_ROW(IG_TAKE, IG_NUMBER, IG_LIFE_WORD, "Parsing." code_ "." letter_, unit_, "")

/* The first IG_CYCLE_FIELD_COUNT fields of a cycle's syntax; code: a string literal, "G181". */
#define IG_CYCLE_FIELDS(code_)                                                                                    \
  IG_CYCLE_ROW(IG_TAKE | IG_WAKE, IG_CODE, IG_LIFE_STANDARD, "Parsing." code_, "canned-cycle", ""),               \
      IG_CYCLE_WORD(code_, "X", "mm"), IG_CYCLE_WORD(code_, "Y", "mm"), IG_CYCLE_WORD(code_, "Z", "mm"),          \
      IG_CYCLE_WORD(code_, "R", "mm"), IG_CYCLE_WORD(code_, "Q", "mm"), IG_CYCLE_WORD(code_, "P", ""),            \
      IG_CYCLE_WORD(code_, "I", "mm"), IG_CYCLE_WORD(code_, "J", "mm"), IG_CYCLE_WORD(code_, "K", "1"),           \
      IG_CYCLE_WORD(code_, "L", "1"), IG_CYCLE_WORD(code_, "F", "mm/min"),                                        \
      IG_CYCLE_OWN_POINT("CannedCycle.Increment", "From hole to hole of a repeat."),                              \
      IG_CYCLE_NUMBER(IG_READ, "CannedCycle.Params.P"), IG_CYCLE_NUMBER(IG_READ, "CannedCycle.Params.Q"),         \
      IG_CYCLE_NUMBER(IG_READ, "CannedCycle.Params.I"), IG_CYCLE_NUMBER(IG_READ, "CannedCycle.Params.J"),         \
      IG_CYCLE_NUMBER(IG_READ, "CannedCycle.Params.K"), IG_CYCLE_NAME(IG_READ, "CannedCycle.ReturnMode"),         \
      IG_CYCLE_NUMBER(IG_READ, "CannedCycle.InitialLevel"), IG_CYCLE_POINT(IG_WRITE, "ProgramXyz"),               \
      IG_CYCLE_NUMBER(IG_READ | IG_WRITE, "Feedrate.FeedrateValue"),                                              \
      IG_CYCLE_NAME(IG_READ | IG_WRITE, "Feedrate.Term"), IG_CYCLE_NAME(IG_READ | IG_WRITE, "Feedrate.Unit"),     \
      IG_CYCLE_ROW(IG_READ | IG_WRITE, IG_SYMBOL, IG_LIFE_MODAL, "Feedrate.EndedUnit", "",                        \
                   "What the feed counted that G94 or G95 ended; gone with the next F."),                         \
      IG_CYCLE_NUMBER(IG_READ, "SpindleSpeed.SpindleSpeed_rpm"), IG_CYCLE_NAME(IG_READ, "PlaneSelect.Term"),      \
      IG_CYCLE_NUMBER(IG_READ, "PolarCoordinate.Turn_deg"), IG_CYCLE_POINT(IG_READ, "PolarCoordinate.Pole"),      \
      IG_CYCLE_NUMBER(IG_READ, "HolePattern.Turn_deg"), IG_CYCLE_POINT(IG_READ, "HolePattern.Center"),            \
      IG_CYCLE_POINT(IG_READ, "Scaling.Center"), IG_CYCLE_POINT(IG_READ, "Scaling.Factor"),                       \
      IG_CYCLE_POINT(IG_READ, "MirrorImage"), IG_CYCLE_POINT(IG_PREVIOUS, "ProgramXyz"),                          \
      IG_CYCLE_POINT(IG_PREVIOUS, "MachineCoordinate"),                                                           \
      IG_CYCLE_OWN_POINT("PivotTransform.Start",                                                                  \
                         "Where the block begins, in its own frame, rotary axes at the start."),                  \
      IG_CYCLE_NAME(IG_READ | IG_WRITE, "CompoundMotion.Term"),                                                   \
      IG_CYCLE_POINT(IG_WRITE, "CompoundMotion.Items[].ProgramXyz"),                                              \
      IG_CYCLE_NAME(IG_WRITE, "CompoundMotion.Items[].MotionEvent.Form"),                                         \
      IG_CYCLE_ROW(IG_WRITE, IG_BOOLEAN, IG_LIFE_STANDARD, "CompoundMotion.Items[].MotionEvent.IsRapid", "", ""), \
      IG_CYCLE_NUMBER(IG_WRITE, "CompoundMotion.Items[].MotionEvent.Feedrate_mmds"),                              \
      IG_CYCLE_NUMBER(IG_WRITE, "CompoundMotion.Items[].Dwell.Time")

/* The option that says what P counts; ig_cycle_seconds() gets its value, an ig_link_api.option_integer. */
#define IG_CYCLE_OPTION_P_UNIT                                                                          \
  {                                                                                                     \
    .struct_size = sizeof(ig_option_decl), .type = IG_OPTION_CHOICE, .name = "p-unit", .fallback = "s", \
    .choices = "s|ms", .minimum = -HUGE_VAL, .maximum = HUGE_VAL, .unit = "", .doc = "What P counts."   \
  }

/* The rows of IG_CYCLE_DIAGNOSTICS, which stand first in the plugin's table. Other plugins declare the same texts. */
enum {
  IG_CYCLE_FEED_NOT_POSITIVE,
  IG_CYCLE_FEED_ENDED,
  IG_CYCLE_NO_FEED,
  IG_CYCLE_NO_SPINDLE_SPEED,
  IG_CYCLE_NEGATIVE_DWELL,
  IG_CYCLE_NO_EFFECT,
  IG_CYCLE_DIAGNOSTIC_COUNT
};

#define IG_CYCLE_DIAGNOSTIC(severity_, code_, text_, explanation_, example_)                              \
  {                                                                                                       \
    .struct_size = sizeof(ig_diagnostic_decl), .severity = (severity_), .code = (code_), .text = (text_), \
    .explanation = (explanation_), .example = (example_)                                                  \
  }
#define IG_CYCLE_DIAGNOSTICS                                                                                           \
  IG_CYCLE_DIAGNOSTIC(                                                                                                 \
      IG_ERROR, "ISO-0210", "F{0} is not greater than zero: the previous feed rate stays in force",                    \
      "A control stops at the next feed move after F0 or a negative F. This word does not change the feed rate here.", \
      "G01 X10. F0"),                                                                                                  \
      IG_CYCLE_DIAGNOSTIC(                                                                                             \
          IG_ERROR, "ISO-0211", "feed move without a feed rate: {0} ended the feed rate in {1}, so program F again",   \
          "F200 is 200 mm/min under G94 and 200 mm/rev under G95. With the option mode-change=\"require-f\", "         \
          "a change of the mode ends the old feed rate: program F together with the new mode, or before the "          \
          "first feed move. The move is kept, without a feed rate.",                                                   \
          "G95 (F100 before), then G01 X10."),                                                                         \
      IG_CYCLE_DIAGNOSTIC(                                                                                             \
          IG_ERROR, "ISO-0302", "feed move without a feed rate: program F in this block or before it",                 \
          "The control stops with an alarm. The move is kept without a feed rate, so cycle times are wrong. "          \
          "Under G93 every feed move needs an F of its own.",                                                          \
          "G01 X10. (no F so far)"),                                                                                   \
      IG_CYCLE_DIAGNOSTIC(                                                                                             \
          IG_ERROR, "ISO-0303",                                                                                        \
          "feed per revolution without a spindle speed: the axes would stand still, so program S first",               \
          "Under G95 the feed rate is F times the spindle speed.", "G95 G01 X10. F0.1 (no S so far)"),                 \
      IG_CYCLE_DIAGNOSTIC(IG_ERROR, "ISO-0337",                                                                        \
                          "{0} with P{1}: a dwell cannot be negative, so the cycle does not dwell",                    \
                          "P is the time that the tool dwells at the bottom of the hole: seconds, or milliseconds on " \
                          "a Fanuc control.",                                                                          \
                          "G82 X10. Y10. Z-20. R2. P-500 F100"),                                                       \
      IG_CYCLE_DIAGNOSTIC(                                                                                             \
          IG_WARNING, "ISO-0354", "{0}: {1}{2} has no effect in this cycle",                                           \
          "The control accepts the word without an alarm and keeps it for a later cycle of the same run of "           \
          "holes. In this cycle the word does nothing: a Fanuc control does not dwell in G73, G81, G83, G85 "          \
          "and G86, whatever P is. It does dwell in G82 and G89.",                                                     \
          "G83 X10. Y10. Z-20. R2. Q5. P500 F100")

/* ---- A cycle of a chain ------------------------------------------------------------------------------------- */

/* What a syntax keeps for each chain; ids of another chain mean nothing. */
typedef struct ig_cycle {
  ig_field ids[IG_CYCLE_FIELD_COUNT];
  ig_symbol code, g18, g19, g93, g94, g95, g99, linear, mm_per_minute;
} ig_cycle;

/* A call, ready to be carried out. Axes are 0 X, 1 Y, 2 Z; `tool` is the axis along which the cycle works. */
typedef struct ig_cycle_run {
  uint32_t words; /* a bit for each word of the call, 1u << IG_CYCLE_P; K and L, the counts, are left out */
  ig_value values[IG_CYCLE_WORD_COUNT];
  int first_axis, second_axis, tool;
  double start[3]; /* where the tool is at the start of the block */
  double first[3]; /* the first hole */
  double increment[3];
  int count; /* of holes, from 1 to 10000 */
  double r_level, bottom;
  double return_level;  /* G98: the initial level; G99: R */
  int32_t is_turned;    /* the holes of a repeat turn about `pole`, each `turn` degrees further */
  double turn, pole[3]; /* of the program before scaling and mirror image */
  double factor[3], offset[3];
} ig_cycle_run;

/* One hole. The component of `position` along the tool axis is not used. */
typedef struct ig_cycle_hole {
  int tool;
  double position[3];
  double approach_level; /* where the tool travels to the hole */
} ig_cycle_hole;

static inline ig_text ig_cycle_text(const char* text) { return (ig_text){text, strlen(text)}; }

/* In create(); code is that of IG_CYCLE_FIELDS, ids are those of the syntax. */
static inline void ig_cycle_create(ig_cycle* cycle, const ig_link_api* api, ig_link* link, const ig_field* ids,
                                   const char* code) {
  memcpy(cycle->ids, ids, sizeof cycle->ids);
  cycle->code = api->symbol(link, ig_cycle_text(code));
  cycle->g18 = api->symbol(link, ig_cycle_text("G18"));
  cycle->g19 = api->symbol(link, ig_cycle_text("G19"));
  cycle->g93 = api->symbol(link, ig_cycle_text("G93"));
  cycle->g94 = api->symbol(link, ig_cycle_text("G94"));
  cycle->g95 = api->symbol(link, ig_cycle_text("G95"));
  cycle->g99 = api->symbol(link, ig_cycle_text("G99"));
  cycle->linear = api->symbol(link, ig_cycle_text("McLinear"));
  cycle->mm_per_minute = api->symbol(link, ig_cycle_text("mm/min"));
}

/* 1 where the symbol field has this value. */
static inline int ig_cycle_is(const ig_cycle* cycle, const ig_host* host, const ig_block* block, int field,
                              ig_symbol symbol) {
  ig_value value;
  return host->get(block, cycle->ids[field], &value) != 0 && value.symbol == symbol;
}

/* Three numbers side by side; a bit for each that has a value, the others are 0. */
static inline uint32_t ig_cycle_point(const ig_cycle* cycle, const ig_host* host, const ig_block* block, int field,
                                      double out[3]) {
  ig_value values[3];
  const uint32_t mask = host->get_many(block, cycle->ids + field, 3, values);
  for (int i = 0; i < 3; ++i) out[i] = (mask >> i & 1u) != 0 ? values[i].number : 0;
  return mask;
}

/* To 1e-9 mm: smaller digits are noise of an inverted frame. */
static inline double ig_cycle_rounded(double mm) {
  const double no_fraction = 0x1.8p52; /* adding it rounds to a whole number */
  if (!(fabs(mm) < 2e6)) return mm;
  return ((mm * 1e9 + no_fraction) - no_fraction) / 1e9 + 0.0;
}

/* The word of the call, or `fallback`. */
static inline double ig_cycle_word(const ig_cycle_run* run, int word, double fallback) {
  return (run->words >> word & 1u) != 0 ? run->values[word].number : fallback;
}

/* Where the block begins: where the frame changed while the axes rest, the machine point seen in the new frame. */
static inline void ig_cycle_start(const ig_cycle* cycle, const ig_host* host, ig_block* block, double out[3]) {
  double machine[3];
  if (host->frame_changed(block) != 0) {
    if (ig_cycle_point(cycle, host, block, IG_CYCLE_PIVOT_START, out) == 7) return;
    if (ig_cycle_point(cycle, host, block, IG_CYCLE_LAST_MACHINE, machine) == 7 &&
        host->map_point(block, IG_TO_PROGRAM, machine, out) != 0) {
      for (int i = 0; i < 3; ++i) out[i] = ig_cycle_rounded(out[i]);
      return;
    }
  }
  ig_cycle_point(cycle, host, block, IG_CYCLE_LAST_PROGRAM, out);
}

/* The axes of the plane in force, so that first x second = tool. */
static inline void ig_cycle_plane(const ig_cycle* cycle, const ig_host* host, const ig_block* block,
                                  ig_cycle_run* run) {
  const int is_zx = ig_cycle_is(cycle, host, block, IG_CYCLE_PLANE, cycle->g18);
  const int is_yz = ig_cycle_is(cycle, host, block, IG_CYCLE_PLANE, cycle->g19);
  run->first_axis = is_zx ? 2 : is_yz ? 1 : 0;
  run->second_axis = (run->first_axis + 1) % 3;
  run->tool = (run->first_axis + 2) % 3;
}

/* How the holes of a repeat turn: in a pattern as they are, under G16 before scaling and mirror image. */
static inline void ig_cycle_turns(const ig_cycle* cycle, const ig_host* host, const ig_block* block,
                                  ig_cycle_run* run) {
  ig_value turn;
  const int is_pattern = host->get(block, cycle->ids[IG_CYCLE_PATTERN_TURN], &turn) != 0;
  run->is_turned = is_pattern || host->get(block, cycle->ids[IG_CYCLE_TURN], &turn) != 0;
  if (run->is_turned == 0) return;
  run->turn = turn.number;
  ig_cycle_point(cycle, host, block, is_pattern ? IG_CYCLE_PATTERN_CENTER : IG_CYCLE_POLE, run->pole);
  double center[3], factor[3], mirror[3];
  ig_cycle_point(cycle, host, block, IG_CYCLE_SCALING_CENTER, center);
  ig_cycle_point(cycle, host, block, IG_CYCLE_SCALING_FACTOR, factor);
  const uint32_t mirrored = ig_cycle_point(cycle, host, block, IG_CYCLE_MIRROR, mirror);
  for (int i = 0; i < 3; ++i) {
    const int is_scaled = !is_pattern && factor[i] != 0;
    run->factor[i] = is_scaled ? factor[i] : 1;
    run->offset[i] = is_scaled ? (1 - factor[i]) * center[i] : 0;
    if (is_pattern || (mirrored >> i & 1u) == 0) continue;
    run->factor[i] = -run->factor[i];
    run->offset[i] = 2 * mirror[i] - run->offset[i];
  }
}

/* Puts the F of the call in force; ISO-0210 where it is not positive. */
static inline void ig_cycle_take_feed(const ig_cycle* cycle, const ig_host* host, ig_block* block,
                                      const ig_cycle_run* run) {
  if ((run->words >> IG_CYCLE_F & 1u) == 0) return;
  const ig_value f = run->values[IG_CYCLE_F];
  if (f.number <= 0) {
    const ig_argument argument = {.number = f.number};
    host->report(block, IG_CYCLE_FEED_NOT_POSITIVE, cycle->ids[IG_CYCLE_WORDS + IG_CYCLE_F], 0, 0, &argument, 1);
    return;
  }
  ig_value term;
  host->set(block, cycle->ids[IG_CYCLE_FEED], f);
  if (host->get(block, cycle->ids[IG_CYCLE_ENDED_UNIT], &term) != 0)
    host->erase(block, cycle->ids[IG_CYCLE_ENDED_UNIT]);
  if (host->get(block, cycle->ids[IG_CYCLE_FEED_TERM], &term) != 0) return;
  host->set(block, cycle->ids[IG_CYCLE_FEED_TERM], (ig_value){.symbol = cycle->g94});
  host->set(block, cycle->ids[IG_CYCLE_FEED_UNIT], (ig_value){.symbol = cycle->mm_per_minute});
}

/* The code of the cycle as the text of a diagnostic. */
static inline ig_argument ig_cycle_argument(const ig_cycle* cycle, const ig_host* host, const ig_block* block) {
  return (ig_argument){.is_text = 1, .text = host->symbol_text(block, cycle->code)};
}

/* Takes the call of this block: 1, or 0 where the block does not hold the code. Reports a negative P (ISO-0337) and
 * drops it, and an F that is not positive. */
static inline int ig_cycle_take(const ig_cycle* cycle, const ig_host* host, ig_block* block, ig_cycle_run* run) {
  uint32_t found = 0;
  if (host->take_code(block, cycle->ids + IG_CYCLE_CODE, 1, &found) < 0) return 0;
  memset(run, 0, sizeof *run);
  run->words = host->take_many(block, cycle->ids + IG_CYCLE_WORDS, IG_CYCLE_WORD_COUNT, run->values);
  ig_cycle_plane(cycle, host, block, run);
  ig_cycle_start(cycle, host, block, run->start);
  for (int i = 0; i < 3; ++i) run->first[i] = ig_cycle_word(run, IG_CYCLE_X + i, run->start[i]);
  const int counter = (run->words >> IG_CYCLE_L & 1u) != 0 ? IG_CYCLE_L : IG_CYCLE_K;
  run->count = (int)fmin(fmax(ig_cycle_word(run, counter, 1), 1), 10000);
  run->words &= ~(1u << counter); /* a K that remains here is the Z component of a vector */
  if (run->count > 1) {
    ig_cycle_point(cycle, host, block, IG_CYCLE_INCREMENT, run->increment);
    ig_cycle_turns(cycle, host, block, run);
  }
  const double level = run->start[run->tool];
  ig_value initial = {.number = level};
  run->bottom = run->first[run->tool];
  run->r_level = ig_cycle_word(run, IG_CYCLE_R, level);
  if (host->get(block, cycle->ids[IG_CYCLE_INITIAL_LEVEL], &initial) == 0) initial.number = level;
  run->return_level = ig_cycle_is(cycle, host, block, IG_CYCLE_RETURN_MODE, cycle->g99) ? run->r_level : initial.number;
  ig_cycle_take_feed(cycle, host, block, run);
  if (ig_cycle_word(run, IG_CYCLE_P, 0) < 0) {
    const ig_argument arguments[] = {ig_cycle_argument(cycle, host, block),
                                     {.number = ig_cycle_word(run, IG_CYCLE_P, 0)}};
    host->report(block, IG_CYCLE_NEGATIVE_DWELL, cycle->ids[IG_CYCLE_WORDS + IG_CYCLE_P], 0, 0, arguments, 2);
    run->words &= ~(1u << IG_CYCLE_P);
  }
  host->set(block, cycle->ids[IG_CYCLE_TERM], (ig_value){.symbol = cycle->code});
  return 1;
}

/* P in seconds, 0 without P; unit is the value of IG_CYCLE_OPTION_P_UNIT. */
static inline double ig_cycle_seconds(const ig_cycle_run* run, int64_t unit) {
  const double p = ig_cycle_word(run, IG_CYCLE_P, 0);
  return unit == 1 ? p / 1000 : p;
}

/* The feed of a stroke of this length, in mm/s; 0, with a diagnostic, where no feed is in force. Under G93 a stroke
 * without length has feed 0 without a diagnostic. */
static inline double ig_cycle_stroke_feed(const ig_cycle* cycle, const ig_host* host, ig_block* block, double length) {
  const int per_revolution = ig_cycle_is(cycle, host, block, IG_CYCLE_FEED_TERM, cycle->g95);
  const int inverse_time = ig_cycle_is(cycle, host, block, IG_CYCLE_FEED_TERM, cycle->g93);
  ig_value feed, speed, term, unit;
  const int has_feed = host->get(block, cycle->ids[IG_CYCLE_FEED], &feed) != 0;
  if (host->get(block, cycle->ids[IG_CYCLE_SPINDLE_SPEED], &speed) == 0) speed.number = 0;
  const double factor = per_revolution ? speed.number : inverse_time ? length : 1;
  const double feed_mmds = has_feed ? feed.number * factor / 60 : 0;
  if (feed_mmds > 0 || (has_feed && inverse_time)) return feed_mmds;
  if (has_feed) {
    host->report(block, IG_CYCLE_NO_SPINDLE_SPEED, IG_NO_FIELD, 0, 0, NULL, 0);
  } else if (host->get(block, cycle->ids[IG_CYCLE_ENDED_UNIT], &unit) != 0) {
    if (host->get(block, cycle->ids[IG_CYCLE_FEED_TERM], &term) == 0) term.symbol = cycle->g94;
    const ig_argument arguments[] = {{.is_text = 1, .text = host->symbol_text(block, (ig_symbol)term.symbol)},
                                     {.is_text = 1, .text = host->symbol_text(block, (ig_symbol)unit.symbol)}};
    host->report(block, IG_CYCLE_FEED_ENDED, IG_NO_FIELD, 0, 0, arguments, 2);
  } else {
    host->report(block, IG_CYCLE_NO_FEED, IG_NO_FIELD, 0, 0, NULL, 0);
  }
  return feed_mmds;
}

/* Reports (ISO-0354) each of P, Q, I, J and K that this block programs, that is not 0 and that is not one of the
 * letters in `used`. */
static inline void ig_cycle_report_unused(const ig_cycle* cycle, const ig_host* host, ig_block* block,
                                          const ig_cycle_run* run, const char* used) {
  static const char letters[] = "PQIJK";
  static const int words[] = {IG_CYCLE_P, IG_CYCLE_Q, IG_CYCLE_I, IG_CYCLE_J, IG_CYCLE_K};
  for (int i = 0; i < 5; ++i) {
    const double value = ig_cycle_word(run, words[i], 0);
    if (value == 0 || strchr(used, letters[i]) != NULL) continue;
    if (host->is_fresh(block, cycle->ids[IG_CYCLE_KEPT + i]) == 0) continue;
    const ig_argument arguments[] = {
        ig_cycle_argument(cycle, host, block), {.is_text = 1, .text = {letters + i, 1}}, {.number = value}};
    host->report(block, IG_CYCLE_NO_EFFECT, cycle->ids[IG_CYCLE_WORDS + words[i]], 0, 0, arguments, 3);
  }
}

/* ---- The holes and their steps ------------------------------------------------------------------------------ */

/* Hole number i of the call, from 0. */
static inline ig_cycle_hole ig_cycle_hole_at(const ig_cycle_run* run, int i) {
  ig_cycle_hole hole = {.tool = run->tool, .approach_level = i == 0 ? run->start[run->tool] : run->return_level};
  if (run->is_turned == 0) {
    for (int axis = 0; axis < 3; ++axis) hole.position[axis] = run->first[axis] + i * run->increment[axis];
    return hole;
  }
  const int a = run->first_axis, b = run->second_axis;
  const double angle = remainder(i * run->turn, 360) * (3.14159265358979323846 / 180), c = cos(angle), s = sin(angle);
  const double u = (run->first[a] - run->offset[a]) / run->factor[a] - run->pole[a];
  const double v = (run->first[b] - run->offset[b]) / run->factor[b] - run->pole[b];
  memcpy(hole.position, run->first, sizeof hole.position);
  hole.position[a] = ig_cycle_rounded(run->factor[a] * (run->pole[a] + c * u - s * v) + run->offset[a]);
  hole.position[b] = ig_cycle_rounded(run->factor[b] * (run->pole[b] + s * u + c * v) + run->offset[b]);
  return hole;
}

/* The values of a step to the hole at this level of the tool axis. */
static inline void ig_cycle_values(const ig_cycle* cycle, const ig_cycle_hole* hole, double level, ig_value out[4]) {
  for (int axis = 0; axis < 3; ++axis) out[axis].number = axis == hole->tool ? level : hole->position[axis];
  out[3].symbol = cycle->linear;
}

static inline void ig_cycle_rapid_to(const ig_cycle* cycle, const ig_host* host, ig_block* block,
                                     const ig_cycle_hole* hole, double level) {
  ig_value values[5];
  ig_cycle_values(cycle, hole, level, values);
  values[4].integer = 1;
  host->append(block, cycle->ids + IG_CYCLE_ITEM_POINT, 5, values);
}

/* A feed of 0 leaves it out: none is in force, which ig_cycle_stroke_feed() has reported. */
static inline void ig_cycle_feed_to(const ig_cycle* cycle, const ig_host* host, ig_block* block,
                                    const ig_cycle_hole* hole, double level, double feed_mmds) {
  const ig_field* const own = cycle->ids + IG_CYCLE_ITEM_POINT;
  const ig_field fields[] = {own[0], own[1], own[2], own[3], cycle->ids[IG_CYCLE_ITEM_FEED]};
  ig_value values[5];
  ig_cycle_values(cycle, hole, level, values);
  values[4].number = feed_mmds;
  host->append(block, fields, feed_mmds > 0 ? 5 : 4, values);
}

static inline void ig_cycle_dwell(const ig_cycle* cycle, const ig_host* host, ig_block* block, double seconds) {
  const ig_value value = {.number = seconds};
  host->append(block, cycle->ids + IG_CYCLE_ITEM_DWELL, 1, &value);
}

/* Leaves the tool at the return level of the last hole. */
static inline void ig_cycle_end(const ig_cycle* cycle, const ig_host* host, ig_block* block, const ig_cycle_run* run) {
  const ig_cycle_hole last = ig_cycle_hole_at(run, run->count - 1);
  ig_value values[4];
  ig_cycle_values(cycle, &last, run->return_level, values);
  host->set_many(block, cycle->ids + IG_CYCLE_PROGRAM, 3, values);
}

#endif
