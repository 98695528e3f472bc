// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "app/render/gl.h"
#include "app/render/gl_support.h"
#include "app/render/scene.h"
#include "app/render/sewn_cloth.h"

namespace toile::app {

/// Float attribute of a vertex: shader location, number of floats, offset in bytes.
struct VertexAttribute {
    GLuint location;
    GLint size;
    std::size_t offset;
};

/// The GPU's copy of vertices and optional indices. All calls need the same context current. Call
/// `release` before that context is destroyed.
class GpuBuffers {
public:
    /// Counts draw calls and uploads in `counts`, which must outlive this object.
    explicit GpuBuffers(FrameCounts& counts) : counts_(counts) {}

    void release();

protected:
    using Indices = std::span<const std::uint32_t>;

    /// Replaces the vertices.
    template <class Vertex>
    void uploadVertices(const std::vector<Vertex>& vertices,
                        std::span<const VertexAttribute> attributes) {
        uploadBytes(vertices.data(), vertices.size() * sizeof(Vertex), sizeof(Vertex), attributes);
    }
    /// Uploads or replaces additional attributes of the same vertices in a separate buffer. Call
    /// after uploading the vertices.
    template <class Vertex>
    void uploadBeside(const std::vector<Vertex>& vertices,
                      std::span<const VertexAttribute> attributes) {
        besideBytes(vertices.data(), vertices.size() * sizeof(Vertex), sizeof(Vertex), attributes);
    }
    /// Concatenates the lists.
    void uploadIndices(std::initializer_list<Indices> lists);
    /// Draws `count` indices, beginning at `first`.
    void draw(GLenum mode, std::size_t first, std::size_t count) const;
    /// Draws the first vertices as points.
    void drawPoints(std::uint32_t count) const;

private:
    void uploadBytes(const void* data, std::size_t bytes, std::size_t stride,
                     std::span<const VertexAttribute> attributes);

    void besideBytes(const void* data, std::size_t bytes, std::size_t stride,
                     std::span<const VertexAttribute> attributes);

    FrameCounts& counts_;
    GLuint array_ = 0, vertices_ = 0, indices_ = 0, beside_ = 0;
};

class GpuMesh : public GpuBuffers {
public:
    using GpuBuffers::GpuBuffers;

    /// Replaces the mesh.
    void upload(const std::vector<ClothVertex>& vertices, const MeshIndices& mesh);
    /// Uploads the vertices' sewn positions; an empty list removes them. Call after `upload`.
    void uploadSewn(const std::vector<SewnVertex>& vertices);

    void drawTriangles() const { draw(GL_TRIANGLES, 0, triangles_); }
    void drawEdges() const { draw(GL_LINES, triangles_, edges_); }
    void drawOutline() const { draw(GL_LINES, triangles_ + edges_, outline_); }

    /// Number of mesh uploads; camera moves must not raise it.
    int uploads() const { return uploads_; }

private:
    std::size_t triangles_ = 0, edges_ = 0, outline_ = 0;  ///< counts of indices
    int uploads_ = 0;
};

/// The GPU's copy of lines, split into segments, so that consecutive polylines take one draw call.
class GpuLines : public GpuBuffers {
public:
    using GpuBuffers::GpuBuffers;

    /// Replaces the lines.
    void upload(const std::vector<LineVertex>& vertices, const LineRuns& runs);
    /// See `GpuMesh::uploadSewn`.
    void uploadSewn(const std::vector<SewnVertex>& vertices);

    void drawSeams() const { drawSegments(seams_); }
    /// Draws both sides.
    void drawSeam(int seam) const;
    void drawReference() const { drawSegments(reference_); }
    void drawExact() const { drawSegments(exact_); }
    void drawCutting() const { drawSegments(cutting_); }
    void drawNotches() const { drawSegments(notches_); }
    void drawInternal() const { drawSegments(internal_); }
    bool hasLeftOut() const { return leftOut_.count > 0; }
    void drawLeftOut() const { drawSegments(leftOut_); }
    /// Draws edges of a piece's boundary, counted as in OutlineRun. The range may wrap past the
    /// outline's start.
    void drawOutline(int piece, int first, int count) const;

private:
    /// A range of segments in the index buffer.
    struct Range {
        std::size_t first = 0, count = 0;
    };

    void drawSegments(const Range& range) const {
        draw(GL_LINES, 2 * range.first, 2 * range.count);
    }

    Range seams_, reference_, exact_, cutting_, notches_, internal_, leftOut_;
    std::vector<Range> seam_, outline_;
    std::vector<std::vector<std::uint32_t>> boundaryAt_;  ///< LineRuns::boundaryAt
};

/// The GPU's copy of the principal strain glyphs. One draw call shows as many glyphs as fit at the
/// view's scale; changing the scale uploads nothing.
class GpuGlyphs : public GpuBuffers {
public:
    using GpuBuffers::GpuBuffers;

    /// Replaces the glyphs.
    void upload(const StrainGlyphs& glyphs);
    void draw(const GlyphRange& run) const { drawPoints(run.count); }
};

}  // namespace toile::app
