/// A block document and the chain around it, for tests of members that share fields: a field has one id, by its path,
/// however many members declare it. The frame is a translation, and there is one list of records.
#pragma once

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "isogloss/sdk.hpp"

namespace isogloss_test {

class BlockDocument {
 public:
  struct Report {
    std::string code;
    ig_severity severity;
    std::string word;  ///< path of the word or code that the diagnostic points at; empty: the block
    std::vector<std::string> arguments;
    friend bool operator==(const Report&, const Report&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Report& report) {
      out << report.code << " severity " << report.severity << " at '" << report.word << "'";
      for (const std::string& argument : report.arguments) out << " '" << argument << "'";
      return out;
    }
  };

  // For the members that are created afterwards.
  std::map<std::string, std::string> options;  ///< by name; a choice that is not given is the first one
  std::map<std::string, const void*> services;
  std::map<std::string, std::vector<std::string>> matches;  ///< the paths for which a pattern stands
  bool has_table = true;

  std::vector<Report> reports;
  ig::Vec3 frame;  ///< from program to machine coordinates, mm
  bool frame_has_inverse = true;

  BlockDocument() {
    diagnostics();
    fill_link();
    fill_values();
    fill_words();
    fill_lists();
  }
  BlockDocument(const BlockDocument&) = delete;
  BlockDocument& operator=(const BlockDocument&) = delete;

  /// A member, or a struct of members, that `make` returns. It must not outlive the document.
  template <class Make>
  auto create(const Make& make) {
    recorders_.push_back(std::make_unique<ig::detail::Recorder>());
    ig::detail::Recorder& recorded = *recorders_.back();
    declared_ = &recorded;
    {
      const ig::detail::Scope<ig::detail::Recorder> recording(ig::detail::recorder, &recorded);
      static_cast<void>(make());
    }
    std::vector<ig_field> ids;
    for (const ig_field_decl& field : recorded.fields)
      ids.push_back(id(std::string((field.access & IG_PREVIOUS) != 0 ? "previous " : "") + field.path));
    ig::detail::Binding binding{&api_, reinterpret_cast<ig_link*>(this), ids.data()};
    const ig::detail::Scope<ig::detail::Binding> binding_scope(ig::detail::binding, &binding);
    return make();
  }
  template <class Member, class... Args>
  Member member(const Args&... args) {
    return create([&] { return Member(args...); });
  }

  ig::Block block() { return {&host_, reinterpret_cast<ig_block*>(this)}; }

  /// The block after this one: no value is fresh, words, codes and records are gone.
  void next_block() {
    for (const auto& [path, field] : ids_)
      if (path.starts_with("Parsing.")) values_.erase(field);
    fresh_.clear();
    codes_.clear();
    answered_.clear();
    records_.clear();
    reports.clear();
  }

  /// Fields by path; a carried value is not fresh.
  void carry(const std::string& path, double number) { values_[id(path)].number = number; }
  void carry_name(const std::string& path, std::string_view name) { values_[id(path)].symbol = symbol(name); }
  void carry_flag(const std::string& path) { values_[id(path)] = ig::present; }
  void carry_count(const std::string& path, std::int64_t count) { values_[id(path)].integer = count; }
  bool has(const std::string& path) { return values_.contains(id(path)); }
  bool is_fresh(const std::string& path) { return fresh_.contains(id(path)); }
  double number(const std::string& path) { return values_.at(id(path)).number; }
  std::int64_t integer(const std::string& path) { return values_.at(id(path)).integer; }
  std::string name(const std::string& path) { return text(values_.at(id(path)).symbol); }
  void forget(const std::string& path) { values_.erase(id(path)); }

  /// Words and codes of the program: "Parsing.X", "Parsing.Flags.G01", "Parsing.G81", "Parsing.G81.R".
  void put_word(const std::string& path, double number) {
    values_[id(path)].number = number;
    fresh_.insert(id(path));
  }
  void put_code(const std::string& path) {
    values_[id(path)] = ig::present;
    fresh_.insert(id(path));
    codes_.push_back(id(path));
  }

  std::size_t step_count() const { return records_.size(); }
  /// A value of a step, counted from 0; the path without "CompoundMotion.Items[].".
  bool step_has(std::size_t step, const std::string& path) { return records_.at(step).contains(item(path)); }
  double step(std::size_t step, const std::string& path) { return records_.at(step).at(item(path)).number; }
  std::int64_t step_integer(std::size_t step, const std::string& path) {
    return records_.at(step).at(item(path)).integer;
  }
  std::string step_name(std::size_t step, const std::string& path) {
    return text(records_.at(step).at(item(path)).symbol);
  }

