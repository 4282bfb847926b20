/// Which line has written each variable of the program last.
#pragma once

#include <map>
#include <nlohmann/json.hpp>

#include "run/explain_values.hpp"

namespace isogloss {

class VariableLog {
 public:
  static std::string value_of(const ig_argument* value) {
    if (value == nullptr) return {};
    if (value->is_text == 0) return number_text(value->number);
    return nlohmann::json(std::string(value->text.data, value->text.size))
        .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }

  void write(const Document& document, std::string_view name, std::uint64_t scope, const ig_argument* value) {
    auto found = written_.find(Key{scope, name});
    if (found == written_.end()) {
      if (written_.size() >= most_variables) return;
      found = written_.emplace(std::pair(scope, std::string(name)), Written{}).first;
    }
    Written& w = found->second;
    w.syntax = document.current;
    w.file = document.file_number;
    w.line = document.source.line;
    w.has_value = value != nullptr;
    w.number = value != nullptr ? value->number : 0;
    w.text = value != nullptr && value->is_text != 0 ? value_of(value) : std::string();
  }

  /// What the block has read; the line that wrote it is that of the last write before.
  ExplainedVariable read(const Chain& chain, std::string_view name, std::uint64_t scope,
                         const ig_argument* value) const {
    ExplainedVariable out{std::string(name), value_of(value), "", {}, ""};
    const auto found = written_.find(Key{scope, name});
    if (found == written_.end()) return out;
    const Written& w = found->second;
    if (w.syntax != 0) out.writer = chain.linked().chain[w.syntax - 1u].element.alias;
    out.written = {std::string(chain.file_name(w.file)), w.line};
    out.written_value = !w.text.empty() ? w.text : w.has_value ? number_text(w.number) : std::string();
    return out;
  }

 private:
  static constexpr std::size_t most_variables = 100'000;
  using Key = std::pair<std::uint64_t, std::string_view>;
  struct Less {
    using is_transparent = void;
    template <class A, class B>
    bool operator()(const A& a, const B& b) const {
      return a.first != b.first ? a.first < b.first : std::string_view(a.second) < std::string_view(b.second);
    }
  };
  struct Written {
    std::uint16_t syntax = 0, file = 0;
    std::uint32_t line = 0;
    bool has_value = false;
    double number = 0;
    std::string text{};
  };
  std::map<std::pair<std::uint64_t, std::string>, Written, Less> written_;
};

}  // namespace isogloss
