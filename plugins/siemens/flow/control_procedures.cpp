/// Procedures of the control: what they do here, and what is missing where they are not executed.
#include "flow/control_procedures.hpp"

#include <algorithm>
#include <cmath>

#include "flow/call_reader.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr std::size_t most_call_paths = 32;  // so that a loop of CALLPATH does not slow down each call

}  // namespace

bool is_shopmill_step(std::string_view name) {
  if (name == "E_CON" || name == "E_DR") return true;
  for (const std::string_view family : {"E_CP_", "E_DR_", "E_MI_", "E_PI_", "E_PO_", "E_PS_", "E_SL_"})
    if (name.starts_with(family)) return true;
  return false;
}

bool is_foreign_cycle(std::string_view name) {
  for (const std::string_view family : {"CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE"})
    if (name.starts_with(family) && skip_digits(name, family.size()) == name.size() &&
        (name.size() > family.size() || family == "LONGHOLE"))
      return true;
  return is_shopmill_step(name);
}

std::string_view not_executed(std::string_view name) {
  struct Known {
    std::string_view name, missing;
  };
  static constexpr std::string_view origin = "the axis keeps its previous origin",
                                    coupled = "the axis that follows another one stands still",
                                    values = "what it would answer is not known",
                                    tools = "the tool table does not change",
                                    axes = "axes, frames and kinematics do not change",
                                    contour = "what the table of the contour is for is missing",
                                    head = "the unit, the plane and the work offset it sets are missing";
  static constexpr Known known[] = {{"PRESETON", origin},
                                    {"PRESETONS", origin},
                                    {"TANG", coupled},
                                    {"TANGON", coupled},
                                    {"TRAILON", coupled},
                                    {"LEADON", coupled},
                                    {"EGON", coupled},
                                    {"EGONSYN", coupled},
                                    {"EGONSYNE", coupled},
                                    {"EGDEF", coupled},
                                    {"CTABDEF", "the blocks up to CTABEND are points of a curve and move nothing"},
                                    {"CTABEND", "no CTABDEF is in force"},
                                    {"MASLON", coupled},
                                    {"MASLDEF", coupled},
                                    {"GEOAX", axes},
                                    {"AXCTSWE", axes},
                                    {"AXCTSWED", axes},
                                    {"CORRTRAFO", axes},
                                    {"TRAFOON", axes},
                                    {"ADDFRAME", axes},
                                    {"START", "the program of the other channel does not run"},
                                    {"SETINT", "no signal interrupts the program"},
                                    {"FPO", "the feed stays as F says"},
                                    {"CONTPRON", contour},
                                    {"CONTDCON", contour},
                                    {"EXECTAB", contour},
                                    {"EXECUTE", contour},
                                    {"CALCDAT", values},
                                    {"INTERSEC", values},
                                    {"MEASURE", values},
                                    {"FILEDATE", values},
                                    {"FILETIME", values},
                                    {"FILESIZE", values},
                                    {"FILESTAT", values},
                                    {"FILEINFO", values},
                                    {"GETT", values},
                                    {"GETACTTD", values},
                                    {"LENTOAX", values},
                                    {"TOOLENV", tools},
                                    {"DELTOOLENV", tools},
                                    {"SETTCOR", tools},
                                    {"DELDL", tools},
                                    {"DZERO", tools},
                                    {"TCA", tools},
                                    {"TCI", tools},
                                    {"PUTFTOC", tools},
                                    {"PUTFTOCF", tools},
                                    {"ORIRESET", "the rotary axes do not turn"},
                                    {"TOFFON", "the offset is missing"},
                                    {"GETTCOR", values},
                                    {"GETTENV", values},
                                    {"GETDNO", values},
                                    {"SETDNO", tools},
                                    {"NEWT", tools},
                                    {"DELT", tools},
                                    {"DELTC", tools},
                                    {"SETMTH", tools},
                                    {"READ", values},
                                    {"CALCPOSI", values},
                                    {"E_HEAD", head},
                                    {"E_CONFIG", head},
                                    {"E_TCARR", "the plane is not swivelled"}};
  for (const Known& k : known)
    if (k.name == name) return k.missing;
  return {};
}

