#include <algorithm>
#include <charconv>

#include "dap/expression.hpp"
#include "isogloss/engine/diagnostic.hpp"

namespace isogloss::dap {

namespace {

using Node = Expression::Node;
using Op = Node::Op;

constexpr std::size_t longest_expression = 4096;
constexpr unsigned deepest_expression = 64;
constexpr std::string_view known_names[] = {
    "x",         "y",         "z",         "a",         "b",       "c",     "machine.x", "machine.y",
    "machine.z", "machine.a", "machine.b", "machine.c", "feed",    "speed", "tool",      "spindle",
    "coolant",   "motion",    "line",      "file",      "program", "depth", "pass",      "block"};

struct Token {
  enum class Kind : std::uint8_t { end, number, text, name, variable, sign } kind = Kind::end;
  std::string text{};
  double number = 0;
};

bool is_name_byte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         c == '~' || c == '$' || c == '@' || static_cast<unsigned char>(c) >= 0x80;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string in_small_letters(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Thrown and caught within parse() alone.
struct Fault {
  std::string sentence;
};

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) { next(); }
  const Token& now() const { return now_; }
  bool is_sign(std::string_view sign) const { return now_.kind == Token::Kind::sign && now_.text == sign; }
  bool is_word(std::string_view word) const {
    return now_.kind == Token::Kind::name && in_small_letters(now_.text) == word;
  }
  void next() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    if (at_ == text_.size()) return void(now_ = {});
    const char c = text_[at_];
    if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) return read_number();
    if (c == '"' || c == '\'') return read_text(c);
    if (c == '#') return read_variable();
    if (is_name_byte(c)) return read_name();
    for (const std::string_view sign : {"||", "&&", "==", "!=", "<>", "<=", ">="})
      if (text_.substr(at_).starts_with(sign)) return take(Token::Kind::sign, sign.size());
    if (std::string_view("()<>=+-*/!,").find(c) == std::string_view::npos)
      throw Fault{std::string("'") + c + "' is no part of an expression"};
    take(Token::Kind::sign, 1);
  }

 private:
  void take(Token::Kind kind, std::size_t size) {
    now_ = {kind, std::string(text_.substr(at_, size)), 0};
    at_ += size;
  }
  void read_number() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) throw Fault{"a number is out of range"};
    take(Token::Kind::number, static_cast<std::size_t>(end - (text_.data() + at_)));
    now_.number = value;
  }
  void read_text(char quote) {
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) throw Fault{"a text has no closing quotation mark"};
    now_ = {Token::Kind::text, std::string(text_.substr(at_ + 1, end - at_ - 1)), 0};
    at_ = end + 1;
  }
  /// #101, #<_name>
  void read_variable() {
    std::size_t end = at_ + 1;
    if (end < text_.size() && text_[end] == '<')
      end = text_.find('>', end) == std::string_view::npos ? end : text_.find('>', end) + 1;
    else
      while (end < text_.size() && is_digit(text_[end])) ++end;
    if (end < at_ + 2) throw Fault{"# needs the number of a variable, such as #101"};
    take(Token::Kind::variable, end - at_);
  }
  void read_name() {
    std::size_t end = at_;
    while (end < text_.size() && is_name_byte(text_[end])) ++end;
    take(Token::Kind::name, end - at_);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Token now_;
};

class Parser {
 public:
  Parser(std::string_view text, const Layout& layout) : lexer_(text), layout_(layout) {}

  std::vector<Node> parse() {
    if (lexer_.now().kind == Token::Kind::end) throw Fault{"the expression is empty"};
    either();
    if (lexer_.now().kind != Token::Kind::end) throw Fault{"'" + lexer_.now().text + "' is not expected there"};
    return std::move(nodes_);
  }

