// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/io/soup.h"

namespace toile::io {

struct NamedSoup {
    std::string name;  ///< of its file, without the ending
    PolygonSoup soup;
};

/// Several files of a garment as one that holds all of them, in their order. What a file names no
/// object is one by the file's name; so is told apart what two files name alike. The files' own
/// digits do not come along. Precondition: at least one, all in one unit.
/// Cost: linear. Pure.
PolygonSoup joinedSoups(std::vector<NamedSoup> files);

}  // namespace toile::io
