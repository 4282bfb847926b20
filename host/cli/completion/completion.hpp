/// What may stand at the cursor of a command line that is being typed.
#pragma once

#include <string>
#include <vector>

#include "session.hpp"
#include "usage.hpp"

namespace isogloss::cli {

struct Completion {
  std::string text, description;
  bool is_whole = true;  ///< false: more follows without a blank, as a row follows the name of its table
};

/// A command line up to the cursor, read against the usage of its command.
struct TypedLine {
  const Command* command = nullptr;  ///< null: the cursor is at or before the command's name
  std::string word;                  ///< what of the word at the cursor, or of the value behind its '=', is typed
  const UsageItem* item = nullptr;   ///< the option whose value, or the operand which the word is; null: neither
  Usage usage;
  std::vector<const UsageItem*> given;  ///< options that stand on the line, each as often as it does
  CommonOptions places;                 ///< the folders that the line names
  std::string dialect, machine, format;
  std::string operand;  ///< the first one
};

/// Reads the words behind `isogloss`; the last one, which may be empty, is the one at the cursor.
void read_typed(const std::vector<std::string>& words, TypedLine& line);

/// Commands and options, or the words that the item at the cursor allows.
std::vector<Completion> words_of(const TypedLine& line);

/// Which files are values of the item at the cursor: a pattern such as "*.xml", "*" for any, "/" for folders, or empty.
std::string_view files_of(const TypedLine& line);
/// Names that are installed, or lie in the folders that the line names, and are values of the item at the cursor.
std::vector<Completion> names_of(const TypedLine& line);

}  // namespace isogloss::cli
