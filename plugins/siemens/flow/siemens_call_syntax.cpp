// Calls: NAME(1,2), NAME P3, L100, CALL "NAME", EXTCALL("NAME"), and the cycles, whose parameters become words. What
// the control knows by name but this run does not execute is one diagnostic for each call.
#include "cycles/cycle_signatures.hpp"
#include "flow/flow_words.hpp"
#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;
namespace {

/// A blank-separated list of names.
class NameSet {
 public:
  explicit NameSet(std::string_view list) {
    while (!(list = trim(list)).empty()) {
      const std::size_t end = std::min(list.find(' '), list.size());
      names_.push_back(upper(list.substr(0, end)));
      list.remove_prefix(end);
    }
  }
  bool holds(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

 private:
  std::vector<std::string> names_;
};

struct SiemensCall {
  static constexpr auto spec = ig::syntax("SiemensCallSyntax", "Calls of subprograms and cycles.")
                                   .after("SiemensWordSyntax", "SiemensFlowSyntax", "SiemensDeclarationSyntax")
                                   .before("UnitModeSyntax", "ProgramEndSyntax")
                                   .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0168",
                     "the synchronized action '{0}' is not executed: the machine runs it in parallel with the program"),
      ig::diagnostic(IG_ERROR, "SIE-0169",
                     "'{0}' does not belong in a call, so nothing is called: write the call as NAME(1,,R5)"),
      ig::diagnostic(IG_ERROR, "SIE-0170", "the program stops the control with its own alarm {0}"),
      ig::diagnostic(IG_ERROR, "SIE-0171", "'{0}' is not executed: this form of CALL is not supported"),
      ig::diagnostic(IG_ERROR, "SIE-0172",
                     "{0} is not called with P={1}: the number of calls is whole, from 0 to 9999"),
      ig::diagnostic(IG_ERROR, "SIE-0173",
                     "{0} is not a known statement, so '{1}' after it is not executed: check the spelling"),
      ig::diagnostic(IG_ERROR, "SIE-0174", "{0} is not executed: {1}"),
      ig::diagnostic(IG_ERROR, "SIE-0181", "{0} is not executed: its moves are missing from the path"),
      ig::diagnostic(IG_ERROR, "SIE-0182",
                     "{0} is not executed, because a parameter has no value: see the diagnostic before this one"),
      ig::diagnostic(IG_WARNING, "SIE-0184",
                     "{0} has {1} parameters, but only the first {2} are used: check the commas of the call"),
  };

