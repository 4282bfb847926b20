/* Reaches every type of the contract, so that one library describes all of it to abidw. */
#include "isogloss.h"
#include "isogloss_axis.h"
#include "isogloss_flow.h"
#include "isogloss_import.h"
#include "isogloss_machine_code.h"
#include "isogloss_provenance.h"
#include "isogloss_tool.h"
#include "isogloss_view.h"

typedef struct ig_contract {
  const ig_plugin* plugin;
  const ig_host* host;
  const ig_link_api* link_api;
  const ig_work_offset_1* work_offset;
  const ig_tool_offset_1* tool_offset;
  const ig_machine_axis_1* machine_axis;
  const ig_config_1* config;
} ig_contract;

IG_EXPORT void ig_probe(const ig_contract* contract);
void ig_probe(const ig_contract* contract) { (void)contract; }

IG_EXPORT void ig_probe_flow(const ig_flow_1* flow, const ig_go* go, const ig_frame* frame, const ig_place* place);
void ig_probe_flow(const ig_flow_1* flow, const ig_go* go, const ig_frame* frame, const ig_place* place) {
  (void)flow, (void)go, (void)frame, (void)place;
}

IG_EXPORT void ig_probe_kinematics(const ig_machine_kinematics_1* kinematics);
void ig_probe_kinematics(const ig_machine_kinematics_1* kinematics) { (void)kinematics; }

IG_EXPORT void ig_probe_view(const ig_view* view);
void ig_probe_view(const ig_view* view) { (void)view; }

IG_EXPORT void ig_probe_import(const ig_importer* importer, const ig_import_api* reading, const ig_export_api* writing);
void ig_probe_import(const ig_importer* importer, const ig_import_api* reading, const ig_export_api* writing) {
  (void)importer, (void)reading, (void)writing;
}

IG_EXPORT void ig_probe_tool_name(const ig_tool_name_1* names);
void ig_probe_tool_name(const ig_tool_name_1* names) { (void)names; }

IG_EXPORT void ig_probe_machine_code(const ig_machine_code_1* codes);
void ig_probe_machine_code(const ig_machine_code_1* codes) { (void)codes; }

IG_EXPORT void ig_probe_axis_name(const ig_axis_name_1* names);
void ig_probe_axis_name(const ig_axis_name_1* names) { (void)names; }

IG_EXPORT void ig_probe_provenance(const ig_provenance_1* provenance);
void ig_probe_provenance(const ig_provenance_1* provenance) { (void)provenance; }

IG_EXPORT void ig_probe_row_meaning(const ig_row_meaning_1* meanings);
void ig_probe_row_meaning(const ig_row_meaning_1* meanings) { (void)meanings; }
