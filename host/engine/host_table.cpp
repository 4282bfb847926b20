// The functions that a syntax calls while it runs. The fast table checks nothing that linking has settled; the checked
// one holds every access against the declarations; the traced one also keeps the line that set each field.
#include "host_table.hpp"

namespace isogloss {

namespace {

Document& doc(ig_block* block) { return *reinterpret_cast<Document*>(block); }
const Document& doc(const ig_block* block) { return *reinterpret_cast<const Document*>(block); }

bool allowed(const std::vector<std::uint64_t>& mask, ig_field f) {
  return (f >> 6) < mask.size() && (mask[f >> 6] >> (f & 63) & 1) != 0;
}

void violation(const Document& d, const std::string& what) {
  if (d.current == 0 || d.chain == nullptr) return;
  const LinkedSyntax& syntax = d.chain->linked().chain[d.current - 1u];
  const Diagnostic text = host_diagnostic("IG-0402", {}, {syntax.element.alias, what});
  d.chain->report(d, text.severity, text.code, text.message, 0, 0);
}

std::string field_name(const Document& d, ig_field f) {
  if (is_record_field(f)) return list_of(f) < d.layout().lists.size() ? d.layout().lists[list_of(f)].path : "?";
  return f < d.size() ? d.layout().fields[f].path : "a field that does not exist";
}

enum class Use { read, write, take };

/// False when the field must not be touched; the fast table only wards off ids that lie outside the document.
template <Mode M>
bool may(const Document& d, ig_field f, Use use) {
  if (f >= d.size()) {
    if constexpr (M == Mode::checked)
      if (f != IG_NO_FIELD) violation(d, "it used a field that does not exist");
    return false;
  }
  if constexpr (M == Mode::checked) {
    if (d.current == 0) return true;
    const LinkedSyntax& s = d.chain->linked().chain[d.current - 1u];
    const bool ok = use == Use::read    ? allowed(s.may_read, f) || allowed(s.may_take, f) || allowed(s.may_write, f)
                    : use == Use::write ? allowed(s.may_write, f)
                                        : allowed(s.may_take, f);
    if (!ok)
      violation(d, std::string(use == Use::read    ? "it reads "
                               : use == Use::write ? "it writes "
                                                   : "it takes ") +
                       field_name(d, f) + ", which it does not declare");
    return ok;
  }
  return true;
}

template <Mode M>
bool sound(const Document& d, ig_field f, ig_value v) {
  if constexpr (M == Mode::checked) {
    const FieldInfo& info = d.layout().fields[f];
    if (info.type == IG_NUMBER && !std::isfinite(v.number)) {
      violation(d, "it gives " + info.path + " a value that is no number");
      return false;
    }
    if (info.type == IG_TRANSFORM || info.type == IG_TEXT) {
      violation(d, "it gives " + info.path + " a plain value: " +
                       (info.type == IG_TEXT ? "a text has set_text" : "a transform has set_transform"));
      return false;
    }
    if (info.type == IG_SYMBOL && (v.symbol == 0 || v.symbol > d.chain->symbols().size())) {
      violation(d, "it gives " + info.path + " a name that does not exist");
      return false;
    }
  }
  return true;
}

template <Mode M>
void note_line(Document& d, ig_field f) {
  if constexpr (M == Mode::traced)
    if (f < d.set_line.size()) d.set_line[f] = d.source.line;
}

template <Mode M>
std::int32_t get(const ig_block* block, ig_field f, ig_value* out) {
  const Document& d = doc(block);
  if (!may<M>(d, f, Use::read) || !d.present(f)) return 0;
  *out = d.value(f);
  return 1;
}

template <Mode M>
std::uint32_t get_many(const ig_block* block, const ig_field* fields, std::uint32_t count, ig_value* out) {
  if constexpr (M == Mode::fast) {
    return doc(block).get_many(fields, count, out);
  }
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (get<M>(block, fields[i], out + i) != 0) mask |= 1u << (i & 31);
  return mask;
}

template <Mode M>
std::int32_t take(ig_block* block, ig_field f, ig_value* out) {
  Document& d = doc(block);
  return may<M>(d, f, Use::take) && d.take(f, *out) ? 1 : 0;
}

template <Mode M>
std::uint32_t take_many(ig_block* block, const ig_field* fields, std::uint32_t count, ig_value* out) {
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (take<M>(block, fields[i], out + i) != 0) mask |= 1u << (i & 31);
  return mask;
}

template <Mode M>
void set(ig_block* block, ig_field f, ig_value v) {
  Document& d = doc(block);
  if (!may<M>(d, f, Use::write) || !sound<M>(d, f, v)) return;
  d.set(f, v);
  d.count_code(f);
  note_line<M>(d, f);
}

template <Mode M>
void set_many(ig_block* block, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  if constexpr (M == Mode::fast) {
    doc(block).set_many(fields, count, v);
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i) set<M>(block, fields[i], v[i]);
}

template <Mode M>
void amend_many(ig_block* block, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  Document& d = doc(block);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!may<M>(d, fields[i], Use::write) || !sound<M>(d, fields[i], v[i])) continue;
    d.write(fields[i], v[i]);
    d.count_code(fields[i]);
    note_line<M>(d, fields[i]);
  }
}

