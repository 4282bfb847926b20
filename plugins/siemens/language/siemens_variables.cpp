// R parameters, global user data (GUD) with their types, and values that the user gives to machine and setting data.
#include <charconv>
#include <stdexcept>
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "frames/frame_value.hpp"
#include "language/declared_type.hpp"
#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

enum class LongText { refused, cut };

/// STOCK[0, 1] is the row STOCK[0,1].
std::string canonical(std::string_view written) {
  std::string out;
  for (const char c : written)
    if (!is_blank(c)) out += to_upper(c);
  return out;
}

bool is_r_parameter(std::string_view name) {
  return name.size() > 1 && name[0] == 'R' && skip_digits(name, 1) == name.size();
}

bool is_name(std::string_view name) {
  return !name.empty() && is_name_start(name[0]) && skip_name(name, 0) == name.size();
}

/// [0], [0,2] or [X1], or nothing at all.
bool is_index(std::string_view index) {
  if (index.empty()) return true;
  if (index.size() < 3 || index.front() != '[' || index.back() != ']') return false;
  for (std::size_t at = 1; at < index.size(); ++at) {
    const std::size_t end = skip_name(index, at);
    if (end == at || (index[end] != ',' && end + 1 != index.size())) return false;
    at = end;
  }
  return true;
}

/// 3 or 2,3; nothing for other texts.
std::optional<std::vector<std::uint32_t>> sizes_in(std::string_view text) {
  constexpr std::uint32_t most = 1'000'000;
  std::vector<std::uint32_t> out;
  for (text = trim(text);; text = trim(text.substr(1))) {
    std::uint32_t size = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (error != std::errc{} || size < 1 || size > most || out.size() == 3) return std::nullopt;
    out.push_back(size);
    text = trim(text.substr(static_cast<std::size_t>(end - text.data())));
    if (text.empty()) return out;
    if (text[0] != ',') return std::nullopt;
  }
}

struct SiemensVariables final : VariableStore::Saver {
  static constexpr auto spec =
      ig::dependency("SiemensVariables", "R parameters, user data (GUD), and values for data of the machine.")
          .rows("Variable", "name")
          .provides(variable_service);

