/// How the fields of a layout nest when a document is shown. The JSON of cases, the block stream and the text for
/// people are one walk over this shape, each with a sink of its own.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/document.hpp"

namespace isogloss {

struct ShapeNode {
  enum class Kind : std::uint8_t { section, field, code, flags, list, transforms, unparsed };
  struct Mask {
    std::uint32_t word;
    std::uint64_t bits;
  };
  Kind kind = Kind::section;
  std::string name;
  ig_field field = IG_NO_FIELD;  ///< field; code: the code that owns the children; list: its index
  std::vector<ShapeNode> children;
  std::vector<Mask> fields;  ///< all fields below, but the codes
  std::vector<Mask> codes;   ///< all codes below, and its own
  bool has_lists = false;    ///< somewhere below
  bool is_parsing = false;   ///< where words without a field show
};

/// Sections in the order in which they show.
std::vector<ShapeNode> document_shape(const Layout& layout);
/// The fields of one record of a list; `field` is the index in the record.
std::vector<ShapeNode> record_shape(const ListInfo& list);

/// "Parsing.Flags." or "Parsing."
inline constexpr std::string_view flags_prefix = "Parsing.Flags.";
inline constexpr std::string_view parsing_prefix = "Parsing.";

/// What a leftover word or expression holds: "#1" of the source's X#1.
std::string leftover_value(const Leftover& left, std::string_view source);
/// The texts that no scanner took and the statements that are not executed, joined by one blank.
std::string unparsed_text(const Document& document);
/// The codes that no syntax took and the unknown codes, in their order.
std::vector<std::string> open_codes(const Document& document, const std::vector<ig_field>& flags);

/// What a walk includes.
struct ShowOptions {
  const std::set<std::string>* sections = nullptr;  ///< only these
  bool only_fresh = false;                          ///< what was written in this block
  const BlockSource* source = nullptr;              ///< Source.File, Line and Text from here
};

/// Gives a document to a sink: begin(key), begin_list(key), begin_record(), end(), end_list(), number, integer,
/// boolean, text (with key) and item (texts and numbers in a list).
class DocumentView {
 public:
  explicit DocumentView(const Layout& layout);

  template <class Sink>
  void show(const Document& d, const SymbolTable& symbols, const ShowOptions& options, Sink& sink) const {
    Walk<Sink>{*this, d, symbols, options, sink}.run();
  }
  /// One section alone, in a walk of the caller's.
  template <class Sink>
  void show_section(const ShapeNode& section, const Document& d, const SymbolTable& symbols, const ShowOptions& options,
                    Sink& sink) const {
    Walk<Sink>{*this, d, symbols, options, sink}.run_section(section);
  }
  const std::vector<ShapeNode>& sections() const { return sections_; }
  const std::vector<ig_field>& transforms() const { return transforms_; }

 private:
  template <class Sink>
  struct Walk {
    const DocumentView& view;
    const Document& d;
    const SymbolTable& symbols;
    const ShowOptions& options;
    Sink& sink;

    void run() {
      for (const ShapeNode& section : view.sections_) {
        if (options.sections != nullptr && !options.sections->contains(section.name)) continue;
        run_section(section);
      }
    }

    void run_section(const ShapeNode& section) {
      if (options.source != nullptr && section.name == "Source")
        show_source(section);
      else
        show(section);
    }

    void show_source(const ShapeNode& section) {
      sink.begin("Source");
      sink.text("File", options.source->file);
      sink.integer("Line", options.source->line);
      sink.text("Text", options.source->text);
      for (const ShapeNode& child : section.children)
        if (child.name != "File" && child.name != "Line" && child.name != "Text") show(child);
      sink.end();
    }

    bool holds(ig_field f) const { return options.only_fresh ? d.present(f) && d.fresh(f) : d.present(f); }

    bool is_visible(const ShapeNode& node) const {
      using enum ShapeNode::Kind;
      switch (node.kind) {
        case field: return holds(node.field) || expression(node.field) != nullptr;
        case flags: return view.has_open_codes(d);
        case list: return d.lists[node.field].count != 0;
        case transforms:
          return std::any_of(view.transforms_.begin(), view.transforms_.end(), [&](ig_field f) { return holds(f); });
        case unparsed: return has_leftover(IG_LEFT_TEXT) || has_leftover(IG_LEFT_STATEMENT);
        case code:
        case section: break;
      }
      for (const ShapeNode::Mask& m : node.fields) {
        const Document::Bits& bits = d.bits(m.word);
        if (((options.only_fresh ? bits.fresh : bits.present) & bits.present & m.bits) != 0) return true;
      }
      for (const ShapeNode::Mask& m : node.codes)
        if ((d.bits(m.word).present & ~d.bits(m.word).taken & m.bits) != 0) return true;
      if (node.is_parsing && !d.leftovers.empty() && has_nameless_word()) return true;
      return (node.has_lists || !d.leftovers.empty()) &&
             std::any_of(node.children.begin(), node.children.end(),
                         [&](const ShapeNode& child) { return is_visible(child); });
    }

