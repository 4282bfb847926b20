// A root dialect lists its chain: elements move to other lines. A dialect that extends another has edits: an edit gets
// another anchor, and what is inherited is removed and put in again.
#include "dialect/order_patch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "dialect/text_edits.hpp"
#include "markup.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace {

namespace fs = std::filesystem;

/// The elements that move: all but the longest part that stays, in which an inherited one weighs more.
std::set<std::string> moved_elements(const Dialect& dialect, const std::vector<std::string>& wanted) {
  const std::vector<ChainElement>& now = dialect.chain;
  const auto weight = [&](const ChainElement& e) { return e.where.file == dialect.file.string() ? 1u : 1000u; };
  std::vector<std::vector<std::size_t>> common(now.size() + 1, std::vector<std::size_t>(wanted.size() + 1));
  for (std::size_t i = now.size(); i-- > 0;)
    for (std::size_t j = wanted.size(); j-- > 0;)
      common[i][j] = now[i].alias == wanted[j] ? common[i + 1][j + 1] + weight(now[i])
                                               : std::max(common[i + 1][j], common[i][j + 1]);
  std::set<std::string> out;
  for (const ChainElement& e : now) out.insert(e.alias);
  for (std::size_t i = 0, j = 0; i < now.size() && j < wanted.size();) {
    if (now[i].alias == wanted[j])
      out.erase(now[i].alias), ++i, ++j;
    else
      common[i + 1][j] >= common[i][j + 1] ? ++i : ++j;
  }
  return out;
}

class Mover {
 public:
  Mover(const Dialect& dialect, const std::vector<std::string>& wanted, const std::string& text)
      : dialect_(dialect), edits_(text), moved_(moved_elements(dialect, wanted)), wanted_(wanted) {
    for (const ChainElement& e : dialect.chain) elements_[e.alias] = &e;
  }

