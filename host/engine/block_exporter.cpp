// Blocks as a stream: JSON Lines in the shape of show_json(), numbers exact, or text for people, who see what each
// block wrote.
#include <optional>

#include "document_shape.hpp"
#include "isogloss/engine/exporter.hpp"
#include "text_buffer.hpp"

namespace isogloss {

namespace {

class JsonLinesSink {
 public:
  explicit JsonLinesSink(TextBuffer& buffer) : buffer_(buffer) {}

  void begin_line() {
    buffer_.append("{");
    first_ = true;
  }
  void end_line() { buffer_.append("}\n"); }

  static std::string key_of(const std::string& name) {
    const std::string quoted = json_string(name);
    return quoted.substr(1, quoted.size() - 2);
  }

  void begin(const std::string& name) { open(name, "{"); }
  void begin_list(const std::string& name) { open(name, "["); }
  void begin_record() {
    buffer_.append(first_ ? "{" : ",{");
    first_ = true;
  }
  void end() { close("}"); }
  void end_list() { close("]"); }

  void number(const std::string& name, double value) {
    key(name);
    item_text(value);
  }
  void integer(const std::string& name, std::int64_t value) {
    key(name);
    buffer_.commit(write_integer(buffer_.reserve(number_room), value));
  }
  void boolean(const std::string& name, bool value) {
    key(name);
    buffer_.append(value ? "true" : "false");
  }
  void text(const std::string& name, std::string_view value) {
    key(name);
    buffer_.append(json_string(value));
  }
  void item(const std::string& value) {
    separate();
    buffer_.append(json_string(value));
  }
  void item(double value) {
    separate();
    item_text(value);
  }

 private:
  void separate() {
    if (!first_) buffer_.append(",");
    first_ = false;
  }
  void key(const std::string& name) {
    char* p = buffer_.reserve(name.size() + 8);
    if (!first_) *p++ = ',';
    first_ = false;
    *p++ = '"';
    p = put(p, std::string_view(name));
    *p++ = '"';
    *p++ = ':';
    buffer_.commit(p);
  }
  void open(const std::string& name, std::string_view bracket) {
    key(name);
    buffer_.append(bracket);
    first_ = true;
  }
  void close(std::string_view bracket) {
    buffer_.append(bracket);
    first_ = false;
  }
  void item_text(double value) { buffer_.commit(write_exact(buffer_.reserve(number_room), value)); }

  TextBuffer& buffer_;
  bool first_ = true;
};

/// A section a line: "Feedrate FeedrateValue=600 Unit=mm/min"; records of a list on lines of their own.
class TextSink {
 public:
  explicit TextSink(TextBuffer& buffer) : buffer_(buffer) {}

  void begin(const std::string& key) {
    append(levels_.empty() ? margin + key : key + "(");
    levels_.push_back({levels_.empty() ? "\n" : ")", !levels_.empty()});
  }
  void end() { close(); }
  void begin_list(const std::string& key) {
    append(levels_.empty() ? margin + key : key);
    levels_.push_back({levels_.empty() ? "\n" : "", true});
  }
  void end_list() { close(); }
  void begin_record() {
    buffer_.append("\n" + margin + "  - ");
    levels_.push_back({"", true});
  }

  static std::string key_of(const std::string& name) { return valid_utf8(name); }
  void number(const std::string& key, double value) { pair(key, text_of(value)); }
  void integer(const std::string& key, std::int64_t value) { pair(key, std::to_string(value)); }
  void boolean(const std::string& key, bool value) { pair(key, value ? "true" : "false"); }
  void text(const std::string& key, std::string_view value) { pair(key, valid_utf8(value)); }
  void item(const std::string& value) {
    buffer_.append((levels_.back().is_empty ? "=" : ",") + valid_utf8(value));
    levels_.back().is_empty = false;
  }
  void item(double value) { item(text_of(value)); }

 private:
  struct Level {
    std::string_view closing;
    bool is_empty;  ///< nothing to part the next text from
  };
  static inline const std::string margin = std::string(10, ' ');

  static std::string text_of(double value) {
    char text[number_room];
    return {text, write_decimal(text, value)};
  }
  void append(const std::string& text) {
    if (!levels_.empty() && !levels_.back().is_empty) buffer_.append(" ");
    if (!levels_.empty()) levels_.back().is_empty = false;
    buffer_.append(text);
  }
  void pair(const std::string& key, const std::string& value) {
    append(levels_.empty() ? margin + key + " " + value + "\n" : key + "=" + value);
  }
  void close() {
    buffer_.append(levels_.back().closing);
    levels_.pop_back();
  }

  TextBuffer& buffer_;
  std::vector<Level> levels_;
};

class BlockLines : public Exporter {
 public:
  explicit BlockLines(Output& output) : buffer_(output) {}

  void begin(Document& initial, const SymbolTable&) override { view_.emplace(initial.layout()); }
  bool block(Document& d, const SymbolTable& symbols) override {
    JsonLinesSink sink(buffer_);
    sink.begin_line();
    view_->show(d, symbols, {.source = &d.source}, sink);
    sink.end_line();
    return buffer_.ok();
  }
  bool end() override { return buffer_.flush(); }

 private:
  TextBuffer buffer_;
  std::optional<DocumentView> view_;
};

class BlockText : public Exporter {
 public:
  explicit BlockText(Output& output) : buffer_(output) {}

  void begin(Document& initial, const SymbolTable&) override { view_.emplace(initial.layout()); }
  bool block(Document& d, const SymbolTable& symbols) override {
    if (d.source.file != file_ || !named_) {
      file_ = d.source.file;
      named_ = true;
      buffer_.append(valid_utf8(file_) + "\n");
    }
    std::string line = std::to_string(d.source.line);
    if (line.size() < 6) line.insert(0, 6 - line.size(), ' ');
    const std::string text = one_line(d.source.text);
    buffer_.append(line + (text.empty() ? "" : "  " + text) + "\n");
    TextSink sink(buffer_);
    view_->show(d, symbols, {.only_fresh = true}, sink);
    return buffer_.ok();
  }
  bool end() override { return buffer_.flush(); }

 private:
  /// Control characters would break the line or the terminal.
  static std::string one_line(std::string_view text) {
    std::string out = valid_utf8(text);
    for (char& c : out)
      if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
    out.erase(out.find_last_not_of(' ') + 1);
    return out;
  }

  TextBuffer buffer_;
  std::optional<DocumentView> view_;
  std::string file_;
  bool named_ = false;
};

}  // namespace

std::unique_ptr<Exporter> make_block_exporter(Output& output, Format format) {
  if (format == Format::text) return std::make_unique<BlockText>(output);
  return std::make_unique<BlockLines>(output);
}

}  // namespace isogloss
