// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gpu_mesh.h"

#include <algorithm>
#include <cstddef>

namespace toile::app {

namespace {

constexpr VertexAttribute kClothAttributes[] = {
    {0, 3, offsetof(ClothVertex, position)}, {1, 3, offsetof(ClothVertex, normal)},
    {2, 2, offsetof(ClothVertex, flat)},     {3, 4, offsetof(ClothVertex, values)},
    {4, 1, offsetof(ClothVertex, piece)},    {5, 3, offsetof(ClothVertex, metric)},
};

constexpr VertexAttribute kLineAttributes[] = {
    {0, 3, offsetof(LineVertex, position)}, {2, 2, offsetof(LineVertex, flat)},
    {4, 1, offsetof(LineVertex, piece)},    {6, 1, offsetof(LineVertex, along)},
    {7, 1, offsetof(LineVertex, tint)},
};

constexpr VertexAttribute kSewnAttributes[] = {
    {8, 3, offsetof(SewnVertex, position)},
    {9, 3, offsetof(SewnVertex, normal)},
    {10, 3, offsetof(SewnVertex, gap)},  // and strain, and whether it is sewn
};

constexpr VertexAttribute kGlyphAttributes[] = {
    {0, 3, offsetof(GlyphVertex, position)},  {1, 2, offsetof(GlyphVertex, flat)},
    {2, 2, offsetof(GlyphVertex, flatAlong)}, {3, 3, offsetof(GlyphVertex, along)},
    {4, 3, offsetof(GlyphVertex, across)},    {5, 2, offsetof(GlyphVertex, strain)},
    {6, 1, offsetof(GlyphVertex, piece)},
};

/// Contents of a buffer.
struct BufferData {
    const void* data;
    std::size_t bytes, stride;
    GLenum usage;
};

/// Offset into the bound buffer, which OpenGL takes as a pointer.
const void* bufferOffset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

/// Fills a buffer and sets the attributes of the bound vertex array, then unbinds it. Without
/// bytes, the attributes are zero.
void fill(GLuint buffer, const BufferData& from, std::span<const VertexAttribute> attributes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(from.bytes), from.data, from.usage);
    for (const VertexAttribute& attribute : attributes) {
        if (from.bytes == 0) {
            glDisableVertexAttribArray(attribute.location);
            continue;
        }
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.size, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(from.stride), bufferOffset(attribute.offset));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

}  // namespace

void GpuBuffers::uploadBytes(const void* data, std::size_t bytes, std::size_t stride,
                             std::span<const VertexAttribute> attributes) {
    release();
    glGenBuffers(1, &vertices_);
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    fill(vertices_, {data, bytes, stride, GL_STATIC_DRAW}, attributes);
    counts_.uploadedBytes += bytes;
}

void GpuBuffers::besideBytes(const void* data, std::size_t bytes, std::size_t stride,
                             std::span<const VertexAttribute> attributes) {
    if (array_ == 0) {
        return;
    }
    if (beside_ == 0) {
        glGenBuffers(1, &beside_);
    }
    glBindVertexArray(array_);
    fill(beside_, {data, bytes, stride, GL_DYNAMIC_DRAW}, attributes);
    counts_.uploadedBytes += bytes;
}

void GpuBuffers::uploadIndices(std::initializer_list<Indices> lists) {
    std::size_t total = 0;
    for (const Indices& list : lists) {
        total += list.size_bytes();
    }
    glGenBuffers(1, &indices_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);  // part of the vertex array's state
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr, GL_STATIC_DRAW);
    std::size_t offset = 0;
    for (const Indices& list : lists) {
        glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(offset),
                        static_cast<GLsizeiptr>(list.size_bytes()), list.data());
        offset += list.size_bytes();
    }
    glBindVertexArray(0);
    counts_.uploadedBytes += total;
}

void GpuBuffers::draw(GLenum mode, std::size_t first, std::size_t count) const {
    if (array_ == 0 || count == 0) {
        return;
    }
    glBindVertexArray(array_);
    glDrawElements(mode, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   bufferOffset(first * sizeof(std::uint32_t)));
    glBindVertexArray(0);
    ++counts_.drawCalls;
}

