/// Messages of the client on their way from the thread that reads to the thread that works.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "protocol/framing.hpp"

namespace isogloss::editors {

class Inbox {
 public:
  using Item = Frame;
  /// The reading thread: waits while too many messages are unread.
  void put(Item item);
  /// The working thread: waits until a message is there or the time is over.
  std::optional<Item> take(std::optional<std::chrono::milliseconds> wait);
  /// The client no longer wants the answer to this request.
  bool is_cancelled(const Json& id) const;
  void forget_cancelled(const Json& id);
  /// A change of this document has come and is not yet taken.
  bool holds_change_of(const std::string& uri) const;
  /// From now on nothing more is put: the reading thread, which may wait, returns.
  void close();

 private:
  static constexpr std::size_t most_unread = 4096;
  mutable std::mutex mutex_;
  std::condition_variable arrived_, taken_;
  std::deque<Item> items_;
  std::set<std::string> cancelled_;  // ids as JSON text
  bool is_closed_ = false;
};

/// Reads until the client says exit, or until the stream ends, which is put as the last item.
void read_all(FrameReader& reader, Inbox& inbox);

}  // namespace isogloss::editors