bool CallReader::is_known(ig::Block& b, std::string_view text, const std::string& name, std::size_t open,
                          std::size_t close) {
  const auto where = ig::Where::columns(begin_, close);
  if (name == "SETAL") {
    if (read_arguments(b, text.substr(0, close), open))
      b.report(ig::diag("SIE-0170"), where,
               arguments_.empty() || !arguments_[0].value ? 0.0 : arguments_[0].value->number);
    b.alarm();
    return true;
  }
  if (name == "CALLPATH") {
    add_call_path(b, text.substr(0, close), open, where);
    return true;
  }
  if (name == "GETEXET" || name == "GETSELT") {
    give_tool(b, text.substr(0, close), open, name == "GETEXET" ? "$P_TOOLNO" : "$P_TOOLP", where);
    return true;
  }
  if (const std::string_view missing = not_executed(name); !missing.empty()) {
    b.report(ig::diag("SIE-0174"), where, std::string_view(name), missing);
    return true;
  }
  if (name == "TRAORI") {  // TRAORI(1), TRAORI(1,0,0,1): one transformation is known
    const ig_word word{traori_.id(0), column(begin_), column(close), ig_value{}, 0, 0};
    b.set_word(word);
    return true;
  }
  for (const std::string_view transformation : {"TRANSMIT", "TRACYL", "TRAANG", "TRACON"})
    if (name == transformation) {
      b.report(ig::diag("SIE-0183"), where, std::string_view(name));
      return true;
    }
  if (!silent_.holds(name)) return false;
  if (name == "SETMS") name_master(b, text.substr(0, close), open);
  if (name == "MSG" && at(text, skip_blanks(text, open + 1)) == '"') {
    const std::size_t first = skip_blanks(text, open + 1) + 1;
    if (text.find('"', first) == std::string_view::npos)
      b.report(ig::diag("SIE-0102"), ig::Where::columns(first - 1, text.size()));
    b.set_text(message_, piece(text, first, std::min(text.find('"', first), close)));
  }
  return true;
}

void CallReader::add_call_path(ig::Block& b, std::string_view text, std::size_t open, ig::Where where) {
  if (!read_arguments(b, text, open)) return;
  std::vector<std::string>& path = environment_.store().call_path;
  const bool is_empty = arguments_.empty() || !arguments_[0].value;
  if (is_empty || (arguments_[0].value->is_text() && arguments_[0].value->text.empty())) {
    path.clear();
  } else if (!arguments_[0].value->is_text() || arguments_.size() > 1 || folder_of(arguments_[0].value->text).empty()) {
    b.report(ig::diag("SIE-0169"), where, text.substr(begin_));
  } else if (path.size() == most_call_paths) {
    b.report(ig::diag("SIE-0370"), where, arguments_[0].value->text, static_cast<double>(most_call_paths));
  } else if (std::string folder = folder_of(arguments_[0].value->text);
             std::find(path.begin(), path.end(), folder) == path.end()) {
    path.push_back(std::move(folder));
  }
}

void CallReader::name_master(ig::Block& b, std::string_view text, std::size_t open) {
  if (!read_arguments(b, text, open)) return;
  environment_.store().master_spindle.reset();
  if (!arguments_.empty() && arguments_[0].value && !arguments_[0].value->is_text())
    environment_.store().master_spindle =
        static_cast<std::int64_t>(std::fmax(0, std::fmin(std::round(arguments_[0].value->number), 999)));
}

void CallReader::give_tool(ig::Block& b, std::string_view text, std::size_t open, std::string_view tool,
                           ig::Where where) {
  if (!read_arguments(b, text, open)) return;
  const Variable* const variable = arguments_.empty() ? nullptr : environment_.store().find(arguments_[0].name);
  if (variable == nullptr || variable->value.is_text()) {
    b.report(ig::diag("SIE-0169"), where, text.substr(open));
    return;
  }
  const Value value = Value::real(environment_.system.read(b, tool).value_or(0));
  const std::string& name = arguments_[0].name;
  environment_.note_write(b, name, value);
  environment_.report_not_stored(b, where, name, value, environment_.store().assign(name, value));
}

}  // namespace siemens