template <Mode M>
void erase(ig_block* block, ig_field f) {
  Document& d = doc(block);
  if (may<M>(d, f, Use::write)) d.erase(f);
}

template <Mode M>
std::int32_t is_fresh(const ig_block* block, ig_field f) {
  const Document& d = doc(block);
  return may<M>(d, f, Use::read) && d.fresh(f) ? 1 : 0;
}

template <Mode M>
std::uint32_t fresh_many(const ig_block* block, const ig_field* fields, std::uint32_t count) {
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (is_fresh<M>(block, fields[i]) != 0) mask |= 1u << (i & 31);
  return mask;
}

// Three fields side by side. What lies otherwise, or is held against the declarations, goes one by one and stays out of
// the fast table's way.

ig_field beside(ig_field x, std::uint32_t i) { return x > IG_NO_FIELD - 2 ? IG_NO_FIELD : x + i; }

template <Mode M>
[[gnu::noinline]] std::uint32_t get_three(const ig_block* block, ig_field x, double* out) {
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    ig_value v{};
    if (get<M>(block, beside(x, i), &v) != 0) mask |= 1u << i;
    out[i] = v.number;
  }
  return mask;
}

template <Mode M>
std::uint32_t get_point(const ig_block* block, ig_field x, double* out) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]]
      return doc(block).get_point(x, out);
  return get_three<M>(block, x, out);
}

template <Mode M>
[[gnu::noinline]] std::uint32_t take_three(ig_block* block, ig_field x, double* out) {
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    ig_value v{};
    if (take<M>(block, beside(x, i), &v) != 0) mask |= 1u << i;
    out[i] = v.number;
  }
  return mask;
}

template <Mode M>
std::uint32_t take_point(ig_block* block, ig_field x, double* out) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]]
      return doc(block).take_point(x, out);
  return take_three<M>(block, x, out);
}

template <Mode M>
[[gnu::noinline]] void set_three(ig_block* block, ig_field x, const double* point) {
  for (std::uint32_t i = 0; i < 3; ++i) set<M>(block, beside(x, i), {.number = point[i]});
}

template <Mode M>
void set_point(ig_block* block, ig_field x, const double* point) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]] {
      doc(block).set_point(x, point);
      return;
    }
  set_three<M>(block, x, point);
}

template <Mode M>
std::uint32_t fresh_point(const ig_block* block, ig_field x) {
  if constexpr (M == Mode::fast)
    if (doc(block).is_point(x)) [[likely]]
      return doc(block).fresh_point(x);
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < 3; ++i)
    if (is_fresh<M>(block, beside(x, i)) != 0) mask |= 1u << i;
  return mask;
}

template <Mode M>
std::int32_t find_code(const ig_block* block, const ig_field* fields, std::uint32_t count, std::uint32_t* found) {
  const Document& d = doc(block);
  std::int32_t last = -1;
  std::int64_t ordinal = -1;
  *found = 0;
  if (d.codes_seen == 0) return -1;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!may<M>(d, fields[i], Use::read) || !d.present(fields[i])) continue;
    ++*found;
    if (d.value(fields[i]).integer > ordinal) {
      ordinal = d.value(fields[i]).integer;
      last = static_cast<std::int32_t>(i);
    }
  }
  return last;
}

