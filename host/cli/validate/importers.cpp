// Importers: files of other formats, empty, huge, cut and damaged files, and options at their bounds.
#include <fmt/format.h>
#include <isogloss_import.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>

#include "isogloss/engine/import.hpp"
#include "validate/guarded_texts.hpp"
#include "validate/option_values.hpp"
#include "validate/process_state.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// What the importer does wrong in the call under way.
struct ImportWatch {
  const ig_importer* importer = nullptr;
  std::uint32_t diagnostics = 0;  ///< in the table of its plugin
  std::size_t size = 0;           ///< of the text
  double seconds = 0;             ///< of the last read(), of this thread's work
  GuardedTexts texts;
  ig_text text{};  ///< as the importer has it
  ig_import_api api{};
  const ig_import_api* real = nullptr;
  std::string fault;
  bool has_reason = false;

  void tell(std::string what) {
    if (fault.empty()) fault = std::move(what);
  }
  void check_place(std::size_t place) {
    if (place > size) tell(fmt::format("it gives the place {} of a text of {} bytes", place, size));
  }
  void check_option(std::uint32_t option) {
    if (option >= importer->option_count)
      tell(fmt::format("it asks for option {} of {}", option, importer->option_count));
  }
  void check_table(ig_text id) {
    const std::string_view name(id.data, id.size);
    for (const char* const* d = importer->dependencies; d != nullptr && *d != nullptr; ++d)
      if (name == *d) return;
    tell(fmt::format("it gives rows for {}, which it does not declare", name));
  }
};
thread_local ImportWatch* import_watch = nullptr;

void watch_functions(ig_import_api& api) {
  api.text = [](const ig_import* in) {  // one copy, however often it is asked for
    if (import_watch->text.data == nullptr) import_watch->text = import_watch->texts.copy(import_watch->real->text(in));
    return import_watch->text;
  };
  api.file_name = [](const ig_import* in) { return import_watch->texts.copy(import_watch->real->file_name(in)); };
  api.option_number = [](const ig_import* in, std::uint32_t i) {
    return import_watch->check_option(i), import_watch->real->option_number(in, i);
  };
  api.option_integer = [](const ig_import* in, std::uint32_t i) {
    return import_watch->check_option(i), import_watch->real->option_integer(in, i);
  };
  api.option_text = [](const ig_import* in, std::uint32_t i) {
    return import_watch->check_option(i), import_watch->texts.copy(import_watch->real->option_text(in, i));
  };
  api.row = [](ig_import* in, ig_text table, ig_text key, std::size_t place) {
    import_watch->check_table(table), import_watch->check_place(place), import_watch->real->row(in, table, key, place);
  };
  api.text_cell = [](ig_import* in, ig_text column, ig_text value, std::size_t place) {
    import_watch->check_place(place), import_watch->real->text_cell(in, column, value, place);
  };
  api.number_cell = [](ig_import* in, ig_text column, double value, std::size_t place) {
    import_watch->check_place(place);
    if (!std::isfinite(value)) import_watch->tell("it gives a cell a value that is not finite");
    import_watch->real->number_cell(in, column, value, place);
  };
  api.option = [](ig_import* in, ig_text table, ig_text name, ig_text value, std::size_t place) {
    import_watch->check_table(table), import_watch->check_place(place),
        import_watch->real->option(in, table, name, value, place);
  };
  api.unused = [](ig_import* in, ig_text what, ig_text why, std::size_t begin, std::size_t end) {
    import_watch->check_place(begin), import_watch->check_place(end);
    if (what.size == 0 || why.size == 0)
      import_watch->tell("it names an unused part without saying what it is and why");
    import_watch->real->unused(in, what, why, begin, end);
  };
  api.report = [](ig_import* in, std::uint32_t diagnostic, std::size_t begin, std::size_t end, const ig_argument* a,
                  std::uint32_t n) {
    import_watch->check_place(begin), import_watch->check_place(end);
    if (diagnostic >= import_watch->diagnostics)
      import_watch->tell("it reports a diagnostic that is not in its plugin's table");
    import_watch->has_reason = true;
    import_watch->real->report(in, diagnostic, begin, end, a, n);
  };
  api.fail = [](ig_import* in, ig_text reason) {
    import_watch->has_reason = import_watch->has_reason || reason.size > 0;
    import_watch->real->fail(in, reason);
  };
}

