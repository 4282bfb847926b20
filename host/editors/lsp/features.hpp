/// What the server answers about a part program. Each function gives the result of one request.
#pragma once

#include "lsp/open_program.hpp"

namespace isogloss::editors {

Json diagnostics_of(const OpenProgram& program, const Surroundings& around);
/// One diagnostic of a file, as the protocol has it.
Json diagnostic_json(const Diagnostic& diagnostic, const TextDocument& text, Toolbox& toolbox);
Json hover(OpenProgram& program, const Position& at, const Surroundings& around);
Json definition(OpenProgram& program, const Position& at, const Surroundings& around);
Json references(OpenProgram& program, const Position& at, bool with_declaration, const Surroundings& around);
Json highlights(OpenProgram& program, const Position& at, const Surroundings& around);
/// The range and text that rename() would change; null where there is nothing to rename.
Json prepare_rename(OpenProgram& program, const Position& at, const Surroundings& around);
/// Throws Refusal where the new name changes what the program does.
Json rename(OpenProgram& program, const Position& at, const std::string& name, const Surroundings& around);
Json symbols(OpenProgram& program);
Json folding(OpenProgram& program);
Json completion(OpenProgram& program, const Position& at, const Surroundings& around);
Json inlay_hints(OpenProgram& program, const Range& range, const Surroundings& around);
Json code_actions(const OpenProgram& program, const Range& range, const Json& context, const Surroundings& around);
/// Throws Refusal where a motion would change.
Json formatting(OpenProgram& program, const Range* range, const Surroundings& around);
Json semantic_tokens(OpenProgram& program, const Range* range);
Json semantic_legend();

}  // namespace isogloss::editors
