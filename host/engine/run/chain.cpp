// A chain from its first block to its last: it begins blocks and calls the syntaxes that are awake.
#include "isogloss/engine/chain.hpp"

#include <algorithm>

#include "contract/flow_host.hpp"
#include "contract/host_table.hpp"
#include "run/calling.hpp"
#include "run/cursor.hpp"

namespace isogloss {

namespace {

thread_local const Document* running = nullptr;

// Nearly all chains have two such words: a call for so few takes longer than to write them.

inline void clear_awake(std::uint64_t* words, std::uint32_t count) {
  words[0] = words[1] = 0;
  if (count > 2) [[unlikely]]
    std::fill(words + 2, words + count, 0);
}

inline void copy_awake(const std::uint64_t* words, std::uint32_t count, std::uint64_t* to) {
  to[0] = words[0];
  to[1] = words[1];
  if (count > 2) [[unlikely]]
    std::copy(words + 2, words + count, to + 2);
}

inline void add_awake(const std::uint64_t* words, std::uint32_t count, std::uint64_t* to) {
  to[0] |= words[0];
  to[1] |= words[1];
  if (count > 2) [[unlikely]]
    for (std::uint32_t k = 2; k < count; ++k) to[k] |= words[k];
}

}  // namespace

Chain::Interlude::Interlude() : before_(running) {}
Chain::Interlude::~Interlude() { running = before_; }

Chain::Chain(const LinkedDialect& linked, ChainSettings settings, DiagnosticSink& sink)
    : linked_(linked),
      settings_(std::move(settings)),
      sink_(sink),
      symbols_(linked.symbols),
      document_(linked.layout, linked.wake, linked.wake_words),
      host_(settings_.host != nullptr ? settings_.host : &host_table(settings_.mode)),
      flow_service_(flow_service()),
      provenance_(provenance_service()),
      is_plain_(settings_.mode == Mode::fast && !settings_.call_all) {
  document_.chain = this;
  if (settings_.mode == Mode::traced) document_.origins.resize(document_.size());
  try {
    create_dependencies();
    if (settings_.hears_rows) listen_to_rows();
    create_syntaxes();
    creating_ = 0;
    before_inspection_ = reach(0, linked_.inspection_begin);
    from_inspection_ = reach(linked_.inspection_begin, static_cast<std::uint32_t>(steps_.size()));
    watch_modal_state();
  } catch (...) {
    destroy();
    throw;
  }
}

Chain::~Chain() {
  if (running == &document_) running = nullptr;
  destroy();
}

void Chain::destroy() {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const LinkedSyntax& s = linked_.chain[i];
    destroy_part(*s.plugin, s.element.alias, s.syntax->destroy, steps_[i].self);
  }
  for (std::size_t i = 0; i < dependencies_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    destroy_part(*d.plugin, d.element.alias, d.dependency->destroy, dependencies_[i]);
  }
  steps_.clear();
  dependencies_.clear();
}

void Chain::destroy_part(const ig_plugin& plugin, const std::string& alias, void (*end)(void*), void* self) {
  if (self == nullptr) return;
  const Calling calling(plugin, alias.c_str(), "destroy");
  try {
    end(self);
  } catch (...) {
    sink_.add(exception_diagnostic(plugin, alias, "destroy", {}));
  }
}

std::string_view Chain::setting(std::string_view name) const {
  const auto found = settings_.settings.find(name);
  return found == settings_.settings.end() ? std::string_view{} : found->second;
}

void Chain::start(std::string_view file) {
  running = &document_;
  document_.begin({file, 0, 0, {}, false});
  ends_program = ends_file = false;
  for (const auto& [field, value] : linked_.initial) document_.set(field, value);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const ig_run_fn restart = linked_.chain[i].syntax->restart;
    if (restart == nullptr) continue;
    document_.current = static_cast<std::uint16_t>(i + 1);
    const Calling calling(*linked_.chain[i].plugin, linked_.chain[i].element.alias.c_str(), "restart");
    try {
      restart(steps_[i].self, host_, document_.block());
    } catch (...) {
      tell_exception(document_, "restart");
    }
  }
  document_.current = 0;
}

