/// A document for tests: the standard sections and some words, without a dialect or a chain.
#pragma once

#include <algorithm>
#include <string>

#include "isogloss/engine/document.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

inline Layout test_layout() {
  const auto word = [](const char* path) {
    return FieldInfo{path, IG_NUMBER, IG_LIFE_WORD, "mm", "", false, IG_NO_FIELD};
  };
  const auto code = [](const char* path) { return FieldInfo{path, IG_CODE, IG_LIFE_WORD, "", "", false, IG_NO_FIELD}; };
  Layout layout;
  layout.fields = standard_fields();
  for (const char* path : {"Parsing.X", "Parsing.Y", "Parsing.A70.X", "Parsing.A70.Q", "Parsing.B5.1.P"})
    layout.fields.push_back(word(path));
  for (const char* path : {"Parsing.Flags.A1", "Parsing.Flags.A2", "Parsing.Flags.A3.1", "Parsing.A70", "Parsing.B5.1"})
    layout.fields.push_back(code(path));
  for (const char* path : {"ProgramToMcTransform.Tilt", "ProgramToMcTransform.Offset"})
    layout.fields.push_back({path, IG_TRANSFORM, IG_LIFE_MODAL, "", "", false, IG_NO_FIELD});
  layout.fields.push_back({"Parsing.~Seen", IG_SWITCH, IG_LIFE_BLOCK, "", "", true, IG_NO_FIELD});
  std::stable_sort(layout.fields.begin(), layout.fields.end(),
                   [](const FieldInfo& a, const FieldInfo& b) { return a.life > b.life; });
  layout.lists = standard_lists();
  for (ig_field f = 0; f < layout.fields.size(); ++f) {
    const FieldInfo& info = layout.fields[f];
    if (info.type == IG_TRANSFORM)
      layout.transforms.push_back(f);
    else if (info.type != IG_CODE && !info.hidden)
      layout.shown.push_back(f);
  }
  layout.index();
  return layout;
}

/// A document with its layout and names, filled by path.
struct TestDocument {
  Layout layout = test_layout();
  SymbolTable symbols;
  Document d{layout, std::vector<std::uint64_t>(layout.fields.size() * 2), 2};

  void block(std::uint32_t line, std::string_view text = "", std::string_view file = "part.nc") {
    d.begin({file, line, 0, text});
  }
  void number(const std::string& path, double v) { d.set(layout.id(path), {.number = v}); }
  void integer(const std::string& path, std::int64_t v) { d.set(layout.id(path), {.integer = v}); }
  void name(const std::string& path, std::string_view v) { d.set(layout.id(path), {.symbol = symbols.intern(v)}); }
  void point(const std::string& section, double x, double y, double z) {
    number(section + ".X", x);
    number(section + ".Y", y);
    number(section + ".Z", z);
  }
  /// A straight move to a program point; machine coordinates follow the frame.
  void line(bool is_rapid, double x, double y, double z, double feed = 0) {
    place(x, y, z);
    name("MotionEvent.Form", "McLinear");
    if (is_rapid) integer("MotionEvent.IsRapid", 1);
    if (feed > 0) number("MotionEvent.Feedrate_mmds", feed);
  }
  void arc(bool is_ccw, double x, double y, double z, double cx, double cy, double cz, double feed = 10) {
    place(x, y, z);
    name("MotionEvent.Form", "McArc");
    point("MotionEvent.ArcCenter", cx, cy, cz);
    integer("MotionEvent.IsCcw", is_ccw ? 1 : 0);
    integer("MotionEvent.AdditionalCircleNum", 0);
    number("MotionEvent.Feedrate_mmds", feed);
  }
  void place(double x, double y, double z) {
    point("ProgramXyz", x, y, z);
    double machine[3];
    d.composed().map({x, y, z}, machine);
    point("MachineCoordinate", machine[0], machine[1], machine[2]);
  }
  void frame(const std::string& source, const double (&m)[16]) {
    d.set_frame(layout.id("ProgramToMcTransform." + source), Frame::from(m));
  }
  void shift(double x, double y, double z) { frame("Offset", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1}); }

  /// A step of a compound motion: value by value.
  void item() {
    if (!d.lists[0].has_room()) d.lists[0].make_room();
    d.lists[0].add(0);
  }
  void item_value(const std::string& path, ig_value v) {
    const std::size_t i = index_in_record(layout.record("CompoundMotion.Items", path));
    d.lists[0].record(d.lists[0].count - 1)[i] = v;
    d.lists[0].masks().back() |= std::uint64_t{1} << i;
  }
  void item_number(const std::string& path, double v) { item_value(path, {.number = v}); }
  void item_name(const std::string& path, std::string_view v) { item_value(path, {.symbol = symbols.intern(v)}); }
  void item_line(bool is_rapid, double x, double y, double z, double feed = 0) {
    item();
    const double at[] = {x, y, z};
    double machine[3];
    d.composed().map({x, y, z}, machine);
    for (std::size_t i = 0; i < 3; ++i) {
      item_number(std::string("ProgramXyz.") + "XYZ"[i], at[i]);
      item_number(std::string("MachineCoordinate.") + "XYZ"[i], machine[i]);
    }
    item_name("MotionEvent.Form", "McLinear");
    if (is_rapid) item_value("MotionEvent.IsRapid", {.integer = 1});
    if (feed > 0) item_number("MotionEvent.Feedrate_mmds", feed);
  }
};

struct StringOutput : Output {
  std::string text;
  bool is_open = true;
  bool write(std::string_view bytes) override {
    if (is_open) text += bytes;
    return is_open;
  }
};

}  // namespace isogloss
