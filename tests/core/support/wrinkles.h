// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace toile::test {

/// Writes an OBJ again with wrinkles, as an artist sculpts them: one round bump for every 60 mm or
/// so of cloth, 5 to 7.5 mm high, along the surface's normal, outwards and inwards by turns. All
/// else, texture coordinates above all, is as it was. The same for the same file everywhere.
/// @param millimetres  in one unit of the file
/// @param widening     1: bumps are 28 to 47 mm wide at half their height
/// @return the new file, in `folder`, under the same name
std::filesystem::path writeWrinkled(const std::filesystem::path& obj, double millimetres,
                                    const std::filesystem::path& folder, double widening = 1);

}  // namespace toile::test
