#include "contract/flow_host.hpp"

#include <algorithm>

#include "isogloss/engine/chain.hpp"

namespace isogloss {

namespace {

FlowHost* host_of(const ig_block* block) { return reinterpret_cast<const Document*>(block)->chain->flow; }

/// As much of a struct as both sides know: a caller of another version has a shorter or a longer one.
template <class T>
void copy_known(const T& from, T* to, std::uint32_t size) {
  std::memcpy(static_cast<void*>(to), &from, std::min<std::size_t>(size, sizeof(T)));
}

void add_label(ig_block* block, ig_text name, ig_label_kind kind) {
  if (FlowHost* const host = host_of(block)) host->label({name.data, name.size}, kind);
}

std::int32_t request_move(ig_block* block, ig_go* request) {
  FlowHost* const host = host_of(block);
  if (host == nullptr) return IG_GO_DONE;
  ig_go known{};
  copy_known(*request, &known, request->struct_size);
  known.struct_size = sizeof known;
  const std::int32_t answer = host->go(*reinterpret_cast<const Document*>(block), known);
  if (request->struct_size >= offsetof(ig_go, reason) + sizeof(ig_text)) request->reason = known.reason;
  return answer;
}

std::int32_t frame_at(const ig_block* block, std::uint32_t level, ig_frame* out) {
  ig_frame found{};
  found.struct_size = out->struct_size;
  if (const FlowHost* const host = host_of(block)) {
    if (!host->frame(level, found)) return 0;
  } else if (level != 0 && level != IG_CURRENT_FRAME) {
    return 0;
  } else {
    found.id = found.pass = found.passes = 1;
  }
  copy_known(found, out, out->struct_size);
  return 1;
}

void place_of_block(const ig_block* block, ig_place* out) {
  const FlowHost* const host = host_of(block);
  *out = host != nullptr ? host->here() : ig_place{};
}

std::size_t copy_text(const ig_block* block, std::uint64_t offset, char* buffer, std::size_t size) {
  const FlowHost* const host = host_of(block);
  return host != nullptr ? host->text(offset, buffer, size) : 0;
}

void note_row(ig_block* block, ig_text service, ig_text row) {
  Chain& chain = *reinterpret_cast<const Document*>(block)->chain;
  if (const std::optional<std::size_t> who = chain.answering({service.data, service.size}))
    chain.note_row(*who, {row.data, row.size}, true);
}

void note_variable(ig_block* block, std::uint32_t access, ig_text name, std::uint64_t scope, const ig_argument* value) {
  const Document& document = *reinterpret_cast<const Document*>(block);
  if (const auto& listener = document.chain->variable_used)
    listener(document, (access & IG_WRITE) != 0, {name.data, name.size}, scope, value);
}

void note_condition(ig_block* block, ig_text text, std::int32_t outcome) {
  const Document& document = *reinterpret_cast<const Document*>(block);
  if (const auto& listener = document.chain->condition_examined)
    listener(document, {text.data, text.size}, static_cast<std::uint32_t>(outcome));
}

}  // namespace

ig_provenance_1 provenance_service() { return {sizeof(ig_provenance_1), 0, note_row, note_variable, note_condition}; }

ig_flow_1 flow_service() {
  return {.struct_size = sizeof(ig_flow_1),
          .is_indexing = 0,
          .label = add_label,
          .go = request_move,
          .frame = frame_at,
          .here = place_of_block,
          .text = copy_text};
}

}  // namespace isogloss
