/// One page of the reference while it is written: the same calls make HTML or Markdown.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "docs/addresses.hpp"
#include "docs/page_text.hpp"
#include "docs/reference.hpp"

namespace isogloss::cli::docs {

/// A text with its markup: what text(), code() and name() return, and what blocks take.
using Markup = std::string;

struct Row {
  std::vector<Markup> cells;
  std::string anchor = {};
};

class Page {
 public:
  Page(std::string file, std::string title, const Addresses& addresses)
      : file_(std::move(file)), title_(std::move(title)), addresses_(addresses) {}
  virtual ~Page() = default;
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  const std::string& file() const { return file_; }
  const std::string& title() const { return title_; }
  const Addresses& addresses() const { return addresses_; }

  virtual Markup text(std::string_view plain) const = 0;
  virtual Markup code(std::string_view plain) const = 0;
  virtual Markup link(const Address& to, const Markup& label) const = 0;
  virtual Markup line_break() const = 0;

  /// A sentence of a plugin: what stands between `backticks` is code, and names become links where the form can do so.
  Markup prose(std::string_view sentence) const;
  /// A name, as a link where something has it.
  Markup name(Kind kind, const std::string& name) const;
  /// The names, separated by commas.
  Markup names(Kind kind, const std::vector<std::string>& names) const;

  virtual void heading(unsigned level, const Markup& title, const std::string& anchor) = 0;
  virtual void paragraph(const Markup& content) = 0;
  virtual void list(const std::vector<Markup>& items) = 0;
  /// Columns without a cell in any row are left out; without rows, the whole table.
  void table(const std::vector<std::string>& head, const std::vector<Row>& rows);
  /// The Markdown of a plugin; the links that lead nowhere.
  virtual std::vector<std::string> page_text(const std::string& markdown) = 0;
  virtual void graph(const Json& chain) = 0;

  /// The text of the file.
  virtual std::string whole() const = 0;

 protected:
  virtual Markup prose_text(std::string_view plain) const = 0;
  virtual Markup prose_code(std::string_view plain) const = 0;
  virtual void full_table(const std::vector<std::string>& head, const std::vector<Row>& rows) = 0;
  std::string out_;

 private:
  std::string file_, title_;
  const Addresses& addresses_;
};

std::unique_ptr<Page> html_page(std::string file, std::string title, const Addresses& addresses);
std::unique_ptr<Page> markdown_page(std::string file, std::string title, const Addresses& addresses);

}  // namespace isogloss::cli::docs
