/// Importers: read a control's own table or backup file as rows of dependencies, and write such a file. An importer is
/// a struct with a `spec`, a static recognise(), read(), and write() where the format is written too:
///
///   struct AcmeToolFile {
///     static constexpr auto spec =
///         ig::importer("AcmeToolFile", "Tool table of an Acme control.").files("*.tls").fills("ToolOffsetTable");
///
///     static unsigned recognise(std::string_view text, std::string_view file_name);  // 0 to 100
///
///     void read(ig::Import& file) const;  // file.row("ToolOffsetTable", "12", place); file.cell("H", 120.5, place);
///   };
///   const ig::Register<AcmeToolFile> acme_tool_file;
///
/// Its members may be options (options.hpp), which a user gives beside the file.
#pragma once

#include <isogloss_import.h>

#include <algorithm>
#include <string>

#include "isogloss/diagnostics.hpp"
#include "isogloss/options.hpp"
#include "isogloss/spec.hpp"

namespace ig {

/// What an importer declares besides its options; a static member `spec` of the struct. Make it with ig::importer().
struct ImporterSpec {
  const char* id;
  const char* summary;
  const char* patterns = "";
  NameList tables{};
  bool is_initial = false;

  /// The usual names of such files, as shell patterns separated by blanks.
  constexpr ImporterSpec files(const char* names) const {
    ImporterSpec s = *this;
    s.patterns = names;
    return s;
  }
  /// The dependencies that it gives rows for, at least one.
  template <class... S>
  constexpr ImporterSpec fills(S... ids) const {
    ImporterSpec s = *this;
    (s.tables.add(ids), ...);
    return s;
  }
  /// The file gives values that the control begins with: of the files in a folder it is read before the others.
  constexpr ImporterSpec initial_values() const {
    ImporterSpec s = *this;
    s.is_initial = true;
    return s;
  }
};

/// `id` is the format that a user names, `summary` one sentence.
constexpr ImporterSpec importer(const char* id, const char* summary) { return {.id = id, .summary = summary}; }

/// A line of a file without its end; `begin` is its byte offset.
struct TextLine {
  std::string_view text;
  std::size_t begin = 0;
};

/// The lines of a text. They end in LF, CR LF or CR.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {}

  class Iterator {
   public:
    Iterator(std::string_view text, std::size_t begin) : text_(text), line_{{}, begin} { find_end(); }
    const TextLine& operator*() const { return line_; }
    const TextLine* operator->() const { return &line_; }
    Iterator& operator++() {
      line_.begin += line_.text.size();
      if (line_.begin < text_.size()) line_.begin += text_.substr(line_.begin).starts_with("\r\n") ? 2 : 1;
      find_end();
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.line_.begin == b.line_.begin; }

   private:
    void find_end() {
      const std::string_view rest = text_.substr(line_.begin);
      line_.text = rest.substr(0, rest.find_first_of("\r\n"));
    }
    std::string_view text_;
    TextLine line_;
  };
  Iterator begin() const { return {text_, 0}; }
  Iterator end() const { return {text_, text_.size()}; }

 private:
  std::string_view text_;
};

/// The whole lines of what recognise() gets: of a large file the host shows the beginning, and so the last line is cut.
inline std::string_view whole_lines(std::string_view head) {
  constexpr std::size_t shown = std::size_t{64} << 10;
  return head.size() < shown ? head : head.substr(0, head.substr(0, shown).find_last_of("\r\n") + 1);
}

/// Counts the entries that recognise() looks at. A damaged entry does not make the file another's, or the whole table
/// would be lost for one line: read() reports that line.
struct EntryCount {
  std::size_t own = 0, others = 0;

  void add(bool is_own) { ++(is_own ? own : others); }
  /// `sure` where all entries are of the format, half of it where up to a quarter is not, otherwise 0.
  constexpr unsigned confidence(unsigned sure) const {
    if (own == 0 || others > own / 3) return 0;
    return others == 0 ? sure : sure / 2;
  }
};