template <Mode M>
std::int32_t take_code(ig_block* block, const ig_field* fields, std::uint32_t count, std::uint32_t* found) {
  Document& d = doc(block);
  std::int32_t last = -1;
  std::int64_t ordinal = -1;
  *found = 0;
  if (d.codes_seen == 0) return -1;
  for (std::uint32_t i = 0; i < count; ++i) {
    ig_value value;
    if (!d.present(fields[i]) || take<M>(block, fields[i], &value) == 0) continue;
    ++*found;
    if (value.integer <= ordinal) continue;
    ordinal = value.integer;
    last = static_cast<std::int32_t>(i);
  }
  return last;
}

template <Mode M>
ig_text text(const ig_block* block, ig_field f) {
  const Document& d = doc(block);
  if (!may<M>(d, f, Use::read) || d.layout().fields[f].type != IG_TEXT) return {nullptr, 0};
  const std::string_view t = d.text(f);
  return {t.data(), t.size()};
}

template <Mode M>
void set_text(ig_block* block, ig_field f, ig_text t) {
  Document& d = doc(block);
  if (!may<M>(d, f, Use::write) || d.layout().fields[f].type != IG_TEXT) return;
  d.set_text(f, {t.data, t.size});
  note_line<M>(d, f);
}

ig_text source(const ig_block* block) { return {doc(block).source.text.data(), doc(block).source.text.size()}; }

template <Mode M>
void set_words(ig_block* block, const ig_word* words, std::uint32_t count) {
  Document& d = doc(block);
  for (std::uint32_t i = 0; i < count; ++i) {
    if constexpr (M != Mode::fast)
      if (!may<M>(d, words[i].field, Use::write)) continue;
    d.set_word(words[i]);
    note_line<M>(d, words[i].field);
  }
}

template <Mode M>
void rewrite(ig_block* block, ig_field f, ig_value v) {
  Document& d = doc(block);
  if (!may<M>(d, f, Use::write) || !sound<M>(d, f, v)) return;
  d.rewrite(f, v);
  note_line<M>(d, f);
}

template <Mode M>
void move(ig_block* block, ig_field from, ig_field to) {
  Document& d = doc(block);
  if (!may<M>(d, from, Use::take) || !may<M>(d, to, Use::write)) return;
  d.move(from, to);
  note_line<M>(d, to);
}

template <Mode M>
std::int32_t word(const ig_block* block, ig_field f, ig_word* out) {
  const Document& d = doc(block);
  if (!may<M>(d, f, Use::read) || !d.present(f)) return 0;
  *out = {f,
          static_cast<std::uint16_t>(d.word_begin(f)),
          static_cast<std::uint16_t>(d.word_end(f)),
          d.value(f),
          d.without_point(f) ? std::uint32_t{IG_WORD_WITHOUT_POINT} : 0u,
          0};
  return d.word_end(f) != 0 ? 1 : 0;
}

void add_leftover(ig_block* block, const ig_leftover* l) {
  Document& d = doc(block);
  const std::string_view name(l->name.data, l->name.size);
  d.add_leftover(l->kind, l->field, l->begin, l->end, name);
}

std::int32_t leftover(const ig_block* block, std::uint32_t index, ig_leftover* out) {
  static thread_local std::vector<Leftover> open;
  if (index == 0) open = doc(block).collect_leftovers();
  if (index >= open.size()) return 0;
  const Leftover& l = open[index];
  *out = {l.kind, l.field, l.begin, l.end, {l.name.data(), l.name.size()}};
  return 1;
}

template <Mode M>
bool is_transform(const Document& d, ig_field f, Use use) {
  return may<M>(d, f, use) && d.layout().fields[f].type == IG_TRANSFORM;
}

template <Mode M>
void set_transform(ig_block* block, ig_field f, const double matrix[16]) {
  Document& d = doc(block);
  if (!is_transform<M>(d, f, Use::write)) return;
  d.set_frame(f, Frame::from(matrix));
  note_line<M>(d, f);
}

