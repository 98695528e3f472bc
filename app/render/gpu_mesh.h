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

/// The GPU's copy of vertices, and of indices into them where there are any. Every call needs the
/// same context current; `release` must be called before that context goes.
class GpuBuffers {
public:
    /// Draw calls and uploads are counted there; must outlive this object.
    explicit GpuBuffers(FrameCounts& counts) : counts_(counts) {}

    void release();

protected:
    using Indices = std::span<const std::uint32_t>;

    /// Replaces what was there.
    template <class Vertex>
    void uploadVertices(const std::vector<Vertex>& vertices,
                        std::span<const VertexAttribute> attributes) {
        uploadBytes(vertices.data(), vertices.size() * sizeof(Vertex), sizeof(Vertex), attributes);
    }
    /// More of the same vertices, in a buffer of their own; replaces what was there of these.
    /// After the vertices themselves.
    template <class Vertex>
    void uploadBeside(const std::vector<Vertex>& vertices,
                      std::span<const VertexAttribute> attributes) {
        besideBytes(vertices.data(), vertices.size() * sizeof(Vertex), sizeof(Vertex), attributes);
    }
    /// One list after the other.
    void uploadIndices(std::initializer_list<Indices> lists);
    /// Vertices by so many indices from the first on.
    void draw(GLenum mode, std::size_t first, std::size_t count) const;
    /// The first vertices, each as a point.
    void drawPoints(std::uint32_t count) const;

private:
    void uploadBytes(const void* data, std::size_t bytes, std::size_t stride,
                     std::span<const VertexAttribute> attributes);

    void besideBytes(const void* data, std::size_t bytes, std::size_t stride,
                     std::span<const VertexAttribute> attributes);

    FrameCounts& counts_;
    GLuint array_ = 0, vertices_ = 0, indices_ = 0, beside_ = 0;
};

/// The GPU's copy of the cloth.
class GpuMesh : public GpuBuffers {
public:
    using GpuBuffers::GpuBuffers;

    /// Replaces what was there.
    void upload(const std::vector<ClothVertex>& vertices, const MeshIndices& mesh);
    /// Where the same vertices lie once sewn; none: takes that away. After `upload`.
    void uploadSewn(const std::vector<SewnVertex>& vertices);

    void drawTriangles() const { draw(GL_TRIANGLES, 0, triangles_); }
    void drawEdges() const { draw(GL_LINES, triangles_, edges_); }
    void drawOutline() const { draw(GL_LINES, triangles_ + edges_, outline_); }

    /// How often a mesh was sent to the GPU: a camera that moves must not raise it.
    int uploads() const { return uploads_; }

private:
    std::size_t triangles_ = 0, edges_ = 0, outline_ = 0;  ///< indices, one list after the other
    int uploads_ = 0;
};

/// The GPU's copy of lines, cut into segments so that any number of polylines that follow
/// each other take one draw call.
class GpuLines : public GpuBuffers {
public:
    using GpuBuffers::GpuBuffers;

    /// Replaces what was there.
    void upload(const std::vector<LineVertex>& vertices, const LineRuns& runs);
    /// As `GpuMesh::uploadSewn`.
    void uploadSewn(const std::vector<SewnVertex>& vertices);

    void drawSeams() const { drawSegments(seams_); }
    /// Both its sides.
    void drawSeam(int seam) const;
    void drawReference() const { drawSegments(reference_); }
    void drawExact() const { drawSegments(exact_); }
    void drawCutting() const { drawSegments(cutting_); }
    void drawNotches() const { drawSegments(notches_); }
    void drawInternal() const { drawSegments(internal_); }
    bool hasLeftOut() const { return leftOut_.count > 0; }
    void drawLeftOut() const { drawSegments(leftOut_); }
    /// Edges of a piece's boundary, as counted by OutlineRun, as they are drawn: it may pass the
    /// outline's beginning.
    void drawOutline(int piece, int first, int count) const;

private:
    /// Segments in the index buffer.
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

/// The GPU's copy of the principal strains' glyphs: one draw call, as many places as the scale of
/// the view has room for, and nothing uploaded when that changes.
class GpuGlyphs : public GpuBuffers {
public:
    using GpuBuffers::GpuBuffers;

    /// Replaces what was there.
    void upload(const StrainGlyphs& glyphs);
    void draw(const GlyphRange& run) const { drawPoints(run.count); }
};

}  // namespace toile::app