/// A part of a file as diagnostics quote it: at most 40 bytes and whole characters, without control characters.
inline std::string shown_part(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::size_t end = std::min(text.size(), longest);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  std::string out(text.substr(0, end));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7F; }, ' ');
  return end < text.size() ? out + "…" : out;
}

/// A file that an importer reads. Places are byte offsets into text().
class Import {
 public:
  Import(const ig_import_api* api, ig_import* raw) : api_(api), raw_(raw), text_(to_view(api->text(raw))) {}

  /// UTF-8.
  std::string_view text() const { return text_; }
  /// Without its folder.
  std::string_view file_name() const { return to_view(api_->file_name(raw_)); }
  TextLines lines() const { return TextLines(text_); }

  /// The cells that follow belong to this row of a dependency's table. A row that comes again is the same row.
  void row(std::string_view dependency, std::string_view key, std::size_t place) {
    api_->row(raw_, to_text(dependency), to_text(key), place);
  }
  void row(std::string_view dependency, std::int64_t key, std::size_t place) {
    row(dependency, std::to_string(key), place);
  }
  /// A cell of the row, in the unit of its column. A cell that comes again has the later value.
  void cell(std::string_view column, double value, std::size_t place) {
    api_->number_cell(raw_, to_text(column), value, place);
  }
  void cell(std::string_view column, std::string_view value, std::size_t place) {
    api_->text_cell(raw_, to_text(column), to_text(value), place);
  }
  void option(std::string_view dependency, std::string_view name, std::string_view value, std::size_t place) {
    api_->option(raw_, to_text(dependency), to_text(name), to_text(value), place);
  }
  /// Says that begin to end has no effect: what it is ("column LAST_USE"), and why. Say the same of the same things:
  /// they are counted and shown once.
  void unused(std::string_view what, std::string_view why, std::size_t begin, std::size_t end) {
    api_->unused(raw_, to_text(what), to_text(why), begin, end);
  }
  /// The rows that the machine's own file has for a table, and their cells as texts, empty where there are none. A file
  /// that is imported without a machine, and a host of contract 1.7, have no such rows.
  std::uint32_t machine_rows(std::string_view dependency) const {
    return api_->host_minor < 8 ? 0 : api_->machine_row_count(raw_, to_text(dependency));
  }
  std::string_view machine_key(std::string_view dependency, std::uint32_t row) const {
    return api_->host_minor < 8 ? std::string_view{} : to_view(api_->machine_row_key(raw_, to_text(dependency), row));
  }
  std::string_view machine_cell(std::string_view dependency, std::uint32_t row, std::string_view column) const {
    return api_->host_minor < 8 ? std::string_view{}
                                : to_view(api_->machine_cell(raw_, to_text(dependency), row, to_text(column)));
  }
  /// Reports a diagnostic that the plugin declares. The arguments, numbers or texts, replace {0}, {1} … in its text.
  template <class... Args>
  void report(DiagnosticCode diagnostic, std::size_t begin, std::size_t end, const Args&... args) {
    const std::array<ig_argument, sizeof...(Args)> list{detail::argument(args)...};
    api_->report(raw_, detail::diagnostic_table().find(diagnostic.code), begin, end, list.data(), sizeof...(Args));
  }

 private:
  const ig_import_api* api_;
  ig_import* raw_;
  std::string_view text_;
};

/// A file that an importer writes from the tables of a machine.
class Export {
 public:
  Export(const ig_export_api* api, ig_export* raw) : api_(api), raw_(raw) {}

  std::uint32_t rows(std::string_view dependency) const { return api_->row_count(raw_, to_text(dependency)); }
  std::string_view key(std::string_view dependency, std::uint32_t row) const {
    return to_view(api_->row_key(raw_, to_text(dependency), row));
  }
  /// Empty where the row has no such cell.
  std::string_view cell(std::string_view dependency, std::uint32_t row, std::string_view column) const {
    return to_view(api_->cell(raw_, to_text(dependency), row, to_text(column)));
  }
  void write(std::string_view bytes) { api_->write(raw_, to_text(bytes)); }
  /// Says what the format has no place for, and why.
  void unused(std::string_view what, std::string_view why) { api_->unused(raw_, to_text(what), to_text(why)); }

