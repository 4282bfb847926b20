/// Executed blocks that wait because a syntax of the post-logic stage reads the blocks that follow. A block enters when
/// such a syntax is awake in it, or when there are blocks before it that still wait; where nothing looks ahead no block
/// is ever copied.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "isogloss/engine/chain.hpp"

namespace isogloss {

/// Diagnostics of blocks that wait are held until their turn, so that they come out in the order of the blocks.
class OrderedDiagnostics : public DiagnosticSink {
 public:
  explicit OrderedDiagnostics(DiagnosticSink& sink) : sink_(sink) {}
  void add(Diagnostic d) override {
    if (is_holding_)
      held_.push_back(std::move(d));
    else
      sink_.add(std::move(d));
  }
  void hold() { is_holding_ = true; }
  bool is_holding() const { return is_holding_; }
  void pass_on() {
    is_holding_ = false;
    for (Diagnostic& d : take()) sink_.add(std::move(d));
  }
  std::vector<Diagnostic> take() { return std::exchange(held_, {}); }

 private:
  DiagnosticSink& sink_;
  std::vector<Diagnostic> held_;
  bool is_holding_ = false;
};

class LookAheadWindow {
 public:
  struct Entry {
    explicit Entry(const Document& d) : document(d) {}
    Document document;
    std::uint32_t resume_at = 0;  ///< chain position
    bool alarmed = false;
    std::vector<Diagnostic> said;  ///< while it was executed
  };

  LookAheadWindow(const LinkedDialect& linked, const Chain& chain) : linked_(linked), chain_(chain) {}

  bool is_empty() const { return waiting_ == 0; }
  std::size_t size() const { return waiting_; }

  Entry& add(const Document& d, std::uint32_t resume_at, std::vector<Diagnostic> said) {
    if (entries_.size() == waiting_) {
      entries_.push_back(std::make_unique<Entry>(d));
      documents_.push_back(&entries_.back()->document);
    } else {
      *documents_[waiting_] = d;
    }
    Entry& e = *entries_[waiting_++];
    e.document.own_source();
    e.resume_at = resume_at;
    e.said = std::move(said);
    return e;
  }

  /// Are all blocks present that the oldest block may need, as far as it is known yet?
  bool is_complete() const {
    return std::none_of(linked_.look_ahead.begin(), linked_.look_ahead.end(), [this](const LookAhead& looking) {
      const Entry& e = oldest();
      return looking.position >= e.resume_at && chain_.is_awake(e.document, looking.position) &&
             !looking.is_satisfied_by(following());
    });
  }
  Entry& oldest() { return *entries_.front(); }
  const Entry& oldest() const { return *entries_.front(); }
  /// The blocks after the oldest.
  std::span<Document* const> following() const { return std::span(documents_).first(waiting_).subspan(1); }
  void drop_oldest() {
    const auto to_the_end = [this](auto& all) {
      std::rotate(all.begin(), all.begin() + 1, all.begin() + static_cast<std::ptrdiff_t>(waiting_));
    };
    to_the_end(entries_);
    to_the_end(documents_);
    --waiting_;
  }
  void clear() { waiting_ = 0; }

 private:
  const LinkedDialect& linked_;
  const Chain& chain_;
  std::vector<std::unique_ptr<Entry>> entries_;  // the first `waiting_` are in use, oldest first
  std::vector<Document*> documents_;             // of the entries
  std::size_t waiting_ = 0;
};

}  // namespace isogloss
