#include "export/canonical_blocks.hpp"

#include "isogloss/engine/document.hpp"
#include "isogloss/engine/program_text.hpp"

namespace isogloss {

namespace {

/// Lines of a program up to here are written as sequence numbers, which have five digits on many controls.
constexpr std::uint32_t last_number = 99999;

/// What a comment may hold on every control.
std::string comment_text(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 ._-/").find(c) ==
        std::string_view::npos)
      c = '_';
  return out;
}

}  // namespace

void CanonicalBlocks::begin() {
  file_.clear();
  document_ = nullptr;
  write_all("head");
}

bool CanonicalBlocks::end() {
  write_all("foot");
  return buffer_.flush();
}

void CanonicalBlocks::report(std::string_view code, std::initializer_list<std::string> arguments) {
  Location where;
  if (document_ != nullptr) where = {std::string(document_->source.file), document_->source.line, 0};
  sink_.add(host_diagnostic(code, std::move(where), arguments));
}

/// A row "head 1", "head 2" … each.
void CanonicalBlocks::write_all(std::string_view part) {
  for (const ProgramText::Row& row : text_.rows)
    if (row.name.starts_with(part) && row.name.size() > part.size() && row.name[part.size()] == ' ') put(row, {});
}

void CanonicalBlocks::write(std::string_view what, const Values& values, std::string_view which) {
  std::string name(what);
  if (!which.empty()) name.append(" ").append(which);
  if (const ProgramText::Row* const row = text_.find(name))
    put(*row, values);
  else
    report("IG-0193", {name});
}

void CanonicalBlocks::put(const ProgramText::Row& row, const Values& values) {
  if (document_ != nullptr && document_->source.file != file_) name_file();
  std::string block;
  const auto value = [&](std::string_view name, std::string_view format, std::string& out) {
    if (name == "LINE") {
      const std::uint32_t line = document_ == nullptr ? 0 : document_->source.line;
      if (line == 0 || line > last_number) return false;
      out += std::to_string(line);
      return true;
    }
    for (const Value& v : values)
      if (v.name == name) {
        out += block_number(v.number, is_exact_, format == "n");
        return true;
      }
    return false;
  };
  if (row.block.fill(value, block)) buffer_.append(block + "\n");
}

/// Sequence numbers are lines of this file from here on.
void CanonicalBlocks::name_file() {
  file_ = document_->source.file;
  const ProgramText::Row* const row = text_.find("comment");
  std::string block;
  const auto value = [&](std::string_view name, std::string_view, std::string& out) {
    if (name == "TEXT") out += comment_text(std::string_view(file_).substr(file_.rfind('/') + 1));
    return name == "TEXT";
  };
  if (row != nullptr && row->block.fill(value, block)) buffer_.append(block + "\n");
}

}  // namespace isogloss
