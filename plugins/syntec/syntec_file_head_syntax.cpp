/// `$2` begins the program of the second axis group: it is not executed, and one diagnostic reports it where it begins,
/// however often the file is called. `$1` begins the program of the first group, which is executed.
#include <isogloss/flow.hpp>
#include <set>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecFileHead {
  static constexpr auto spec = ig::syntax("SyntecFileHeadSyntax", "Rejects the programs of further axis groups.")
                                   .before("TapeBoundarySyntax", "IsoCommentSyntax", "WordSyntax", "FlagSyntax")
                                   .scans("$");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SYN-0004",
                     "${0} begins the program of another axis group: nothing is executed from here to the end of the "
                     "file"),
  };

  ig::TextField text_{"TapeBoundary.Text", ig::read | ig::write};
  ig::Signal declined_{"Source.~Declined", ig::read | ig::write | ig::wake};
  ig::Flow flow_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    std::size_t before = position;  // backwards, because a long line may hold many marks
    while (before > 0 && is_blank(text[before - 1])) --before;
    if (before > 0) return position;
    return axis_group(b, text, position);
  }

  ig::Status restart(ig::Block&) {
    said_.clear();
    return ig::Status::unchanged;
  }

  /// Returns from a called program where it is declined; the run of the main program ends there.
  ig::Status build(ig::Block& b) {
    if (!b.is_raised(declined_)) return ig::Status::unchanged;
    const ig_frame frame = flow_.frame(b);
    const std::string_view head = b.text(text_);
    if (const FileAndHead place{ig::to_view(frame.file), head}; !said_.contains(place)) {
      said_.emplace(place);
      report(b, head);
    }
    if (frame.depth > 0)
      flow_.leave(b);
    else
      b.end_program();
    return ig::Status::unchanged;
  }

 private:
  std::size_t axis_group(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t end = skip_digits(text, position + 1);
    const std::string_view group = piece(text, position + 1, end);
    if (group.empty()) return position;
    return group == "1" ? end : decline(b, text, position, end);
  }

  /// The program ends here, even for text on the same line.
  std::size_t decline(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) const {
    b.set_text(text_, piece(text, begin, end));
    b.raise(declined_);
    b.flow(IG_FLOW_END_FILE);
    return block_end(text, end);
  }

  void report(ig::Block& b, std::string_view head) const {
    b.report(ig::diag("SYN-0004"), ig::Where::word(text_.id()), head.substr(std::min<std::size_t>(head.size(), 1)));
  }

  using FileAndHead = std::pair<std::string_view, std::string_view>;
  struct ByText {
    using is_transparent = void;
    bool operator()(const FileAndHead& a, const FileAndHead& b) const { return a < b; }
  };
  std::set<std::pair<std::string, std::string>, ByText> said_;  ///< of this run
};

const ig::Register<SyntecFileHead> syntec_file_head_syntax;

}  // namespace
}  // namespace syntec
