// Blocks as a stream: JSON Lines in the shape of show_json(), numbers exact, or text for people, who see what each
// block wrote.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <vector>

#include "document/document_shape.hpp"
#include "export/text_buffer.hpp"
#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/printable.hpp"

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

  bool is_first() const { return first_; }

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
    quote(value);
  }
  void item(const std::string& value) {
    separate();
    quote(value);
  }
  void item(double value) {
    separate();
    item_text(value);
  }

 private:
  /// Most texts stand for themselves.
  void quote(std::string_view value) {
    const bool is_plain = std::all_of(value.begin(), value.end(), [](char c) {
      return static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7f && c != '"' && c != '\\';
    });
    if (!is_plain) return buffer_.append(json_string(value));
    char* p = buffer_.reserve(value.size() + 2);
    *p++ = '"';
    p = put(p, value);
    *p++ = '"';
    buffer_.commit(p);
  }
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

  static std::string key_of(const std::string& name) { return printable(name); }
  void number(const std::string& key, double value) { pair(key, text_of(value)); }
  void integer(const std::string& key, std::int64_t value) { pair(key, std::to_string(value)); }
  void boolean(const std::string& key, bool value) { pair(key, value ? "true" : "false"); }
  void text(const std::string& key, std::string_view value) { pair(key, printable(value)); }
  void item(const std::string& value) {
    buffer_.append((levels_.back().is_empty ? "=" : ",") + printable(value));
    levels_.back().is_empty = false;
  }
  void item(double value) { item(text_of(value)); }

 private:
  struct Level {
    std::string_view closing;
    bool is_empty;  ///< nothing before it that needs a separator
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

/// The text of a section as it was last written: most sections are carried on from block to block, and to compare a few
/// values is much less work than to write them.
class WrittenSection {
 public:
  WrittenSection(const ShapeNode& node, const Layout& layout, const std::vector<ig_field>& transforms) : node_(&node) {
    if (node.kind == ShapeNode::Kind::transforms)
      transforms_ = transforms;
    else if (node.kind == ShapeNode::Kind::section && node.name != "Source")
      is_kept_ = collect(node.children, layout) && fields_.size() <= most_fields;
    is_kept_ |= !transforms_.empty();
    if (!is_kept_) fields_.clear();
  }
  const ShapeNode& node() const { return *node_; }
  bool is_kept() const { return is_kept_; }

  /// Are the values those of the text? Whatever they are, they are the ones of the text that is written now.
  bool is_as_written(const Document& d) {
    bool same = has_text_ && are_present_as_before(d);
    if (!has_text_ || !same) note_present(d);
    for (Kept& kept : kept_) {
      const std::int64_t value = d.value(kept.field).integer;
      same = same && value == kept.value;
      kept.value = value;
    }
    return (transforms_.empty() || have_same_frames(d)) && same;
  }

  std::string_view text() const { return text_; }
  void set_text(std::string_view text) {
    text_.assign(text);
    has_text_ = true;
  }
  void forget() { has_text_ = false; }

 private:
  static constexpr std::size_t most_fields = 100;
  struct Kept {
    ig_field field;
    std::int64_t value;  ///< its bits
  };
  struct KeptFrame {
    bool present = false, is_moving = false;
    std::array<double, 16> matrix{};
  };

  /// False where other than plain values may stand.
  bool collect(const std::vector<ShapeNode>& nodes, const Layout& layout) {
    return std::all_of(nodes.begin(), nodes.end(), [&](const ShapeNode& node) {
      if (node.kind == ShapeNode::Kind::section) return collect(node.children, layout);
      if (node.kind != ShapeNode::Kind::field || layout.fields[node.field].type == IG_TEXT) return false;
      fields_.push_back(node.field);
      return true;
    });
  }

  bool are_present_as_before(const Document& d) const {
    for (std::size_t i = 0; i < node_->fields.size(); ++i)
      if ((d.bits(node_->fields[i].word).present & node_->fields[i].bits) != present_[i]) return false;
    return true;
  }
  void note_present(const Document& d) {
    present_.clear();
    for (const ShapeNode::Mask& m : node_->fields) present_.push_back(d.bits(m.word).present & m.bits);
    kept_.clear();
    for (const ig_field field : fields_)
      if (d.present(field)) kept_.push_back({field, 0});
  }

  /// -0 and 0 are written differently.
  static bool has_same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  }
  bool have_same_frames(const Document& d) {
    frames_.resize(transforms_.size());
    bool same = true;
    for (std::size_t i = 0; i < transforms_.size(); ++i) {
      KeptFrame& kept = frames_[i];
      const bool present = d.present(transforms_[i]);
      if (!present && !kept.present) continue;
      const bool is_moving = d.is_moving_frame(transforms_[i]);
      const bool has_same_matrix =
          present && std::equal(kept.matrix.begin(), kept.matrix.end(), d.frame(transforms_[i]).matrix, has_same_bits);
      if (present == kept.present && is_moving == kept.is_moving && has_same_matrix) continue;
      same = false;
      kept.present = present;
      kept.is_moving = is_moving;
      if (present) std::memcpy(kept.matrix.data(), d.frame(transforms_[i]).matrix, sizeof kept.matrix);
    }
    return same;
  }

  const ShapeNode* node_;
  bool is_kept_ = false, has_text_ = false;
  std::vector<ig_field> fields_;
  std::vector<std::uint64_t> present_;  // by the masks of the node
  std::vector<Kept> kept_;
  std::vector<ig_field> transforms_;
  std::vector<KeptFrame> frames_;
  std::string text_;
};

class BlockLines : public Exporter {
 public:
  explicit BlockLines(Output& output) : buffer_(output) {}

  void begin(Document& initial, const SymbolTable&) override {
    view_.emplace(initial.layout());
    sections_.clear();
    for (const ShapeNode& node : view_->sections()) sections_.emplace_back(node, initial.layout(), view_->transforms());
  }
  bool block(Document& d, const SymbolTable& symbols) override {
    JsonLinesSink sink(buffer_);
    sink.begin_line();
    const bool has_leftovers = !d.leftovers.empty();  // they show as values
    for (WrittenSection& section : sections_) show(section, d, symbols, has_leftovers, sink);
    sink.end_line();
    return buffer_.ok();
  }
  bool end() override { return buffer_.flush(); }

 private:
  static constexpr std::size_t longest_kept = std::size_t{16} << 10;

  void show(WrittenSection& section, const Document& d, const SymbolTable& symbols, bool has_leftovers,
            JsonLinesSink& sink) {
    // The first section of a line has no comma before it.
    const bool is_kept = section.is_kept() && !sink.is_first() && !has_leftovers;
    if (is_kept && section.is_as_written(d)) return buffer_.append(section.text());
    section.forget();
    const char* const begin = buffer_.reserve(longest_kept);
    view_->show_section(section.node(), d, symbols, {.source = &d.source}, sink);
    const char* const end = buffer_.reserve(0);
    if (is_kept && end >= begin && end <= begin + longest_kept)
      section.set_text({begin, static_cast<std::size_t>(end - begin)});
  }

  TextBuffer buffer_;
  std::optional<DocumentView> view_;
  std::vector<WrittenSection> sections_;
};

class BlockText : public Exporter {
 public:
  explicit BlockText(Output& output) : buffer_(output) {}

  void begin(Document& initial, const SymbolTable&) override { view_.emplace(initial.layout()); }
  bool block(Document& d, const SymbolTable& symbols) override {
    if (d.source.file != file_ || !named_) {
      file_ = d.source.file;
      named_ = true;
      buffer_.append(printable(file_) + "\n");
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
