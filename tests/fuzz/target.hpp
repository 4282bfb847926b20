/// What fuzzers feed with bytes. A target aborts where a promise is broken; a crash, a hang or what a sanitizer finds
/// ends it as well.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "product.hpp"

namespace isogloss::fuzz {

using product::dialect;
using product::TextOutput;
using product::texts_of_files;
using product::workspace;

class Target {
 public:
  virtual ~Target() = default;
  virtual void run(std::string_view bytes) = 0;
  /// From programs, pages and files of this project; further ones stand in corpus/NAME.
  virtual std::vector<std::string> samples() const = 0;
  /// Names that the plugins declare for such inputs, in any order; the samples need not hold them.
  virtual std::vector<std::string> words() const { return {}; }
  /// Inputs that were not refused at the first look. Where no sample is among them, the target tests nothing.
  std::uint64_t accepted() const { return accepted_; }

 protected:
  void accept() { ++accepted_; }

 private:
  std::uint64_t accepted_ = 0;
};

/// By name; null: there is none.
std::unique_ptr<Target> make_target(const std::string& name);
std::vector<std::string> target_names();
/// What a fuzzer inserts into inputs: the words of the target, and those that several of its samples hold.
std::vector<std::string> dictionary(const Target& target);

/// Ends the process: the input breaks this promise.
[[noreturn]] void fail(const std::string& promise);

/// The parts of a text between blanks and signs: names and codes, from two to 40 bytes.
void add_words(std::string_view text, std::set<std::string>& out);
/// Names of syntaxes, tables, importers, options, rows and columns that the plugins declare.
std::vector<std::string> declared_names();

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
