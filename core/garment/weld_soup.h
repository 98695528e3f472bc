// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "core/base/error.h"
#include "core/io/soup.h"

namespace toile {

/// Joins vertices that lie on each other, within each object, by making faces name one of them; no
/// vertex goes. Where none are to be joined the soup stays the same pointer. A corner that comes to
/// repeat its neighbour goes where three are left.
/// @param wanted       by the user: joins what lies within this, mm; 0: within a thousandth of the
///                     median edge. None: only a file of unconnected triangles is touched, and
///                     only where coordinates are equal
/// @param millimetres  per unit of the file, for the message
/// @return a VerticesWelded note where anything was joined
/// Cost: linear on average; for a file that needs nothing its triangles and one count of their
/// corners.
Problems weldSoup(std::shared_ptr<const PolygonSoup>& soup, std::optional<double> wanted,
                  double millimetres, const std::string& name);

}  // namespace toile
