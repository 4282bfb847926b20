// The functions that a syntax calls while it runs. The fast table checks nothing that linking has settled; the checked
// one checks every access against the declarations; the traced one also keeps the line that set each field.
#include "contract/host_table.hpp"

#include <algorithm>

#include "contract/argument_text.hpp"
#include "contract/host_records.hpp"
#include "contract/host_values.hpp"

namespace isogloss {

namespace calls {
namespace {

ig_symbol symbol(ig_block* block, ig_text name) {
  Document& d = doc(block);
  SymbolTable& symbols = d.chain->symbols();
  if (symbols.size() >= maximum_symbols) {
    const Diagnostic text = host_diagnostic("IG-0409", {}, {});
    d.chain->report(d, text.severity, text.code, text.message, 0, 0);
    return 0;
  }
  return symbols.intern({name.data, name.size});
}

template <Mode M>
ig_text symbol_text(const ig_block* block, ig_symbol symbol) {
  if constexpr (M == Mode::checked)
    if (symbol > doc(block).chain->symbols().size())
      violation(doc(block), "it asks for the text of a name that does not exist");
  const std::string_view t = doc(block).chain->symbols().text(symbol);
  return {t.data(), t.size()};
}

/// {0} to {9}: how many arguments the text has places for.
std::uint32_t places_in(std::string_view text) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i + 2 < text.size(); ++i)
    if (text[i] == '{' && text[i + 1] >= '0' && text[i + 1] <= '9' && text[i + 2] == '}')
      out = std::max(out, static_cast<std::uint32_t>(text[i + 1] - '0') + 1);
  return out;
}

template <Mode M>
void report(ig_block* block, std::uint32_t diagnostic, ig_field f, std::uint32_t begin, std::uint32_t end,
            const ig_argument* arguments, std::uint32_t count) {
  Document& d = doc(block);
  if (d.current == 0) return;
  const ig_plugin& plugin = *d.chain->linked().chain[d.current - 1u].plugin;
  if (diagnostic >= plugin.diagnostic_count) {
    violation(d, "it reports a diagnostic that is not in its plugin's table");
    return;
  }
  const ig_diagnostic_decl& row = plugin.diagnostics[diagnostic];
  if (row.severity != IG_NOTE) d.chain->failure_said_by = d.current;  // should build() fail, this is why
  if constexpr (M == Mode::checked)
    if (const std::uint32_t places = places_in(row.text); places > count)
      violation(
          d, "it gives " + std::to_string(count) + " of the " + std::to_string(places) + " arguments of " + row.code);
  if constexpr (M == Mode::checked)
    if (f != IG_NO_FIELD && f >= d.size() && !is_record_field(f))
      violation(d, std::string("it reports ") + row.code + " at a field that does not exist");
  if (f < d.size() && d.word_end(f) != 0) {
    begin = d.word_begin(f);
    end = d.word_end(f);
  } else {
    check_columns<M>(d, begin, end, row.code);
  }
  d.chain->report(d, static_cast<Severity>(row.severity), row.code, fill_in(row.text, argument_texts(arguments, count)),
                  begin, end);
}

void fault(ig_block* block, ig_text message) {
  Document& d = doc(block);
  if (d.current == 0) return;
  const LinkedSyntax& syntax = d.chain->linked().chain[d.current - 1u];
  const Diagnostic text =
      host_diagnostic("IG-0401", {}, {syntax.element.alias, std::string(message.data, message.size)});
  d.chain->failure_said_by = d.current;
  d.chain->report(d, text.severity, text.code, text.message, 0, 0);
}

template <Mode M>
void flow(ig_block* block, ig_flow what, std::size_t position) {
  Chain& chain = *doc(block).chain;
  if (what == IG_FLOW_SPLIT || what == IG_FLOW_SKIP_REST)
    check_columns<M>(doc(block), position, std::max(position, doc(block).source.text.size()), "the rest of the block");
  switch (what) {
    case IG_FLOW_END: chain.ends_program = true; break;
    case IG_FLOW_END_FILE: chain.ends_file = true; break;
    case IG_FLOW_SPLIT: chain.split_at = position; break;
    case IG_FLOW_SKIP_REST: chain.skip_rest = true; break;
    case IG_FLOW_ALARM: chain.alarmed = true; break;
    default: violation(doc(block), "it asks for a flow that does not exist");
  }
}

/// The syntax at work promises not to read past a block with one of some fields.
void refuse_past_end(const Document& d, std::uint32_t k) {
  const std::vector<Document*>& window = d.chain->window;
  for (const LookAhead& looking : d.chain->linked().look_ahead) {
    if (looking.position + 1 != d.current) continue;
    for (std::size_t i = 0; i + 1 < k && i < window.size(); ++i)
      if (looking.ends_at(*window[i]))
        return violation(d, "it asks for the block " + std::to_string(k) + " ahead, past the block " +
                                std::to_string(i + 1) + ", which has a field that ends its look-ahead");
  }
}

template <Mode M>
ig_block* ahead(ig_block* block, std::uint32_t k) {
  const Document& d = doc(block);
  if constexpr (M == Mode::checked)
    if (d.current != 0) {
      const std::uint32_t most = d.chain->linked().chain[d.current - 1u].syntax->look_ahead;
      if (k == 0 || k > most)
        violation(d, "it asks for the block " + std::to_string(k) + " ahead, while it declares a look-ahead of " +
                         std::to_string(most));
      refuse_past_end(d, k);
    }
  const std::vector<Document*>& window = doc(block).chain->window;
  return k >= 1 && k <= window.size() ? window[k - 1]->block() : nullptr;
}

std::int32_t in_turn(ig_block*) { return 1; }

template <Mode M>
constexpr ig_host table() {
  return {.struct_size = sizeof(ig_host),
          .flags = M == Mode::fast ? IG_HOST_SHOWS_BLOCKS : 0,  // the others see every read
          .get = get<M>,
          .get_many = get_many<M>,
          .take = take<M>,
          .take_many = take_many<M>,
          .set = set<M>,
          .set_many = set_many<M>,
          .amend_many = amend_many<M>,
          .erase = erase<M>,
          .is_fresh = is_fresh<M>,
          .take_code = take_code<M>,
          .find_code = find_code<M>,
          .text = text<M>,
          .set_text = set_text<M>,
          .source = source,
          .set_words = set_words<M>,
          .rewrite = rewrite<M>,
          .move = move<M>,
          .word = word<M>,
          .add_leftover = add_leftover<M>,
          .leftover = leftover,
          .set_transform = set_transform<M>,
          .set_translation = set_translation<M>,
          .transform = transform<M>,
          .map_point = map_point,
          .frame_changed = frame_changed,
          .append = append<M>,
          .count = count_records<M>,
          .record = record<M>,
          .set_record = set_record<M>,
          .map_records = map_records<M>,
          .symbol = symbol,
          .symbol_text = symbol_text<M>,
          .report = report<M>,
          .fault = fault,
          .flow = flow<M>,
          .ahead = ahead<M>,
          .fresh_many = fresh_many<M>,
          .set_moving_transform = set_moving_transform<M>,
          .get_point = get_point<M>,
          .take_point = take_point<M>,
          .set_point = set_point<M>,
          .fresh_point = fresh_point<M>,
          .in_turn = in_turn,
          .append_many = append_many<M>};
}

constexpr ig_host fast_table = table<Mode::fast>();
constexpr ig_host checked_table = table<Mode::checked>();
constexpr ig_host traced_table = table<Mode::traced>();

}  // namespace
}  // namespace calls

const ig_host& host_table(Mode mode) {
  using namespace calls;
  return mode == Mode::fast ? fast_table : mode == Mode::checked ? checked_table : traced_table;
}

}  // namespace isogloss
