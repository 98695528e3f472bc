// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/render/frame_counts.h"
#include "app/render/gl_support.h"
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
    void upload(Gl& gl, const LineBuffers<Vertex>& lines,
                std::span<const VertexAttribute> attributes) {
        uploadVertices(gl, lines.vertices.data(), lines.vertices.size(), sizeof(Vertex),
                       attributes);
        uploadSegments(gl, lines.runs);
    }

    void drawSeams(Gl& gl) const { draw(gl, seams_); }
    /// Both its sides.
    void drawSeam(Gl& gl, int seam) const;
    void drawDesigner(Gl& gl) const { draw(gl, designer_); }
    /// Edges of an outline, as counted by OutlineRun: it may pass the outline's beginning.
    void drawOutline(Gl& gl, int piece, int first, int count) const;
    void release(Gl& gl);

private:
    /// Segments in the index buffer.
    struct Range {
        std::size_t first = 0, count = 0;
    };

    void uploadVertices(Gl& gl, const void* data, std::size_t count, std::size_t stride,
                        std::span<const VertexAttribute> attributes);
    void uploadSegments(Gl& gl, const LineRuns& runs);
    void draw(Gl& gl, const Range& range) const;

    FrameCounts& counts_;
    GLuint array_ = 0, vertices_ = 0, indices_ = 0;
    Range seams_, designer_;
    std::vector<Range> seam_, outline_;
};

}  // namespace toile
