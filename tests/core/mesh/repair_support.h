// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/mesh/disk_check.h"
#include "core/mesh/repair.h"
#include "core/mesh/weld.h"
#include "tests/core/support/literal_mesh.h"

namespace toile::test {

/// The mesh as if it were the whole file.
/// The part with each vertex replaced by its target, and vertices without use taken out.
inline MeshPart applyWeld(MeshPart part, const Weld& weld) {
    for (int& v : cornersOf(part.mesh.F)) {
        v = weld.target[v];
    }
    eraseUnusedVertices(part);
    return part;
}

inline MeshPart asPart(MeshArrays mesh) {
    MeshPart part{std::move(mesh), {}, {}};
    part.sourceVertex.resize(part.mesh.V.rows());
    part.sourceFace.resize(part.mesh.F.rows());
    std::iota(part.sourceVertex.begin(), part.sourceVertex.end(), 0);
    std::iota(part.sourceFace.begin(), part.sourceFace.end(), 0);
    return part;
}

inline double areaOf(const MeshArrays& mesh) {
    double area = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3d a = mesh.V.row(mesh.F(f, 1)) - mesh.V.row(mesh.F(f, 0));
        const Eigen::RowVector3d b = mesh.V.row(mesh.F(f, 2)) - mesh.V.row(mesh.F(f, 0));
        area += a.cross(b).norm() / 2;
    }
    return area;
}

/// The components as meshes of their own, as pieces will be.
inline std::vector<MeshArrays> componentsOf(const MeshArrays& mesh) {
    const std::vector<int> label = faceComponents(mesh.F, static_cast<int>(mesh.V.rows()));
    const int count = label.empty() ? 0 : *std::max_element(label.begin(), label.end()) + 1;
    std::vector<MeshArrays> components;
    for (int c = 0; c < count; ++c) {
        MeshPart part = asPart(mesh);
        std::vector<char> others(label.size());
        std::transform(label.begin(), label.end(), others.begin(),
                       [c](int l) { return static_cast<char>(l != c); });
        eraseFaces(part, others);
        eraseUnusedVertices(part);
        components.push_back(std::move(part.mesh));
    }
    return components;
}

/// Every component is an oriented manifold of faces with area; only its shape as a whole (closed,
/// loops, handles) may keep it from being a disk.
inline void expectOrientedManifold(const MeshArrays& mesh) {
    for (int f = 0; f < mesh.F.rows(); ++f) {
        EXPECT_FALSE(shapeOf(mesh, f).flat) << "face " << f;
    }
    for (const MeshArrays& component : componentsOf(mesh)) {
        const DiskCheck check = checkDisk(component, "component");
        const bool isFine = !check.defect || check.defect->code == ErrorCode::ClosedSurface ||
                            check.defect->code == ErrorCode::SeveralLoops ||
                            check.defect->code == ErrorCode::Handle;
        EXPECT_TRUE(isFine) << sentence(*check.defect);
    }
    MeshPart copy = asPart(mesh);
    EXPECT_EQ(eraseUnusedVertices(copy), 0);
}

/// Sources point into the original, and a vertex stands where its source stands.
inline void expectSources(const MeshPart& part, const MeshArrays& original) {
    ASSERT_EQ(part.sourceVertex.size(), static_cast<std::size_t>(part.mesh.V.rows()));
    ASSERT_EQ(part.sourceFace.size(), static_cast<std::size_t>(part.mesh.F.rows()));
    for (int v = 0; v < part.mesh.V.rows(); ++v) {
        const int source = part.sourceVertex[v];
        ASSERT_LT(source, original.V.rows());
        ASSERT_GE(source, -1);
        if (source >= 0) {
            EXPECT_EQ(part.mesh.V.row(v), original.V.row(source));
        }
    }
    for (const int source : part.sourceFace) {
        EXPECT_GE(source, 0);
        EXPECT_LT(source, original.F.rows());
    }
}

/// The kinds of repair, for example "windings-turned edges-cut-apart".
inline std::string kindsOf(const Problems& repairs) {
    std::string kinds;
    for (const Error& repair : repairs) {
        kinds += (kinds.empty() ? "" : " ") + std::string(name(repair.code));
    }
    return kinds;
}

/// The first number in the note of this kind; 0 where there is none.
inline int countOf(const Problems& repairs, ErrorCode code) {
    for (const Error& repair : repairs) {
        if (repair.code == code) {
            return std::stoi(repair.detail);
        }
    }
    return 0;
}

}  // namespace toile::test