template <Mode M>
void set_moving_transform(ig_block* block, ig_field f, const double matrix[16]) {
  Document& d = doc(block);
  if (!is_transform<M>(d, f, Use::write)) return;
  d.move_frame(f, matrix);
  note_line<M>(d, f);
}

template <Mode M>
void set_translation(ig_block* block, ig_field f, const double offset[3]) {
  const double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, offset[0], offset[1], offset[2], 1};
  set_transform<M>(block, f, m);
}

template <Mode M>
std::int32_t transform(const ig_block* block, ig_field f, double matrix[16]) {
  const Document& d = doc(block);
  if (!is_transform<M>(d, f, Use::read) || !d.present(f)) return 0;
  std::memcpy(matrix, d.frame(f).matrix, sizeof d.frame(f).matrix);
  return 1;
}

std::int32_t map_point(ig_block* block, ig_direction direction, const double in[3], double out[3]) {
  Document& d = doc(block);
  const double from[3] = {in[0], in[1], in[2]};
  double to[3];
  if (direction == IG_TO_MACHINE)
    d.composed().map(from, to);
  else if (!d.map_to_program(from, to))
    return 0;
  std::memcpy(out, to, sizeof to);
  return 1;
}

std::int32_t frame_changed(const ig_block* block) { return doc(block).frame_changed ? 1 : 0; }

/// The list that all these record fields belong to, or null.
ListData* list_of_all(Document& d, const ig_field* fields, std::uint32_t count) {
  if (count == 0 || !is_record_field(fields[0]) || list_of(fields[0]) >= d.lists.size()) return nullptr;
  ListData& list = d.lists[list_of(fields[0])];
  for (std::uint32_t i = 0; i < count; ++i)
    if ((fields[i] & ~0xffffu) != (fields[0] & ~0xffffu) || index_in_record(fields[i]) >= list.stride) return nullptr;
  return &list;
}

std::int32_t append(ig_block* block, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  Document& d = doc(block);
  ListData* const list = list_of_all(d, fields, count);
  if (list == nullptr) return 0;
  if (list->count >= maximum_items) {
    if (list->count == maximum_items) {
      const Diagnostic text = host_diagnostic("IG-0405", {}, {std::to_string(maximum_items)});
      d.chain->report(d, text.severity, text.code, text.message, 0, 0);
      list->present.push_back(0);  // says it once: an empty record past the limit
      list->values.resize(list->values.size() + list->stride);
      ++list->count;
    }
    return 0;
  }
  const std::size_t base = list->values.size();
  list->values.resize(base + list->stride);
  std::uint64_t present = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    list->values[base + index_in_record(fields[i])] = v[i];
    present |= std::uint64_t{1} << index_in_record(fields[i]);
  }
  list->present.push_back(present);
  ++list->count;
  return 1;
}

std::uint32_t count_records(const ig_block* block, ig_field f) {
  const Document& d = doc(block);
  return is_record_field(f) && list_of(f) < d.lists.size() ? d.lists[list_of(f)].count : 0;
}

std::uint32_t record(const ig_block* block, std::uint32_t index, const ig_field* fields, std::uint32_t count,
                     ig_value* out) {
  Document& d = const_cast<Document&>(doc(block));
  const ListData* const list = list_of_all(d, fields, count);
  if (list == nullptr || index >= list->count) return 0;
  std::uint32_t mask = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((list->present[index] >> index_in_record(fields[i]) & 1) == 0) continue;
    out[i] = list->values[std::size_t{index} * list->stride + index_in_record(fields[i])];
    mask |= 1u << (i & 31);
  }
  return mask;
}

void set_record(ig_block* block, std::uint32_t index, const ig_field* fields, std::uint32_t count, const ig_value* v) {
  Document& d = doc(block);
  ListData* const list = list_of_all(d, fields, count);
  if (list == nullptr || index >= list->count) return;
  for (std::uint32_t i = 0; i < count; ++i) {
    list->values[std::size_t{index} * list->stride + index_in_record(fields[i])] = v[i];
    list->present[index] |= std::uint64_t{1} << index_in_record(fields[i]);
  }
}

