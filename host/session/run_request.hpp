/// What a run of a program is asked for: which dialect, the user's own tables, the switches of the machine.
#pragma once

#include <memory>

#include "isogloss/engine/runner.hpp"
#include "workspace.hpp"

namespace isogloss {

struct RunRequest {
  std::string dialect;
  std::string machine, offsets, tools, variables;
  std::vector<std::string> set;
  std::string block_skip;
  bool optional_stop = false;
  std::string program;
  std::vector<std::string> subprograms;
  std::string main_passes;
  std::uint32_t maximum_depth = 100;
  std::uint64_t maximum_jumps = 1'000'000, maximum_loop_blocks = 100'000'000, maximum_repeat_blocks = 10'000'000;
  std::string on_error = "continue";
  std::uint64_t maximum_blocks = 0;
  std::uint64_t maximum_motions = RunOptions{}.maximum_motions;

  /// Reads the tables and settings, and sets `dialect` where a machine names it; empty, and reported, when something
  /// is wrong.
  std::optional<RunOptions> make(Workspace& workspace);
  /// What the files of a control in a table stand for, plugins tell. A process that loads none leaves them unread.
  enum class Completion : std::uint8_t { none, by_plugins };
  /// The first half of make(): the tables, and `dialect`.
  std::optional<std::vector<DependencyElement>> read_tables(Workspace& workspace, Completion completion);
  /// The second half: all but the tables, and no plugin is loaded.
  std::optional<RunOptions> make_settings(Workspace& workspace) const;
};

/// Called programs are looked for in the program's own folder, then in those that the user named, then in the
/// machine's.
void add_program_places(const std::string& program, const Dialect& dialect, RunOptions& options);

/// A program that was opened, with its head read for guessing.
class OpenedProgram : public Source {
 public:
  /// Null, and reported, when it cannot be read.
  static std::unique_ptr<OpenedProgram> open(const std::string& path, Workspace& workspace);
  std::size_t read(char* buffer, std::size_t size) override;
  bool has_places() const override { return rest_->has_places(); }
  std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t size) override {
    return rest_->read_at(offset, buffer, size);
  }
  std::string failure() const override { return rest_->failure(); }
  std::unique_ptr<Source> again() const override { return rest_->again(); }
  std::string_view head() const { return head_; }

 private:
  OpenedProgram(std::unique_ptr<Source> rest, std::string head) : rest_(std::move(rest)), head_(std::move(head)) {}
  std::unique_ptr<Source> rest_;
  std::string head_;
  std::size_t given_ = 0;
};

}  // namespace isogloss
