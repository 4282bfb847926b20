/// PROC … SAVE: at the end of the subprogram the modal codes and the programmable frame become those of the caller
/// again. They are written as codes of the block that ends it (M17) or, where that one moves or sets something itself,
/// of the block that comes next, whose own codes win.
#include <string>
#include <vector>

#include "frames/assigned_frame.hpp"
#include "frames/settable_frames.hpp"
#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

/// A group of modal codes, the field that names the one in force, and the one that is in force before any.
struct SavedGroup {
  ig::Codes codes;
  ig::In<ig::Symbol> term;
  ig::Name first;
};

struct SiemensSave {
  static constexpr auto spec =
      ig::syntax("SiemensSaveSyntax", "SAVE: a subprogram gives its caller the modal codes and the frame back.")
          .after("SiemensDeclarationSyntax", "SiemensWordSyntax", "SiemensCallSyntax")
          .before("ParameterizedFlagSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SIE-0163", "SAVE does not restore {0}: program it again after the call"),
  };

  Environment environment_;
  ig::Signal begins_{"SiemensSave.~Begins", ig::read | ig::wake};
  ig::Signal holds_{"SiemensSave.~Holds", ig::write | ig::wake_while, ig::Life::modal};
  std::array<SavedGroup, 7> groups_{group({"G00", "G01", "G02", "G03", "CIP"}, "MotionState.Term", "G01"),
                                    group({"G93", "G94", "G95", "G96", "G97"}, "Feedrate.Term", "G94"),
                                    group({"G17", "G18", "G19"}, "PlaneSelect.Term", "G17"),
                                    group({"G40", "G41", "G42"}, "RadiusCompensation.Term", "G40"),
                                    group({"G70", "G71", "G700", "G710"}, "Unit.Term", "G710"),
                                    group({"G90", "G91"}, "PositioningMode.Term", "G90"),
                                    group({"DIAMON", "DIAM90", "DIAMOF"}, "DiameterProgramming.Term", "DIAMOF",
                                          {ig::Life::modal, "", "DIAMON or DIAM90, while X is a diameter."})};
  // Further codes of the groups of motion and feed: a block that has one of them has its code.
  ig::Call threads_{{"G33", "G34", "G35", "G331", "G332"}, "", ig::read};
  ig::Call curves_{{"CT", "POLY", "ASPLINE", "BSPLINE", "CSPLINE", "INVCW", "INVCCW"}, "", ig::read};
  ig::Codes rates_{{"G961", "G962", "G971", "G972"}, ig::read};
  ig::Call other_rates_{{"G931", "G942", "G952", "G973"}, "", ig::read};
  ig::In<ig::Symbol> thread_{"ThreadCutting.Term",
                             ig::read,
                             {ig::Life::modal, "", "G33, G331 or G332, as long as no other motion code comes."}};
  ig::In<ig::Symbol> surface_speed_{"SpindleSpeed.Term"};
  ig::In<ig::Symbol> returned_{"SubProgramReturn.Term"};
  SettableFrames frames_{ig::read | ig::write};
  AssignedFrame frame_{ig::read | ig::write};
  ig::Name g96_{"G96"};

  ig::Status restart(ig::Block&) {
    saved_.clear();
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    const ig_frame here = environment_.flow.frame(b);
    bool any = b.is_fresh(returned_) && is_bare_end(b.source()) && !saved_.empty() && saved_.back().frame == here.id;
    if (any) {
      restore(b, saved_.back());
      saved_.pop_back();
    }
    while (!saved_.empty() && saved_.back().frame != here.id && saved_.back().depth >= here.depth) {
      restore(b, saved_.back());
      saved_.pop_back();
      any = true;
    }
    if (b.is_raised(begins_) && here.depth > 0) {
      any = true;
      const bool is_known = !saved_.empty() && saved_.back().frame == here.id;
      if (!is_known) save(b, here);
      if (is_known && saved_.back().pass != here.pass) {  // NAME P3; a jump back to PROC is no further pass
        restore(b, saved_.back());
        saved_.back().pass = here.pass;
      }
    }
    if (any && saved_.empty())
      b.erase(holds_);
    else if (any)
      b.raise(holds_);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static constexpr std::size_t motion = 0, feed = 1;

  static SavedGroup group(std::initializer_list<std::string_view> codes, std::string_view term, const char* first,
                          ig::About about = {}) {
    return {ig::Codes{codes, ig::read | ig::write}, ig::In<ig::Symbol>{term, ig::read, about}, ig::Name{first}};
  }

  /// N40 M17, and nothing else.
  static bool is_bare_end(std::string_view text) {
    text = trim(piece(text, 0, statement_text_end(text, 0)));
    if (!text.empty() && to_upper(text[0]) == 'N') text.remove_prefix(skip_blanks(text, skip_digits(text, 1)));
    for (const std::string_view end : {"M17", "RET", "M30", "M2", "M02"})
      if (equals_ignoring_case(text, end)) return true;
    return false;
  }

  /// What the caller of a subprogram has in force.
  struct Saved {
    std::uint64_t frame;
    std::uint32_t depth, pass;
    std::array<ig::Symbol, 7> terms;
    ig::Symbol thread, settable;
    std::optional<FrameValue> programmable;
  };

  ig::Symbol in_force(const ig::Block& b, std::size_t i) const {
    if (i == feed && b.is(surface_speed_, g96_)) return g96_;
    return b.get_or(groups_[i].term, static_cast<ig::Symbol>(groups_[i].first));
  }

  bool has_code_of(const ig::Block& b, std::size_t i) const {
    if (i == motion && (b.find(threads_) || b.find(curves_))) return true;
    if (i == feed && (b.find(rates_) || b.find(other_rates_))) return true;
    return b.find(groups_[i].codes).has_value();
  }

  void save(ig::Block& b, const ig_frame& here) {
    Saved now{here.id,
              here.depth,
              here.pass,
              {},
              b.get_or(thread_, ig::Symbol{}),
              frames_.in_force(b).id,
              environment_.system.frame(b, "$P_PFRAME")};
    for (std::size_t i = 0; i < groups_.size(); ++i) now.terms[i] = in_force(b, i);
    if (!now.programmable)
      b.report(ig::diag("SIE-0163"), ig::Where::block(),
               std::string_view("the frame of the caller, whose axes are not square"));
    saved_.push_back(now);
  }

  void restore(ig::Block& b, const Saved& saved) const {
    if (saved.thread != ig::Symbol{} && b.get_or(thread_, ig::Symbol{}) != saved.thread && !has_code_of(b, motion))
      b.report(ig::diag("SIE-0163"), ig::Where::block(), b.text(saved.thread));
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (has_code_of(b, i) || in_force(b, i) == saved.terms[i]) continue;
      const ig::Codes& codes = groups_[i].codes;
      for (std::size_t code = 0; code < codes.size(); ++code)
        if (codes.name(code) == saved.terms[i]) put(b, codes.id(code));
    }
    if (!frames_.find(b) && frames_.in_force(b).id != saved.settable)
      for (std::size_t i = 0; i < settable_frames; ++i)
        if (frames_.name(i) == saved.settable) put(b, frames_.id(i));
    const auto present = environment_.system.frame(b, "$P_PFRAME");
    if (saved.programmable && !frame_.get(b) && (!present || present->text() != saved.programmable->text()))
      frame_.set(b, *saved.programmable);
  }

  static void put(ig::Block& b, ig_field code) { b.set_word(ig_word{code, 0, 0, ig_value{}, 0, 0}); }

  std::vector<Saved> saved_;
};

const ig::Register<SiemensSave> siemens_save_syntax;

}  // namespace
}  // namespace siemens
