/// Files that commands write: as a whole, and never over what they read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "session.hpp"

namespace isogloss::cli {

/// False, and reported, when the file cannot be written. A reader that went away is no fault.
bool write_file(const std::string& path, std::string_view text, Session& session);

/// No output replaces a file that the command reads, nor another output; otherwise false, and reported.
bool are_apart(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs, Session& session);

/// False, and reported, where the name promises a picture of another form than SVG.
bool is_name_of_svg(const std::string& path, Session& session);

/// The files of a machine: those of the folder that machine.xml stands in, or the file of another name alone.
std::vector<std::string> files_of_machine(const std::string& machine_file);

}  // namespace isogloss::cli