ig_status watched_read(const ig_import_api* api, ig_import* in) {
  ImportWatch& w = *import_watch;
  w.real = api;
  w.api = *api;
  w.size = api->text(in).size;
  w.text = {};
  watch_functions(w.api);
  ig_status status = IG_UNCHANGED;
  const double begin = thread_seconds();
  try {
    status = w.importer->read(&w.api, in);
  } catch (const std::exception& error) {
    w.tell(fmt::format("its read() lets an exception out: {}", error.what()));
  } catch (...) {
    w.tell("its read() lets an exception out");
  }
  w.seconds = thread_seconds() - begin;
  w.texts.end_call();
  if (status != IG_UNCHANGED && status != IG_CHANGED && status != IG_FAILED)
    w.tell(fmt::format("its read() returned the status {}", status));
  if (status == IG_FAILED && !w.has_reason) w.tell("its read() fails and gives no reason");
  return status;
}

struct ImportFile {
  std::string name, text;
  std::vector<Attribute> options{};
};

const std::vector<ImportFile>& files_of_other_formats() {
  static const std::vector<ImportFile> out{
      {"EMPTY.TXT", ""},
      {"LINE.TXT", "\n"},
      {"PART.NC", "%\nO0001 (PART)\nG90 G54 G21\nG00 X1. Y2.\nG01 Z-1. F100.\nM30\n%\n"},
      {"DATA.XML", "<?xml version=\"1.0\"?>\n<Tools><Tool T=\"1\" L=\"100.5\"/></Tools>\n"},
      {"DATA.JSON", "{\"version\": 1, \"data\": [{\"type\": \"drill\", \"geometry\": {\"DC\": 6}}]}\n"},
      {"DATA.CSV", "T;L;R\n1;100,5;3\n2;-1e400;nan\n"},
      {"NAME.T", "BEGIN X.T MM\nT NAME L R\n1 A +1 +2\n[END]\n"},
      {"HUGE.TXT", std::string(200'000, 'A')},
      {"LINES.TXT", std::string(60'000, '\n')},
      {"DIGITS.TXT", std::string(60'000, '9')},
      {"NESTED.TXT", std::string(60'000, '[')},
      {"OPEN.TXT", std::string(60'000, '{')},
      {"ODD.TXT", "\xc3\xa9=\xe2\x82\xac;\xf0\x9f\x98\x80\n\"open\n(open\n"}};
  return out;
}

/// The file cut, damaged, doubled and without a line.
std::vector<ImportFile> damaged(const ImportFile& file, std::uint64_t seed, bool is_first) {
  constexpr std::size_t cuts = 6, changes = 12;
  std::vector<ImportFile> out;
  const std::size_t size = file.text.size();
  for (std::size_t i = 1; i < cuts && size > 0; ++i)
    out.push_back({file.name, file.text.substr(0, i * size / cuts), file.options});
  if (size > 0) out.push_back({file.name, file.text.substr(0, size - 1), file.options});
  if (size > 0) out.push_back({file.name, file.text.substr(1), file.options});
  out.push_back({file.name, file.text + file.text, file.options});
  constexpr std::size_t huge_size = 100'000;
  std::string huge;
  while (is_first && huge.size() < huge_size && size > 0) huge += file.text;
  if (is_first) out.push_back({file.name, huge, file.options});
  constexpr const char* odd_values[] = {"", "0", "-1", "99999999999999999999", "1e400", "nan", "x", "1.5.5", "--1"};
  const auto is_part = [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; };
  std::size_t at = file.text.find('\n');
  for (int number = 0; number < 3 && at < size; ++number) {
    while (at < size && !is_part(file.text[at])) ++at;
    std::size_t end = at;
    while (end < size && is_part(file.text[end])) ++end;
    for (const char* const odd : odd_values)
      if (end > at) out.push_back({file.name, file.text.substr(0, at) + odd + file.text.substr(end), file.options});
    at = end;
  }
  std::seed_seq sequence{seed, std::uint64_t{size}};
  std::mt19937_64 random(sequence);
  constexpr std::string_view bytes = "09-+.,;:=\"'()[]{}<>/\\ \t\nAXTe#%*";
  for (std::size_t i = 0; i < changes && size > 0; ++i) {
    ImportFile changed = file;
    for (std::size_t k = 0; k <= i % 4; ++k) changed.text[random() % size] = bytes[random() % bytes.size()];
    out.push_back(std::move(changed));
  }
  return out;
}

class ImporterAtWork {
 public:
  ImporterAtWork(Examination& e, Subject& subject, const ig_importer& importer)
      : e_(e), subject_(subject), importer_(importer), original_(importer) {
    import_watch = &watched_;
    watched_.importer = &original_;
    watched_.diagnostics = subject.plugin().diagnostic_count;
    // The descriptor is the host's copy, in this process of the check alone.
    const_cast<ig_importer&>(importer_).read = watched_read;
  }
  ~ImporterAtWork() {
    const_cast<ig_importer&>(importer_).read = original_.read;
    import_watch = nullptr;
  }
  ImporterAtWork(const ImporterAtWork&) = delete;
  ImporterAtWork& operator=(const ImporterAtWork&) = delete;

  void recognise(const ImportFile& file, const std::string& where) {
    e_.attempt(where + "; no byte behind a text may be read");
    constexpr std::size_t most = std::size_t{64} << 10;
    const std::string head = file.text.substr(0, most);
    std::uint32_t answers[2];
    for (std::uint32_t& answer : answers) {
      answer = original_.recognise(watched_.texts.copy({head.data(), head.size()}),
                                   watched_.texts.copy({file.name.data(), file.name.size()}));
      watched_.texts.end_call();
    }
    if (answers[0] > 100) e_.find(where, fmt::format("its recognise() answers {}, more than 100", answers[0]));
    if (answers[0] != answers[1])
      e_.find(where, fmt::format("its recognise() answers {}, then {}", answers[0], answers[1]));
    if (head.empty() && answers[0] > 0)
      e_.find(where, fmt::format("its recognise() answers {} for an empty file", answers[0]));
  }

  /// How long the importer reads: the shortest of a few times, of this thread's work.
  double seconds(const ImportFile& file, const std::string& where) {
    constexpr int tries = 3;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) {
      read(file, where);
      least = std::min(least, watched_.seconds);
    }
    return least;
  }

  /// What the file gives, as text.
  std::string read(const ImportFile& file, const std::string& where) {
    e_.attempt(where + "; no byte behind a text may be read");
    watched_.fault.clear();
    watched_.has_reason = false;
    DiagnosticList said;
    Import asked{file.name, original_.id, {}, {"validate"}};
    asked.options = file.options;
    const std::optional<ImportedFile> got = import_bytes(asked, file.text, subject_.library(), said);
    if (!watched_.fault.empty()) e_.find(where, watched_.fault);
    std::string out;
    for (const Diagnostic& d : said.all) out += d.code + d.message + "\n";
    if (!got) return out;
    for (const DependencyElement& table : got->tables) check_cells(table, where);
    for (const UnusedPart& part : got->unused)
      out += fmt::format("{}: {}, {} times\n", part.what, part.why, part.count);
    return out + write_tables(got->tables, true);
  }

 private:
  /// A cell that its table refuses would stop the whole machine.
  void check_cells(const DependencyElement& table, const std::string& where) {
    const ig_dependency* const declared = subject_.library().dependency(table.id);
    if (declared == nullptr) return;
    for (const TableRow& row : table.rows)
      for (const Attribute& cell : row.attributes) {
        if (declared->row_key != nullptr && cell.name == declared->row_key) {
          if (cell.value.empty()) return e_.find(where, fmt::format("it gives {} a row without a key", table.id));
          continue;
        }
        const ig_column_decl* const end = declared->columns + declared->column_count;
        const ig_column_decl* const column =
            std::find_if(declared->columns, end, [&](const ig_column_decl& c) { return cell.name == c.name; });
        if (column == end)
          return e_.find(where, fmt::format("it gives {} the column {}, which it has not", table.id, cell.name));
        if (column->is_text != 0) continue;
        double number = 0;
        const char* const text_end = cell.value.data() + cell.value.size();
        const auto [stop, error] = std::from_chars(cell.value.data(), text_end, number, std::chars_format::fixed);
        if (error != std::errc() || stop != text_end || number < column->minimum || number > column->maximum)
          return e_.find(where, fmt::format("it gives {} of {} the value '{}', which the table refuses", cell.name,
                                            table.id, cell.value));
      }
  }

  Examination& e_;
  Subject& subject_;
  const ig_importer& importer_;
  const ig_importer original_;
  ImportWatch watched_;
};

/// The files of the importer's cases, with their options.
std::vector<ImportFile> files_of_cases(const Subject& subject, const Examination& e, const ig_importer& importer) {
  constexpr std::size_t most = 5;
  std::vector<ImportFile> out;
  DiagnosticList ignored;
  for (const PageText& text : pages_of(subject, e.options)) {
    const Page page = read_page(text.text, text.name, ignored);
    if (page.syntax != importer.id) continue;
    for (const Case& one : page.cases)
      if (one.file && out.size() < most) out.push_back({one.file_name, one.file->text});
  }
  return out;
}

/// The file, longer: as a whole over and over, or one of its lines.
std::vector<ImportFile> longer(const ImportFile& file, std::size_t size) {
  ImportFile all = file, of_a_line = file;
  while (all.text.size() < size) all.text += file.text;
  const std::size_t begin = file.text.rfind('\n', file.text.size() / 2) + 1;
  const std::size_t end = std::min(file.text.find('\n', begin), file.text.size() - 1) + 1;
  const std::string line = file.text.substr(begin, end - begin);
  std::string lines;
  while (lines.size() < size) lines += line;
  of_a_line.text.insert(begin, lines);
  return {all, of_a_line};
}

/// A backup has a few thousand lines, and a large one shall not take hours.
void check_growth(Examination& e, ImporterAtWork& work, const ImportFile& file, const std::string& id) {
  constexpr std::size_t size = 60'000, times = 4;
  constexpr double too_much = 2.5 * times, noise = 0.05;  // the second in seconds: what is faster may be chance
  if (file.text.empty()) return;
  const std::vector<ImportFile> small = longer(file, size), large = longer(file, times * size);
  for (std::size_t i = 0; i < small.size(); ++i) {
    const std::string where = fmt::format("{}, the file of its case 1, {} times as long", id, times);
    const double first = work.seconds(small[i], where);
    if (const double second = work.seconds(large[i], where); second > noise && second > too_much * first)
      return e.find(where, fmt::format("reading takes {:.0f} times as long for {} times the text, so that a large file "
                                       "takes hours",
                                       second / first, times));
  }
}

void check_importer(Examination& e, Subject& subject, const ig_importer& importer) {
  const std::string id = importer.id;
  const std::vector<ImportFile> own = files_of_cases(subject, e, importer);
  ImporterAtWork work(e, subject, importer);
  std::size_t number = 0;
  const auto try_file = [&](const ImportFile& file, const std::string& what, int times = 1) {
    const std::string where = fmt::format("{}, {}", id, what);
    const std::size_t before = e.findings();
    work.recognise(file, where);
    const std::string first = work.read(file, where);
    if (times > 1 && e.findings() == before && work.read(file, where) != first)
      e.find(where, "the same file gives another result the second time");
    return e.findings() == before;
  };
  for (const ImportFile& file : files_of_other_formats())
    if (!try_file(file, "a file of another format, " + file.name)) return;
  for (const ImportFile& file : own) {
    if (!try_file(file, fmt::format("the file of its case {}", ++number), 2)) return;
    std::size_t k = 0;
    for (const ImportFile& other : damaged(file, e.options.seed, number == 1))
      if (!try_file(other, fmt::format("the file of its case {}, damaged in the way {}", number, ++k))) return;
  }
  if (!own.empty()) check_growth(e, work, own.front(), id);
  for (std::uint32_t i = 0; i < importer.option_count; ++i)
    for (const Candidate& c : candidates(importer.options[i]))
      for (ImportFile file : own) {
        if (!c.is_allowed) continue;
        file.options = {{importer.options[i].name, c.value, {"validate"}}};
        const std::string shown = c.value.size() > 40 ? fmt::format("a text of {} bytes", c.value.size()) : c.value;
        if (!try_file(file, fmt::format("a file of its cases with {}=\"{}\"", importer.options[i].name, shown))) return;
      }
}

}  // namespace

void check_importers(Examination& e) {
  Subject subject(e);
  const ProcessState state;
  for (std::uint32_t i = 0; i < subject.plugin().importer_count; ++i)
    check_importer(e, subject, *subject.plugin().importers[i]);
  for (const std::string& change : state.changes()) e.find("", change);
}

}  // namespace isogloss::cli
