// A sound descriptor of a plugin in which the bytes replace members: refused, or good for a library and its schemas.
#include <cmath>
#include <cstdint>
#include <deque>

#include "contract/descriptor_check.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/schema.hpp"
#include "target.hpp"
#include "test_plugin.hpp"

namespace isogloss::fuzz {

namespace {

/// A plugin in which nothing is wrong, and its members, so that others can be put in their place.
class Sound {
 public:
  Sound() {
    test::Syntax& syntax = plugin.syntax("OneSyntax");
    syntax.fields = {test::field("Feedrate.FeedrateValue", IG_READ), test::field("Parsing.A54.1.X", IG_TAKE | IG_WAKE),
                     test::field("Steps.Items[].Dwell.Time", IG_WRITE), test::field("@words", IG_READ | IG_PATTERN),
                     test::field("Parsing.~Signal", IG_WAKE, IG_SWITCH, IG_LIFE_BLOCK)};
    syntax.options = {test::option("words", IG_OPTION_FIELDS, "Parsing.? Parsing.*.X"),
                      test::option("unit", IG_OPTION_CHOICE, "ms", "s|ms"),
                      test::option("on", IG_OPTION_BOOLEAN, "false"),
                      test::option("count", IG_OPTION_INTEGER, "3", "", 0, 10),
                      test::option("length", IG_OPTION_NUMBER, "-0.5", "", -1, 1),
                      test::option("name", IG_OPTION_TEXT, nullptr)};
    syntax.services = {{sizeof(ig_service_decl), 0, "test.offset/1", ""}};
    syntax.after = {"OtherSyntax"};
    plugin.syntax("OtherSyntax");
    test::Dependency& dependency = plugin.dependency("ATable");
    dependency.out.row_element = "Row";
    dependency.out.row_key = "id";
    dependency.columns = {test::column("X", "0"), test::column("Y")};
    dependency.provides = {"test.offset/1"};
    test::Importer& importer = plugin.importer("AnImporter");
    importer.dependencies = {"ATable"};
    plugin.diagnostics = {{sizeof(ig_diagnostic_decl), IG_ERROR, "FUZ-0001", "a text with {0}", "An explanation.", ""}};
    static_cast<void>(plugin.get());
    collect();
  }

  test::Plugin plugin{"fuzzed"};
  std::vector<const char**> texts;
  std::vector<std::uint32_t*> numbers;
  std::vector<double*> limits;

 private:
  void collect() {
    ig_plugin& p = plugin.out;
    texts = {&p.name, &p.version, &p.vendor, &p.built_with};
    numbers = {&p.struct_size, &p.abi_major, &p.abi_minor};
    for (test::Syntax& s : plugin.syntaxes) {
      for (const char** text : {&s.out.id, &s.out.summary, &s.out.page, &s.out.exclusive_slot, &s.out.first_writer_slot,
                                &s.out.triggers, &s.out.cases, &s.out.folder})
        texts.push_back(text);
      for (std::uint32_t* number : {&s.out.struct_size, &s.out.look_ahead, &s.out.inspects}) numbers.push_back(number);
      for (ig_field_decl& f : s.fields) {
        for (const char** text : {&f.path, &f.unit, &f.doc}) texts.push_back(text);
        numbers.push_back(&f.access);
      }
      add(s.options);
      for (ig_service_decl& service : s.services) texts.push_back(&service.id);
      add(s.after);
    }
    for (test::Dependency& d : plugin.dependencies) {
      for (const char** text : {&d.out.id, &d.out.summary, &d.out.row_element, &d.out.row_key}) texts.push_back(text);
      for (ig_column_decl& c : d.columns) {
        for (const char** text : {&c.name, &c.unit, &c.fallback, &c.doc}) texts.push_back(text);
        for (double* limit : {&c.minimum, &c.maximum}) limits.push_back(limit);
        numbers.push_back(&c.is_text);
      }
      add(d.provides);
    }
    for (test::Importer& i : plugin.importers) {
      for (const char** text : {&i.out.id, &i.out.summary, &i.out.files, &i.out.folder}) texts.push_back(text);
      add(i.dependencies);
    }
    for (ig_diagnostic_decl& d : plugin.diagnostics)
      for (const char** text : {&d.code, &d.text, &d.explanation, &d.example}) texts.push_back(text);
  }
  /// All but the null at the end, which nothing can do without.
  void add(test::Names& names) {
    for (const char*& name : names)
      if (name != nullptr) texts.push_back(&name);
  }
  void add(std::vector<ig_option_decl>& options) {
    for (ig_option_decl& o : options) {
      for (const char** text : {&o.name, &o.fallback, &o.choices, &o.unit, &o.doc}) texts.push_back(text);
      for (double* limit : {&o.minimum, &o.maximum}) limits.push_back(limit);
    }
  }
};

/// Members of other values, as the bytes say: four of them for each member, and more for a text.
class Changes {
 public:
  explicit Changes(std::string_view bytes) : rest_(bytes) {}

  void apply(Sound& sound) {
    constexpr double values[] = {0, 1, -1, 1e308, HUGE_VAL, -HUGE_VAL, 0.5, NAN};
    constexpr std::uint32_t counts[] = {0, 1, 2, 7, 64, 255, 65'536, UINT32_MAX};
    while (rest_.size() >= 4) {
      const std::size_t kind = byte(), place = byte(), value = byte();
      if (kind % 4 == 0)
        *sound.numbers[place % sound.numbers.size()] = counts[value % std::size(counts)];
      else if (kind % 4 == 1)
        *sound.limits[place % sound.limits.size()] = values[value % std::size(values)];
      else if (kind % 4 == 2)
        *sound.texts[place % sound.texts.size()] = *sound.texts[value % sound.texts.size()];
      else
        *sound.texts[place % sound.texts.size()] = value == 0 ? nullptr : text(value % 32);
    }
  }

 private:
  std::size_t byte() {
    const auto out = static_cast<unsigned char>(rest_[0]);
    rest_.remove_prefix(1);
    return out;
  }
  const char* text(std::size_t size) {
    kept_.emplace_back(rest_.substr(0, size));
    rest_.remove_prefix(std::min(size, rest_.size()));
    return kept_.back().c_str();
  }

  std::string_view rest_;
  std::deque<std::string> kept_;
};

class DescriptorTarget : public Target {
 public:
  void run(std::string_view bytes) override {
    Sound sound;
    Changes changes(bytes);
    changes.apply(sound);
    const ig_plugin& made = sound.plugin.out;
    if (descriptor_fault(made)) return;
    accept();
    Library library({});
    library.add(&made);
    for (const std::string& schema : {dialect_schema(library), table_schema(library), block_schema(library)})
      if (schema.empty()) fail("a library has schemas");
  }
  std::vector<std::string> samples() const override {
    using namespace std::string_literals;
    return {""s,
            "\x03\x01\x05"
            "1.2.3."s,
            "\x03\x05\x08"
            "Summary."s,
            "\x01\x01\x05."s,
            "\x02\x08\x09."s,
            "\x00\x04\x01."s};
  }
};

}  // namespace

std::unique_ptr<Target> make_descriptor_target() { return std::make_unique<DescriptorTarget>(); }

}  // namespace isogloss::fuzz
