// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A graph on the vertices of a mesh, with a symmetric weight per edge.
struct WeightedEdges {
    Edges edges;              ///< #E x 2, sorted as in EdgeTable
    Eigen::VectorXd weights;  ///< #E
};

}  // namespace toile