 private:
  std::uint32_t add(Node node) {
    nodes_.push_back(std::move(node));
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  std::uint32_t add(Op op, std::uint32_t first, std::uint32_t second = 0) { return add({op, first, second}); }
  bool take_sign(std::string_view sign) {
    const bool is_there = lexer_.is_sign(sign);
    if (is_there) lexer_.next();
    return is_there;
  }
  bool take_word(std::string_view word) {
    const bool is_there = lexer_.is_word(word);
    if (is_there) lexer_.next();
    return is_there;
  }

  std::uint32_t either() {
    std::uint32_t left = both();
    while (take_word("or") || take_sign("||")) left = add(Op::either, left, both());
    return left;
  }
  std::uint32_t both() {
    std::uint32_t left = negated();
    while (take_word("and") || take_sign("&&")) left = add(Op::both, left, negated());
    return left;
  }
  std::uint32_t negated() {
    const Depth depth(*this);
    if (take_word("not") || take_sign("!")) return add(Op::negated, negated());
    return comparison();
  }
  std::uint32_t comparison() {
    const std::uint32_t left = sum();
    constexpr std::pair<std::string_view, Op> signs[] = {
        {"==", Op::equal},       {"=", Op::equal},     {"!=", Op::unequal}, {"<>", Op::unequal},
        {"<=", Op::not_greater}, {">=", Op::not_less}, {"<", Op::less},     {">", Op::greater}};
    for (const auto& [sign, op] : signs)
      if (take_sign(sign)) return add(op, left, sum());
    return state_of(left);
  }
  /// "spindle off", "spindle is cw".
  std::uint32_t state_of(std::uint32_t left) {
    const bool has_is = take_word("is");
    if (lexer_.is_word("and") || lexer_.is_word("or") || lexer_.now().kind != Token::Kind::name) {
      if (has_is) throw Fault{"'is' needs a word behind it, such as on or off"};
      return left;
    }
    if (take_word("on")) return add(Op::is_on, left);
    if (take_word("off")) return add(Op::is_off, left);
    const std::uint32_t word = add({Op::constant, 0, 0, Value::of(lexer_.now().text)});
    lexer_.next();
    return add(Op::equal, left, word);
  }
  std::uint32_t sum() {
    std::uint32_t left = product();
    while (true) {
      if (take_sign("+"))
        left = add(Op::sum, left, product());
      else if (take_sign("-"))
        left = add(Op::difference, left, product());
      else
        return left;
    }
  }
  std::uint32_t product() {
    std::uint32_t left = factor();
    while (true) {
      if (take_sign("*"))
        left = add(Op::product, left, factor());
      else if (take_sign("/"))
        left = add(Op::quotient, left, factor());
      else
        return left;
    }
  }
  std::uint32_t factor() {
    const Depth depth(*this);
    if (take_sign("-")) return add(Op::minus, factor());
    if (take_sign("+")) return factor();
    if (take_sign("(")) {
      const std::uint32_t inside = either();
      if (!take_sign(")")) throw Fault{"a bracket is not closed"};
      return inside;
    }
    Token token = lexer_.now();
    if (token.kind == Token::Kind::end) throw Fault{"the expression ends where a value is missing"};
    if (token.kind == Token::Kind::sign) throw Fault{"'" + token.text + "' stands where a value is missing"};
    lexer_.next();
    switch (token.kind) {
      case Token::Kind::number: return add({Op::constant, 0, 0, Value::of(token.number)});
      case Token::Kind::text: return add({Op::constant, 0, 0, Value::of(token.text)});
      case Token::Kind::variable: return add({Op::variable, 0, 0, {}, IG_NO_FIELD, token.text});
      default: return lexer_.is_sign("(") ? function(token.text) : name(token.text);
    }
  }

  std::uint32_t function(const std::string& written) {
    const std::string name = in_small_letters(written);
    lexer_.next();
    if (name == "var") {
      if (lexer_.now().kind != Token::Kind::text) throw Fault{"var needs a name in quotation marks, as in var(\"R5\")"};
      const std::uint32_t out = add({Op::variable, 0, 0, {}, IG_NO_FIELD, lexer_.now().text});
      lexer_.next();
      return close(out);
    }
    if (name != "abs" && name != "min" && name != "max" && name != "has")
      throw Fault{"there is no function '" + written + "': there are abs, min, max, has and var"};
    const std::uint32_t first = either();
    if (name == "abs") return close(add(Op::absolute, first));
    if (name == "has") return close(add(Op::has, first));
    if (!take_sign(",")) throw Fault{name + " needs two values, as in " + name + "(X, Y)"};
    return close(add(name == "min" ? Op::smaller : Op::larger, first, either()));
  }
  std::uint32_t close(std::uint32_t inside) {
    if (!take_sign(")")) throw Fault{"a bracket is not closed"};
    return inside;
  }

  std::uint32_t name(const std::string& written) {
    const std::string small = in_small_letters(written);
    if (small == "true" || small == "false") return add({Op::constant, 0, 0, Value::truth(small == "true")});
    if (std::ranges::find(known_names, small) != std::end(known_names))
      return add({Op::name, 0, 0, {}, IG_NO_FIELD, small});
    if (const auto field = layout_.find(written)) return add({Op::field, 0, 0, {}, *field});
    const bool has_number = is_digit(written.back()) && !is_digit(written.front());
    if (has_number && written.find('.') == std::string::npos)
      return add({Op::variable, 0, 0, {}, IG_NO_FIELD, written});
    std::vector<std::string> names(std::begin(known_names), std::end(known_names));
    for (const FieldInfo& info : layout_.fields)
      if (!info.hidden) names.push_back(info.path);
    const std::string near = nearest_name(written, names);
    throw Fault{"nothing is called '" + written + "'" + (near.empty() ? "" : "; did you mean " + near + "?") +
                " (a variable of the program is written as var(\"" + written + "\"))"};
  }

  /// A chain of brackets must not exhaust the stack.
  struct Depth {
    explicit Depth(Parser& parser) : of(parser) {
      if (++of.depth_ > deepest_expression) throw Fault{"the expression nests too deep"};
    }
    ~Depth() { --of.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Parser& of;
  };

  Lexer lexer_;
  const Layout& layout_;
  std::vector<Node> nodes_;
  unsigned depth_ = 0;
};

}  // namespace

std::variant<Expression, std::string> Expression::parse(std::string_view text, const Layout& layout) {
  if (text.size() > longest_expression)
    return "the expression is longer than " + std::to_string(longest_expression) + " characters";
  try {
    Expression out;
    out.nodes_ = Parser(text, layout).parse();
    out.text_ = text;
    return out;
  } catch (const Fault& fault) {
    return fault.sentence;
  }
}

}  // namespace isogloss::dap
