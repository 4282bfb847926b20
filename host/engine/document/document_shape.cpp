#include "document/document_shape.hpp"

#include <functional>
#include <iterator>
#include <limits>
#include <unordered_map>
#include <utility>

namespace isogloss {

namespace {

constexpr std::string_view frames_prefix = "ProgramToMcTransform.";

/// The tree while it is made. The names are those of the layout, which outlives it.
class ShapeDrafts {
 public:
  static constexpr std::size_t root = 0;

  explicit ShapeDrafts(std::size_t paths) {
    drafts_.reserve(2 * paths + 8);
    drafts_.emplace_back();
    by_name_.reserve(2 * paths + 8);
  }

  ShapeNode& operator[](std::size_t node) { return drafts_[node].node; }

  /// Made where it is not there yet.
  std::size_t child(std::size_t parent, std::string_view name) {
    const auto [found, is_new] = by_name_.try_emplace({parent, name}, drafts_.size());
    if (is_new) {
      drafts_.emplace_back().node.name = name;
      drafts_[parent].children.push_back(found->second);
    }
    return found->second;
  }
  std::size_t code(std::size_t parent, std::string_view name) {
    drafts_[parent].has_codes = true;
    return child(parent, name);
  }

  /// The node that a path leads to, made on the way. A code keeps its decimals in one name.
  std::size_t at(std::size_t parent, std::string_view path) {
    while (true) {
      const std::size_t code = drafts_[parent].has_codes ? longest_code(parent, path) : none;
      const std::size_t point = code != none ? drafts_[code].node.name.size() : path.find('.');
      parent = code != none ? code : child(parent, path.substr(0, point));
      if (point >= path.size()) return parent;
      path.remove_prefix(point + 1);
    }
  }