  /// A cell of the table; nothing where row or value is missing.
  std::optional<double> cell(const std::string& row, std::uint32_t column) const {
    const auto cells = table_.find(row);
    if (cells == table_.end()) return std::nullopt;
    const auto found = cells->second.find(column);
    return found == cells->second.end() ? std::nullopt : std::optional(found->second);
  }
  void set_cell(const std::string& row, std::uint32_t column, double value) { table_[row][column] = value; }

  ig_field id(const std::string& path) {
    return ids_.try_emplace(path, static_cast<ig_field>(ids_.size() + 1)).first->second;
  }
  ig::Symbol symbol_of(std::string_view name) { return {symbol(name)}; }
  std::string text_of(ig::Symbol name) const { return text(static_cast<ig_symbol>(name.id)); }

 private:
  static BlockDocument& self(ig_link* link) { return *reinterpret_cast<BlockDocument*>(link); }
  static BlockDocument& self(ig_block* block) { return *reinterpret_cast<BlockDocument*>(block); }
  static const BlockDocument& self(const ig_block* block) { return *reinterpret_cast<const BlockDocument*>(block); }
  static const BlockDocument& self(const ig_table* table) { return *reinterpret_cast<const BlockDocument*>(table); }

  ig_field item(const std::string& path) { return id("CompoundMotion.Items[]." + path); }
  ig_symbol symbol(std::string_view name) {
    return symbols_.try_emplace(std::string(name), static_cast<ig_symbol>(symbols_.size() + 1)).first->second;
  }
  ig_text borrowed(ig_symbol sought) const {
    for (const auto& [name, number] : symbols_)
      if (number == sought) return {name.data(), name.size()};
    return {nullptr, 0};
  }
  std::string text(ig_symbol sought) const { return std::string(ig::to_view(borrowed(sought))); }
  const std::string& path_of(ig_field sought) const {
    return std::find_if(ids_.begin(), ids_.end(), [sought](const auto& entry) { return entry.second == sought; })
        ->first;
  }

  std::int64_t choice(std::uint32_t option) const {
    const ig_option_decl& declared = declared_->options.at(option);
    const auto given = options.find(declared.name);
    if (given == options.end()) return 0;
    const std::string choices = '|' + std::string(declared.choices) + '|';
    const std::size_t at = choices.find('|' + given->second + '|');
    return std::count(choices.begin(), choices.begin() + static_cast<std::ptrdiff_t>(at), '|');
  }

  void fill_link() {
    api_.struct_size = sizeof api_;
    api_.symbol = [](ig_link* link, ig_text name) { return self(link).symbol(ig::to_view(name)); };
    api_.option_integer = [](ig_link* link, std::uint32_t option) { return self(link).choice(option); };
    api_.service = [](ig_link* link, const char* name) -> const void* {
      const auto found = self(link).services.find(name);
      return found == self(link).services.end() ? nullptr : found->second;
    };
    api_.expand = [](ig_link* link, std::uint32_t declaration, const ig_field** ids) {
      const std::string pattern = self(link).declared_->fields.at(declaration).path;
      std::vector<ig_field>& found = self(link).expanded_[pattern];
      found.clear();
      for (const std::string& path : self(link).matches[pattern]) found.push_back(self(link).id(path));
      *ids = found.data();
      return static_cast<std::uint32_t>(found.size());
    };
    api_.field_path = [](ig_link* link, ig_field field) { return ig::to_text(self(link).path_of(field)); };
    api_.field_unit = [](ig_link*, ig_field) { return ig::to_text(""); };
    api_.table = [](ig_link* link) -> ig_table* {
      return self(link).has_table ? reinterpret_cast<ig_table*>(link) : nullptr;
    };
    api_.value = [](const ig_table* table, ig_text row, std::uint32_t column, double* out) {
      const auto found = self(table).cell(std::string(ig::to_view(row)), column);
      if (found) *out = *found;
      return std::int32_t{found.has_value()};
    };
    api_.set_value = [](ig_table* table, ig_text row, std::uint32_t column, double value) {
      reinterpret_cast<BlockDocument*>(table)->set_cell(std::string(ig::to_view(row)), column, value);
      return std::int32_t{1};
    };
  }

