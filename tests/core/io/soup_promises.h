// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/io/soup.h"

namespace toile::test {

/// The first promise of the soup's header that it breaks, in words: indices in range, three corners
/// per face, lists of matching lengths, text inside the file. Empty where it keeps them all.
/// Cost: linear. Pure; knows no test framework, so that the fuzz targets can use it.
std::string brokenPromise(const PolygonSoup& soup);

}  // namespace toile::test