    void show(const ShapeNode& node) {
      if (!is_visible(node)) return;
      using enum ShapeNode::Kind;
      switch (node.kind) {
        case field:
          if (holds(node.field))
            show_field(node);
          else
            show_leftover(node.name, *expression(node.field));
          return;
        case flags:
          sink.begin_list(node.name);
          for (const std::string& name : open_codes(d, view.flags_)) sink.item(name);
          sink.end_list();
          return;
        case list: show_list(node); return;
        case transforms: show_transforms(node); return;
        case unparsed: sink.text(node.name, unparsed_text(d)); return;
        case code:
        case section: break;
      }
      sink.begin(node.name);
      for (const ShapeNode& child : node.children) show(child);
      if (node.is_parsing)
        for (const Leftover& left : d.leftovers)
          if (is_nameless_word(left)) show_leftover(sink.key_of(left.name), left);
      sink.end();
    }

    void show_field(const ShapeNode& node) {
      const FieldInfo& info = d.layout().fields[node.field];
      if (info.type == IG_TEXT)
        sink.text(node.name, d.text(node.field));
      else
        show_value(node.name, info.type, d.value(node.field));
    }

    void show_value(const std::string& name, ig_type type, ig_value v) {
      switch (type) {
        case IG_NUMBER:
          if (std::isfinite(v.number)) sink.number(name, v.number);
          return;
        case IG_BOOLEAN: sink.boolean(name, v.integer != 0); return;
        case IG_SYMBOL: sink.text(name, symbols.text(static_cast<ig_symbol>(v.symbol))); return;
        default: sink.integer(name, v.integer); return;
      }
    }

    void show_list(const ShapeNode& node) {
      const ListData& list = d.lists[node.field];
      sink.begin_list(node.name);
      for (std::uint32_t i = 0; i < list.count; ++i) {
        if (list.present[i] == 0) continue;
        sink.begin_record();
        show_record(node.children, list.present[i], list.values.data() + std::size_t{i} * list.stride,
                    d.layout().lists[node.field]);
        sink.end();
      }
      sink.end_list();
    }

    void show_record(const std::vector<ShapeNode>& nodes, std::uint64_t present, const ig_value* values,
                     const ListInfo& list) {
      for (const ShapeNode& node : nodes) {
        if (node.kind == ShapeNode::Kind::field) {
          if ((present >> node.field & 1) != 0) show_value(node.name, list.fields[node.field].type, values[node.field]);
        } else if (!node.fields.empty() && (present & node.fields.front().bits) != 0) {
          sink.begin(node.name);
          show_record(node.children, present, values, list);
          sink.end();
        }
      }
    }

    void show_transforms(const ShapeNode& node) {
      sink.begin_list(node.name);
      for (const ig_field f : view.transforms_) {
        if (!holds(f)) continue;
        sink.begin_record();
        sink.text("Source", std::string_view(d.layout().fields[f].path).substr(node.name.size() + 1));
        sink.text("Kind", d.is_moving_frame(f) ? "Dynamic" : "Static");
        sink.begin_list("Mat4d");
        for (const double element : d.frame(f).matrix) sink.item(element);
        sink.end_list();
        sink.end();
      }
      sink.end_list();
    }

    const Leftover* expression(ig_field f) const {
      for (const Leftover& left : d.leftovers)
        if (left.kind == IG_LEFT_EXPRESSION && left.field == f) return &left;
      return nullptr;
    }
    bool has_leftover(ig_leftover_kind kind) const {
      return std::any_of(d.leftovers.begin(), d.leftovers.end(), [&](const Leftover& l) { return l.kind == kind; });
    }
    bool is_nameless_word(const Leftover& left) const {
      return (left.kind == IG_LEFT_WORD || left.kind == IG_LEFT_EXPRESSION) && left.field >= d.size();
    }
    bool has_nameless_word() const {
      return std::any_of(d.leftovers.begin(), d.leftovers.end(),
                         [&](const Leftover& l) { return is_nameless_word(l); });
    }
    void show_leftover(const std::string& name, const Leftover& left) {
      const std::string value = leftover_value(left, d.source.text);
      double number = 0;
      const char* const first = value.data() + (value.starts_with('+') ? 1 : 0);
      const auto [end, error] = std::from_chars(first, value.data() + value.size(), number, std::chars_format::fixed);
      if (left.kind == IG_LEFT_WORD && error == std::errc() && end == value.data() + value.size() &&
          std::isfinite(number))
        sink.number(name, number);
      else
        sink.text(name, value);
    }
  };

  bool has_open_codes(const Document& d) const;

  std::vector<ShapeNode> sections_;
  std::vector<ig_field> flags_;       // the codes that own no words
  std::vector<ig_field> transforms_;  // in chain order
};

}  // namespace isogloss
