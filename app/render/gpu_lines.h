// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/render/gl_support.h"
#include "app/render/gpu_mesh.h"
#include "app/render/scene.h"

namespace toile {

/// The GPU's copy of a LineBuffers. Every call needs the same context current; `release` must be
/// called before that context goes.
class GpuLines {
public:
    /// Replaces what was there.
    template <class Vertex>
    void upload(Gl& gl, const LineBuffers<Vertex>& lines,
                std::span<const VertexAttribute> attributes) {
        uploadVertices(gl, lines.vertices.data(), lines.vertices.size(), sizeof(Vertex),
                       attributes);
    }

    /// One polyline; nothing where the run is empty.
    void draw(Gl& gl, const VertexRun& run) const;
    void release(Gl& gl);

private:
    void uploadVertices(Gl& gl, const void* data, std::size_t count, std::size_t stride,
                        std::span<const VertexAttribute> attributes);

    GLuint array_ = 0, vertices_ = 0;
};

}  // namespace toile