void Chain::begin_block(const BlockSource& source) {
  running = &document_;
  if (source.is_joined && joined_ != nullptr) joined_->forget();
  document_.begin(source);
  if (settings_.mode == Mode::traced) document_.file_number = file_number(source.file);
  document_.changes |= passing_;
  if (document_.changes != 0) look_at_state();
  document_.active[0] = awake_by_state_[0];
  document_.active[1] = awake_by_state_[1];
  if ((awake_by_state_[1] & wakes_beyond) != 0) [[unlikely]]
    std::copy(awake_by_state_ + 2, awake_by_state_ + linked_.wake_words, document_.active + 2);
  ++blocks;
  ends_program = ends_file = alarmed = skip_rest = false;
  split_at = 0;
  failure_said_by = 0;
  answered_rows.clear();
}

/// The run keeps the names of its files: the same name has the same place.
std::uint16_t Chain::file_number(std::string_view file) {
  for (std::size_t i = 0; i < files_.size(); ++i)
    if (files_[i].data() == file.data() || files_[i] == file) return static_cast<std::uint16_t>(i);
  if (files_.size() > UINT16_MAX) return 0;
  files_.emplace_back(file);
  return static_cast<std::uint16_t>(files_.size() - 1);
}

/// Re-evaluates only the watches whose fields changed, or whose value ended with the previous block; caches the union
/// of the others.
void Chain::look_at_state() {
  const std::uint64_t changes = document_.changes;
  if (changes != changing_) {
    changing_ = changes;
    clear_awake(awake_by_rest_, linked_.wake_words);
    for (std::size_t i = 0; i < watches_.size(); ++i)
      if ((changes & change_of(i)) == 0) add_awake(watches_[i].awake, linked_.wake_words, awake_by_rest_);
  }
  copy_awake(awake_by_rest_, linked_.wake_words, awake_by_state_);
  document_.changes = 0;
  passing_ = always_;
  for (std::uint64_t open = changes; open != 0; open &= open - 1) {
    const auto first = static_cast<std::size_t>(__builtin_ctzll(open));
    const std::size_t last = first == last_change ? watches_.size() : first + 1;
    for (std::size_t i = first; i < std::min(last, watches_.size()); ++i) {
      look_at(watches_[i], change_of(i));
      add_awake(watches_[i].awake, linked_.wake_words, awake_by_state_);
    }
  }
}

[[gnu::always_inline]] inline void Chain::look_at(Watch& watch, std::uint64_t change) {
  clear_awake(watch.awake, linked_.wake_words);
  if (!document_.present(watch.field)) return;
  if (!watch.is_modal) passing_ |= change;
  const std::uint64_t value = document_.value(watch.field).symbol;
  for (std::uint32_t i = watch.begin; i < watch.end; ++i) {
    const WakeWhile& w = watched_[i];
    if (w.value != 0 && w.value != value) continue;
    const std::size_t bit = wake_bit(w.position - linked_.first_build);
    watch.awake[bit / 64] |= std::uint64_t{1} << (bit % 64);
    if (bit >= 128) watch.awake[1] |= wakes_beyond;
  }
}

void Chain::wake(Document& d, std::size_t position) const {
  const std::size_t bit = wake_bit(position - linked_.first_build);
  d.active[bit / 64] |= std::uint64_t{1} << (bit % 64);
  if (bit >= 128) d.active[1] |= wakes_beyond;
}

bool Chain::is_awake(const Document& d, std::size_t position) const {
  const std::size_t bit = wake_bit(position - linked_.first_build);
  return (d.active[bit / 64] >> (bit % 64) & 1) != 0;
}

