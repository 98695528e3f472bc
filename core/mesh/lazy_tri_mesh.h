// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

class TriMesh;

/// A place for the half-edge mesh of arrays that do not change any more: it is built when it is
/// first asked for, as most pieces are flattened without and it is the largest part of one.
class LazyTriMesh {
public:
    /// The half-edge mesh, see `buildTriMesh`. Always give the same arrays. Thread-safe: one caller
    /// builds, others wait.
    const TriMesh& get(const MeshArrays& mesh, const EdgeTable& table) const;

private:
    mutable std::once_flag built_;
    mutable std::shared_ptr<const TriMesh> halfedges_;
};

}  // namespace toile
