// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/render/gl.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"

namespace toile {

/// Float attribute of a vertex: shader location, number of floats, offset in bytes.
struct VertexAttribute {
    GLuint location;
    GLint size;
    std::size_t offset;
};

/// Bytes into the bound buffer, which OpenGL takes as a pointer.
inline const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

/// A vertex buffer with these bytes, and a vertex array that reads attributes from one.
GLuint makeVertexBuffer(const void* data, std::size_t bytes);
GLuint makeVertexArray(GLuint buffer, std::size_t stride,
                       std::span<const VertexAttribute> attributes);

/// The GPU's copy of a MeshBuffers. Every call needs the same context current; `release` must be
/// called before that context goes.
class GpuMesh {
public:
    /// Draw calls and uploads are counted there; must outlive this object.
    explicit GpuMesh(FrameCounts& counts) : counts_(counts) {}

    /// Replaces what was there.
    template <class Vertex>
    void upload(const MeshBuffers<Vertex>& buffers, std::span<const VertexAttribute> attributes) {
        uploadVertices(buffers.vertices.data(), buffers.vertices.size(), sizeof(Vertex),
                       attributes);
        uploadIndices({buffers.triangles, buffers.edges, buffers.outline});
    }

    void drawTriangles() const { draw(GL_TRIANGLES, 0); }
    void drawEdges() const { draw(GL_LINES, 1); }
    void drawOutline() const { draw(GL_LINES, 2); }
    void release();

    /// How often a mesh was sent to the GPU: a camera that moves must not raise it.
    int uploads() const { return uploads_; }

private:
    using IndexLists = std::array<std::span<const std::uint32_t>, 3>;

    struct Run {
        std::size_t offset = 0;  ///< bytes into the index buffer
        GLsizei count = 0;
    };

    void uploadVertices(const void* data, std::size_t count, std::size_t stride,
                        std::span<const VertexAttribute> attributes);
    void uploadIndices(const IndexLists& lists);
    void draw(GLenum mode, std::size_t list) const;

    FrameCounts& counts_;
    GLuint array_ = 0, vertices_ = 0, indices_ = 0;
    std::array<Run, 3> runs_{};
    int uploads_ = 0;
};

}  // namespace toile
