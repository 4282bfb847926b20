/// Calls, returns, jumps and loops as a syntax requests them, through the host's service isogloss.flow/1. Details,
/// limits and errors are in isogloss_flow.h.
#pragma once

#include <isogloss_flow.h>

#include <cstddef>

#include "isogloss/block.hpp"

namespace ig {

/// A member of each syntax that directs the run. A request is carried out after the block; only the first request of a
/// block is. Where the chain has no such service, every request is answered IG_GO_NOT_FOUND.
class Flow {
 public:
  /// What became of a request. `reason` says where the host looked, and is valid to the end of the block.
  struct Answer {
    std::int32_t status;
    std::string_view reason;
    bool is_done() const { return status == IG_GO_DONE; }
    bool is_not_found() const { return status == IG_GO_NOT_FOUND; }
  };
  /// A request to call `program` (or a part of it, from the label `start`), `repeats` times. `files` are the names that
  /// its file may have, without folder and extension; `scope` tells where to look; `tag` is shown in the called frame.
  struct Call {
    std::string_view program;
    std::span<const ig_text> files{};
    std::uint32_t scope = IG_IN_FILES | IG_IN_FOLDERS;
    std::uint32_t repeats = 1;
    std::uint64_t tag = 0;
    std::string_view start = {};
  };

  /// True while a file is only indexed: only then a label is needed, so its name need not be put together otherwise.
  bool is_indexing() const { return service_ && service_->is_indexing != 0; }
  void label(Block& b, std::string_view name, ig_label_kind kind = IG_LABEL_PLACE) const {
    if (is_indexing()) service_->label(b.raw(), to_text(name), kind);
  }

  /// Calls a program after this block.
  Answer call(Block& b, const Call& c) const {
    ig_go go = request(IG_GO_CALL);
    go.label = to_text(c.program);
    go.start = to_text(c.start);
    go.files = c.files.data();
    go.file_count = static_cast<std::uint32_t>(c.files.size());
    go.scope = c.scope;
    go.repeats = c.repeats;
    go.tag = c.tag;
    return ask(b, go);
  }
  /// Returns to the block after the call, or to a label of the caller. flags: IG_GO_DROP_REPEATS.
  Answer leave(Block& b, std::string_view label = {}, std::uint32_t flags = 0) const {
    ig_go go = request(IG_GO_RETURN);
    go.label = to_text(label);
    go.flags = flags;
    return ask(b, go);
  }
  /// Jumps to a label of this program. flags: IG_GO_BEHIND.
  Answer jump(Block& b, std::string_view label, ig_search search = IG_SEARCH_AROUND, std::uint32_t flags = 0) const {
    ig_go go = request(IG_GO_LABEL);
    go.label = to_text(label);
    go.search = search;
    go.flags = flags;
    return ask(b, go);
  }
  /// True when jump() would find the label. Requests nothing.
  bool has_label(Block& b, std::string_view label, ig_search search = IG_SEARCH_AROUND) const {
    ig_go go = request(IG_ASK_LABEL);
    go.label = to_text(label);
    go.search = search;
    return ask(b, go).is_done();
  }
  /// Goes to a place that here() gave in this frame. flags: IG_GO_BEHIND.
  Answer go_to(Block& b, const ig_place& place, std::uint32_t flags = 0) const {
    ig_go go = request(IG_GO_PLACE);
    go.place = place;
    go.flags = flags;
    return ask(b, go);
  }
  /// Goes to the first block of this frame.
  Answer restart(Block& b) const {
    ig_go go = request(IG_GO_START);
    return ask(b, go);
  }

  /// The place of this block, for go_to().
  ig_place here(const Block& b) const {
    ig_place place{};
    if (service_) service_->here(b.raw(), &place);
    return place;
  }
  /// Bytes of the main program's text from `offset`; empty at its end, and where the host is older than this function.
  std::string_view text(const Block& b, std::uint64_t offset, std::span<char> buffer) const {
    if (!service_ || service_->struct_size < offsetof(ig_flow_1, text) + sizeof service_->text) return {};
    return {buffer.data(), service_->text(b.raw(), offset, buffer.data(), buffer.size())};
  }
  /// The frame that this block belongs to, or the one at `level`; nothing where there is no such frame.
  ig_frame frame(const Block& b) const { return frame(b, IG_CURRENT_FRAME).value_or(ig_frame{}); }
  std::optional<ig_frame> frame(const Block& b, std::uint32_t level) const {
    ig_frame out{};
    out.struct_size = sizeof out;
    if (!service_ || service_->frame(b.raw(), level, &out) == 0) return std::nullopt;
    return out;
  }

 private:
  static ig_go request(ig_go_kind kind) {
    ig_go go{};
    go.struct_size = sizeof go;
    go.kind = kind;
    return go;
  }
  Answer ask(Block& b, ig_go& go) const {
    const std::int32_t status = service_ ? service_->go(b.raw(), &go) : std::int32_t{IG_GO_NOT_FOUND};
    return {status, to_view(go.reason)};
  }

  Service<ig_flow_1> service_{IG_FLOW_SERVICE, Need::optional, "Calls, returns and jumps; the host has it."};
};

}  // namespace ig
