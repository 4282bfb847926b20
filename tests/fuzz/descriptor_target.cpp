// Descriptors of plugins, put together from the bytes: refused, or good for a library and its schemas.
#include <deque>

#include "contract/descriptor_check.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/schema.hpp"
#include "target.hpp"
#include "test_plugin.hpp"

namespace isogloss::fuzz {

namespace {

/// Turns bytes into members; zeros when they are used up.
class Draw {
 public:
  explicit Draw(std::string_view bytes) : rest_(bytes) {}

  std::uint32_t number(std::uint32_t below) {
    const std::uint32_t out = rest_.empty() ? 0 : static_cast<unsigned char>(rest_[0]);
    rest_.remove_prefix(rest_.empty() ? 0 : 1);
    return out % below;
  }
  /// Mostly a good text, now and then any bytes, or none.
  const char* text(const char* good) {
    constexpr std::uint32_t kinds = 8, longest = 24;
    const std::uint32_t kind = number(kinds);
    if (kind > 1) return good;
    if (kind == 0) return nullptr;
    const std::size_t size = std::min<std::size_t>(number(longest), rest_.size());
    texts_.emplace_back(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return texts_.back().c_str();
  }
  double value() {
    constexpr double values[] = {0, 1, -1, 1e308, HUGE_VAL, -HUGE_VAL, 0.5, 3};
    return values[number(std::size(values))];
  }

 private:
  std::string_view rest_;
  std::deque<std::string> texts_;
};

test::Plugin plugin_of(Draw& draw) {
  constexpr const char* paths[] = {"Feedrate.FeedrateValue", "Parsing.A", "Parsing.G.81", "Steps.Items[].Dwell.Time",
                                   "@words"};
  test::Plugin plugin(draw.text("fuzzed"));
  plugin.out.version = draw.text("1.0.0");
  plugin.out.vendor = draw.text("tests");
  constexpr std::uint32_t most = 4;
  for (std::uint32_t i = draw.number(most); i > 0; --i) {
    test::Syntax& s = plugin.syntax(draw.text(i == 1 ? "OneSyntax" : "OtherSyntax"));
    s.out.summary = draw.text("A syntax.");
    s.out.triggers = draw.text(nullptr);
    s.out.exclusive_slot = draw.text(nullptr);
    s.out.look_ahead = draw.number(3);
    s.out.inspects = draw.number(3);
    for (std::uint32_t k = draw.number(most); k > 0; --k) {
      s.fields.push_back(test::field(draw.text(paths[draw.number(std::size(paths))]), draw.number(64),
                                     static_cast<ig_type>(draw.number(12)), static_cast<ig_life>(draw.number(6))));
      s.fields.back().unit = draw.text("mm");
      s.fields.back().doc = draw.text("");
    }
    for (std::uint32_t k = draw.number(most); k > 0; --k)
      s.options.push_back(test::option(draw.text("an-option"), static_cast<ig_option_type>(draw.number(9)),
                                       draw.text("1"), draw.text("a|b"), draw.value(), draw.value()));
    for (std::uint32_t k = draw.number(2); k > 0; --k)
      s.services.push_back({sizeof(ig_service_decl), draw.number(2), draw.text("test.offset/1"), draw.text("")});
    if (const char* const after = draw.text("OtherSyntax")) s.after = {after};
  }
  for (std::uint32_t i = draw.number(3); i > 0; --i) {
    test::Dependency& d = plugin.dependency(draw.text("ATable"));
    d.out.summary = draw.text("A table.");
    d.out.row_element = draw.text("Row");
    d.out.row_key = draw.text("id");
    for (std::uint32_t k = draw.number(most); k > 0; --k)
      d.columns.push_back(test::column(draw.text("Column"), draw.text("0"), draw.value(), draw.value()));
    if (const char* const row = draw.text("id=1 Column=2")) d.rows = {row};
    if (const char* const service = draw.text("test.offset/1")) d.provides = {service};
  }
  for (std::uint32_t i = draw.number(2); i > 0; --i) {
    test::Importer& importer = plugin.importer(draw.text("AnImporter"));
    importer.out.files = draw.text("*.t");
    if (const char* const table = draw.text("ATable")) importer.dependencies = {table};
  }
  for (std::uint32_t i = draw.number(3); i > 0; --i)
    plugin.diagnostics.push_back({sizeof(ig_diagnostic_decl), static_cast<ig_severity>(draw.number(5)),
                                  draw.text("FUZ-0001"), draw.text("a text with {0}"), draw.text("An explanation."),
                                  draw.text("")});
  return plugin;
}

class DescriptorTarget : public Target {
 public:
  void run(std::string_view bytes) override {
    Draw draw(bytes);
    test::Plugin plugin = plugin_of(draw);
    const ig_plugin* const made = plugin.get();
    if (descriptor_fault(*made)) return;
    Library library({});
    library.add(made);
    for (const std::string& schema : {dialect_schema(library), table_schema(library), block_schema(library)})
      if (schema.empty()) fail("a library has schemas");
  }
  /// Bytes of 2 choose what is good; the others are for the fuzzer.
  std::vector<std::string> samples() const override {
    return {std::string(200, '\x02'), std::string(400, '\x03'), std::string(400, '\x0b'), std::string()};
  }
};

}  // namespace

std::unique_ptr<Target> make_descriptor_target() { return std::make_unique<DescriptorTarget>(); }

}  // namespace isogloss::fuzz
