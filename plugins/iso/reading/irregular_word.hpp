/// Text in the place of a word that is not an address and a plain number: an expression is a leftover for evaluation,
/// and a typing error is a diagnostic that shows the text. Neither sets the word. Each function returns the end of the
/// text that it has read, or the place where it began where another scanner may read it. Places are byte columns.
#pragma once

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

/// True at #1, [#1+2.], SIN[30.]
bool begins_expression(std::string_view text, std::size_t position);

/// The address at `begin`, whose field is `field`, has no number at `number`: an expression, a name or a typing error.
std::size_t read_without_number(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number,
                                ig_field field, Expressions expressions);

/// The number of the address at `begin` ends at `end` before a character that does not end a word.
std::size_t read_odd_end(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, ig_field field);

/// A number that no address precedes.
std::size_t read_without_address(ig::Block& b, std::string_view text, std::size_t position);

/// G01 X5. ,C2. or ,R2.: a chamfer or a corner radius, which is neither a C word nor an R word.
std::size_t read_corner(ig::Block& b, std::string_view text, std::size_t position, Expressions expressions);

}  // namespace iso