void Chain::call_watched(Document& d, std::uint32_t position) {
  const Step& step = steps_[position];
  const ig_run_fn run_step = step.any_build();
  if (settings_.mode == Mode::traced) {
    if (trace) trace(position, true);
    const ig_status status = run_step(step.self, host_, d.block());
    if (status == IG_FAILED) tell_failure(d, position);
    if (trace) trace(position, false);
    return;
  }
  const Document before = d;
  const bool is_awake_itself = is_awake(d, position);
  const std::uint64_t reports_before = reports_;
  const ig_status status = run_step(step.self, host_, d.block());
  if (status == IG_FAILED) tell_failure(d, position);
  if (!is_awake_itself && (reports_ != reports_before || !d.same_content(before))) {
    const Diagnostic text = host_diagnostic("IG-0240", {}, {linked_.chain[position].element.alias});
    report(d, text.severity, text.code, text.message, 0, 0);
  }
  std::string fault;
  if (status != IG_UNCHANGED && status != IG_CHANGED && status != IG_FAILED)
    fault = "its build() returned the status " + std::to_string(status);
  else if (status == IG_UNCHANGED && !d.same_content(before))
    fault = "its build() says unchanged, but the block changed";
  if (!fault.empty()) {
    const Diagnostic text = host_diagnostic("IG-0402", {}, {linked_.chain[position].element.alias, fault});
    report(d, text.severity, text.code, text.message, 0, 0);
  }
}

/// Calls a syntax that looks ahead. False when it, and every later syntax, has to wait for the blocks ahead.
bool Chain::call_looking_ahead(Document& d, std::uint32_t position, std::uint32_t first) {
  const Step& step = steps_[position];
  if (step.build_ahead == nullptr) return true;
  const bool is_too_early = first < std::min(position, linked_.post_logic_begin);
  if (is_too_early || (window_grows && is_awake(d, position) && !sees_enough(position))) {
    waits_at = position;
    d.current = 0;
    return false;
  }
  d.current = static_cast<std::uint16_t>(position + 1);
  ++builds;
  if (settings_.mode != Mode::fast)
    call_watched(d, position);
  else if (step.build_ahead(step.self, host_, d.block()) == IG_FAILED)
    tell_failure(d, position);
  return true;
}

bool Chain::sees_enough(std::uint32_t position) const {
  return std::all_of(linked_.look_ahead.begin(), linked_.look_ahead.end(), [&](const LookAhead& looking) {
    return looking.position != position || looking.is_satisfied_by(window);
  });
}

Chain::Reach Chain::reach(std::uint32_t first, std::uint32_t last) const {
  Reach out{};
  const std::uint32_t origin = linked_.first_build;
  if (last <= std::max(first, origin)) return out;
  const std::size_t begin = wake_bit(std::max(first, origin) - origin), end = wake_bit(last - 1 - origin) + 1;
  for (std::size_t k = begin / 64; k * 64 < end; ++k) {
    const std::uint64_t from = ~std::uint64_t{0} << (k * 64 < begin ? begin % 64 : 0);
    const std::uint64_t beyond = (k + 1) * 64 > end ? ~std::uint64_t{0} << (end % 64) : 0;
    out.words[k] = from & ~beyond;
  }
  out.words[1] &= ~(wakes_beyond | holds_far_words);
  return out;
}

/// Calls the syntaxes that are awake. `begin` is where this pass over the block began: a syntax that looks ahead may
/// have to wait. Plain is the fast mode without call_all, which pays for neither.
template <bool is_plain>
[[gnu::always_inline]] inline void Chain::call_steps(Document& d, std::uint32_t begin, const Reach& reach) {
  const bool is_watched = !is_plain && settings_.mode != Mode::fast;
  const std::uint64_t forced = !is_plain && settings_.call_all ? ~std::uint64_t{0} : 0;
  std::uint32_t origin = linked_.first_build;
  const std::size_t words = linked_.wake_words;
  const Step* const steps = steps_.data();
  const ig_host* const host = host_;
  ig_block* const block = d.block();
  for (std::size_t k = 0; k < words; ++k, origin += 64) {
    if (k == 2) {
      if ((d.active[1] & wakes_beyond) == 0 && forced == 0) break;
      origin -= 2;  // the bits of the flags
    }
    const std::uint64_t& active = d.active[k];
    std::uint64_t rest = reach.words[k];
    while (const std::uint64_t awake = (active | forced) & rest) {
      const auto bit = static_cast<unsigned>(__builtin_ctzll(awake));
      rest &= ~std::uint64_t{1} << bit;
      const std::uint32_t position = origin + bit;
      const Step& step = steps[position];
      if (step.build == nullptr) [[unlikely]] {
        if (!call_looking_ahead(d, position, begin)) return;
        continue;
      }
      d.current = static_cast<std::uint16_t>(position + 1);
      ++builds;
      if (is_watched)
        call_watched(d, position);
      else if (step.build(step.self, host, block) == IG_FAILED) [[unlikely]]
        tell_failure(d, position);
    }
  }
  d.current = 0;
}

