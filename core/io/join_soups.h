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

/// Joins several files of a garment, in their order. A file without objects becomes one object with
/// the file's name, which is also the prefix of an object whose name is taken. The files' own
/// digits are dropped. Precondition: at least one, all in one unit.
/// Cost: linear. Pure.
PolygonSoup joinedSoups(std::vector<NamedSoup> files);

}  // namespace toile::io