  ig::IntegerOption r_parameters{"r-parameters", "1000", {1, 32'535}, "How many R parameters there are, from R0."};
  ig::IntegerOption most_variables{"most-variables",
                                   "100000",
                                   {1, 10'000'000},
                                   "Variables that one program may have; each element of an array counts as one."};
  ig::Choice<LongText> long_text{"long-text", "refused|cut", "refused",
                                 "A text that is longer than its STRING: an error, or cut without a message."};
  ig::Column value{"Value", "0", "", {}, "The number when the program starts."};
  ig::Column text{"Text", nullptr, "", {}, "The text of a STRING, the axis of an AXIS, the links of a FRAME.", true};
  ig::Column type{"Type", nullptr, "", {}, "REAL, INT, BOOL, CHAR, STRING[n], AXIS or FRAME; none: REAL or STRING.",
                  true};
  ig::Column size{"Size", nullptr, "", {}, "Of an array, the elements of each dimension: 3, or 2,3.", true};
  ig::Column lowest{"Lowest", nullptr, "", {}, "The limit LLI, below which nothing is assigned."};
  ig::Column highest{"Highest", nullptr, "", {}, "The limit ULI, above which nothing is assigned."};
  ig::Table table;
  ig::RowNames names;
  VariableStore store;

  SiemensVariables() {
    store.most_names = static_cast<std::size_t>(most_variables);
    store.cuts_texts = long_text == LongText::cut;
    store.set_r_count(static_cast<std::size_t>(r_parameters));
    for (const std::string& name : names)
      if (const auto [first, is_new] = rows_.emplace(canonical(name), name); !is_new)
        faults_[name] = "the row " + first->second + " is the same variable";
    for (const bool elements : {false, true})
      for (const auto& [name, row] : rows_) {
        if ((name.find('[') != std::string::npos) != elements) continue;
        store.rows.give(name, row);
        if (std::string fault = load(name, row); !fault.empty()) faults_[row] = std::move(fault);
      }
    store.keep_user_data();
    store.save_to(this);
  }

  const void* service(std::string_view id) const { return id == variable_service ? &store : nullptr; }

  std::string row_fault(std::string_view row) const {
    const auto fault = faults_.find(std::string(row));
    return fault == faults_.end() ? "" : fault->second;
  }

  void save(const std::string& name, const Value& v) override {
    store.rows.overwrite(name);
    const auto row = rows_.find(name);
    const std::string& written = row == rows_.end() ? name : row->second;
    if (v.is_text())
      table.set_text(written, text, v.text);
    else
      table.set_value(written, value, v.number);
  }
  void save_r(std::size_t number, double v) override {
    std::array<char, 24> name{'R'};
    const auto end = std::to_chars(name.data() + 1, name.data() + name.size(), number).ptr;
    const std::string_view row(name.data(), static_cast<std::size_t>(end - name.data()));
    store.rows.overwrite(std::string(row));
    const auto written = rows_.find(row);
    table.set_value(written == rows_.end() ? row : std::string_view(written->second), value, v);
  }

 private:
  /// Returns why the row cannot be used.
  std::string load(const std::string& name, const std::string& row) {
    const bool has_text = table.value(row, text).has_value();
    const bool is_typed = !table.text(row, type).empty() || !table.text(row, size).empty() ||
                          table.value(row, lowest) || table.value(row, highest);
    const double number = table.value(row, value).value_or(0);
    if (is_r_parameter(name) || name.starts_with('$')) {
      if (has_text || is_typed)
        return "an R parameter or a system variable has a Value, and no Text, Type, Size or limit";
      if (!is_r_parameter(name)) return store.give(name, number), "";
      VariableStore::RParameter* const r = name.size() < 8 ? store.r(std::stoul(name.substr(1))) : nullptr;
      if (r == nullptr)
        throw std::runtime_error(name + " is not an R parameter: the option r-parameters says how many there are");
      return *r = {number, true}, "";
    }
    const std::size_t bracket = name.find('[');
    if (!is_name(name.substr(0, bracket)) || !is_index(name.substr(std::min(bracket, name.size()))))
      return "its name is that of a variable, as R5, LENGTH, PLACE[0,2] or $AC_TIME";
    Variable* const array = bracket == std::string::npos ? nullptr : store.user_data(name.substr(0, bracket));
    if (array != nullptr && is_typed) return "Type, Size and limits stand in the row of the array";
    if (array != nullptr && !array->is_array)
      return "the row " + name.substr(0, bracket) + " has no Size, so it is no array";
    if (array != nullptr && !array->number_of(std::string_view(name).substr(bracket)))
      return "it lies outside " + array->shown_as(name.substr(0, bracket));
    Variable own;
    if (array != nullptr)
      own.declared = array->declared;
    else if (std::string fault = declare(row, has_text, own.declared); !fault.empty())
      return fault;
    const bool takes_text = own.declared.type == Type::text || own.declared.type == Type::frame;
    if (has_text != takes_text && (has_text || number != 0))
      return takes_text ? "a " + type_text(own.declared) + " has a Text, and no Value"
                        : "a " + type_text(own.declared) + " has a Value, and no Text";
    own.value = own.declared.initial();
    const bool is_zero_given = array != nullptr && !takes_text && own.value.number == 0;
    if (has_text || number != 0 || is_zero_given)
      if (std::string fault = give(row, number, own); !fault.empty()) return fault;
    if (array != nullptr) {
      array->elements.push_back(name.substr(bracket));
    } else if (!table.text(row, size).empty()) {
      const auto sizes = bracket == std::string::npos ? sizes_in(table.text(row, size)) : std::nullopt;
      if (!sizes) return "Size is up to three whole numbers from 1 to 1000000 in the row of the array, as 3 or 2,3";
      own.is_array = true;
      own.sizes = *sizes;
    }
    store.define_user_data(name, std::move(own));
    return "";
  }

  std::string declare(const std::string& row, bool has_text, Declared& out) const {
    const std::string_view written = trim(table.text(row, type));
    std::size_t end = 0;
    const auto declared = type_at(written.empty() ? (has_text ? "STRING" : "REAL") : written, end);
    if (!declared || end < written.size())
      return "Type is REAL, INT, BOOL, CHAR, STRING[n] with n from 1 to 1000, AXIS or FRAME";
    out = *declared;
    out.cuts = store.cuts_texts;
    const auto low = table.value(row, lowest), high = table.value(row, highest);
    const bool takes_limits = out.type == Type::real || out.type == Type::integer;
    if ((low || high) && !takes_limits) return "a " + type_text(out) + " has no limits";
    if (low) out.lowest = std::max(out.lowest, *low);
    if (high) out.highest = std::min(out.highest, *high);
    return out.lowest <= out.highest ? "" : "Lowest is above Highest";
  }

  std::string give(const std::string& row, double number, Variable& own) const {
    const std::string_view written = table.text(row, text);
    Value v = Value::real(number);
    if (own.declared.type == Type::text) v = Value::string(std::string(written));
    if (own.declared.detail == Declared::Detail::axis) v.text = upper(trim(written));
    if (own.declared.type == Type::frame) {
      const auto frame = FrameValue::read(written);
      if (!frame) return "the Text of a FRAME has links with numbers, as CTRANS(X,10):CROT(Z,30)";
      v = Value::frame(frame->text());
    }
    switch (own.declared.fit(v)) {
      case Stored::yes: own.value = std::move(v); return "";
      case Stored::too_long: return "its Text is longer than a " + type_text(own.declared);
      default: return "its Value is outside the range of the variable, " + own.declared.range();
    }
  }

  std::map<std::string, std::string, std::less<>> rows_;  // as the user has named them, by their canonical names
  std::unordered_map<std::string, std::string> faults_;
};

const ig::Register<SiemensVariables> siemens_variables;

}  // namespace
}  // namespace siemens
