#include "explain/block_json.hpp"

#include "explain/frame_text.hpp"
#include "explain/ladder_text.hpp"
#include "explain/sentence.hpp"

namespace isogloss::cli {

namespace {

void add(Json& to, const char* key, const ProgramLine& line) {
  if (line.line != 0) to[key] = {{"File", line.file}, {"Line", line.line}};
}

Json point(const std::array<double, 3>& p) { return {{"X", p[0]}, {"Y", p[1]}, {"Z", p[2]}}; }

Json json_of(const std::vector<ExplainedValue>& values) {
  Json out = Json::array();
  for (const ExplainedValue& v : values) {
    Json one{{"Path", v.path}, {"Value", Json::parse(v.value)}};
    if (!v.writer.empty()) one["Writer"] = v.writer;
    if (v.set.line != 0) one.update({{"File", v.set.file}, {"Line", v.set.line}});
    if (!(v.since == v.set)) add(one, "Since", v.since);
    out.push_back(std::move(one));
  }
  return out;
}

Json json_of(const ExplainedStep& s) {
  Json changes = Json::array();
  for (const ExplainedChange& c : s.changes) {
    Json one{{"Path", c.path}};
    if (!c.before.empty()) one["Before"] = Json::parse(c.before);
    if (!c.after.empty()) one["After"] = Json::parse(c.after);
    changes.push_back(std::move(one));
  }
  Json step{{"Syntax", s.syntax}};
  if (!s.plugin.empty()) step["Plugin"] = s.plugin;
  for (const ExplainedAnswer& a : s.answers)
    step["Asks"].push_back({{"Service", a.service}, {"Dependency", a.dependency}});
  for (const ExplainedRow& r : s.rows) {
    Json one{{"Dependency", r.dependency}, {"Row", r.row}};
    if (!r.where.file.empty()) one.update({{"File", r.where.file}, {"Line", r.where.line}});
    step["Rows"].push_back(std::move(one));
  }
  step["Changes"] = std::move(changes);
  return step;
}

Json json_of(const std::vector<ExplainedWord>& words) {
  Json out = Json::array();
  for (const ExplainedWord& w : words) {
    Json one{{"Text", w.text}, {"Column", w.column}};
    if (!w.name.empty()) one["Name"] = w.name;
    if (!w.value.empty()) one["Value"] = Json::parse(w.value);
    if (!w.reader.empty()) one["ReadBy"] = w.reader;
    if (!w.name.empty()) one["UsedBy"] = w.users;
    out.push_back(std::move(one));
  }
  return out;
}

Json json_of(const std::vector<ExplainedVariable>& variables) {
  Json out = Json::array();
  for (const ExplainedVariable& v : variables) {
    Json one{{"Name", v.name}};
    if (!v.value.empty()) one["Value"] = Json::parse(v.value);
    if (!v.writer.empty()) one["Writer"] = v.writer;
    add(one, "Written", v.written);
    if (!v.written_value.empty()) one["WrittenValue"] = Json::parse(v.written_value);
    out.push_back(std::move(one));
  }
  return out;
}

Json json_of(const ExplainedGo& go) {
  const char* kind = "next";
  switch (go.kind) {
    case ExplainedGo::Kind::next: return {{"Kind", kind}};
    case ExplainedGo::Kind::call: kind = "call"; break;
    case ExplainedGo::Kind::leave: kind = "return"; break;
    case ExplainedGo::Kind::again: kind = "again"; break;
    case ExplainedGo::Kind::jump: kind = "jump"; break;
  }
  Json out{{"Kind", kind}, {"File", go.to.file}, {"Line", go.to.line}};
  if (!go.program.empty()) out["Program"] = go.program;
  if (go.is_behind && go.kind == ExplainedGo::Kind::jump)
    out["Behind"] = true;  // a return gives the line behind the call
  if (go.call_line != 0) out["CallLine"] = go.call_line;
  if (go.kind == ExplainedGo::Kind::again) out["Pass"] = go.pass;
  if (go.passes > 1) out["Passes"] = go.passes;
  return out;
}

Json json_of(const std::vector<ExplainedCondition>& conditions) {
  Json out = Json::array();
  for (const ExplainedCondition& c : conditions)
    out.push_back(c.is_reason ? Json{{"Reason", c.text}} : Json{{"Text", c.text}, {"Holds", c.holds}});
  return out;
}

Json ladder_of(const Facts& facts) {
  const ExplainedLadder& ladder = facts.block().ladder;
  if (!ladder.is_there) return Json::object();
  Json rungs = Json::array();
  for (const ExplainedRung& r : ladder.rungs) {
    Json one{{"Source", r.source}, {"Name", facts.name_of(r)}, {"Does", effect_of(r.matrix).text}};
    if (r.is_moving) one["IsMoving"] = true;
    one["Point"] = point(r.point);
    if (!r.writer.empty()) one["Writer"] = r.writer;
    add(one, "Since", r.since);
    rungs.push_back(std::move(one));
  }
  Json functions = Json::array();
  for (const LadderRow& row : ladder_rows(facts, 1)) {
    Json one{{"Source", row.source}, {"Name", row.name}, {"Does", row.does}, {"Point", point(row.point)}};
    add(one, "Since", row.since);
    functions.push_back(std::move(one));
  }
  Json out{{"ProgramXyz", point(ladder.program)}, {"Rungs", std::move(rungs)}, {"Functions", std::move(functions)}};
  if (const auto machine = facts.document().find("MachineCoordinate"); machine != facts.document().end())
    out["MachineCoordinate"] = *machine;
  return out;
}

Json json_of(const std::vector<Stroke>& strokes) {
  Json out = Json::array();
  for (const Stroke& s : strokes) {
    Json one{{"Does", s.does}};
    if (s.program) one["ProgramXyz"] = point(*s.program);
    if (s.machine) one["MachineCoordinate"] = point(*s.machine);
    if (s.feed_mm_min) one["Feedrate_mm_min"] = *s.feed_mm_min;
    if (!s.reason.empty()) one["Reason"] = s.reason;
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace

Json json_of(const ExplainedBlock& b, Amount amount, LineTexts& lines, std::span<const Diagnostic> reports) {
  const Facts facts(b, lines, reports);
  const std::vector<Stroke> strokes = strokes_of(facts);
  Json out{{"File", b.where.file}, {"Line", b.where.line}, {"Sentence", sentence_of(facts, strokes)}};
  if (amount == Amount::sentence) return out;
  Json steps = Json::array(), slept = Json::array(), frames = Json::array();
  for (const ExplainedStep& s : b.steps) steps.push_back(json_of(s));
  for (const SleepingSyntax& s : b.slept) slept.push_back({{"Syntax", s.syntax}, {"WakesOn", s.wakes_on}});
  for (const ExplainedFrame& f : b.frames) {
    Json one{{"File", f.file}};
    if (!f.program.empty()) one.update({{"Program", f.program}, {"CallLine", f.call_line}});
    if (f.passes > 1) one.update({{"Pass", f.pass}, {"Passes", f.passes}});
    frames.push_back(std::move(one));
  }
  Json calls = Json::object();
  if (b.go.kind == ExplainedGo::Kind::call)
    calls = {{"Program", b.go.program}, {"File", b.go.to.file}, {"Line", b.go.to.line}};
  out.update({{"Calls", std::move(calls)},
              {"GoesOn", json_of(b.go)},
              {"Conditions", json_of(b.conditions)},
              {"Pass", b.pass},
              {"Frames", std::move(frames)},
              {"Text", b.text},
              {"Words", json_of(b.words)},
              {"Variables", json_of(b.variables)},
              {"VariablesWritten", json_of(b.written)},
              {"Strokes", json_of(strokes)},
              {"Ladder", ladder_of(facts)},
              {"Steps", std::move(steps)},
              {"Carried", json_of(b.carried)},
              {"Slept", std::move(slept)},
              {"Values", json_of(b.values)},
              {"Document", facts.document()}});
  return out;
}

}  // namespace isogloss::cli