void map_records(ig_block* block, const ig_field program[3], const ig_field machine[3]) {
  Document& d = doc(block);
  if (count_records(block, program[0]) == 0) return;
  const ig_field all[6] = {program[0], program[1], program[2], machine[0], machine[1], machine[2]};
  ListData* const list = list_of_all(d, all, 6);
  if (list == nullptr) return;
  std::uint64_t wanted = 0, given = 0;
  for (int i = 0; i < 3; ++i) {
    wanted |= std::uint64_t{1} << index_in_record(program[i]);
    given |= std::uint64_t{1} << index_in_record(machine[i]);
  }
  const Frame& frame = d.composed();
  for (std::uint32_t r = 0; r < list->count; ++r) {
    if ((list->present[r] & wanted) != wanted || (list->present[r] & given) != 0) continue;
    ig_value* const v = list->values.data() + std::size_t{r} * list->stride;
    const double from[3] = {v[index_in_record(program[0])].number, v[index_in_record(program[1])].number,
                            v[index_in_record(program[2])].number};
    double to[3];
    frame.map(from, to);
    for (int i = 0; i < 3; ++i) v[index_in_record(machine[i])].number = to[i];
    list->present[r] |= given;
  }
}

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

ig_text symbol_text(const ig_block* block, ig_symbol symbol) {
  const std::string_view t = doc(block).chain->symbols().text(symbol);
  return {t.data(), t.size()};
}

std::string shown(const ig_argument& a) {
  // A program's text may be a megabyte long; a message shows where it begins.
  constexpr std::size_t longest = 120;
  if (a.is_text != 0) {
    if (a.text.size <= longest) return std::string(a.text.data, a.text.size);
    return std::string(a.text.data, longest) + " …";
  }
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", a.number);
  return buffer;
}

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
  std::vector<std::string> texts;
  for (std::uint32_t i = 0; i < count; ++i) texts.push_back(shown(arguments[i]));
  if (f < d.size() && d.word_end(f) != 0) {
    begin = d.word_begin(f);
    end = d.word_end(f);
  }
  d.chain->report(d, static_cast<Severity>(row.severity), row.code, fill_in(row.text, texts), begin, end);
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

void flow(ig_block* block, ig_flow what, std::size_t position) {
  Chain& chain = *doc(block).chain;
  switch (what) {
    case IG_FLOW_END: chain.ends_program = true; break;
    case IG_FLOW_END_FILE: chain.ends_file = true; break;
    case IG_FLOW_SPLIT: chain.split_at = position; break;
    case IG_FLOW_SKIP_REST: chain.skip_rest = true; break;
    case IG_FLOW_ALARM: chain.alarmed = true; break;
    default: violation(doc(block), "it asks for a flow that does not exist");
  }
}

ig_block* ahead(ig_block* block, std::uint32_t k) {
  const std::vector<Document*>& window = doc(block).chain->window;
  return k >= 1 && k <= window.size() ? window[k - 1]->block() : nullptr;
}

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
          .add_leftover = add_leftover,
          .leftover = leftover,
          .set_transform = set_transform<M>,
          .set_translation = set_translation<M>,
          .transform = transform<M>,
          .map_point = map_point,
          .frame_changed = frame_changed,
          .append = append,
          .count = count_records,
          .record = record,
          .set_record = set_record,
          .map_records = map_records,
          .symbol = symbol,
          .symbol_text = symbol_text,
          .report = report,
          .fault = fault,
          .flow = flow,
          .ahead = ahead,
          .fresh_many = fresh_many<M>,
          .set_moving_transform = set_moving_transform<M>,
          .get_point = get_point<M>,
          .take_point = take_point<M>,
          .set_point = set_point<M>,
          .fresh_point = fresh_point<M>};
}

constexpr ig_host fast_table = table<Mode::fast>();
constexpr ig_host checked_table = table<Mode::checked>();
constexpr ig_host traced_table = table<Mode::traced>();

}  // namespace

const ig_host& host_table(Mode mode) {
  return mode == Mode::fast ? fast_table : mode == Mode::checked ? checked_table : traced_table;
}

}  // namespace isogloss
