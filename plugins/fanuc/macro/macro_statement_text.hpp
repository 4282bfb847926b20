/// How a macro statement is written in its block: its first word, its end, the text after THEN. Works on text only;
/// positions are byte offsets into the text of the block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fanuc {

enum class Word : std::uint8_t { none, if_, then, while_, do_, end, go_to, output, set_name, foreign };

/// The word that begins at `position`; `end`: the position after its letters.
Word keyword(std::string_view text, std::size_t position, std::size_t& end);

/// Also accepts WH, EN, TH … where only a statement can be.
Word keyword_or_short(std::string_view text, std::size_t position, std::size_t& end);

/// The statement that begins here; none where words begin.
Word statement_at(std::string_view text, std::size_t position);

/// True when the statement assigns to #3000 or #3006, whose text stands in parentheses.
bool has_message(std::string_view statement);

/// The position of the semicolon after the statement, without comments before it; the parentheses of #3000=1(ALARM
/// TEXT) belong to the statement. `inner` is set where a comment stands inside it.
std::size_t statement_end(std::string_view text, std::size_t position, bool& inner);

/// The position where words begin after THEN; 0 where none do.
std::size_t words_behind_then(std::string_view text, std::size_t position, std::size_t end);

/// The position of an assignment or of words that depend on the condition of an IF, with or without THEN; 0 where there
/// is something else.
std::size_t governed(std::string_view text, std::size_t position, std::size_t end);

/// The end of the assignment where words follow, as in "#101=0.0 M99": a single letter outside brackets. Functions and
/// operators have two letters or more.
std::size_t assignment_end(std::string_view text, std::size_t position, std::size_t end);

/// The position after an M99 that begins here; 0 where none does.
std::size_t return_end(std::string_view text, std::size_t position);

/// Reads the digits after DO and END.
bool loop_number(std::string_view text, std::size_t position, std::int64_t& number);

}  // namespace fanuc