 private:
  const ig_export_api* api_;
  ig_export* raw_;
};

namespace detail {

/// Options of an importer are members as those of a syntax are; Api and File are those of reading or of writing.
template <class Api, class File>
struct ImporterLink {
  const Api* api;
  File* file;

  static const ImporterLink& of(ig_link* link) { return *reinterpret_cast<const ImporterLink*>(link); }
  static ig_link_api link_api() {
    ig_link_api out{};
    out.struct_size = sizeof out;
    out.host_minor = IG_ABI_MINOR;
    out.option_number = [](ig_link* l, std::uint32_t i) { return of(l).api->option_number(of(l).file, i); };
    out.option_integer = [](ig_link* l, std::uint32_t i) { return of(l).api->option_integer(of(l).file, i); };
    out.option_text = [](ig_link* l, std::uint32_t i) { return of(l).api->option_text(of(l).file, i); };
    return out;
  }
};

/// Makes the importer with its options and calls `work` with it; what it throws becomes a failure.
template <class T, class Api, class File, class Work>
ig_status with_importer(const Api* api, File* file, Work&& work) noexcept {
  const auto fail = [&](std::string_view why) {
    api->fail(file, to_text(why));
    return IG_FAILED;
  };
  try {
    ImporterLink<Api, File> link{api, file};
    const ig_link_api options = ImporterLink<Api, File>::link_api();
    Binding bound{&options, reinterpret_cast<ig_link*>(&link), nullptr, &recorded_of<T>()};
    std::unique_ptr<T> importer;
    {
      const Scope<Binding> scope(binding, &bound);
      importer = std::make_unique<T>();
    }
    work(*importer);
    return IG_CHANGED;
  } catch (const std::exception& e) {
    return fail(e.what());
  } catch (...) {
    return fail("an exception that is no std::exception");
  }
}

template <class T>
class ImporterDescriptor {
 public:
  ImporterDescriptor() {
    {
      const Scope<Recorder> scope(recorder, &recorded_);
      [[maybe_unused]] const T prototype{};
    }
    out_.struct_size = sizeof out_;
    out_.option_count = static_cast<std::uint32_t>(recorded_.options.size());
    out_.id = T::spec.id;
    out_.summary = T::spec.summary;
    const std::string file = snake_case(T::spec.id);
    out_.page = embedded_page(file.c_str());
    out_.cases = embedded_page((file + ".cases").c_str());
    out_.folder = embedded_folder(file.c_str());
    out_.files = T::spec.patterns;
    out_.dependencies = T::spec.tables.data();
    out_.options = recorded_.options.data();
    out_.is_initial = T::spec.is_initial ? 1 : 0;
    out_.recognise = [](ig_text text, ig_text name) noexcept -> std::uint32_t {
      try {
        return static_cast<std::uint32_t>(T::recognise(to_view(text), to_view(name)));
      } catch (...) {
        return 0;
      }
    };
    out_.read = [](const ig_import_api* api, ig_import* raw) noexcept {
      return with_importer<T>(api, raw, [&](const T& importer) {
        Import in(api, raw);
        importer.read(in);
      });
    };
    if constexpr (requires(const T& t, Export& out) { t.write(out); })
      out_.write = [](const ig_export_api* api, ig_export* raw) noexcept {
        return with_importer<T>(api, raw, [&](const T& importer) {
          Export out(api, raw);
          importer.write(out);
        });
      };
  }
  const ig_importer* get() const { return &out_; }
  const Recorder& recorded() const { return recorded_; }

 private:
  Recorder recorded_;
  ig_importer out_{};
};

}  // namespace detail
}  // namespace ig