void GpuBuffers::drawPoints(std::uint32_t count) const {
    glBindVertexArray(array_);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
    glBindVertexArray(0);
    ++counts_.drawCalls;
}

void GpuBuffers::release() {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &vertices_);
    glDeleteBuffers(1, &indices_);
    glDeleteBuffers(1, &beside_);
    array_ = vertices_ = indices_ = beside_ = 0;
}

void GpuMesh::upload(const std::vector<ClothVertex>& vertices, const MeshIndices& mesh) {
    ++uploads_;
    uploadVertices(vertices, kClothAttributes);
    uploadIndices({mesh.triangles, mesh.edges, mesh.outline});
    triangles_ = mesh.triangles.size();
    edges_ = mesh.edges.size();
    outline_ = mesh.outline.size();
}

void GpuMesh::uploadSewn(const std::vector<SewnVertex>& vertices) {
    uploadBeside(vertices, kSewnAttributes);
}

void GpuLines::uploadSewn(const std::vector<SewnVertex>& vertices) {
    uploadBeside(vertices, kSewnAttributes);
}

void GpuLines::upload(const std::vector<LineVertex>& vertices, const LineRuns& runs) {
    uploadVertices(vertices, kLineAttributes);
    seam_.clear();
    outline_.clear();
    std::vector<std::uint32_t> indices;
    const auto add = [&indices](const VertexRun& run) {
        for (std::uint32_t i = 1; i < run.count; ++i) {
            indices.push_back(run.first + i - 1);
            indices.push_back(run.first + i);
        }
    };
    const auto rangeSince = [&indices](std::size_t first) -> Range {
        return {first, indices.size() / 2 - first};
    };
    for (const auto& sides : runs.seams) {
        const std::size_t first = indices.size() / 2;
        add(sides[0]);
        add(sides[1]);
        seam_.push_back(rangeSince(first));
    }
    seams_ = rangeSince(0);
    const auto addAll = [&](const std::vector<VertexRun>& lines) -> Range {
        const std::size_t first = indices.size() / 2;
        std::ranges::for_each(lines, add);
        return rangeSince(first);
    };
    reference_ = addAll(runs.reference);
    exact_ = addAll(runs.exact);
    cutting_ = addAll(runs.cutting);
    notches_ = addAll(runs.notches);
    internal_ = addAll(runs.internal);
    leftOut_ = addAll(runs.leftOut);
    boundaryAt_ = runs.boundaryAt;
    for (const VertexRun& run : runs.outlines) {
        const std::size_t first = indices.size() / 2;
        add(run);
        outline_.push_back(rangeSince(first));
    }
    uploadIndices({indices});
}

void GpuLines::drawSeam(int seam) const {
    if (seam >= 0 && seam < static_cast<int>(seam_.size())) {
        drawSegments(seam_[static_cast<std::size_t>(seam)]);
    }
}

void GpuLines::drawOutline(int piece, int first, int count) const {
    if (piece < 0 || piece >= static_cast<int>(outline_.size())) {
        return;
    }
    const auto at = static_cast<std::size_t>(piece);
    const Range& whole = outline_[at];
    const auto* drawnAt =
        at < boundaryAt_.size() && !boundaryAt_[at].empty() ? &boundaryAt_[at] : nullptr;
    const int size = static_cast<int>(drawnAt ? drawnAt->size() - 1 : whole.count);
    first = std::clamp(first, 0, size);
    count = std::clamp(count, 0, size);
    const auto drawEdges = [&](int from, int to) {
        const auto segment = [drawnAt](int k) -> std::size_t {
            const auto edge = static_cast<std::size_t>(k);
            return drawnAt ? (*drawnAt)[edge] : edge;
        };
        drawSegments({whole.first + segment(from), segment(to) - segment(from)});
    };
    const int before = std::min(count, size - first);
    drawEdges(first, first + before);
    drawEdges(0, count - before);
}

void GpuGlyphs::upload(const StrainGlyphs& glyphs) {
    uploadVertices(glyphs.vertices, kGlyphAttributes);
}

}  // namespace toile::app