  // Messages and pictures; what the path is measured on; other channels; couplings of spindles, and the end of
  // couplings, of the handwheel's offset and of synchronized actions, which are not executed either.
  ig::TextOption silent_list_{
      "silent",
      "MSG WORKPIECE GROUP_BEGIN GROUP_END GROUP_ADDEND E_END SETMS FGROUP CYCLE832 WAITM WAITMC SETM "
      "CLEARM WAITS WAITP WAITE COUPDEF COUPDEL COUPON COUPONC COUPOF COUPOFS COUPRES WRITE DELETE BRISKA SOFTA "
      "DRIVEA JERKA IPOBRKA ADISPOSA NEWCONF TMON TMOF RESETMON SETPIECE CHKDNO CHKDM GWPSON GWPSOF TANGOF TANGDEL "
      "TLIFT TRAILOF LEADOF EGOFS EGOFC EGDEL MASLOF MASLOFS MASLDEL CTABDEL CTABLOCK CTABUNLOCK TOFFOF SPCON SPCOF "
      "WAITENC GET GETD RELEASE AXTOCHAN INIT CANCEL LOCK UNLOCK RESET CLRINT ENABLE DISABLE CALLPATH PROTA PROTS "
      "PROTD "
      "CPROT CPROTDEF NPROT NPROTDEF FCTDEF CORROF DRFOF IPTRLOCK IPTRUNLOCK POLFMASK POLFMLIN BLSYNC",
      "Procedures of the control that move nothing and change nothing here."};
  std::vector<CycleFields> cycles_ = all_cycles();
  ig::Codes modal_{{"MCALL"}, ig::read};
  ig::Codes traori_{{"TRAORI"}, ig::write};
  ig::TextField message_{"Message.Text", ig::write, {ig::Life::block, "", "What MSG shows."}};
  ig::Signal modal_call_{"ModalCall.~Begins", ig::write};
  ig::Signal call_{"Parsing.~Call", ig::read | ig::write | ig::wake};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::TextField file_{"SubProgramCall.FileName", ig::write};
  Environment environment_;
  NameSet silent_{silent_list_.text()};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t end = skip_name(text, position);
    const bool is_l = to_upper(text[position]) == 'L' && end > position + 1 && skip_digits(text, position + 1) == end;
    const std::string* const macro = macro_at(text, position, end);
    if (macro == nullptr && (end - position < 2 || (is_digit(at(text, position + 1)) && !is_l))) return position;
    if (environment_.flow.is_indexing()) {
      for (const CycleSignature& s : pattern_signatures)
        if (equals_ignoring_case(piece(text, position, end), s.name))
          environment_.flow.label(b, pattern_label(environment_.flow.here(b).line));
      return statement_end(text, position);
    }
    std::string name = upper(piece(text, position, end));
    if (macro != nullptr) return expand(b, text, position, end, *macro);
    begin_ = position;
    std::size_t next = skip_blanks(text, end);
    if (is_synchronized(text, position, name)) {
      const std::size_t last = statement_text_end(text, position);
      b.report(ig::diag("SIE-0168"), ig::Where::columns(position, last), piece(text, position, last));
      return statement_end(text, position);
    }
    if (const auto behind = curve(b, name, text, position, next)) return *behind;
    environment_.enter(b);
    arguments_.clear();
    if (name == "CALL" || name == "PCALL" || name == "EXTCALL" || name == "ISOCALL")
      return indirect(b, text.substr(0, statement_text_end(text, position)), next, name);
    const bool has_bracket = at(text, next) == '(';
    if (has_bracket) {
      const std::size_t close = skip_call(text, next);
      if (const CycleFields* const cycle = cycle_of(name)) {
        pass(b, *cycle, text, next, close);
        return close;
      }
      if (is_known(b, text, name, next, close)) return name == "SETINT" ? statement_end(text, close) : close;
      if (!read_arguments(b, text.substr(0, close), next)) return close;
      next = skip_blanks(text, close);
    } else if (is_foreign_cycle(name) && !silent_.holds(name)) {
      environment_.report_once(b, ig::diag("SIE-0181"), ig::Where::columns(position, end), position,
                               std::string_view(name));
      return end;
    } else if (const std::string_view missing = not_executed(name); !missing.empty()) {
      b.report(ig::diag("SIE-0174"), ig::Where::columns(position, end), std::string_view(name), missing);
      return end;
    } else if (silent_.holds(name)) {
      if (name == "SETMS") environment_.store().master_spindle.reset();
      return end;
    }
    return request(b, text, next, std::move(name), has_bracket ? next : end);
  }

  /// CTABDEF begins the definition of a curve, CTABEND ends it; cycles and calls in between are part of it. Nothing:
  /// the name is none of that.
  std::optional<std::size_t> curve(ig::Block& b, std::string_view name, std::string_view text, std::size_t position,
                                   std::size_t next) {
    std::uint32_t& begins = environment_.store().curve_begins;
    if (name == "CTABDEF") begins = std::max(environment_.flow.here(b).line, 1u);
    if (begins == 0 || name == "CTABDEF") return std::nullopt;
    if (name == "CTABEND") begins = 0;
    return at(text, next) == '(' ? skip_call(text, next) : skip_name(text, position);
  }

  /// What DEFINE says of the name: one that looks like a code counts, too (DEFINE M6 AS L6).
  const std::string* macro_at(std::string_view text, std::size_t position, std::size_t end) const {
    const VariableStore& store = environment_.store();
    if (is_expanded_ || !store.has_macros() || environment_.flow.is_indexing()) return nullptr;
    return store.macro(upper(piece(text, position, end)));
  }

  /// A name for a call (DEFINE).
  std::size_t expand(ig::Block& b, std::string_view text, std::size_t position, std::size_t end,
                     const std::string& macro) {
    const ExpandedText as(text, position, end, macro);
    const bool is_flow = flow_word(piece(macro, 0, skip_name(macro, 0))) != FlowWord::none;
    is_expanded_ = true;
    const std::size_t behind = is_flow ? position : scan(b, as.text(), position);
    is_expanded_ = false;
    end_ = as.original(end_);
    if (behind <= position || skip_blanks(as.text(), behind) < as.macro_end()) {
      b.report(ig::diag("SIE-0288"), ig::Where::columns(position, end), std::string_view(macro));
      return end;
    }
    return as.original(behind);
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(call_)) return ig::Status::unchanged;
    const auto where = ig::Where::columns(begin_, std::max(end_, begin_));
    b.set(term_, b.symbol(program_));
    if (b.find(modal_)) {
      environment_.store().modal = {program_, std::move(arguments_), environment_.flow.frame(b).id};
      b.raise(modal_call_);
      return ig::Status::changed;
    }
    if (repeats_ < 1) return ig::Status::changed;
    const ig_text file = ig::to_text(program_);
    ig::Flow::Call call;
    call.program = program_;
    call.files = {&file, 1};
    call.repeats = static_cast<std::uint32_t>(repeats_);
    call.tag = environment_.store().pass(std::move(arguments_));
    const ig::Flow::Answer answer = environment_.flow.call(b, call);
    if (answer.is_not_found())
      environment_.report_once(b, ig::diag("SIE-0165"), where, begin_, std::string_view(program_), answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("SIE-0167"), where, std::string_view(program_));
    return ig::Status::changed;
  }

 private:
  static std::vector<CycleFields> all_cycles() {
    std::vector<CycleFields> out;
    for (const CycleSignature& s : drilling_signatures) out.emplace_back(s, ig::write);
    for (const CycleSignature& s : pattern_signatures) out.emplace_back(s, ig::write);
    out.emplace_back(swivel_signature, ig::write);
    return out;
  }
  const CycleFields* cycle_of(std::string_view name) const {
    for (const CycleFields& c : cycles_)
      if (c.name() == name) return &c;
    return nullptr;
  }
  /// Cycles of the control that are not executed here.
  static bool is_foreign_cycle(std::string_view name) {
    for (const std::string_view family : {"CYCLE", "POCKET", "SLOT", "HOLES", "LONGHOLE"})
      if (name.starts_with(family) && skip_digits(name, family.size()) == name.size() &&
          (name.size() > family.size() || family == "LONGHOLE"))
        return true;
    return is_shopmill_step(name);
  }
  /// E_DR(…), E_MI_PL(…), E_PS_CIR(…): what a work step of ShopMill drills and mills, and where.
  static bool is_shopmill_step(std::string_view name) {
    if (name == "E_CON" || name == "E_DR") return true;
    for (const std::string_view family : {"E_CP_", "E_DR_", "E_MI_", "E_PI_", "E_PO_", "E_PS_", "E_SL_"})
      if (name.starts_with(family)) return true;
    return false;
  }
  static bool is_synchronized(std::string_view text, std::size_t position, std::string_view name) {
    for (const std::string_view word : {"WHEN", "WHENEVER", "EVERY", "FROM", "DO"})
      if (name == word) return true;
    return (name == "ID" || name == "IDS") && at(text, skip_blanks(text, skip_name(text, position))) == '=';
  }

  /// What is missing of a procedure that changes the path.
  static std::string_view not_executed(std::string_view name) {
    struct Known {
      std::string_view name, missing;
    };
    static constexpr std::string_view origin = "the axis counts from its origin of before",
                                      coupled = "the axis that follows another one stands still",
                                      values = "what it would answer is not known",
                                      tools = "the table of tools stays as it is",
                                      axes = "axes, frames and kinematics stay as they are",
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

  /// SETMS(2): what S and M3 mean from here on.
  void name_master(ig::Block& b, std::string_view text, std::size_t open) {
    if (!read_arguments(b, text, open)) return;
    environment_.store().master_spindle.reset();
    if (!arguments_.empty() && arguments_[0].value && !arguments_[0].value->is_text())
      environment_.store().master_spindle =
          static_cast<std::int64_t>(std::fmax(0, std::fmin(std::round(arguments_[0].value->number), 999)));
  }

  /// GETEXET(NUMBER) and GETSELT(NUMBER): the tool in the spindle, and the one that T has named.
  void give_tool(ig::Block& b, std::string_view text, std::size_t open, std::string_view tool, ig::Where where) {
    if (!read_arguments(b, text, open)) return;
    Variable* const variable = arguments_.empty() ? nullptr : environment_.store().find(arguments_[0].name);
    if (variable == nullptr || variable->value.is_text())
      b.report(ig::diag("SIE-0169"), where, text.substr(open));
    else
      variable->value.number = environment_.system.read(b, tool).value_or(0);
  }

  /// MSG("…"), SETAL(65000), cycles that are not executed. False: a subprogram.
  bool is_known(ig::Block& b, std::string_view text, const std::string& name, std::size_t open, std::size_t close) {
    const auto where = ig::Where::columns(begin_, close);
    if (is_foreign_cycle(name) && !silent_.holds(name)) {
      environment_.report_once(b, ig::diag("SIE-0181"), where, begin_, std::string_view(name));
      return true;
    }
    if (name == "SETAL") {
      if (read_arguments(b, text.substr(0, close), open))
        b.report(ig::diag("SIE-0170"), where,
                 arguments_.empty() || !arguments_[0].value ? 0.0 : arguments_[0].value->number);
      b.alarm();
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

  // ---- Parameters

  bool read_arguments(ig::Block& b, std::string_view text, std::size_t open) {
    std::size_t next = skip_blanks(text, open + 1);
    if (at(text, next) == ')') return true;
    for (;;) {
      Argument& argument = arguments_.emplace_back();
      next = skip_blanks(text, next);
      if (const char c = at(text, next); c != ',' && c != ')') {
        Expression e(b, environment_, text, next);
        argument.value = e.value();
        if (!argument.value) return false;
        name_of(b, text, next, e.position(), argument);
        next = skip_blanks(text, e.position());
      }
      if (at(text, next) == ')') return true;
      if (at(text, next) != ',' || arguments_.size() > 1000) {
        b.report(ig::diag("SIE-0169"), ig::Where::columns(next, std::max(next + 1, text.size())),
                 text.substr(std::min(next, text.size())));
        return false;
      }
      ++next;
    }
  }

  /// Where a variable alone stands, a VAR parameter may change it.
  void name_of(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, Argument& argument) const {
    if (!is_name_start(text[begin])) return;
    const std::size_t open = skip_blanks(text, skip_name(text, begin));
    if (at(text, open) != '[' && open != skip_blanks(text, end)) return;
    Expression variable(b, environment_, text, begin);
    const auto reference = variable.reference();
    if (!reference || skip_blanks(text, variable.position()) != skip_blanks(text, end)) return;
    argument.name = reference->name;
    argument.elements = environment_.store().elements(argument.name);
    if (const Variable* const passed = environment_.store().find(argument.name)) argument.sizes = passed->sizes;
  }

  void pass(ig::Block& b, const CycleFields& cycle, std::string_view text, std::size_t open, std::size_t close) {
    if (!read_arguments(b, text.substr(0, close), open)) {
      b.report(ig::diag("SIE-0182"), ig::Where::columns(begin_, close), cycle.name());
      return;
    }
    if (arguments_.size() > cycle.size())
      b.report(ig::diag("SIE-0184"), ig::Where::columns(begin_, close), cycle.name(),
               static_cast<double>(arguments_.size()), static_cast<double>(cycle.size()));
    std::array<ig_word, CycleFields::most + 1> words;
    std::uint32_t count = 0;
    const std::uint16_t begin = column(begin_), end = column(close);
    words[count++] = {cycle.code().code(0), begin, end, ig_value{}, 0, 0};
    for (std::size_t i = 0; i < std::min(arguments_.size(), cycle.size()); ++i) {
      const std::optional<Value>& v = arguments_[i].value;
      if (!v) continue;
      if (v->is_text() && v->text.empty() && cycle.parameter(i) != "TC") continue;
      // Of texts counts whether they are there; "0" of a swivel data set is none.
      const double number = v->is_text() ? (v->text == "0" ? 0.0 : 1.0) : v->number;
      words[count++] = {cycle.field(i).id(), begin, end, {.number = number + 0.0}, 0, 0};
    }
    b.set_words(words.data(), count);
  }

  // ---- Subprograms

  /// CALL "NAME", EXTCALL("FOLDER/NAME.SPF"), PCALL NAME(1,2)
  std::size_t indirect(ig::Block& b, std::string_view text, std::size_t next, const std::string& how) {
    const bool is_name = is_name_start(at(text, next));
    const std::size_t name_end = skip_name(text, next);
    std::string name = upper(piece(text, next, name_end));
    const Variable* const variable = is_name ? environment_.store().find(name) : nullptr;
    if (name == "BLOCK") {
      b.report(ig::diag("SIE-0171"), ig::Where::columns(begin_, text.size()), text.substr(begin_));
      return text.size();
    }
    if (!is_name || (variable != nullptr && variable->value.is_text())) {
      Expression e(b, environment_, text, next);
      const auto path = e.value();
      if (!path || !path->is_text()) {
        if (path || next >= text.size())
          b.report(ig::diag("SIE-0169"), ig::Where::columns(begin_, text.size()), text.substr(begin_));
        return text.size();
      }
      name = program_of(path->text);
      next = e.position();
    } else {
      next = skip_blanks(text, name_end);
      if (at(text, next) == '(') {
        const std::size_t close = skip_call(text, next);
        if (!read_arguments(b, text.substr(0, close), next)) return text.size();
        next = close;
      }
    }
    next = skip_blanks(text, next);
    if (next < text.size() && how == "CALL") {
      b.report(ig::diag("SIE-0171"), ig::Where::columns(begin_, text.size()), text.substr(begin_));
      return text.size();
    }
    return request(b, text, next, std::move(name), next);
  }

  /// NAME of /_N_SPF_DIR/_N_NAME_SPF, FOLDER\NAME.SPF and NAME.
  static std::string program_of(std::string_view path) {
    path.remove_prefix(std::min(path.find_last_of("/\\:") + 1, path.size()));
    std::string name = upper(trim(path.substr(0, path.find('.'))));
    if (name.starts_with("_N_")) name.erase(0, 3);
    for (const std::string_view kind : {"_SPF", "_MPF"})
      if (name.size() > 4 && name.ends_with(kind)) name.erase(name.size() - 4);
    return name;
  }

  /// P3 or P=R1 behind the name; `next` is where it may stand.
  std::size_t request(ig::Block& b, std::string_view text, std::size_t next, std::string name, std::size_t end) {
    repeats_ = 1;
    end_ = end;
    const char behind = at(text, next + 1);
    if (to_upper(at(text, next)) == 'P' && !is_name_start(behind)) {
      std::size_t value = skip_blanks(text, next + 1);
      if (at(text, value) == '=') value = skip_blanks(text, value + 1);
      Expression e(b, environment_, text, value);
      const auto times = e.number();
      if (!times) return std::max(e.position(), value);
      end_ = e.position();
      repeats_ = *times;
      if (!(repeats_ >= 0 && repeats_ <= 9999) || repeats_ != std::floor(repeats_)) {
        b.report(ig::diag("SIE-0172"), ig::Where::columns(next, end_), std::string_view(name), *times);
        repeats_ = 0;
        return end_;
      }
    }
    if (const std::size_t rest = skip_blanks(text, end_); !is_alone(text, rest)) {
      const std::size_t last = statement_text_end(text, rest);
      environment_.report_once(b, ig::diag("SIE-0173"), ig::Where::columns(begin_, last), begin_,
                               std::string_view(name), piece(text, rest, last));
      return statement_end(text, rest);
    }
    if (b.is_raised(call_)) {
      b.report(ig::diag("SIE-0167"), ig::Where::columns(begin_, end_), std::string_view(name));
      return statement_end(text, end_);
    }
    program_ = std::move(name);
    b.raise(call_);
    return end_;
  }

  /// Behind a call: nothing, or a word, which stands wrong, but is read. Else the line is no statement at all.
  static bool is_alone(std::string_view text, std::size_t rest) {
    if (rest >= text.size() || std::string_view(";\r\n").find(text[rest]) != std::string_view::npos) return true;
    return is_name_start(text[rest]) && !is_name_start(at(text, rest + 1));
  }

  // What scan() has found.
  std::size_t begin_ = 0, end_ = 0;
  std::string program_;
  std::vector<Argument> arguments_;
  double repeats_ = 1;
  bool is_expanded_ = false;  // the text is what DEFINE says
};

const ig::Register<SiemensCall> siemens_call_syntax;

}  // namespace
}  // namespace siemens