  /// The children of a node, with all that is below them.
  std::vector<ShapeNode> take_children(std::size_t parent) {
    std::vector<ShapeNode> out;
    out.reserve(drafts_[parent].children.size());
    for (const std::size_t i : drafts_[parent].children) {
      ShapeNode& node = out.emplace_back(std::move(drafts_[i].node));
      if (drafts_[i].children.empty()) continue;
      std::vector<ShapeNode> below = take_children(i);
      node.children.insert(node.children.end(), std::make_move_iterator(below.begin()),
                           std::make_move_iterator(below.end()));
    }
    return out;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  struct Draft {
    ShapeNode node{};
    std::vector<std::size_t> children{};
    bool has_codes = false;
  };
  struct Name {
    std::size_t parent;
    std::string_view name;
    bool operator==(const Name&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Name& n) const {
      return std::hash<std::string_view>()(n.name) + n.parent * 0x9e3779b97f4a7c15u;
    }
  };

  /// A code with decimals may stand beside the one without.
  std::size_t longest_code(std::size_t parent, std::string_view path) const {
    for (std::size_t end = path.size(); end != 0 && end != std::string_view::npos; end = path.rfind('.', end - 1)) {
      const auto found = by_name_.find({parent, path.substr(0, end)});
      if (found != by_name_.end() && drafts_[found->second].node.kind == ShapeNode::Kind::code) return found->second;
    }
    return none;
  }

  std::vector<Draft> drafts_;
  std::unordered_map<Name, std::size_t, Hash> by_name_;
};

void add_mask(std::vector<ShapeNode::Mask>& masks, std::uint32_t word, std::uint64_t bits) {
  for (ShapeNode::Mask& m : masks) {
    if (m.word != word) continue;
    m.bits |= bits;
    return;
  }
  masks.push_back({word, bits});
}
void add_field(std::vector<ShapeNode::Mask>& masks, ig_field f) {
  add_mask(masks, f >> 6, std::uint64_t{1} << (f & 63));
}

/// Every section knows the fields below it, so that one without values costs a test.
void collect_fields(ShapeNode& node) {
  using enum ShapeNode::Kind;
  if (node.kind == code) add_field(node.codes, node.field);
  for (ShapeNode& child : node.children) {
    if (child.kind == field) add_field(node.fields, child.field);
    node.has_lists |= child.kind == list;
    if (child.kind != section && child.kind != code) continue;
    collect_fields(child);
    for (const ShapeNode::Mask& m : child.fields) add_mask(node.fields, m.word, m.bits);
    for (const ShapeNode::Mask& m : child.codes) add_mask(node.codes, m.word, m.bits);
    node.has_lists |= child.has_lists;
  }
}

bool is_owner(const FieldInfo& info) {
  return info.type == IG_CODE && info.path.starts_with(parsing_prefix) && !info.path.starts_with(flags_prefix);
}

bool is_flag(const FieldInfo& info) {
  return !info.hidden && info.type == IG_CODE && info.path.starts_with(flags_prefix);
}

bool shows_as_value(const FieldInfo& info) {
  return !info.hidden && info.type != IG_CODE && info.type != IG_TRANSFORM && info.type != IG_SWITCH;
}

std::size_t rank(const std::string& section) {
  const std::vector<std::string>& order = section_order();
  return static_cast<std::size_t>(std::find(order.begin(), order.end(), section) - order.begin());
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

}  // namespace

std::vector<ShapeNode> document_shape(const Layout& layout) {
  using enum ShapeNode::Kind;
  ShapeDrafts drafts(layout.fields.size() + layout.lists.size());
  drafts.child(ShapeDrafts::root, "Source");
  drafts[drafts.child(ShapeDrafts::root, "UnparsedText")].kind = unparsed;
  const std::size_t parsing = drafts.child(ShapeDrafts::root, "Parsing");
  drafts[drafts.child(parsing, "Flags")].kind = flags;
  // The words that stand for themselves come before the codes that own some.
  for (const ig_field f : layout.shown) {
    const std::string_view path = layout.fields[f].path;
    if (!path.starts_with(parsing_prefix) || path.find('.', parsing_prefix.size()) != std::string_view::npos) continue;
    if (shows_as_value(layout.fields[f])) drafts.child(parsing, path.substr(parsing_prefix.size()));
  }
  for (ig_field f = 0; f < layout.fields.size(); ++f) {
    const FieldInfo& info = layout.fields[f];
    if (info.hidden || !is_owner(info)) continue;
    ShapeNode& node = drafts[drafts.code(parsing, std::string_view(info.path).substr(parsing_prefix.size()))];
    node.kind = code;
    node.field = f;
  }
  for (const ig_field f : layout.shown) {
    if (!shows_as_value(layout.fields[f])) continue;
    ShapeNode& node = drafts[drafts.at(ShapeDrafts::root, layout.fields[f].path)];
    node.kind = field;
    node.field = f;
  }
  for (std::size_t i = 0; i < layout.lists.size(); ++i) {
    ShapeNode& node = drafts[drafts.at(ShapeDrafts::root, layout.lists[i].path)];
    node.kind = list;
    node.field = static_cast<ig_field>(i);
    node.children = record_shape(layout.lists[i]);
  }
  const std::string_view frames = frames_prefix.substr(0, frames_prefix.size() - 1);
  drafts[drafts.child(ShapeDrafts::root, frames)].kind = transforms;
  std::vector<ShapeNode> sections = drafts.take_children(ShapeDrafts::root);
  std::stable_sort(sections.begin(), sections.end(),
                   [](const ShapeNode& a, const ShapeNode& b) { return rank(a.name) < rank(b.name); });
  for (ShapeNode& s : sections) {
    if (s.name == frames) s.children.clear();
    collect_fields(s);
    s.is_parsing = s.name == "Parsing";
    if (!s.is_parsing) continue;
    for (ig_field f = 0; f < layout.fields.size(); ++f)
      if (is_flag(layout.fields[f])) add_field(s.codes, f);
  }
  return sections;
}

std::vector<ShapeNode> record_shape(const ListInfo& list) {
  ShapeDrafts drafts(list.fields.size());
  for (std::size_t i = 0; i < list.fields.size(); ++i) {
    if (list.fields[i].hidden || list.fields[i].type == IG_TEXT) continue;
    ShapeNode& node = drafts[drafts.at(ShapeDrafts::root, list.fields[i].path)];
    node.kind = ShapeNode::Kind::field;
    node.field = static_cast<ig_field>(i);
  }
  std::vector<ShapeNode> nodes = drafts.take_children(ShapeDrafts::root);
  for (ShapeNode& node : nodes) collect_fields(node);
  return nodes;
}

std::string leftover_value(const Leftover& left, std::string_view source) {
  if (left.begin >= left.end || left.end > source.size()) return left.value;
  std::string_view written = source.substr(left.begin, left.end - left.begin);
  const std::size_t point = left.kind == IG_LEFT_WORD || left.kind == IG_LEFT_EXPRESSION ? left.name.rfind('.') : 0;
  const std::string_view name = std::string_view(left.name).substr(point == std::string::npos ? 0 : point + 1);
  std::size_t at = 0;
  for (const char c : name) {
    while (at < written.size() && (written[at] == ' ' || written[at] == '\t')) ++at;
    if (at == written.size() || lower(written[at]) != lower(c)) return std::string(written);
    ++at;
  }
  written = trimmed(written.substr(at));
  if (written.starts_with('=')) written = trimmed(written.substr(1));
  return std::string(written);
}

std::string unparsed_text(const Document& document) {
  std::string all;
  for (const Leftover& left : document.leftovers) {
    if (left.kind != IG_LEFT_TEXT && left.kind != IG_LEFT_STATEMENT) continue;
    const std::string_view text = trimmed(left.name);
    if (text.empty()) continue;
    if (!all.empty()) all += ' ';
    all += text;
  }
  return all;
}

std::vector<std::string> open_codes(const Document& document, const std::vector<ig_field>& flags) {
  struct Open {
    std::uint32_t begin, end;
    std::int64_t ordinal;
    std::string_view name;
  };
  std::vector<Open> known;
  for (const ig_field f : flags) {
    if (!document.present(f) || document.taken(f)) continue;
    known.push_back({document.word_begin(f), document.word_end(f), document.value(f).integer,
                     std::string_view(document.layout().fields[f].path).substr(flags_prefix.size())});
  }
  std::stable_sort(known.begin(), known.end(), [](const Open& a, const Open& b) { return a.ordinal < b.ordinal; });
  for (const Leftover& left : document.leftovers) {
    if (left.kind != IG_LEFT_UNKNOWN && left.kind != IG_LEFT_CODE) continue;
    // Without columns (a document read from JSON) `begin` counts the codes before it.
    const bool has_place = left.begin < left.end;
    const auto follows = std::find_if(known.begin(), known.end(), [&](const Open& code) {
      if (has_place) return code.begin < code.end && code.begin > left.begin;
      return code.ordinal > std::int64_t{left.begin};
    });
    known.insert(follows, {left.begin, left.end, has_place ? 0 : std::int64_t{left.begin}, left.name});
  }
  std::vector<std::string> names;
  for (const Open& code : known) names.emplace_back(code.name);
  return names;
}

DocumentView::DocumentView(const Layout& layout) : sections_(document_shape(layout)), transforms_(layout.transforms) {
  for (ig_field f = 0; f < layout.fields.size(); ++f)
    if (is_flag(layout.fields[f])) flags_.push_back(f);
}

bool DocumentView::has_open_codes(const Document& d) const {
  for (const Leftover& left : d.leftovers)
    if (left.kind == IG_LEFT_UNKNOWN || left.kind == IG_LEFT_CODE) return true;
  std::uint64_t open = 0;
  for (std::uint32_t w = 0; w < d.words(); ++w) open |= d.bits(w).present & d.bits(w).codes & ~d.bits(w).taken;
  return open != 0 &&
         std::any_of(flags_.begin(), flags_.end(), [&](ig_field f) { return d.present(f) && !d.taken(f); });
}

}  // namespace isogloss