  void write(ig_field field, ig_value value) {
    values_[field] = value;
    fresh_.insert(field);
  }
  std::int32_t read(ig_field field, ig_value* out) const {
    const auto found = values_.find(field);
    if (found == values_.end()) return 0;
    *out = found->second;
    return 1;
  }

  void fill_values() {
    host_.struct_size = sizeof host_;
    host_.get = [](const ig_block* b, ig_field field, ig_value* out) { return self(b).read(field, out); };
    host_.get_many = [](const ig_block* b, const ig_field* fields, std::uint32_t count, ig_value* out) {
      std::uint32_t mask = 0;
      for (std::uint32_t i = 0; i < count; ++i)
        if (self(b).read(fields[i], out + i) != 0) mask |= 1u << i;
      return mask;
    };
    host_.set = [](ig_block* b, ig_field field, ig_value value) { self(b).write(field, value); };
    host_.set_many = [](ig_block* b, const ig_field* fields, std::uint32_t count, const ig_value* values) {
      for (std::uint32_t i = 0; i < count; ++i) self(b).write(fields[i], values[i]);
    };
    host_.amend_many = [](ig_block* b, const ig_field* fields, std::uint32_t count, const ig_value* values) {
      for (std::uint32_t i = 0; i < count; ++i) self(b).values_[fields[i]] = values[i];
    };
    host_.erase = [](ig_block* b, ig_field field) {
      self(b).values_.erase(field);
      self(b).fresh_.erase(field);
    };
    host_.is_fresh = [](const ig_block* b, ig_field field) { return std::int32_t{self(b).fresh_.contains(field)}; };
    host_.symbol = [](ig_block* b, ig_text name) { return self(b).symbol(ig::to_view(name)); };
    host_.symbol_text = [](const ig_block* b, ig_symbol sought) { return self(b).borrowed(sought); };
    host_.map_point = [](ig_block* b, ig_direction direction, const double in[3], double out[3]) {
      for (std::size_t i = 0; i < 3; ++i)
        out[i] = direction == IG_TO_MACHINE ? in[i] + self(b).frame[i] : in[i] - self(b).frame[i];
      return std::int32_t{direction == IG_TO_MACHINE || self(b).frame_has_inverse};
    };
    host_.frame_changed = [](const ig_block*) { return std::int32_t{0}; };
    host_.report = [](ig_block* b, std::uint32_t diagnostic, ig_field field, std::uint32_t, std::uint32_t,
                      const ig_argument* arguments, std::uint32_t count) {
      const ig_diagnostic_decl& declared = diagnostics()[diagnostic];
      Report report{declared.code, declared.severity, {}, {}};
      if (field != IG_NO_FIELD) report.word = self(b).path_of(field);
      for (std::uint32_t i = 0; i < count; ++i) report.arguments.push_back(written(arguments[i]));
      self(b).reports.push_back(std::move(report));
    };
    host_.fault = [](ig_block* b, ig_text message) {
      self(b).reports.push_back({"fault", IG_ERROR, {}, {std::string(ig::to_view(message))}});
    };
  }
  /// The table answers for codes only after it is complete.
  static std::span<const ig_diagnostic_decl> diagnostics() {
    static const auto rows = ig::detail::diagnostic_table().complete({});
    return rows;
  }
  static std::string written(const ig_argument& argument) {
    if (argument.is_text != 0) return std::string(ig::to_view(argument.text));
    char digits[32];
    const char* const end = std::to_chars(digits, digits + sizeof digits, argument.number).ptr;
    return {static_cast<const char*>(digits), end};
  }