  std::string apply(std::string& reason) {
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (!moved_.contains(wanted_[i])) continue;
      std::vector<const ChainElement*> run;  // those that stand beside each other move together
      const Stage stage = elements_[wanted_[i]]->stage;
      std::size_t end = i;
      while (end < wanted_.size() && moved_.contains(wanted_[end]) && elements_[wanted_[end]]->stage == stage)
        run.push_back(elements_[wanted_[end++]]);
      const auto neighbour = [&](bool exists, std::size_t at) -> const ChainElement* {
        return exists && elements_[wanted_[at]]->stage == stage ? elements_[wanted_[at]] : nullptr;
      };
      const ChainElement* const previous = neighbour(i > 0, i - 1);
      const ChainElement* const next = neighbour(end < wanted_.size(), end);
      reason = dialect_.ancestors.empty() ? move_lines(run, previous, next) : move_edits(run, previous, next);
      if (!reason.empty()) return {};
      i = end - 1;
    }
    return edits_.apply();
  }

 private:
  bool is_own(const Location& where) const { return where.file == dialect_.file.string(); }

  std::string move_lines(const std::vector<const ChainElement*>& run, const ChainElement* previous,
                         const ChainElement* next) {
    if (previous == nullptr && next == nullptr) return "a whole stage would move";
    const std::size_t at = edits_.offset((previous != nullptr ? previous : next)->where);
    const std::string blanks = edits_.indentation(at);
    for (const ChainElement* const e : run) {
      const std::size_t begin = edits_.offset(e->where);
      edits_.remove(begin);
      if (previous != nullptr)
        edits_.replace(edits_.end_of(at), edits_.end_of(at), edits_.line_end() + blanks + edits_.element(begin));
      else
        edits_.replace(at, at, edits_.element(begin) + edits_.line_end() + blanks);
    }
    return {};
  }

  /// The number of the edit that puts the element in: 0 for what is inherited, else from 1.
  std::size_t placed_by(const std::string& alias) const {
    for (std::size_t i = dialect_.edits.size(); i-- > 0;) {
      const AppliedEdit& edit = dialect_.edits[i];
      if (edit.of_dependency || edit.dialect != dialect_.name) continue;
      if (std::find(edit.elements.begin(), edit.elements.end(), alias) != edit.elements.end()) return i + 1;
    }
    return 0;
  }

  /// What the element is when the dialect's own edits begin, or as it is written in the edit.
  std::string element_text(const ChainElement& e) const {
    if (is_own(e.where)) return edits_.element(edits_.offset(e.where));
    std::string out = "<" + e.syntax;
    if (e.alias != e.syntax) out += fmt::format(" as=\"{}\"", e.alias);
    if (e.override_slot) out += " override=\"true\"";
    for (const Attribute& a : e.options) {
      if (is_own(a.where)) continue;  // the dialect's own <Configure> follows
      out += fmt::format(" {}=\"{}\"", a.name, escaped_xml(a.value));
    }
    return out + "/>";
  }

  /// Takes the elements out of the edits that put them in, and writes one edit for them all.
  std::string move_edits(const std::vector<const ChainElement*>& run, const ChainElement* previous,
                         const ChainElement* next) {
    const std::size_t none = SIZE_MAX;
    const std::size_t after = previous == nullptr ? none : placed_by(previous->alias);
    const std::size_t before = next == nullptr ? none : placed_by(next->alias);
    if (after == none && before == none) return "a whole stage would move";
    // The anchor that stands there earlier, so that the edit may stay where it is.
    const bool puts_after = after <= before;
    const std::size_t anchored = std::min(after, before);
    std::string text, removals;
    std::size_t last = anchored, inherited = 0;
    for (const ChainElement* const e : run) {
      text += (text.empty() ? "" : " ") + element_text(*e);
      const std::size_t edit = placed_by(e->alias);
      if (edit == 0) {
        removals += fmt::format("<Remove syntax=\"{}\"/>", e->alias);
        ++inherited;
        continue;
      }
      if (!is_own(dialect_.edits[edit - 1].where))
        return fmt::format("{} is put in by {}", e->alias, dialect_.edits[edit - 1].where.file);
      last = std::max(last, edit);
    }
    const std::string kind = puts_after ? "InsertAfter" : "InsertBefore";
    text = fmt::format("<{0} syntax=\"{1}\"> {2} </{0}>", kind, (puts_after ? previous : next)->alias, text);
    bool stands = false;
    for (const ChainElement* const e : run)
      if (const std::size_t edit = placed_by(e->alias); edit != 0)
        stands = take_out(*e, dialect_.edits[edit - 1], run, edit == last && inherited == 0 ? text : "") || stands;
    return stands ? std::string() : put_in(last, removals, text, run);
  }

  /// True when `instead` has taken the place of the whole edit.
  bool take_out(const ChainElement& e, const AppliedEdit& edit, const std::vector<const ChainElement*>& run,
                const std::string& instead) {
    const bool all_move = std::all_of(edit.elements.begin(), edit.elements.end(), [&](const std::string& alias) {
      return std::any_of(run.begin(), run.end(), [&](const ChainElement* r) { return r->alias == alias; });
    });
    const std::size_t begin = edits_.offset(edit.where);
    if (!all_move) {
      edits_.remove(edits_.offset(e.where));
      return false;
    }
    if (!gone_.insert(begin).second) return !instead.empty();
    std::string by = edit.kind == "Replace" ? fmt::format("<Remove syntax=\"{}\"/>", edit.anchor) : "";
    if (!by.empty() && !instead.empty()) by += edits_.line_end() + edits_.indentation(begin);
    by += instead;
    by.empty() ? edits_.remove(begin) : edits_.replace(begin, edits_.end_of(begin), by);
    return !instead.empty();
  }

  /// A new edit: before the dialect's own <Configure> of what moves, else behind edit `last`, else at the chain's end.
  std::string put_in(std::size_t last, const std::string& removals, const std::string& text,
                     const std::vector<const ChainElement*>& run) {
    for (std::size_t i = last; i < dialect_.edits.size(); ++i) {
      const AppliedEdit& edit = dialect_.edits[i];
      if (edit.of_dependency || edit.kind != "Configure" || !is_own(edit.where)) continue;
      if (std::none_of(run.begin(), run.end(), [&](const ChainElement* e) { return e->alias == edit.anchor; }))
        continue;
      const std::size_t at = edits_.offset(edit.where);
      const std::string line = edits_.line_end() + edits_.indentation(at);
      edits_.replace(at, at, removals + (removals.empty() ? "" : line) + text + line);
      return {};
    }
    if (last > 0 && is_own(dialect_.edits[last - 1].where)) {
      const std::size_t begin = edits_.offset(dialect_.edits[last - 1].where), at = edits_.end_of(begin);
      const std::string line = edits_.line_end() + edits_.indentation(begin);
      edits_.replace(at, at, (removals.empty() ? "" : line + removals) + line + text);
      return {};
    }
    const std::size_t end = edits_.find_last("</Chain");
    if (end == std::string::npos) return "the wrong order is inherited";
    const std::string blanks = edits_.indentation(end) + "  ";
    const std::string line = edits_.line_end() + blanks;
    edits_.replace(end, end,
                   (removals.empty() ? "" : "  " + removals + line) + (removals.empty() ? "  " : "") + text +
                       edits_.line_end() + edits_.indentation(end));
    return {};
  }

  const Dialect& dialect_;
  TextEdits edits_;
  std::set<std::string> moved_;
  const std::vector<std::string>& wanted_;
  std::map<std::string, const ChainElement*> elements_;
  std::set<std::size_t> gone_;
};

/// The name that a patch gives the file: from the folder that the command runs in, where the file lies below it.
std::string patch_name(const fs::path& file) {
  std::error_code error;
  const fs::path relative = fs::relative(file, fs::current_path(error), error);
  return error || relative.empty() || *relative.begin() == ".." ? file.string() : relative.generic_string();
}

}  // namespace

std::string order_patch(const Dialect& dialect, const std::vector<std::string>& wanted, std::string& reason) {
  const std::optional<std::string> text = read_text(dialect.file.string(), reason);
  if (!text) return {};
  const std::string changed = Mover(dialect, wanted, *text).apply(reason);
  return reason.empty() ? unified_diff(patch_name(dialect.file), *text, changed) : std::string();
}

}  // namespace isogloss::cli
