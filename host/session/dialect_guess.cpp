#include "dialect_guess.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <utility>

#include "isogloss/engine/byte_order_mark.hpp"
#include "isogloss/engine/exporter.hpp"
#include "run_request.hpp"

namespace isogloss {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The first lines of the text, trimmed, without empty ones.
std::vector<std::string> head_lines(std::string_view head) {
  constexpr std::size_t enough = 2000;
  head = behind_byte_order_mark(head);
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < head.size() && lines.size() < enough;) {
    const std::size_t end = std::min(head.find_first_of("\r\n", at), head.size());
    std::string_view line = head.substr(at, end - at);
    at = end + 1;
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (const std::size_t last = line.find_last_not_of(" \t"); last != std::string_view::npos)
      lines.emplace_back(line.substr(0, last + 1));
  }
  return lines;
}

/// The longest literal piece of a pattern: each matching line contains it.
std::string_view fixed_piece(std::string_view pattern) {
  std::string_view best;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t end = std::min(pattern.find_first_of("*?[\\", at), pattern.size());
    if (end - at > best.size()) best = pattern.substr(at, end - at);
    at = end;
    if (at < pattern.size() && pattern[at] == '[') {
      // A bracket that stands first in its set belongs to it.
      at += at + 1 < pattern.size() && (pattern[at + 1] == '!' || pattern[at + 1] == '^') ? 3 : 2;
      at = std::min(pattern.find(']', at), pattern.size());
    } else if (at < pattern.size() && pattern[at] == '\\') {
      ++at;
    }
    ++at;
  }
  return best;
}

/// The sum of the weights of the signatures that match a line. A search for the fixed piece comes before the pattern:
/// it is a tenth of the work.
std::size_t weight_of_signatures(const Dialect& dialect, std::string_view head, const std::vector<std::string>& lines) {
  std::size_t weight = 0;
  for (const Signature& signature : dialect.signatures) {
    const std::string_view piece = fixed_piece(signature.pattern);
    if (head.find(piece) == std::string_view::npos) continue;
    const auto matches = [&](const std::string& line) {
      return line.find(piece) != std::string::npos && ::fnmatch(signature.pattern.c_str(), line.c_str(), 0) == 0;
    };
    if (std::any_of(lines.begin(), lines.end(), matches)) weight += signature.weight;
  }
  return weight;
}

std::size_t weight_of_names(const Dialect& dialect, const std::string& name) {
  std::size_t weight = 0;
  for (const Signature& sign : dialect.names)
    if (::fnmatch(sign.pattern.c_str(), name.c_str(), 0) == 0) weight += sign.weight;
  return weight;
}

struct Candidate {
  const Dialect* dialect = nullptr;
  std::size_t score = 0, of_text = 0, of_name = 0;

  std::string key() const { return dialect->file.empty() ? dialect->name : dialect->file.string(); }
  /// The default dialect wins a tie.
  bool comes_before(const Candidate& other) const {
    if (other.dialect == nullptr || score != other.score) return other.dialect == nullptr || score > other.score;
    return dialect->name == default_dialect;
  }
};

struct Move {
  std::string_view place;    ///< "part.nc,12"
  std::string_view event;    ///< "rapid"
  std::string_view machine;  ///< from the machine coordinates on
  bool is_as(const Move& other) const {
    return place == other.place && event == other.event && machine == other.machine;
  }
};

/// A row of the motion stream, where it is a move.
std::optional<Move> read_move(std::string_view row) {
  constexpr int program_columns = 3;
  for (const std::string_view event : {",rapid,", ",feed,", ",arc,"}) {
    const std::size_t at = row.rfind(event);
    if (at == std::string_view::npos) continue;
    std::size_t machine = at + event.size();
    for (int i = 0; i < program_columns; ++i) machine = row.find(',', machine) + 1;
    return Move{row.substr(0, at), event.substr(1, event.size() - 2), row.substr(machine)};
  }
  return std::nullopt;
}

/// The moves of a run, up to its budget.
class Moves : public Output {
 public:
  bool write(std::string_view bytes) override {
    constexpr std::size_t enough = 1u << 20;
    text_.append(bytes);
    return text_.size() < enough;
  }