  /// The index of the last code of the block that is in the list.
  std::int32_t last_code(const ig_field* fields, std::uint32_t count, std::uint32_t* found) const {
    std::int32_t last = -1;
    *found = 0;
    for (const ig_field code : codes_) {
      const ig_field* const at = std::find(fields, fields + count, code);
      if (at == fields + count) continue;
      ++*found;
      last = static_cast<std::int32_t>(at - fields);
    }
    return last;
  }
  std::int32_t take(ig_field field, ig_value* out) {
    if (read(field, out) == 0) return 0;
    const bool is_code = std::find(codes_.begin(), codes_.end(), field) != codes_.end();
    if (is_code)
      answered_.insert(field);
    else
      values_.erase(field);
    return 1;
  }
  std::int32_t leftover(std::uint32_t index, ig_leftover* out) const {
    for (const auto& [path, field] : ids_) {
      const bool is_code = std::find(codes_.begin(), codes_.end(), field) != codes_.end();
      const bool is_left =
          is_code ? !answered_.contains(field) : path.starts_with("Parsing.") && values_.contains(field);
      if (!is_left || index-- != 0) continue;
      const std::string_view name = ig::word_name(path);
      *out = {is_code ? ig_leftover_kind{IG_LEFT_CODE} : ig_leftover_kind{IG_LEFT_WORD}, field, 0, 0,
              ig::to_text(name)};
      return 1;
    }
    return 0;
  }
  void fill_words() {
    host_.take = [](ig_block* b, ig_field field, ig_value* out) { return self(b).take(field, out); };
    host_.take_many = [](ig_block* b, const ig_field* fields, std::uint32_t count, ig_value* out) {
      std::uint32_t mask = 0;
      for (std::uint32_t i = 0; i < count; ++i)
        if (self(b).take(fields[i], out + i) != 0) mask |= 1u << i;
      return mask;
    };
    host_.find_code = [](const ig_block* b, const ig_field* fields, std::uint32_t count, std::uint32_t* found) {
      return self(b).last_code(fields, count, found);
    };
    host_.take_code = [](ig_block* b, const ig_field* fields, std::uint32_t count, std::uint32_t* found) {
      const std::int32_t last = self(b).last_code(fields, count, found);
      self(b).answered_.insert(fields, fields + count);
      return last;
    };
    host_.leftover = [](const ig_block* b, std::uint32_t index, ig_leftover* out) {
      return self(b).leftover(index, out);
    };
  }

  void fill_lists() {
    host_.append = [](ig_block* b, const ig_field* fields, std::uint32_t count, const ig_value* values) {
      auto& record = self(b).records_.emplace_back();
      for (std::uint32_t i = 0; i < count; ++i) record[fields[i]] = values[i];
      return std::int32_t{1};
    };
    host_.append_many = [](ig_block* b, const ig_field* fields, std::uint32_t count, std::uint32_t records,
                           const std::uint32_t* masks, const ig_value* values) {
      for (std::uint32_t r = 0; r < records; ++r, values += count) {
        auto& record = self(b).records_.emplace_back();
        for (std::uint32_t i = 0; i < count; ++i)
          if ((masks[r] >> i & 1) != 0) record[fields[i]] = values[i];
      }
      return records;
    };
    host_.count = [](const ig_block* b, ig_field) { return static_cast<std::uint32_t>(self(b).records_.size()); };
    host_.record = [](const ig_block* b, std::uint32_t index, const ig_field* fields, std::uint32_t count,
                      ig_value* out) {
      std::uint32_t mask = 0;
      const auto& record = self(b).records_.at(index);
      for (std::uint32_t i = 0; i < count; ++i) {
        const auto found = record.find(fields[i]);
        if (found == record.end()) continue;
        out[i] = found->second;
        mask |= 1u << i;
      }
      return mask;
    };
    host_.set_record = [](ig_block* b, std::uint32_t index, const ig_field* fields, std::uint32_t count,
                          const ig_value* values) {
      for (std::uint32_t i = 0; i < count; ++i) self(b).records_.at(index)[fields[i]] = values[i];
    };
    host_.map_records = [](ig_block* b, const ig_field program[3], const ig_field machine[3]) {
      for (auto& record : self(b).records_)
        for (std::size_t i = 0; i < 3; ++i)
          if (record.contains(program[i]) && !record.contains(machine[i]))
            record[machine[i]].number = record[program[i]].number + self(b).frame[i];
    };
  }

  using Record = std::map<ig_field, ig_value>;

  ig_link_api api_{};
  ig_host host_{};
  std::vector<std::unique_ptr<ig::detail::Recorder>> recorders_;
  const ig::detail::Recorder* declared_ = nullptr;
  std::map<std::string, ig_field> ids_;
  std::map<std::string, ig_symbol> symbols_;
  std::map<std::string, std::map<std::uint32_t, double>> table_;
  std::map<std::string, std::vector<ig_field>> expanded_;
  Record values_;
  std::set<ig_field> fresh_, answered_;
  std::vector<ig_field> codes_;
  std::vector<Record> records_;
};

}  // namespace isogloss_test
