// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/render/gpu_mesh.h"
#include "app/render/scene.h"

namespace toile {

/// The GPU's copy of a LineBuffers, cut into segments so that any number of polylines that follow
/// each other take one draw call. Every call needs the same context current; `release` must be
/// called before that context goes.
class GpuLines {
public:
    /// Draw calls and uploads are counted there; must outlive this object.
    explicit GpuLines(FrameCounts& counts) : counts_(counts) {}

    /// Replaces what was there.
    template <class Vertex>
    void upload(const LineBuffers<Vertex>& lines, std::span<const VertexAttribute> attributes) {
        uploadVertices(lines.vertices.data(), lines.vertices.size(), sizeof(Vertex), attributes);
        uploadSegments(lines.runs);
    }

    void drawSeams() const { draw(seams_); }
    /// Both its sides.
    void drawSeam(int seam) const;
    void drawDesigner() const { draw(designer_); }
    /// Edges of an outline, as counted by OutlineRun: it may pass the outline's beginning.
    void drawOutline(int piece, int first, int count) const;
    void release();

private:
    /// Segments in the index buffer.
    struct Range {
        std::size_t first = 0, count = 0;
    };

    void uploadVertices(const void* data, std::size_t count, std::size_t stride,
                        std::span<const VertexAttribute> attributes);
    void uploadSegments(const LineRuns& runs);
    void draw(const Range& range) const;

    FrameCounts& counts_;
    GLuint array_ = 0, vertices_ = 0, indices_ = 0;
    Range seams_, designer_;
    std::vector<Range> seam_, outline_;
};

}  // namespace toile
