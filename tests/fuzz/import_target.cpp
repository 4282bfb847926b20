// Files of controls: the first byte chooses the importer, the rest is the file. What an importer makes of it is XML
// that reads back.
#include <cstdint>

#include "isogloss/engine/cases.hpp"
#include "isogloss/engine/import.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

struct Choice {
  const ig_importer* importer;
  std::vector<std::string> texts;  ///< of its cases
};

std::vector<Choice> choices() {
  std::vector<Choice> out;
  workspace().library().load_all();
  for (const LoadedPlugin& loaded : workspace().library().plugins())
    for (std::uint32_t i = 0; i < loaded.plugin->importer_count; ++i) {
      const ig_importer& importer = *loaded.plugin->importers[i];
      Choice choice{&importer, {}};
      DiagnosticList ignored;
      if (importer.page != nullptr)
        for (const Case& one : read_page(importer.page, importer.id, ignored).cases)
          if (one.file) choice.texts.push_back(one.file->text);
      out.push_back(std::move(choice));
    }
  return out;
}

class ImportTarget : public Target {
 public:
  void run(std::string_view bytes) override {
    if (bytes.empty()) return;
    const Choice& choice = all_[static_cast<unsigned char>(bytes[0]) % all_.size()];
    const std::string text(bytes.substr(1));
    DiagnosticList said;
    const Import asked{"/fuzz/file", choice.importer->id, {}, {}};
    const auto made = import_bytes(asked, text, workspace().library(), said);
    for (const Diagnostic& d : said.all)
      if (d.code == "IG-0127") fail("no file makes an importer fail: " + d.message);
    if (!made) {
      if (!said.has_errors()) fail("a file that is not read is reported");
      return;
    }
    if (!made->tables.empty()) accept();
    DiagnosticList of_tables;
    workspace().reader().give("/fuzz/tables.xml", write_tables(made->tables, text.size() % 2 == 0));
    static_cast<void>(workspace().reader().read_dependencies("/fuzz/tables.xml", of_tables));
    workspace().reader().forget("/fuzz/tables.xml");
    if (of_tables.has_errors()) fail("tables of an importer read back: " + of_tables.all[0].message);
    static_cast<void>(recognise(text, "file", workspace().library()));
  }
  std::vector<std::string> words() const override { return declared_names(); }
  std::vector<std::string> samples() const override {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < all_.size(); ++i)
      for (const std::string& text : all_[i].texts) out.push_back(std::string(1, static_cast<char>(i)) + text);
    return out;
  }

 private:
  const std::vector<Choice> all_ = choices();
};

}  // namespace

std::unique_ptr<Target> make_import_target() { return std::make_unique<ImportTarget>(); }

}  // namespace isogloss::fuzz
