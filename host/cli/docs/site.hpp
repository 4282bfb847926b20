/// The reference while it is written: its pages as texts, by the names of their files.
#pragma once

#include "docs/page.hpp"

namespace isogloss::cli::docs {

enum class Format { html, markdown };

struct DeadLink {
  std::string part, link;
};

class Site {
 public:
  /// Gives everything its address; the reference must outlive the site.
  Site(const Reference& reference, Format format);

  const Reference& reference() const { return reference_; }
  const Addresses& addresses() const { return addresses_; }
  Format format() const { return format_; }

  std::unique_ptr<Page> page(const std::string& file, const std::string& title) const;
  void add(const Page& page);
  void add_file(const std::string& name, std::string text) { files_[name] = std::move(text); }
  /// What the plugin wrote about the part; its dead links are kept.
  void add_text(Page& page, const std::string& part, const std::string& markdown);

  const std::map<std::string, std::string>& files() const { return files_; }
  const std::vector<DeadLink>& dead_links() const { return dead_links_; }

 private:
  const Reference& reference_;
  Format format_;
  Addresses addresses_;
  std::map<std::string, std::string> files_;
  std::vector<DeadLink> dead_links_;
};

// Each writes pages of its kind.
void write_parts(Site& site);
void write_dialects(Site& site);
void write_machines(Site& site);
void write_plugins(Site& site);
void write_fields(Site& site);
void write_diagnostics(Site& site);
void write_codes(Site& site);
void write_index(Site& site);
/// names.js: what the search box finds.
void write_names(Site& site);

/// "a: b" of a list of facts.
Markup fact(const Page& page, std::string_view label, const Markup& value);
/// "CompoundMotion" of "CompoundMotion.Items[].Dwell".
std::string section_of_field(const std::string& path);
/// "ISO" of "ISO-0301".
std::string prefix_of_code(const std::string& code);
/// The options of a syntax, dependency or importer; nothing when it has none.
void write_options(Page& page, const Json& options);

}  // namespace isogloss::cli::docs
