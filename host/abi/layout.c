/* The layout of isogloss.h on 64-bit machines (LP64: x86_64, aarch64), checked by compiling this file.
 *
 * Plugins that are in the field were built with these numbers: a line here is never changed. A member that is added at
 * the end of a struct gets a new line at its end; the structs without struct_size cannot grow. */
#include "isogloss.h"
#include "isogloss_axis.h"
#include "isogloss_flow.h"
#include "isogloss_import.h"
#include "isogloss_machine_code.h"
#include "isogloss_provenance.h"
#include "isogloss_scan.h"
#include "isogloss_tool.h"
#include "isogloss_view.h"

#define AT(type, member, offset) _Static_assert(offsetof(type, member) == (offset), #type "." #member " has moved")
#define FROZEN(type, size) _Static_assert(sizeof(type) == (size), #type " cannot change its size")
#define CONSTANT(name, value) _Static_assert((name) == (value), #name " has changed its value")
#define GROWS_FROM(type, size)                                                             \
  _Static_assert(sizeof(type) >= (size), #type " has become smaller than in version 1.0"); \
  _Static_assert(offsetof(type, struct_size) == 0, #type " does not begin with struct_size")

#if UINTPTR_MAX == 0xffffffffffffffffu

FROZEN(ig_value, 8);

FROZEN(ig_text, 16);
AT(ig_text, data, 0);
AT(ig_text, size, 8);

GROWS_FROM(ig_field_decl, 48);
AT(ig_field_decl, access, 4);
AT(ig_field_decl, type, 8);
AT(ig_field_decl, life, 12);
AT(ig_field_decl, path, 16);
AT(ig_field_decl, unit, 24);
AT(ig_field_decl, doc, 32);
AT(ig_field_decl, wake_value, 40);

GROWS_FROM(ig_option_decl, 64);
AT(ig_option_decl, type, 4);
AT(ig_option_decl, name, 8);
AT(ig_option_decl, fallback, 16);
AT(ig_option_decl, choices, 24);
AT(ig_option_decl, minimum, 32);
AT(ig_option_decl, maximum, 40);
AT(ig_option_decl, unit, 48);
AT(ig_option_decl, doc, 56);

GROWS_FROM(ig_service_decl, 24);
AT(ig_service_decl, is_optional, 4);
AT(ig_service_decl, id, 8);
AT(ig_service_decl, doc, 16);

GROWS_FROM(ig_diagnostic_decl, 40);
AT(ig_diagnostic_decl, severity, 4);
AT(ig_diagnostic_decl, code, 8);
AT(ig_diagnostic_decl, text, 16);
AT(ig_diagnostic_decl, explanation, 24);
AT(ig_diagnostic_decl, example, 32);

GROWS_FROM(ig_syntax, 152);
AT(ig_syntax, look_ahead, 4);
AT(ig_syntax, id, 8);
AT(ig_syntax, summary, 16);
AT(ig_syntax, page, 24);
AT(ig_syntax, fields, 32);
AT(ig_syntax, options, 40);
AT(ig_syntax, services, 48);
AT(ig_syntax, field_count, 56);
AT(ig_syntax, option_count, 60);
AT(ig_syntax, service_count, 64);
AT(ig_syntax, inspects, 68);
AT(ig_syntax, after, 72);
AT(ig_syntax, before, 80);
AT(ig_syntax, exclusive_slot, 88);
AT(ig_syntax, first_writer_slot, 96);
AT(ig_syntax, triggers, 104);
AT(ig_syntax, create, 112);
AT(ig_syntax, destroy, 120);
AT(ig_syntax, restart, 128);
AT(ig_syntax, scan, 136);
AT(ig_syntax, build, 144);
AT(ig_syntax, cases, 152);
AT(ig_syntax, folder, 160);
AT(ig_syntax, scan_flags, 168);
AT(ig_syntax, reserved, 172);

GROWS_FROM(ig_column_decl, 56);
AT(ig_column_decl, is_text, 4);
AT(ig_column_decl, name, 8);
AT(ig_column_decl, unit, 16);
AT(ig_column_decl, fallback, 24);
AT(ig_column_decl, minimum, 32);
AT(ig_column_decl, maximum, 40);
AT(ig_column_decl, doc, 48);

GROWS_FROM(ig_dependency, 112);
AT(ig_dependency, column_count, 4);
AT(ig_dependency, id, 8);
AT(ig_dependency, summary, 16);
AT(ig_dependency, page, 24);
AT(ig_dependency, row_element, 32);
AT(ig_dependency, row_key, 40);
AT(ig_dependency, columns, 48);
AT(ig_dependency, options, 56);
AT(ig_dependency, provides, 64);
AT(ig_dependency, option_count, 72);
AT(ig_dependency, default_row_count, 76);
AT(ig_dependency, default_rows, 80);
AT(ig_dependency, create, 88);
AT(ig_dependency, destroy, 96);
AT(ig_dependency, service, 104);
AT(ig_dependency, row_fault, 112);

GROWS_FROM(ig_plugin, 80);
AT(ig_plugin, abi_major, 4);
AT(ig_plugin, abi_minor, 8);
AT(ig_plugin, syntax_count, 12);
AT(ig_plugin, name, 16);
AT(ig_plugin, version, 24);
AT(ig_plugin, vendor, 32);
AT(ig_plugin, built_with, 40);
AT(ig_plugin, syntaxes, 48);
AT(ig_plugin, dependencies, 56);
AT(ig_plugin, diagnostics, 64);
AT(ig_plugin, dependency_count, 72);
AT(ig_plugin, diagnostic_count, 76);
AT(ig_plugin, importers, 80);
AT(ig_plugin, importer_count, 88);
AT(ig_plugin, reserved, 92);

GROWS_FROM(ig_link_api, 136);
AT(ig_link_api, host_minor, 4);
AT(ig_link_api, symbol, 8);
AT(ig_link_api, option_number, 16);
AT(ig_link_api, option_integer, 24);
AT(ig_link_api, option_text, 32);
AT(ig_link_api, expand, 40);
AT(ig_link_api, field_path, 48);
AT(ig_link_api, field_unit, 56);
AT(ig_link_api, service, 64);
AT(ig_link_api, setting, 72);
AT(ig_link_api, table, 80);
AT(ig_link_api, value, 88);
AT(ig_link_api, set_value, 96);
AT(ig_link_api, text_value, 104);
AT(ig_link_api, row_count, 112);
AT(ig_link_api, row_name, 120);
AT(ig_link_api, fail, 128);
AT(ig_link_api, idle, 136);
AT(ig_link_api, set_text_value, 144);

FROZEN(ig_word, 24);
AT(ig_word, field, 0);
AT(ig_word, begin, 4);
AT(ig_word, end, 6);
AT(ig_word, value, 8);
AT(ig_word, flags, 16);
AT(ig_word, reserved, 20);

FROZEN(ig_leftover, 32);
AT(ig_leftover, kind, 0);
AT(ig_leftover, field, 4);
AT(ig_leftover, begin, 8);
AT(ig_leftover, end, 12);
AT(ig_leftover, name, 16);

FROZEN(ig_argument, 32);
AT(ig_argument, is_text, 0);
AT(ig_argument, reserved, 4);
AT(ig_argument, number, 8);
AT(ig_argument, text, 16);

GROWS_FROM(ig_host, 296);
AT(ig_host, flags, 4);
AT(ig_host, get, 8);
AT(ig_host, get_many, 16);
AT(ig_host, take, 24);
AT(ig_host, take_many, 32);
AT(ig_host, set, 40);
AT(ig_host, set_many, 48);
AT(ig_host, amend_many, 56);
AT(ig_host, erase, 64);
AT(ig_host, is_fresh, 72);
AT(ig_host, take_code, 80);
AT(ig_host, find_code, 88);
AT(ig_host, text, 96);
AT(ig_host, set_text, 104);
AT(ig_host, source, 112);
AT(ig_host, set_words, 120);
AT(ig_host, rewrite, 128);
AT(ig_host, move, 136);
AT(ig_host, word, 144);
AT(ig_host, add_leftover, 152);
AT(ig_host, leftover, 160);
AT(ig_host, set_transform, 168);
AT(ig_host, set_translation, 176);
AT(ig_host, transform, 184);
AT(ig_host, map_point, 192);
AT(ig_host, frame_changed, 200);
AT(ig_host, append, 208);
AT(ig_host, count, 216);
AT(ig_host, record, 224);
AT(ig_host, set_record, 232);
AT(ig_host, map_records, 240);
AT(ig_host, symbol, 248);
AT(ig_host, symbol_text, 256);
AT(ig_host, report, 264);
AT(ig_host, fault, 272);
AT(ig_host, flow, 280);
AT(ig_host, ahead, 288);
AT(ig_host, fresh_many, 296);
AT(ig_host, set_moving_transform, 304);
AT(ig_host, get_point, 312);
AT(ig_host, take_point, 320);
AT(ig_host, set_point, 328);
AT(ig_host, fresh_point, 336);
AT(ig_host, in_turn, 344);
AT(ig_host, append_many, 352);

GROWS_FROM(ig_work_offset_1, 32);
AT(ig_work_offset_1, reserved, 4);
AT(ig_work_offset_1, self, 8);
AT(ig_work_offset_1, get, 16);
AT(ig_work_offset_1, set, 24);
AT(ig_work_offset_1, get_rotary, 32);
AT(ig_work_offset_1, set_rotary, 40);

GROWS_FROM(ig_tool_offset_1, 32);
AT(ig_tool_offset_1, reserved, 4);
AT(ig_tool_offset_1, self, 8);
AT(ig_tool_offset_1, get, 16);
AT(ig_tool_offset_1, set, 24);

GROWS_FROM(ig_machine_axis_1, 48);
AT(ig_machine_axis_1, reserved, 4);
AT(ig_machine_axis_1, self, 8);
AT(ig_machine_axis_1, home, 16);
AT(ig_machine_axis_1, reference, 24);
AT(ig_machine_axis_1, travel, 32);
AT(ig_machine_axis_1, rapid_rate, 40);

GROWS_FROM(ig_config_1, 24);
AT(ig_config_1, reserved, 4);
AT(ig_config_1, self, 8);
AT(ig_config_1, number, 16);

FROZEN(ig_place, 24);
AT(ig_place, frame, 0);
AT(ig_place, offset, 8);
AT(ig_place, line, 16);
AT(ig_place, column, 20);

GROWS_FROM(ig_frame, 72);
AT(ig_frame, depth, 4);
AT(ig_frame, id, 8);
AT(ig_frame, tag, 16);
AT(ig_frame, pass, 24);
AT(ig_frame, passes, 28);
AT(ig_frame, program, 32);
AT(ig_frame, file, 48);
AT(ig_frame, call_line, 64);
AT(ig_frame, reserved, 68);

GROWS_FROM(ig_go, 120);
AT(ig_go, kind, 4);
AT(ig_go, label, 8);
AT(ig_go, start, 24);
AT(ig_go, files, 40);
AT(ig_go, file_count, 48);
AT(ig_go, scope, 52);
AT(ig_go, repeats, 56);
AT(ig_go, search, 60);
AT(ig_go, flags, 64);
AT(ig_go, reserved, 68);
AT(ig_go, tag, 72);
AT(ig_go, place, 80);
AT(ig_go, reason, 104);

GROWS_FROM(ig_flow_1, 40);
AT(ig_flow_1, is_indexing, 4);
AT(ig_flow_1, label, 8);
AT(ig_flow_1, go, 16);
AT(ig_flow_1, frame, 24);
AT(ig_flow_1, here, 32);
AT(ig_flow_1, text, 40);

CONSTANT(IG_NO_FIELD, 0xffffffff);
CONSTANT(IG_ABI_MAJOR, 1);
CONSTANT(IG_NUMBER, 1);
CONSTANT(IG_INTEGER, 2);
CONSTANT(IG_BOOLEAN, 3);
CONSTANT(IG_SYMBOL, 4);
CONSTANT(IG_TEXT, 5);
CONSTANT(IG_CODE, 6);
CONSTANT(IG_TRANSFORM, 7);
CONSTANT(IG_SWITCH, 8);
CONSTANT(IG_LIFE_STANDARD, 0);
CONSTANT(IG_LIFE_WORD, 1);
CONSTANT(IG_LIFE_BLOCK, 2);
CONSTANT(IG_LIFE_MODAL, 3);
CONSTANT(IG_LIFE_FRAME, 4);
CONSTANT(IG_UNCHANGED, 0);
CONSTANT(IG_CHANGED, 1);
CONSTANT(IG_FAILED, -1);
CONSTANT(IG_READ, 1);
CONSTANT(IG_REQUIRED, 2);
CONSTANT(IG_WRITE, 4);
CONSTANT(IG_TAKE, 8);
CONSTANT(IG_PREVIOUS, 16);
CONSTANT(IG_WAKE, 32);
CONSTANT(IG_WAKE_WHILE, 64);
CONSTANT(IG_PATTERN, 128);
CONSTANT(IG_ENDS_AHEAD, 256);
CONSTANT(IG_OPTION_TEXT, 1);
CONSTANT(IG_OPTION_NUMBER, 2);
CONSTANT(IG_OPTION_INTEGER, 3);
CONSTANT(IG_OPTION_BOOLEAN, 4);
CONSTANT(IG_OPTION_CHOICE, 5);
CONSTANT(IG_OPTION_FIELDS, 6);
CONSTANT(IG_NOTE, 1);
CONSTANT(IG_WARNING, 2);
CONSTANT(IG_ERROR, 3);
CONSTANT(IG_WORD_WITHOUT_POINT, 1);
CONSTANT(IG_LEFT_WORD, 1);
CONSTANT(IG_LEFT_CODE, 2);
CONSTANT(IG_LEFT_UNKNOWN, 3);
CONSTANT(IG_LEFT_EXPRESSION, 4);
CONSTANT(IG_LEFT_STATEMENT, 5);
CONSTANT(IG_LEFT_TEXT, 6);
CONSTANT(IG_FLOW_END, 1);
CONSTANT(IG_FLOW_SPLIT, 2);
CONSTANT(IG_FLOW_END_FILE, 3);
CONSTANT(IG_FLOW_SKIP_REST, 4);
CONSTANT(IG_FLOW_ALARM, 5);
CONSTANT(IG_TO_MACHINE, 1);
CONSTANT(IG_TO_PROGRAM, 2);
CONSTANT(IG_LABEL_PLACE, 0);
CONSTANT(IG_LABEL_PROGRAM, 1);
CONSTANT(IG_GO_CALL, 1);
CONSTANT(IG_GO_RETURN, 2);
CONSTANT(IG_GO_LABEL, 3);
CONSTANT(IG_GO_PLACE, 4);
CONSTANT(IG_GO_START, 5);
CONSTANT(IG_ASK_LABEL, 6);
CONSTANT(IG_IN_FILES, 1);
CONSTANT(IG_IN_FOLDERS, 2);
CONSTANT(IG_IN_PROGRAM, 4);
CONSTANT(IG_SEARCH_AROUND, 0);
CONSTANT(IG_SEARCH_FORWARD, 1);
CONSTANT(IG_SEARCH_BACKWARD, 2);
CONSTANT(IG_SEARCH_TOP, 3);
CONSTANT(IG_GO_BEHIND, 1);
CONSTANT(IG_GO_DROP_REPEATS, 2);
CONSTANT(IG_GO_DONE, 1);
CONSTANT(IG_GO_NOT_FOUND, 0);
CONSTANT(IG_GO_REFUSED, -1);
CONSTANT(IG_GO_TAKEN, -2);
CONSTANT(IG_CURRENT_FRAME, 0xffffffff);

FROZEN(ig_view_bits, 64);
AT(ig_view_bits, present, 0);
AT(ig_view_bits, fresh, 8);
FROZEN(ig_view_value, 16);
AT(ig_view_value, value, 0);
AT(ig_view, bits, 0);
AT(ig_view, values, 8);
AT(ig_view, field_count, 16);
CONSTANT(IG_HOST_SHOWS_BLOCKS, 1);

GROWS_FROM(ig_tool_name_1, 32);
AT(ig_tool_name_1, reserved, 4);
AT(ig_tool_name_1, self, 8);
AT(ig_tool_name_1, find, 16);
AT(ig_tool_name_1, name, 24);
CONSTANT(IG_TOOL_INDEX_STEP, 100000);
CONSTANT(IG_TOOL_CORNER_RADIUS, 4);
CONSTANT(IG_TOOL_CORNER_RADIUS_WEAR, 5);
CONSTANT(IG_TOOL_TIP_ANGLE, 6);
CONSTANT(IG_TOOL_TEETH, 7);
CONSTANT(IG_TOOL_MAXIMUM_SPEED, 8);

GROWS_FROM(ig_importer, 104);
AT(ig_importer, option_count, 4);
AT(ig_importer, id, 8);
AT(ig_importer, summary, 16);
AT(ig_importer, page, 24);
AT(ig_importer, cases, 32);
AT(ig_importer, folder, 40);
AT(ig_importer, files, 48);
AT(ig_importer, dependencies, 56);
AT(ig_importer, options, 64);
AT(ig_importer, recognise, 72);
AT(ig_importer, read, 80);
AT(ig_importer, write, 88);
AT(ig_importer, is_initial, 96);
AT(ig_importer, reserved, 100);

GROWS_FROM(ig_import_api, 104);
AT(ig_import_api, host_minor, 4);
AT(ig_import_api, text, 8);
AT(ig_import_api, file_name, 16);
AT(ig_import_api, option_number, 24);
AT(ig_import_api, option_integer, 32);
AT(ig_import_api, option_text, 40);
AT(ig_import_api, row, 48);
AT(ig_import_api, text_cell, 56);
AT(ig_import_api, number_cell, 64);
AT(ig_import_api, option, 72);
AT(ig_import_api, unused, 80);
AT(ig_import_api, report, 88);
AT(ig_import_api, fail, 96);

GROWS_FROM(ig_export_api, 80);
AT(ig_export_api, host_minor, 4);
AT(ig_export_api, option_number, 8);
AT(ig_export_api, option_integer, 16);
AT(ig_export_api, option_text, 24);
AT(ig_export_api, row_count, 32);
AT(ig_export_api, row_key, 40);
AT(ig_export_api, cell, 48);
AT(ig_export_api, write, 56);
AT(ig_export_api, unused, 64);
AT(ig_export_api, fail, 72);

#else
#error "no layout is written down for this machine"
#endif

GROWS_FROM(ig_machine_code, 144);
AT(ig_machine_code, does, 4);
AT(ig_machine_code, name, 8);
AT(ig_machine_code, codes, 24);
AT(ig_machine_code, program, 40);
AT(ig_machine_code, text, 56);
AT(ig_machine_code, title, 72);
AT(ig_machine_code, axes, 88);
AT(ig_machine_code, when, 92);
AT(ig_machine_code, position, 96);
AT(ig_machine_code, row, 144);
AT(ig_machine_code, arguments, 160);
AT(ig_machine_code, reserved, 164);
GROWS_FROM(ig_machine_code_1, 24);
AT(ig_machine_code_1, unknown_programs, 4);
AT(ig_machine_code_1, self, 8);
AT(ig_machine_code_1, find, 16);
AT(ig_machine_code_1, find_family, 24);
GROWS_FROM(ig_provenance_1, 24);
AT(ig_provenance_1, is_listening, 4);
AT(ig_provenance_1, answered, 8);
AT(ig_provenance_1, variable, 16);
AT(ig_provenance_1, condition, 24);
GROWS_FROM(ig_row_meaning, 64);
AT(ig_row_meaning, reserved, 4);
AT(ig_row_meaning, title, 8);
AT(ig_row_meaning, prefix, 24);
AT(ig_row_meaning, unit, 40);
AT(ig_row_meaning, scale, 56);
GROWS_FROM(ig_row_meaning_1, 24);
AT(ig_row_meaning_1, reserved, 4);
AT(ig_row_meaning_1, self, 8);
AT(ig_row_meaning_1, meaning, 16);
CONSTANT(IG_CONDITION_FAILS, 0);
CONSTANT(IG_CONDITION_HOLDS, 1);
CONSTANT(IG_CONDITION_TELLS, 2);
CONSTANT(IG_CODE_DOES_NOTHING, 1);
CONSTANT(IG_CODE_ACTS, 2);
CONSTANT(IG_CODE_CALLS, 3);
CONSTANT(IG_CODE_MOVES, 4);
CONSTANT(IG_CODE_IS_REFUSED, 5);

GROWS_FROM(ig_axis_name_1, 64);
AT(ig_axis_name_1, reserved, 4);
AT(ig_axis_name_1, self, 8);
AT(ig_axis_name_1, find, 16);
AT(ig_axis_name_1, name, 24);
AT(ig_axis_name_1, further_names, 32);
AT(ig_axis_name_1, is_rotary, 40);
AT(ig_axis_name_1, position, 48);
AT(ig_axis_name_1, travel, 56);
CONSTANT(IG_AXIS_HOME, 1);
CONSTANT(IG_AXIS_DATUM, 2);
CONSTANT(IG_AXIS_RETRACT, 3);
CONSTANT(IG_AXIS_FIXED_POINT_1, 4);
CONSTANT(IG_AXIS_FIXED_POINT_4, 7);
CONSTANT(IG_SCANS_AHEAD, 1);
