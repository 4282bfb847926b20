// The sections of the block document that consumers know by name: the data model, as one list. A syntax that writes
// one of these fields declares no life, unit or text for it. Nothing here is a word or code of a program.
#include "isogloss/engine/layout.hpp"

namespace isogloss {

namespace {

FieldInfo field(const char* path, ig_type type, ig_life life, const char* unit, const char* doc) {
  return {path, type, life, unit, doc, false, IG_NO_FIELD};
}

std::vector<FieldInfo> make_fields() {
  constexpr auto number = IG_NUMBER, integer = IG_INTEGER, boolean = IG_BOOLEAN, name = IG_SYMBOL, text = IG_TEXT;
  constexpr auto block = IG_LIFE_BLOCK, modal = IG_LIFE_MODAL;
  return {
      field("Source.File", text, block, "", "File of the block."),
      field("Source.Line", integer, block, "", "Line in its file, from 1."),
      field("Source.Text", text, block, "", "The block as written."),
      field("Source.N", integer, block, "", "Sequence number."),
      field("Source.Program", text, block, "", "Program number or name that begins here."),
      field("Source.Iteration", integer, block, "", "Pass of a loop or repeat, from 1."),
      field("Comment.Symbol", name, block, "", "What opened the comment."),
      field("Comment.Text", text, block, "", "The comment without its brackets."),
      field("BlockSkip.Symbol", name, block, "", "The skip character."),
      field("BlockSkip.Layer", integer, block, "", "Layer 1 to 9."),
      field("BlockSkip.Body", text, block, "", "What was skipped because the layer is on."),
      field("TapeBoundary.Text", text, block, "", "The tape mark as written."),
      field("PositioningMode.Term", name, modal, "", "The code in force."),
      field("PositioningMode.Mode", name, modal, "", "Absolute or Incremental."),
      field("Unit.Term", name, modal, "", "The code in force."),
      field("Unit.System", name, modal, "", "Metric or Inch: how the program is written; the document is metric."),
      field("PlaneSelect.Term", name, modal, "", "The code in force."),
      field("PlaneSelect.Plane", name, modal, "", "XY, ZX or YZ."),
      field("Feedrate.FeedrateValue", number, modal, "", "As programmed, metric: mm/min, mm/rev or 1/min."),
      field("Feedrate.Term", name, modal, "", "The code in force."),
      field("Feedrate.Unit", name, modal, "", "mm/min, mm/rev or 1/min."),
      field("SpindleSpeed.SpindleSpeed_rpm", number, modal, "1/min", "Programmed speed; kept while the spindle stops."),
      field("SpindleSpeed.Direction", name, modal, "", "CW, CCW or STOP."),
      field("SpindleSpeed.Term", name, modal, "", "Constant surface speed is in force; absent where it is not."),
      field("SpindleSpeed.SurfaceSpeed", number, modal, "", "As programmed, m/min or ft/min."),
      field("SpindleSpeed.Limit_rpm", number, modal, "1/min", "Highest speed under constant surface speed."),
      field("Coolant.Mode", name, modal, "", "OFF, FLOOD, MIST …"),
      field("ToolChange.ToolId", integer, modal, "", "The tool that was named last."),
      field("ToolChange.IsChange", boolean, block, "", "True in the block that changes the tool."),
      field("ToolChange.Term", name, block, "", "The code that changes the tool."),
      field("ToolChange.SpindleToolId", integer, modal, "", "The tool in the spindle."),
      field("ToolHeightCompensation.Term", name, modal, "", "The code in force."),
      field("ToolHeightCompensation.OffsetId", integer, modal, "", "Number in the tool offset table."),
      field("ToolHeightCompensation.Offset_mm", number, modal, "mm", "Length in force, signed."),
      field("ToolHeightCompensation.Untravelled_mm", number, modal, "mm",
            "Part of the length that no move has travelled yet."),
      field("ToolOrientation.X", number, modal, "", "Tool axis, unit vector."),
      field("ToolOrientation.Y", number, modal, "", "Tool axis, unit vector."),
      field("ToolOrientation.Z", number, modal, "", "Tool axis, unit vector."),
      field("RadiusCompensation.Side", name, modal, "", "Left, Right or None."),
      field("RadiusCompensation.Term", name, modal, "", "The code in force."),
      field("RadiusCompensation.OffsetId", integer, modal, "", "Number in the tool offset table."),
      field("RadiusCompensation.Radius_mm", number, modal, "mm", "Radius in force."),
      field("CoordinateOffset.CoordinateId", name, modal, "", "The work offset in force."),
      field("CoordinateOffset.Offset_X", number, modal, "mm", "Origin in machine coordinates."),
      field("CoordinateOffset.Offset_Y", number, modal, "mm", "Origin in machine coordinates."),
      field("CoordinateOffset.Offset_Z", number, modal, "mm", "Origin in machine coordinates."),
      field("LocalCoordinateOffset.Offset_X", number, modal, "mm", "Local origin in the work offset."),
      field("LocalCoordinateOffset.Offset_Y", number, modal, "mm", "Local origin in the work offset."),
      field("LocalCoordinateOffset.Offset_Z", number, modal, "mm", "Local origin in the work offset."),
      field("ReferenceReturn.Intermediate.X", number, modal, "mm",
            "Point passed on the way there, program coordinates."),
      field("ReferenceReturn.Intermediate.Y", number, modal, "mm",
            "Point passed on the way there, program coordinates."),
      field("ReferenceReturn.Intermediate.Z", number, modal, "mm",
            "Point passed on the way there, program coordinates."),
      field("WorkCoordinateShift.Offset_X", number, modal, "mm", "Shift of all work coordinate systems."),
      field("WorkCoordinateShift.Offset_Y", number, modal, "mm", "Shift of all work coordinate systems."),
      field("WorkCoordinateShift.Offset_Z", number, modal, "mm", "Shift of all work coordinate systems."),
      field("TiltTransform.Term", name, modal, "", "The code in force."),
      field("TiltTransform.X", number, modal, "mm", "As programmed: centre or origin."),
      field("TiltTransform.Y", number, modal, "mm", "As programmed: centre or origin."),
      field("TiltTransform.Z", number, modal, "mm", "As programmed: centre or origin."),
      field("TiltTransform.R", number, modal, "deg", "As programmed: angle."),
      field("RigidTapping.Term", name, modal, "", "The code in force; absent where tapping is not rigid."),
      field("PolarCoordinate.Term", name, modal, "", "The code in force; absent where none is."),
      field("PolarCoordinate.Pole.X", number, modal, "mm", "Where radius and angle count from, program coordinates."),
      field("PolarCoordinate.Pole.Y", number, modal, "mm", "Where radius and angle count from, program coordinates."),
      field("PolarCoordinate.Pole.Z", number, modal, "mm", "Where radius and angle count from, program coordinates."),
      field("PolarCoordinate.Radius", number, modal, "mm", "Radius reached."),
      field("PolarCoordinate.Angle_deg", number, modal, "deg", "Angle reached."),
      field("PolarCoordinate.Turn_deg", number, block, "deg", "From hole to hole of a repeated cycle."),
      field("Scaling.Term", name, modal, "", "The code in force; absent where none is."),
      field("Scaling.Center.X", number, modal, "mm", "Centre, program coordinates."),
      field("Scaling.Center.Y", number, modal, "mm", "Centre, program coordinates."),
      field("Scaling.Center.Z", number, modal, "mm", "Centre, program coordinates."),
      field("Scaling.Factor.X", number, modal, "", "Factor of the axis; negative: mirrored as well."),
      field("Scaling.Factor.Y", number, modal, "", "Factor of the axis; negative: mirrored as well."),
      field("Scaling.Factor.Z", number, modal, "", "Factor of the axis; negative: mirrored as well."),
      field("MirrorImage.Term", name, modal, "", "The code in force; absent where none is."),
      field("MirrorImage.X", number, modal, "mm", "Where the axis is mirrored; absent: it is not."),
      field("MirrorImage.Y", number, modal, "mm", "Where the axis is mirrored; absent: it is not."),
      field("MirrorImage.Z", number, modal, "mm", "Where the axis is mirrored; absent: it is not."),
      field("ProgramXyz.X", number, modal, "mm", "Tool tip in program coordinates at the end of the block."),
      field("ProgramXyz.Y", number, modal, "mm", "Tool tip in program coordinates at the end of the block."),
      field("ProgramXyz.Z", number, modal, "mm", "Tool tip in program coordinates at the end of the block."),
      field("MachineCoordinate.X", number, modal, "mm", "Gauge point in machine coordinates."),
      field("MachineCoordinate.Y", number, modal, "mm", "Gauge point in machine coordinates."),
      field("MachineCoordinate.Z", number, modal, "mm", "Gauge point in machine coordinates."),
      field("MachineCoordinate.A", number, modal, "deg", "Rotary axis."),
      field("MachineCoordinate.B", number, modal, "deg", "Rotary axis."),
      field("MachineCoordinate.C", number, modal, "deg", "Rotary axis."),
      field("MotionState.Term", name, modal, "", "The motion code in force."),
      field("MotionEvent.Form", name, block, "", "McLinear, McArc or ClLinear."),
      field("MotionEvent.IsRapid", boolean, block, "", "True on rapids, else absent."),
      field("MotionEvent.Feedrate_mmds", number, block, "mm/s", "Absent on rapids and where no feed is in force."),
      field("MotionEvent.ArcCenter.X", number, block, "mm", "Program coordinates, at the level of the arc's start."),
      field("MotionEvent.ArcCenter.Y", number, block, "mm", "Program coordinates, at the level of the arc's start."),
      field("MotionEvent.ArcCenter.Z", number, block, "mm", "Program coordinates, at the level of the arc's start."),
      field("MotionEvent.IsCcw", boolean, block, "", "Sense, seen from the positive end of the plane's third axis."),
      field("MotionEvent.AdditionalCircleNum", integer, block, "", "Whole turns besides the arc."),
      field("CompoundMotion.Term", name, block, "", "The code that moves by steps."),
      field("CannedCycle.Term", name, modal, "", "The cycle in force; the cancelling code in the block that cancels."),
      field("CannedCycle.ReturnMode", name, modal, "", "The return mode in force."),
      field("CannedCycle.InitialLevel", number, modal, "mm", "Tool-axis position when the cycle mode was entered."),
      field("CannedCycle.Params.X", number, modal, "mm", "Hole, absolute."),
      field("CannedCycle.Params.Y", number, modal, "mm", "Hole, absolute."),
      field("CannedCycle.Params.Z", number, modal, "mm", "Hole, absolute."),
      field("CannedCycle.Params.R", number, modal, "mm", "R plane, absolute."),
      field("CannedCycle.Params.Q", number, modal, "mm", "Peck depth or shift."),
      field("CannedCycle.Params.P", number, modal, "", "Dwell as programmed."),
      field("CannedCycle.Params.I", number, modal, "mm", "Shift."),
      field("CannedCycle.Params.J", number, modal, "mm", "Shift."),
      field("Dwell.Time", number, block, "s", "Dwell."),
      field("SpindleOrientation.Angle_deg", number, block, "deg", "Oriented stop."),
      field("ThreadCutting.Lead", number, modal, "mm", "Along the path, a revolution."),
      field("ThreadCutting.StartAngle_deg", number, modal, "deg", "Where the spindle stands at the start."),
      field("PathMode.Term", name, modal, "", "The code in force."),
      field("PathMode.Mode", name, modal, "", "ExactStop, CornerOverride, Tapping or Cutting."),
      field("PathMode.Tolerance_mm", number, modal, "mm", "Of rounded corners, where the program gives one."),
      field("PathMode.IsExactStop", boolean, block, "", "True where this block alone stops at its end."),
      field("PathSmoothing.IsEnabled", boolean, modal, "", "High-speed smoothing is on."),
      field("PathSmoothing.Term", name, modal, "", "The code in force."),
      field("PathSmoothing.Level", number, modal, "", "Level of the smoothing."),
      field("ProgramStop.Term", name, block, "", "The code that stops."),
      field("ProgramEnd.Term", name, block, "", "The code that ends."),
  };
}

}  // namespace

const std::vector<FieldInfo>& standard_fields() {
  static const std::vector<FieldInfo> fields = make_fields();
  return fields;
}

const std::vector<ListInfo>& standard_lists() {
  constexpr auto number = IG_NUMBER, integer = IG_INTEGER, boolean = IG_BOOLEAN, name = IG_SYMBOL;
  constexpr auto block = IG_LIFE_BLOCK;
  static const std::vector<ListInfo> lists{
      {"CompoundMotion.Items",
       {
           field("ProgramXyz.X", number, block, "mm", "Program coordinates at the end of the step."),
           field("ProgramXyz.Y", number, block, "mm", "Program coordinates at the end of the step."),
           field("ProgramXyz.Z", number, block, "mm", "Program coordinates at the end of the step."),
           field("MachineCoordinate.X", number, block, "mm", "Machine coordinates at the end of the step."),
           field("MachineCoordinate.Y", number, block, "mm", "Machine coordinates at the end of the step."),
           field("MachineCoordinate.Z", number, block, "mm", "Machine coordinates at the end of the step."),
           field("MachineCoordinate.A", number, block, "deg", "Rotary axis."),
           field("MachineCoordinate.B", number, block, "deg", "Rotary axis."),
           field("MachineCoordinate.C", number, block, "deg", "Rotary axis."),
           field("MotionEvent.Form", name, block, "", "McLinear, McArc or ClLinear."),
           field("MotionEvent.IsRapid", boolean, block, "", "True on rapids, else absent."),
           field("MotionEvent.IsManual", boolean, block, "", "True where the operator moves by hand, else absent."),
           field("MotionEvent.Feedrate_mmds", number, block, "mm/s", "Absent on rapids."),
           field("MotionEvent.ArcCenter.X", number, block, "mm", "At the level of the arc's start."),
           field("MotionEvent.ArcCenter.Y", number, block, "mm", "At the level of the arc's start."),
           field("MotionEvent.ArcCenter.Z", number, block, "mm", "At the level of the arc's start."),
           field("MotionEvent.IsCcw", boolean, block, "", "Sense of an arc."),
           field("MotionEvent.AdditionalCircleNum", integer, block, "", "Whole turns besides the arc."),
           field("Dwell.Time", number, block, "s", "Dwell."),
           field("SpindleControl.Direction", name, block, "", "CW, CCW or STOP."),
           field("SpindleOrientation.Angle_deg", number, block, "deg", "Oriented stop."),
       }},
  };
  return lists;
}

const std::vector<std::string>& section_order() {
  static const std::vector<std::string> order{"Source",           "UnparsedText",
                                              "Comment",          "BlockSkip",
                                              "TapeBoundary",     "Parsing",
                                              "PositioningMode",  "Unit",
                                              "PlaneSelect",      "Feedrate",
                                              "SpindleSpeed",     "Coolant",
                                              "ToolChange",       "ToolHeightCompensation",
                                              "ToolOrientation",  "RadiusCompensation",
                                              "CoordinateOffset", "LocalCoordinateOffset",
                                              "PolarCoordinate",  "Scaling",
                                              "MirrorImage",      "WorkCoordinateShift",
                                              "TiltTransform",    "ProgramToMcTransform",
                                              "CannedCycle",      "ReferenceReturn",
                                              "ProgramXyz",       "MachineCoordinate",
                                              "MotionState",      "MotionEvent",
                                              "CompoundMotion",   "Dwell",
                                              "SpindleControl",   "SpindleOrientation",
                                              "ThreadCutting",    "PathMode",
                                              "PathSmoothing",    "ProgramStop",
                                              "ProgramEnd"};
  return order;
}

}  // namespace isogloss
