// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/render/gl.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"

namespace toile {

/// The GPU's copy of the triangles' own values, looked up by gl_PrimitiveID, so that vertices need
/// not be doubled for colours that end at edges. Two texels per triangle, in rows of this many.
inline constexpr int kFaceTableWidth = 2048;

/// In the order of Scene::garment; zeros for pieces that are not flat.
std::vector<FaceValues> garmentFaces(const Scene& scene);

/// Every call needs the same context current; `release` before that context goes.
class FaceTable {
public:
    /// Uploads are counted there; must outlive this object.
    explicit FaceTable(FrameCounts& counts) : counts_(counts) {}

    /// Replaces what was there.
    /// @return false where the graphics card has no room for so many triangles
    bool upload(std::span<const FaceValues> faces);
    void bind(int unit) const;
    void release();

private:
    FrameCounts& counts_;
    GLuint texture_ = 0;
};

}  // namespace toile
