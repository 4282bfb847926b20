#include "lsp/inbox.hpp"

namespace isogloss::editors {

namespace {

const Json* member(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

bool is_method(const Json& message, std::string_view method) {
  const Json* const name = member(message, "method");
  return name != nullptr && name->is_string() && name->get_ref<const std::string&>() == method;
}

}  // namespace

void Inbox::put(Item item) {
  std::unique_lock lock(mutex_);
  taken_.wait(lock, [&] { return items_.size() < most_unread || is_closed_; });
  if (is_closed_) return;
  if (const Json* const message = std::get_if<Json>(&item);
      message != nullptr && is_method(*message, "$/cancelRequest"))
    if (const Json* const params = member(*message, "params"); params != nullptr && cancelled_.size() < most_unread)
      if (const Json* const id = member(*params, "id")) cancelled_.insert(id->dump());
  items_.push_back(std::move(item));
  arrived_.notify_one();
}

std::optional<Inbox::Item> Inbox::take(std::optional<std::chrono::milliseconds> wait) {
  std::unique_lock lock(mutex_);
  const auto has_item = [&] { return !items_.empty(); };
  if (wait)
    arrived_.wait_for(lock, *wait, has_item);
  else
    arrived_.wait(lock, has_item);
  if (items_.empty()) return std::nullopt;
  Item out = std::move(items_.front());
  items_.pop_front();
  taken_.notify_one();
  return out;
}

bool Inbox::is_cancelled(const Json& id) const {
  const std::lock_guard lock(mutex_);
  return cancelled_.contains(id.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Inbox::forget_cancelled(const Json& id) {
  const std::lock_guard lock(mutex_);
  cancelled_.erase(id.dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool Inbox::holds_change_of(const std::string& uri) const {
  const std::lock_guard lock(mutex_);
  for (const Item& item : items_) {
    const Json* const message = std::get_if<Json>(&item);
    if (message == nullptr || !is_method(*message, "textDocument/didChange")) continue;
    const Json* const params = member(*message, "params");
    const Json* const document = params != nullptr ? member(*params, "textDocument") : nullptr;
    const Json* const named = document != nullptr ? member(*document, "uri") : nullptr;
    if (named != nullptr && *named == uri) return true;
  }
  return false;
}

void Inbox::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  taken_.notify_all();
}

void read_all(FrameReader& reader, Inbox& inbox) {
  for (;;) {
    Frame frame = reader.next();
    const auto* const bad = std::get_if<BadFrame>(&frame);
    const auto* const message = std::get_if<Json>(&frame);
    const bool is_last = std::holds_alternative<EndOfInput>(frame) || (bad != nullptr && bad->is_fatal) ||
                         (message != nullptr && is_method(*message, "exit"));
    inbox.put(std::move(frame));
    if (is_last) return;
  }
}

}  // namespace isogloss::editors
