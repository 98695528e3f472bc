// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/cli/arguments.h"

namespace toile::app {

/// What is wrong with arguments of which each is well written: numbers that no range of CLI11 sees,
/// and files that cannot be written, or must not. @return nothing where all is well
std::string wrongIn(const Arguments& arguments);

/// Whether a file is a picture by its ending: "x.png".
bool isPicture(const std::filesystem::path& file);

}  // namespace toile::app
