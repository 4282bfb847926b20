#include "run/flow.hpp"

#include <algorithm>

namespace isogloss {

Flow::Flow(const LinkedDialect& linked, Source& source, const std::string& name, const RunOptions& options,
           DiagnosticSink& sink)
    : linked_(linked), options_(options), end_(sink), programs_(linked, options, sink, end_, source, name) {
  frame_ = frames_.emplace_back(std::make_unique<Frame>()).get();
  frame_->file = &programs_.main();
  frame_->id = ++last_id_;
  cursor_ = &frame_->cursor;
  cursor_->open(*frame_->file->source, options_.maximum_line_bytes, linked_.dialect.segmenter);
}

std::uint64_t Flow::bytes() const {
  std::uint64_t sum = 0;
  for (const auto& frame : frames_) sum += frame->cursor.bytes();
  return sum;
}

bool Flow::select_program(const std::string& name) {
  const Chain::Interlude interlude;
  const std::string label = programs_.indexer().program_name(name);
  const std::optional<BlockPlace> at = labels(programs_.main()).program(label.empty() ? name : label);
  if (!at) return false;
  frame_->start = *at;
  programs_.begin_at(*at);
  reached_.insert(*at);
  seek(*at);
  return true;
}

// ---- requests

std::int32_t Flow::go(const Document& document, ig_go& request) {
  const bool is_built = &document == &document.chain->document() && document.current <= linked_.post_logic_begin;
  if (!is_built) return not_found(request, "where the run goes on is settled before post-logic");
  if (request.kind == IG_ASK_LABEL) return ask_label(request);
  if (has_request()) return IG_GO_TAKEN;
  switch (request.kind) {
    case IG_GO_CALL: return call(document, request);
    case IG_GO_RETURN: return leave(request);
    case IG_GO_LABEL:
    case IG_GO_PLACE:
    case IG_GO_START: return jump(request);
    default: return not_found(request, "this host knows no such request");
  }
}

std::int32_t Flow::ask_label(ig_go& request) {
  const bool found = labels(*frame_->file).find(view_of(request.label), here_, request.search).has_value();
  if (frame_->file->source->is_lost()) return IG_GO_REFUSED;
  return found ? std::int32_t{IG_GO_DONE} : not_found(request, "looked in this program, " + frame_->file->name);
}

std::int32_t Flow::not_found(ig_go& request, std::string reason) {
  reason_ = std::move(reason);
  request.reason = {reason_.data(), reason_.size()};
  return IG_GO_NOT_FOUND;
}

std::int32_t Flow::call(const Document& document, ig_go& request) {
  reason_.clear();
  if (request.scope == 0) request.scope = IG_IN_FILES | IG_IN_FOLDERS;
  if (!programs_.find(request, {*frame_->file, here_}, target_, reason_)) return not_found(request, std::move(reason_));
  called_.assign(view_of(request.label));
  if (depth_ >= options_.maximum_depth) {
    const Diagnostic text = host_diagnostic("IG-0416", {}, {std::to_string(options_.maximum_depth), chain_of_calls()});
    document.chain->report(document, text.severity, text.code, text.message, 0, 0);
    if (++refused_ == most_refused && !is_over()) stop("IG-0422", here_, {std::to_string(most_refused), shown(here_)});
    return IG_GO_REFUSED;
  }
  request_ = Go::call;
  tag_ = request.tag;
  repeats_ = std::max(request.repeats, 1u);
  return IG_GO_DONE;
}

std::int32_t Flow::leave(ig_go& request) {
  if (depth_ == 0) return not_found(request, "the main program has no caller");
  const std::string_view label = view_of(request.label);
  to_.reset();
  if (!label.empty()) {
    to_ = labels(*frames_[depth_ - 1]->file).find(label, frame_->called_at, IG_SEARCH_AROUND);
    if (!to_) return not_found(request, "looked in the calling program, " + frames_[depth_ - 1]->file->name);
  }
  const bool again = !to_ && frame_->pass < frame_->passes && (request.flags & IG_GO_DROP_REPEATS) == 0;
  request_ = again ? Go::again : Go::leave;
  return IG_GO_DONE;
}

std::int32_t Flow::jump(ig_go& request) {
  if (request.kind == IG_GO_START) {
    to_ = frame_->start;
  } else if (request.kind == IG_GO_PLACE) {
    if (request.place.frame != frame_->id) return not_found(request, "the place belongs to another call");
    to_ = BlockPlace{request.place.offset, request.place.column, request.place.line};
  } else {
    to_ = labels(*frame_->file).find(view_of(request.label), here_, request.search);
    if (!to_) return not_found(request, "looked in this program, " + frame_->file->name);
  }
  if (frame_->file->source->is_lost()) {
    programs_.report_lost(*frame_->file, here_.line);
    return IG_GO_REFUSED;
  }
  request_ = Go::jump;
  if (options_.moved) jump_label_.assign(request.kind == IG_GO_LABEL ? view_of(request.label) : std::string_view());
  behind_ = request.kind != IG_GO_START && (request.flags & IG_GO_BEHIND) != 0;
  return IG_GO_DONE;
}

FlowHost::Request Flow::requested() const {
  FlowHost::Request out;
  out.kind = request_;
  out.file = frame_->file->name;
  out.program = request_ == Go::call ? called_ : frame_->program;
  switch (request_) {
    case Go::none: return {};
    case Go::call:
      out.file = target_.file->name;
      out.line = target_.start.line;
      out.passes = repeats_;
      break;
    case Go::leave:
      out.file = frames_[depth_ - 1]->file->name;
      out.line = to_ ? to_->line : frame_->back.line;
      out.call_line = frame_->called_at.line;
      out.is_behind = !to_;
      break;
    case Go::again:
      out.line = frame_->start.line;
      out.pass = frame_->pass + 1;
      out.passes = frame_->passes;
      break;
    case Go::jump:
      out.line = to_->line;
      out.is_behind = behind_;
      break;
  }
  return out;
}

// ---- moves

void Flow::perform(Document& document, const BlockPlace& next) {
  if (++jumps_ > options_.maximum_jumps) {
    const BlockPlace to = request_ == Go::call    ? target_.start
                          : to_                   ? *to_
                          : request_ == Go::again ? frame_->start
                                                  : frame_->back;
    const ProgramFile& file = request_ == Go::call    ? *target_.file
                              : request_ == Go::leave ? *frames_[depth_ - 1]->file
                                                      : *frame_->file;
    request_ = Go::none;
    stop("IG-0417", here_, {std::to_string(jumps_ - 1), shown(here_), file.name + ":" + std::to_string(to.line)});
    return;
  }
  if (options_.moved) tell_move(next);
  switch (std::exchange(request_, Go::none)) {
    case Go::call: enter(document, next); break;
    case Go::leave: leave_frame(document, to_); break;
    case Go::again:
      ++frame_->pass;
      if (repeats_at_ == 0) repeats_at_ = depth_;
      if (!frame_->is_local) document.clear_frame_values();
      seek(frame_->start);
      break;
    case Go::jump:
      if (*to_ == frame_->start && !frame_->is_local) document.clear_frame_values();
      note_jump(*to_);
      seek(*to_);
      passing_ = behind_;
      break;
    case Go::none: break;
  }
}

void Flow::tell_move(const BlockPlace& next) const {
  FlowStep step;
  step.file = frame_->file->name;
  step.line = here_.line;
  step.column = here_.column + 1;
  step.to_file = step.file;
  switch (request_) {
    case Go::call:
      step.kind = FlowStep::Kind::call;
      step.label = called_;
      step.to_file = target_.file->name;
      step.to_line = target_.start.line;
      break;
    case Go::leave:
      step.kind = FlowStep::Kind::leave;
      step.to_file = frames_[depth_ - 1]->file->name;
      step.to_line = to_ ? to_->line : frame_->back.line;
      break;
    case Go::again:
      step.kind = FlowStep::Kind::again;
      step.to_line = frame_->start.line;
      break;
    case Go::jump:
      step.label = jump_label_;
      step.to_line = to_->line;
      break;
    case Go::none: step.to_line = next.line; break;
  }
  options_.moved(step);
}

void Flow::enter(Document& document, const BlockPlace& next) {
  if (frames_.size() == ++depth_) frames_.push_back(std::make_unique<Frame>());
  Frame& frame = *frames_[depth_];
  frame.file = target_.file;
  frame.start = target_.start;
  frame.called_at = here_;
  frame.back = next;
  frame.program = called_;
  frame.id = ++last_id_;
  frame.tag = tag_;
  frame.pass = 1;
  frame.passes = repeats_;
  document.get_frame_values(frame.below);
  frame.is_local = target_.is_local;
  if (!frame.is_local) document.clear_frame_values();
  frame_ = &frame;
  cursor_ = &frame.cursor;
  if (cursor_->source() != frame.file->source)
    cursor_->open(*frame.file->source, options_.maximum_line_bytes, linked_.dialect.segmenter);
  seek(frame.start);
}

void Flow::leave_frame(Document& document, std::optional<BlockPlace> to) {
  document.set_frame_values(frame_->below);
  const BlockPlace back = frame_->back, called_at = frame_->called_at;
  if (repeats_at_ == depth_) repeats_at_ = 0;
  frame_ = frames_[--depth_].get();
  cursor_ = &frame_->cursor;
  here_ = called_at;
  if (to) note_jump(*to);
  seek(to.value_or(back));
}

bool Flow::request_end(const Document& document) {
  if (depth_ == 0) return false;
  const Diagnostic text = host_diagnostic("IG-0419", {}, {frame_->program});
  document.chain->report(document, text.severity, text.code, text.message, 0, 0);
  request_ = frame_->pass < frame_->passes ? Go::again : Go::leave;
  to_.reset();
  return true;
}

bool Flow::leave_at_end(Document& document) {
  if (!request_end(document)) return false;
  perform(document, {});
  return true;
}

void Flow::seek(const BlockPlace& place) {
  if (frame_->file == &programs_.main() && place != last_reached_) {
    last_reached_ = place;
    reached_.insert(place);
  }
  cursor_->seek(place.offset, place.line);
  column_ = place.column;
}

// ---- limits

/// A jump back begins a loop; one that lies inside the loop that is known changes nothing.
void Flow::note_jump(const BlockPlace& to) {
  if (here_ < to) return;
  if (is_looping_ && (depth_ > loop_.depth || (!(to < loop_.to) && !(loop_.from < here_)))) {
    if (depth_ == loop_.depth && to == loop_.to && here_ == loop_.from) ++loop_.times;
    return;
  }
  loop_ = {frame_->id, depth_, here_, to, 1};
  is_looping_ = true;
}

void Flow::count_loop() {
  const bool left = depth_ < loop_.depth ||
                    (depth_ == loop_.depth && (frame_->id != loop_.frame || loop_.from < here_ || here_ < loop_.to));
  if (left)
    is_looping_ = false;
  else if (++loop_blocks_ > options_.maximum_loop_blocks)
    stop("IG-0418", loop_.from,
         {std::to_string(options_.maximum_loop_blocks), std::to_string(loop_.from.line), std::to_string(loop_.to.line),
          std::to_string(loop_.times)});
}

void Flow::count_repeat() {
  if (++repeat_blocks_ <= options_.maximum_repeat_blocks) return;
  const Frame& frame = *frames_[repeats_at_];
  stop("IG-0450", here_,
       {std::to_string(options_.maximum_repeat_blocks), frame.program,
        frames_[repeats_at_ - 1]->file->name + ":" + std::to_string(frame.called_at.line), std::to_string(frame.pass),
        std::to_string(frame.passes)});
}

void Flow::stop(std::string_view code, const BlockPlace& at, std::initializer_list<std::string> arguments) {
  const Frame& frame = code == "IG-0418" ? *frames_[loop_.depth] : *frame_;
  end_.report(host_diagnostic(code, {frame.file->name, at.line, at.column + 1}, arguments));
}

// ---- files

std::optional<BlockPlace> Flow::first_not_run() {
  if (depth_ != 0) return std::nullopt;
  const BlockPlace end = here_;
  const LabelIndex* const names = programs_.main().labels.get();
  const std::vector<BlockPlace> programs = names != nullptr ? names->programs_behind(end) : std::vector<BlockPlace>{};
  const auto was_reached = [&](const BlockPlace& begin, std::size_t following) {
    const auto first = reached_.lower_bound(begin);
    return first != reached_.end() && (following >= programs.size() || *first < programs[following]);
  };
  // The rest of the main program itself: its own subprograms and the targets of its jumps may stand there.
  if (!was_reached({end.offset, end.column + 1, end.line}, 0))
    for (Line line; cursor_->next(line);) {
      if (!programs.empty() && line.offset >= programs[0].offset) break;
      const std::size_t first = line.text.find_first_not_of(std::string_view(" \t\r\0\x1a%", 6));
      if (first != std::string_view::npos)
        return BlockPlace{line.offset, static_cast<std::uint32_t>(first), line.number};
    }
  for (std::size_t i = 0; i < programs.size(); ++i)
    if (!was_reached(programs[i], i + 1)) return programs[i];
  return std::nullopt;
}

// ---- frames

std::string Flow::shown(const BlockPlace& place) const { return frame_->file->name + ":" + std::to_string(place.line); }

std::string Flow::chain_of_calls() const {
  constexpr std::uint32_t longest = 4;
  std::string out;
  for (std::uint32_t level = depth_ > longest ? depth_ - longest : 0; level < depth_; ++level) {
    const Frame& called = *frames_[level + 1];
    out += frames_[level]->file->name + ":" + std::to_string(called.called_at.line) + " calls " + called.program + ", ";
  }
  return out + shown(here_) + " calls " + std::string(called_);
}

bool Flow::is_file(std::string_view name, std::string_view wanted) const {
  if (wanted.empty()) return name == programs_.main().name;
  return name == wanted || (name.ends_with(wanted) && name[name.size() - wanted.size() - 1] == '/');
}

bool Flow::frame(std::uint32_t level, ig_frame& out) const {
  if (level == IG_CURRENT_FRAME) level = depth_;
  if (level > depth_) return false;
  const Frame& f = *frames_[level];
  out.depth = level;
  out.id = f.id;
  out.tag = f.tag;
  out.pass = f.pass;
  out.passes = f.passes;
  out.program = {f.program.data(), f.program.size()};
  out.file = {f.file->name.data(), f.file->name.size()};
  out.call_line = level == 0 ? 0 : f.called_at.line;
  return true;
}

}  // namespace isogloss