void Chain::run_range(Document& d, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t next = first; next < last;) try {
      const Reach* way = &before_inspection_;
      Reach there;
      if (next == linked_.inspection_begin && last == steps_.size()) {
        way = &from_inspection_;
      } else if (next != 0 || last != linked_.inspection_begin) {
        there = reach(next, last);
        way = &there;
      }
      if (is_plain_)
        call_steps<true>(d, first, *way);
      else
        call_steps<false>(d, first, *way);
      next = last;
    } catch (...) {
      next = d.current;
      tell_exception(d, "build");
    }
}

void Chain::run_part(Document& d, std::uint32_t first, std::uint32_t last) {
  running = &d;
  const std::uint32_t inspection = std::clamp(linked_.inspection_begin, first, last);
  run_range(d, first, inspection);
  if (inspection != last && waits_at == 0) inspect(d, inspection, last);
  running = &document_;  // a block of the look-ahead window ends before the chain does
}

/// What run() does with a block that no other one waits for, in the plain mode: nearly all blocks.
void Chain::run_whole(Document& d) {
  running = &d;
  const auto last = static_cast<std::uint32_t>(steps_.size());
  const std::uint32_t inspection = std::min(linked_.inspection_begin, last);
  try {
    call_steps<true>(d, 0, before_inspection_);
  } catch (...) {
    const std::uint32_t next = d.current;
    tell_exception(d, "build");
    run_range(d, next, inspection);
  }
  if (inspection != last && waits_at == 0) inspect(d, inspection, last);
  running = &document_;
}

inline void Chain::inspect(Document& d, std::uint32_t first, std::uint32_t last) {
  if (d.has_leftovers())
    for (std::size_t k = 0; k < linked_.wake_words; ++k) d.active[k] |= inspectors_.words[k];
  std::uint64_t awake = (d.active[0] & inspection_.words[0]) | (d.active[1] & inspection_.words[1] & ~wakes_beyond);
  if ((d.active[1] & wakes_beyond) != 0) [[unlikely]]
    for (std::size_t k = 2; k < linked_.wake_words; ++k) awake |= d.active[k] & inspection_.words[k];
  if (awake != 0 || settings_.call_all) run_range(d, first, last);
}

ig_status Chain::build(std::uint32_t position) {
  const Step& step = steps_[position];
  const ig_run_fn run_step = step.any_build();
  if (run_step == nullptr) return IG_UNCHANGED;
  running = &document_;
  document_.current = static_cast<std::uint16_t>(position + 1);
  ig_status status = IG_FAILED;
  try {
    status = run_step(step.self, host_, document_.block());
    if (status == IG_FAILED) tell_failure(document_, position);
  } catch (...) {
    tell_exception(document_, "build");
  }
  document_.current = 0;
  return status;
}

const Breadcrumb& Chain::breadcrumb() {
  static thread_local Breadcrumb crumb;
  crumb = Calling::under_way();
  if (crumb.syntax != nullptr || running == nullptr) return crumb;
  crumb.document = running;
  if (running->current == 0 || running->chain == nullptr) return crumb;
  const LinkedSyntax& s = running->chain->linked_.chain[running->current - 1u];
  crumb.plugin = s.plugin->name;
  crumb.syntax = s.syntax->id;
  crumb.phase = running->chain->is_scanning_ ? "scan" : "build";
  return crumb;
}

}  // namespace isogloss
