/// What fuzzers feed with bytes. A target aborts where a promise is broken; a crash, a hang or what a sanitizer finds
/// ends it as well.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/exporter.hpp"
#include "workspace.hpp"

namespace isogloss::fuzz {

class Target {
 public:
  virtual ~Target() = default;
  virtual void run(std::string_view bytes) = 0;
  /// From programs, pages and files of this project; further ones stand in corpus/NAME.
  virtual std::vector<std::string> samples() const = 0;
  /// Inputs that were not refused at the first look. Where no sample is among them, the target tests nothing.
  std::uint64_t accepted() const { return accepted_; }

 protected:
  void accept() { ++accepted_; }

 private:
  std::uint64_t accepted_ = 0;
};

/// By name; null: there is none. Dictionaries stand in NAME.dict, or in that of the part before the dot.
std::unique_ptr<Target> make_target(const std::string& name);
std::vector<std::string> target_names();

/// Ends the process: the input breaks this promise.
[[noreturn]] void fail(const std::string& promise);

/// The workspace of the build tree, with all its plugins. One for the process.
Workspace& workspace();
/// A dialect without tables of the user.
const LinkedDialect& dialect(const std::string& name);
/// All files of the project's tree whose names end so, up to 64 KiB each.
std::vector<std::string> texts_of_files(const std::string& below, const std::string& ending);

class TextOutput : public Output {
 public:
  bool write(std::string_view bytes) override {
    text.append(bytes);
    return true;
  }
  std::string text;
};

/// Faults of plugins and of the host are none of the input: a diagnostic that tells of one breaks a promise.
void expect_no_internal_fault(const std::vector<Diagnostic>& said);

// One for each file *_target.cpp.
std::unique_ptr<Target> make_program_target(const std::string& dialect, const std::string& before,
                                            const std::string& behind);
std::unique_ptr<Target> make_dialect_target();
std::unique_ptr<Target> make_tables_target();
std::unique_ptr<Target> make_import_target();
std::unique_ptr<Target> make_page_target();
std::unique_ptr<Target> make_block_target();
std::unique_ptr<Target> make_descriptor_target();
std::unique_ptr<Target> make_stream_target();
std::unique_ptr<Target> make_messages_target();

}  // namespace isogloss::fuzz
