/// Functions of the control that are known by name but not executed: each is one error that says what is missing, and
/// its words are taken with it.
#include <algorithm>
#include <vector>

#include <isogloss/cnc/recognised_codes.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensCode {
  static constexpr auto spec =
      ig::syntax("SiemensCodeSyntax", "Codes that are recognised but not executed: one error each.")
          .after("ParameterizedFlagSyntax")
          .before("SiemensPositionSyntax", "ProgramXyzSyntax");

  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SIE-0375", "{0}: {1} are not watched, so nothing is reported where they end a move"),
  };
  static constexpr std::string_view thread = "the thread is not cut; its blocks move with the previous motion code",
                                    feed = "the feed and the speed that it sets are not known",
                                    limits = "the limits of the working area and of the spindle speed",
                                    contour = "the way back to the contour is missing";

  RecognisedCodes codes_{
      ig::diag("SIE-0261"),
      {
          {ig::Call{{"TRANSMIT", "TRACYL", "TRAANG", "TRACON"}, ""},
           "the transformation is missing: machine coordinates are wrong up to TRAFOOF"},
          {ig::Call{{"G335", "G336"}, "I J K CR AR[deg]"}, thread},
          {ig::Call{{"CT", "POLY", "ASPLINE", "BSPLINE", "CSPLINE", "INVCW", "INVCCW"}, ""},
           "the curve is missing; its blocks move with the previous motion code"},
          {ig::Call{{"ROTS", "AROTS", "CROTS"}, "X[deg] Y[deg] Z[deg]"}, "positions are not turned"},
          {ig::Call{{"G58", "G59"}, "X Y Z"}, "positions are not shifted"},
          {ig::Call{{"G147", "G148", "G247", "G248", "G347", "G348"}, ""},
           "the soft approach or retraction is missing"},
          {ig::Call{{"G291"}, ""}, "the blocks up to G290 are ISO code and are read wrong"},
          {ig::Call{{"G973"}, "S[]"}, "the speed of the spindle is not known"},
          {ig::Call{{"G931", "G942", "G952"}, "S[] F[]"}, feed},
          {ig::Call{{"REPOSL", "REPOSQ", "REPOSH", "REPOSA", "REPOSQA", "REPOSHA"}, "DISR DISPR[]"}, contour},
          {ig::Call{{"G461", "G462"}, ""}, "the end of the contour is as under G460"},
          {ig::Call{{"PTP", "PTPG0", "PTPWOC"}, ""}, "blocks go straight in the workpiece"},
          {ig::Call{{"SON", "SONS", "PON", "PONS"}, ""}, "the strokes of the punch are missing"},
          {ig::Call{{"CUTCONON"}, ""}, "the radius goes on being compensated"},
          {ig::Call{{"FTOCON"}, ""}, "the tool is that of the table"},
          {ig::Call{{"TOFRAME", "TOFRAMEX", "TOFRAMEY", "TOFRAMEZ", "TOROT", "TOROTX", "TOROTY", "TOROTZ", "PAROT",
                     "TCOFR", "TCOFRX", "TCOFRY", "TCOFRZ"},
                    ""},
           "positions are not turned with the tool"},
          {ig::Call{{"CUT3DC", "CUT3DF", "CUT3DFF", "CUT3DFS", "CUT3DCC", "CUT3DCCD", "CUT3DCD", "CUT3DFD", "CUT2DD",
                     "CUT2DFD"},
                    ""},
           "the radius is that of the table, and is compensated in the plane only"},
      }};
  RecognisedCodes limits_{ig::diag("SIE-0375"), {{ig::Call{{"G25", "G26"}, "X Y Z S[]"}, limits}}};
  struct Word {
    ig::Word word;
    std::string_view missing;
  };
  std::vector<Word> words_ = declared_words();
  /// A tool that keeps its direction is reported once for each kind of word, since whole programs are full of them.
  struct Direction {
    std::string_view word;
    ig::Signal said;
  };
  std::array<Direction, 7> directions_{
      Direction{"XH", {"SiemensCode.~XhSaid", ig::read | ig::write, ig::Life::modal}},
      Direction{"A4", {"SiemensCode.~A4Said", ig::read | ig::write, ig::Life::modal}},
      Direction{"A5", {"SiemensCode.~A5Said", ig::read | ig::write, ig::Life::modal}},
      Direction{"LEAD", {"SiemensCode.~LeadSaid", ig::read | ig::write, ig::Life::modal}},
      Direction{"TILT", {"SiemensCode.~TiltSaid", ig::read | ig::write, ig::Life::modal}},
      Direction{"A2", {"SiemensCode.~A2Said", ig::read | ig::write, ig::Life::modal}},
      Direction{"A3", {"SiemensCode.~A3Said", ig::read | ig::write, ig::Life::modal}}};

  // Smoothing, limits and the start angle of a thread: they do not change end points. For splines the code itself
  // reports that the curve is missing.
  std::array<ig::Word, 13> quiet_{ig::Word{"Parsing.OVRRAP"}, ig::Word{"Parsing.ALF"},     ig::Word{"Parsing.DILF"},
                                  ig::Word{"Parsing.ADIS"},   ig::Word{"Parsing.ADISPOS"}, ig::Word{"Parsing.CTOL"},
                                  ig::Word{"Parsing.OTOL"},   ig::Word{"Parsing.STOLF"},   ig::Word{"Parsing.LIMS"},
                                  ig::Word{"Parsing.SF"},     ig::Word{"Parsing.SD"},      ig::Word{"Parsing.PW"},
                                  ig::Word{"Parsing.PL"}};

  ig::Status build(ig::Block& b) {
    bool any = codes_.report(b);
    any |= limits_.report(b);
    for (const ig::Word& word : quiet_) any |= b.take(word).has_value();
    std::string_view said;  // of words that belong together the first one is reported
    for (const Word& word : words_) {
      const auto value = b.take(word.word);
      if (!value) continue;
      any = true;
      if (*value == 0 && is_additional(word.missing)) continue;  // its end
      const auto direction = std::find_if(directions_.begin(), directions_.end(),
                                          [&](const Direction& d) { return word.missing.starts_with(d.word); });
      const bool is_direction = direction != directions_.end();
      if (is_direction ? !b.is_raised(direction->said) : word.missing != said)
        b.report(ig::diag("SIE-0262"), ig::Where::word(word.word.id()), word.missing);
      said = word.missing;
      if (is_direction) b.raise(direction->said);
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static bool is_additional(std::string_view missing) {
    return missing.starts_with("OFFN=") || missing.starts_with("DISC=") || missing.starts_with("TOFF") ||
           missing.starts_with("DL=");
  }
  static std::vector<Word> declared_words() {
    struct Known {
      const char* name;
      std::string_view missing;
    };
    static constexpr Known known[] = {{"DISC", "DISC=: outer corners are turned on an arc, as under DISC=0"},
                                      {"OVR", "OVR=: feeds are those of F"},
                                      {"OFFN", "OFFN=: the contour is not offset"},
                                      {"TOFFL", "TOFFL=: the length of the tool is that of the table"},
                                      {"TOFFR", "TOFFR=: the radius of the tool is that of the table"},
                                      {"TOFF", "TOFF=: the tool is that of the table"},
                                      {"DL", "DL=: the additional offset of the edge does not count"},
                                      {"TCARR", "TCARR=: the tool carrier does not count"},
                                      {"LEAD", "LEAD=: the tool keeps its direction"},
                                      {"TILT", "TILT=: the tool keeps its direction"},
                                      {"SPP", "SPP=: the strokes of the punch are missing"},
                                      {"SPN", "SPN=: the strokes of the punch are missing"},
                                      {"SUG", "SUG=: the speed of the grinding wheel is not known"},
                                      {"THETA", "THETA=: the tool does not turn about itself"},
                                      {"ANG1", "ANG1= ANG2=: the corner of two contour lines is not computed"},
                                      {"ANG2", "ANG1= ANG2=: the corner of two contour lines is not computed"},
                                      {"XH", "XH= YH= ZH=: the tool keeps its direction"},
                                      {"YH", "XH= YH= ZH=: the tool keeps its direction"},
                                      {"ZH", "XH= YH= ZH=: the tool keeps its direction"},
                                      {"A4", "A4= B4= C4=: the direction square to the surface does not count"},
                                      {"B4", "A4= B4= C4=: the direction square to the surface does not count"},
                                      {"C4", "A4= B4= C4=: the direction square to the surface does not count"},
                                      {"A5", "A5= B5= C5=: the direction square to the surface does not count"},
                                      {"B5", "A5= B5= C5=: the direction square to the surface does not count"},
                                      {"C5", "A5= B5= C5=: the direction square to the surface does not count"},
                                      {"SVC", "SVC=: the speed of the spindle is not known"},
                                      {"FZ", "FZ=: the feed per tooth is not known"},
                                      {"A2", "A2= B2= C2=: the tool keeps its direction"},
                                      {"B2", "A2= B2= C2=: the tool keeps its direction"},
                                      {"C2", "A2= B2= C2=: the tool keeps its direction"},
                                      {"A3", "A3= B3= C3=: the tool keeps its direction"},
                                      {"B3", "A3= B3= C3=: the tool keeps its direction"},
                                      {"C3", "A3= B3= C3=: the tool keeps its direction"}};
    std::vector<Word> out;
    for (const Known& k : known)
      out.push_back({ig::Word(std::string("Parsing.").append(k.name), ig::wake, ""), k.missing});
    return out;
  }
};

const ig::Register<SiemensCode> siemens_code_syntax;

}  // namespace
}  // namespace siemens
