// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/cli/option_groups.h"

namespace toile::app {

/// Options of which it is known only when all is parsed what becomes of them.
struct TypedOptions {
    std::vector<std::filesystem::path> windowFiles;
    std::vector<std::string> methods;
    std::string report, picture, size, look;
    std::map<std::string, std::string> exporting;  ///< by FormatOption::name
    OptionGroups groups;
};

}  // namespace toile::app
