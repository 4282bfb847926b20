// PATTERN DEF: points, rows, grids, frames and circles of points, at which CYCL CALL PAT runs the cycle. They are kept
// as a list of points. SEL PATTERN takes the points of a table instead.
#include <isogloss/cnc/hole_layout.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/tilt_transform.hpp>

#include "cycles/point_tables.hpp"
#include "language/block_words.hpp"
#include "language/file_name.hpp"
#include "language/klartext_values.hpp"
#include "language/program_unit.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPattern {
  static constexpr auto spec = ig::syntax("KlartextPatternSyntax", "PATTERN DEF: the points of CYCL CALL PAT.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("KlartextUnknownSyntax")
                                   .scans("PSps");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0369",
                     "the machine has no point table {0}, so its points are missing: import the file of the control"),
      ig::diagnostic(IG_ERROR, "HEI-0370",
                     "row {0} of {1} has no value for an axis of the plane, so its point is missing: complete the row"),
      ig::diagnostic(IG_ERROR, "HEI-0187", "{0} has no point or more than {1} points: its points are missing"),
  };

  Values values_;
  PlaneInForce plane_;
  ProgramUnit unit_;
  ig::Service<PointTables> tables_{point_table_service, ig::Need::optional, "The point tables of the machine."};
  ig::AnsweredRows answered_{point_table_service};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!stands_first(text, position)) return position;
    const std::size_t definition = keyword(text, position, "PATTERN DEF"),
                      selection = keyword(text, position, "SEL PATTERN");
    if (definition == position && selection == position) return position;
    const std::size_t end = statement_end(text, position);
    QStore* const store = values_.store();
    if (values_.is_indexing() || store == nullptr) return end;
    store->pattern.clear();
    if (selection != position)
      select(b, text.substr(0, end), position, selection, store->pattern);
    else
      read(b, text.substr(0, end), position, definition, store->pattern);
    return end;
  }

 private:
  enum Kind : std::size_t { pos, row, pat, frame, circ, pitch_circle, kind_count };
  static constexpr std::array<std::string_view, kind_count> kinds{"POS", "ROW", "PAT", "FRAME", "CIRC", "PITCHCIRC"};
  enum Name : std::size_t { X, Y, Z, D, DX, DY, NUM, NUMX, NUMY, ROT, ROTX, ROTY, START, STEP, END, name_count };
  static constexpr std::array<std::string_view, name_count> names{
      "X", "Y", "Z", "D", "DX", "DY", "NUM", "NUMX", "NUMY", "ROT", "ROTX", "ROTY", "START", "STEP", "END"};
  static constexpr std::size_t most_points = 10'000;

  using Words = std::array<std::optional<double>, name_count>;
  using Points = std::vector<PatternPoint>;

  /// Whether a pattern of this kind has the word.
  static bool takes(Kind kind, std::size_t name) {
    if (name <= Z) return true;
    switch (kind) {
      case pos: return false;
      case row: return name == D || name == NUM || name == ROT;
      case pat:
      case frame: return name != D && name != NUM && name < START;
      case circ: return name == D || name == NUM || name == START;
      default: return name == D || name == NUM || name >= START;
    }
  }

  /// SEL PATTERN "TNC:\HOLES.PNT"
  void select(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i, Points& points) const {
    const auto name = file_name_at(b, values_, text, skip(text, i));
    if (!name) return;
    const std::string_view path = *name;
    const auto where = where_of_line(text, begin);
    if (path.empty())
      return b.report(ig::diag("HEI-0104"), where, std::string_view("SEL PATTERN"),
                      std::string_view("the name of the table"));
    const PointTables::Table* const table = tables_ ? tables_->find(path) : nullptr;
    if (table == nullptr) return b.report(ig::diag("HEI-0369"), where, path);
    const PlaneAxes plane = plane_(b);
    for (const auto& [number, point] : table->rows) {
      answered_.add(b, point.name);
      if (point.is_faded) continue;
      const auto first = point.position[plane.first], second = point.position[plane.second];
      if (!first || !second) {
        b.report(ig::diag("HEI-0370"), where, static_cast<double>(number), std::string_view(table->name));
        continue;
      }
      if (points.size() >= most_points) {
        b.report(ig::diag("HEI-0187"), where, path, static_cast<double>(most_points));
        return points.clear();
      }
      points.push_back({*first, *second, point.position[plane.tool].value_or(0),
                        point.clearance.value_or(std::numeric_limits<double>::quiet_NaN())});
    }
  }

  /// Reads POS1 (X+25 Y+33.5 Z+0) POS2 (...)
  void read(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i, Points& points) const {
    bool any = false;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t letters = letters_end(text, i);
      std::size_t kind = 0;
      while (kind < kind_count && !equals_ignoring_case(piece(text, i, letters), kinds[kind])) ++kind;
      const std::size_t open = skip(text, skip_digits(text, letters));
      if (kind == kind_count || at(text, open) != '(') {
        report_not_a_word(b, text, i, "PATTERN DEF");
        return;
      }
      Words words;
      const std::string_view shown = piece(text, i, skip_digits(text, letters));
      const auto where = ig::Where::columns(i, open);
      any = true;
      i = open + 1;
      bool is_complete = true;
      if (!words_at(b, text, i, static_cast<Kind>(kind), words, is_complete)) return;
      if (is_complete) add(b, static_cast<Kind>(kind), words, shown, where, points);
    }
    if (!any) report_not_executed(b, text, begin, "it holds no point");
  }

  /// Reads up to the closing bracket; false, with a diagnostic, where other text is there.
  bool words_at(ig::Block& b, std::string_view text, std::size_t& i, Kind kind, Words& words, bool& is_complete) const {
    while ((i = skip(text, i)) < text.size() && text[i] != ')') {
      std::size_t end = letters_end(text, i);
      if (end > i + 1 && to_upper(text[end - 1]) == 'Q') --end;
      std::size_t name = 0;
      while (name < name_count && !equals_ignoring_case(piece(text, i, end), names[name])) ++name;
      if (name == name_count) {
        report_not_a_word(b, text, i, "PATTERN DEF");
        return false;
      }
      const Value v = values_.read(b, text, end);
      if (v.ok && words[name]) report_repeated(b, text, i, v.end);
      if (!v.ok)
        b.report(ig::diag("HEI-0104"), ig::Where::columns(i, end), std::string_view("PATTERN DEF"), names[name]);
      else if (takes(kind, name))
        words[name] = v.number;
      else
        b.report(ig::diag("HEI-0103"), ig::Where::columns(i, v.end), trim(piece(text, i, v.end)), kinds[kind]);
      is_complete = is_complete && v.ok;
      i = v.ok ? v.end : skip_while(text, end, [](char c) { return c == '+' || c == '-'; });
    }
    if (i < text.size()) ++i;  // a bracket that is not closed ends with the block
    return true;
  }

  void add(ig::Block& b, Kind kind, const Words& w, std::string_view shown, ig::Where where, Points& points) const {
    // Shorter rows are padded with X, which has been found by then.
    static constexpr std::array<std::array<Name, 6>, kind_count> needed{{{X, Y},
                                                                         {X, Y, D, NUM},
                                                                         {X, Y, DX, DY, NUMX, NUMY},
                                                                         {X, Y, DX, DY, NUMX, NUMY},
                                                                         {X, Y, D, NUM},
                                                                         {X, Y, D, NUM}}};
    const PlaneAxes plane = plane_(b);
    static constexpr std::array<Name, 3> axes{X, Y, Z};
    for (const Name name : needed[kind]) {
      // X and Y stand for the first and the second axis of the plane.
      const Name needs = name == X ? axes[plane.first] : name == Y ? axes[plane.second] : name;
      if (w[needs]) continue;
      b.report(ig::diag("HEI-0104"), where, shown, names[needs]);
      return;
    }
    const auto number = [&](Name name) { return w[name].value_or(0); };
    const auto count = [&](Name name) {
      const double n = std::round(number(name));
      return n >= 1 && n <= most_points ? static_cast<std::size_t>(n) : 0;
    };
    const double unit = unit_.in_mm(b);
    const double u = number(axes[plane.first]), v = number(axes[plane.second]), z = number(axes[plane.tool]);
    const auto put = [&](const Point2& p) { points.push_back({p.u * unit, p.v * unit, z * unit}); };
    const bool is_grid = kind == pat || kind == frame;
    const std::size_t columns = kind == pos ? 1 : is_grid ? count(NUMX) : count(NUM), rows = is_grid ? count(NUMY) : 1;
    if (columns == 0 || rows == 0 || columns * rows + points.size() > most_points) {
      b.report(ig::diag("HEI-0187"), where, shown, static_cast<double>(most_points));
      return;
    }
    switch (kind) {
      case pos: return put({u, v});
      case circ:
      case pitch_circle: {
        if (w[STEP] && w[END]) b.report(ig::diag("HEI-0105"), where, names[END], std::string_view("STEP of PITCHCIRC"));
        const bool to_end = kind == pitch_circle && !w[STEP] && w[END];
        if (kind == pitch_circle && !w[STEP] && !w[END])
          return b.report(ig::diag("HEI-0104"), where, shown, std::string_view("STEP"));
        const double step = kind == circ ? 360 / static_cast<double>(columns)
                            : to_end ? (*w[END] - number(START)) / static_cast<double>(columns > 1 ? columns - 1 : 1)
                                     : number(STEP);
        for (std::size_t i = 0; i < columns; ++i) {
          put(hole_towards({u, v}, number(D) / 2, Turn::by(number(START) + step * static_cast<double>(i))));
        }
        return;
      }
      default: break;
    }
    const HoleGrid grid{{u, v},
                        Turn::by(number(ROT) + number(ROTX)),
                        Turn::by(number(ROT) + number(ROTY)),
                        is_grid ? number(DX) : number(D),
                        number(DY)};
    for (std::size_t r = 0; r < rows; ++r)
      for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t c = alternating_column(r, i, columns);
        if (kind == frame && r != 0 && r + 1 != rows && c != 0 && c + 1 != columns) continue;
        put(grid.at(c, r));
      }
  }
};

const ig::Register<KlartextPattern> klartext_pattern_syntax;

}  // namespace
}  // namespace heidenhain
