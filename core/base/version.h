// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace toile {

/// Version of the program, for example "0.1.0"; the same as the CMake project's.
std::string_view version();

}  // namespace toile