  void run(const LinkedDialect& dialect, const std::string& path, std::string_view head, RunOptions options) {
    constexpr std::uint64_t blocks = 2000;
    options.maximum_blocks = options.maximum_blocks == 0 ? blocks : std::min(options.maximum_blocks, blocks);
    const std::unique_ptr<Source> source = memory_source(head);
    const std::unique_ptr<Exporter> exporter = make_motion_exporter(*this, {Format::csv, false, false, false, {}});
    DiagnosticList ignored;
    const RunResult result = isogloss::run(dialect, *source, path, options, {exporter.get()}, ignored);
    is_cut_ = result.output_closed || result.blocks >= options.maximum_blocks;
    std::string_view rest = text_;
    for (std::size_t end = 0; (end = rest.find('\n')) != std::string_view::npos; rest.remove_prefix(end + 1))
      if (const std::optional<Move> move = read_move(rest.substr(0, end))) moves_.push_back(*move);
  }

  /// The place of the first move that the other run makes differently, or not at all.
  std::optional<std::string_view> parts_at(const Moves& other) const {
    const std::size_t both = std::min(moves_.size(), other.moves_.size());
    for (std::size_t i = 0; i < both; ++i)
      if (!moves_[i].is_as(other.moves_[i])) return moves_[i].place;
    if (moves_.size() > both && !other.is_cut_) return moves_[both].place;
    if (other.moves_.size() > both && !is_cut_) return other.moves_[both].place;
    return std::nullopt;
  }

 private:
  std::string text_;
  std::vector<Move> moves_;
  bool is_cut_ = false;
};

}  // namespace

std::optional<Guess> guess_dialect(const std::string& path, std::string_view head, Workspace& workspace) {
  const std::string extension = lower(std::filesystem::path(path).extension().string());
  const std::string name = lower(std::filesystem::path(path).stem().string());
  const std::vector<std::string> lines = head_lines(head);
  const std::vector<Dialect> dialects = workspace.reader().list();
  Candidate best, next;
  for (const Dialect& d : dialects) {
    const bool fits = std::any_of(d.extensions.begin(), d.extensions.end(),
                                  [&](const std::string& e) { return lower(e) == extension; });
    constexpr std::size_t extension_weight = 2;
    Candidate candidate{&d, 0, weight_of_signatures(d, head, lines), weight_of_names(d, name)};
    candidate.score =
        candidate.of_text + candidate.of_name + (fits ? extension_weight : 0) + (d.name == default_dialect ? 1 : 0);
    if (candidate.comes_before(best))
      next = std::exchange(best, candidate);
    else if (candidate.comes_before(next))
      next = candidate;
  }
  if (best.dialect == nullptr) {
    workspace.report("IG-0512", {path}, {});
    return std::nullopt;
  }
  Guess guess{best.key(), best.dialect->name, {}, {}, {}};
  guess.why = best.of_name > best.of_text ? "from the name of the file"
              : best.of_text > 0          ? "from the text of the program"
              : best.score >= 2           ? "from the extension " + extension
                                          : "nothing identifies the dialect";
  if (next.score > 0 && best.score - next.score < Signature::usual_weight) {
    guess.next = next.key();
    guess.next_name = next.dialect->name;
  }
  return guess;
}

void report_guess(const std::string& path, const Guess& guess, const std::string& parting, Workspace& workspace) {
  workspace.report("IG-0514", {path}, {guess.name, guess.why + parting});
}

std::optional<std::string> guessed(const std::string& path, std::string_view head, Workspace& workspace) {
  const std::optional<Guess> guess = guess_dialect(path, head, workspace);
  if (!guess) return std::nullopt;
  report_guess(path, *guess, {}, workspace);
  return guess->dialect;
}

std::string where_moves_part(const LinkedDialect& taken, const LinkedDialect& next, const std::string& path,
                             std::string_view head, const RunOptions& options) {
  // The last line may be cut off.
  if (head.size() >= guessed_head_bytes) head = head.substr(0, head.rfind('\n') + 1);
  try {
    Moves of_taken, of_next;
    of_taken.run(taken, path, head, options);
    of_next.run(next, path, head, options);
    const std::optional<std::string_view> place = of_taken.parts_at(of_next);
    if (!place) return {};
    const std::size_t comma = place->rfind(',');
    const std::string line = "line " + std::string(place->substr(comma + 1)), file(place->substr(0, comma));
    return file == path || file.starts_with('"') ? line : line + " of " + file;
  } catch (const std::exception&) {
    return {};  // the run itself reports what is wrong
  }
}

std::string parting(const Guess& guess, const LinkedDialect& taken, const LinkedDialect& next, const std::string& path,
                    std::string_view head, RunOptions options) {
  add_program_places(path, taken.dialect, options);
  const std::string place = where_moves_part(taken, next, path, head, options);
  return place.empty() ? "" : "; " + guess.next_name + ", the next candidate, moves differently from " + place + " on";
}

}  // namespace isogloss
