/// PROC … SAVE: behind the end of the subprogram the modal codes and the programmable frame are those of the caller
/// again. They are written as codes of the block that comes next; a code of that block itself wins.
#include <string>
#include <vector>

#include "frames/assigned_frame.hpp"
#include "frames/settable_frames.hpp"
#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

/// A group of modal codes, and the field that names the one in force.
struct SavedGroup {
  ig::Codes codes;
  ig::In<ig::Symbol> term;
};

struct SiemensSave {
  static constexpr auto spec =
      ig::syntax("SiemensSaveSyntax", "SAVE: a subprogram gives its caller the modal codes and the frame back.")
          .after("SiemensDeclarationSyntax", "SiemensWordSyntax", "SiemensCallSyntax")
          .before("ParameterizedFlagSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SIE-0163",
                     "SAVE does not restore the frame of the caller, whose axes are not square: program it after the "
                     "call"),
  };

  Environment environment_;
  ig::Signal begins_{"SiemensSave.~Begins", ig::read | ig::wake};
  ig::Signal holds_{"SiemensSave.~Holds", ig::write | ig::wake_while, ig::Life::modal};
  std::array<SavedGroup, 6> groups_{
      SavedGroup{ig::Codes{{"G00", "G01", "G02", "G03", "CIP"}, ig::read | ig::write},
                 ig::In<ig::Symbol>{"MotionState.Term"}},
      SavedGroup{ig::Codes{{"G17", "G18", "G19"}, ig::read | ig::write}, ig::In<ig::Symbol>{"PlaneSelect.Term"}},
      SavedGroup{ig::Codes{{"G40", "G41", "G42"}, ig::read | ig::write}, ig::In<ig::Symbol>{"RadiusCompensation.Term"}},
      SavedGroup{ig::Codes{{"G70", "G71", "G700", "G710"}, ig::read | ig::write}, ig::In<ig::Symbol>{"Unit.Term"}},
      SavedGroup{ig::Codes{{"G90", "G91"}, ig::read | ig::write}, ig::In<ig::Symbol>{"PositioningMode.Term"}},
      SavedGroup{ig::Codes{{"G93", "G94", "G95", "G96", "G97"}, ig::read | ig::write},
                 ig::In<ig::Symbol>{"Feedrate.Term"}}};
  SettableFrames frames_{ig::read | ig::write};
  AssignedFrame frame_{ig::read | ig::write};
  ig::Name g40_{"G40"};

  ig::Status restart(ig::Block&) {
    saved_.clear();
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    const ig_frame here = environment_.flow.frame(b);
    bool any = false;
    while (!saved_.empty() && saved_.back().depth > here.depth) {
      restore(b, saved_.back());
      saved_.pop_back();
      any = true;
    }
    if (b.is_raised(begins_) && here.depth > 0) {
      any = true;
      if (!saved_.empty() && saved_.back().frame == here.id)
        restore(b, saved_.back());  // the next pass of NAME P3
      else
        save(b, here);
    }
    if (any && saved_.empty())
      b.erase(holds_);
    else if (any)
      b.raise(holds_);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static constexpr std::size_t compensation = 2;

  /// What the caller of a subprogram has in force.
  struct Saved {
    std::uint64_t frame;
    std::uint32_t depth;
    std::array<ig::Symbol, 6> terms;
    ig::Symbol settable;
    std::optional<FrameValue> programmable;
  };

  /// Before the first G41 or G42 the state names no code of their group.
  ig::Symbol in_force(const ig::Block& b, const SavedGroup& group) const {
    const bool is_compensation = &group == &groups_[compensation];
    return b.get_or(group.term, is_compensation ? static_cast<ig::Symbol>(g40_) : ig::Symbol{});
  }

  void save(ig::Block& b, const ig_frame& here) {
    Saved now{here.id, here.depth, {}, frames_.in_force(b).id, environment_.system.frame(b, "$P_PFRAME")};
    for (std::size_t i = 0; i < groups_.size(); ++i) now.terms[i] = in_force(b, groups_[i]);
    if (!now.programmable) b.report(ig::diag("SIE-0163"), ig::Where::block());
    saved_.push_back(now);
  }

  void restore(ig::Block& b, const Saved& saved) const {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const SavedGroup& group = groups_[i];
      if (b.find(group.codes) || in_force(b, group) == saved.terms[i]) continue;
      for (std::size_t code = 0; code < group.codes.size(); ++code)
        if (group.codes.name(code) == saved.terms[i]) put(b, group.codes.id(code));
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
