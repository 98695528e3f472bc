// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gpu_lines.h"

#include <algorithm>

namespace toile {

void GpuLines::uploadVertices(const void* data, std::size_t count, std::size_t stride,
                              std::span<const VertexAttribute> attributes) {
    release();
    vertices_ = makeVertexBuffer(data, count * stride);
    array_ = makeVertexArray(vertices_, stride, attributes);
    counts_.uploadedBytes += count * stride;
}

void GpuLines::uploadSegments(const LineRuns& runs) {
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
    const std::size_t designerFirst = indices.size() / 2;
    for (const VertexRun& run : runs.designer) {
        add(run);
    }
    designer_ = rangeSince(designerFirst);
    for (const VertexRun& run : runs.outlines) {
        const std::size_t first = indices.size() / 2;
        add(run);
        outline_.push_back(rangeSince(first));
    }
    const std::size_t bytes = indices.size() * sizeof(std::uint32_t);
    glGenBuffers(1, &indices_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);  // stays with the vertex array
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), indices.data(),
                 GL_STATIC_DRAW);
    glBindVertexArray(0);
    counts_.uploadedBytes += bytes;
}

void GpuLines::drawSeam(int seam) const {
    if (seam >= 0 && seam < static_cast<int>(seam_.size())) {
        draw(seam_[static_cast<std::size_t>(seam)]);
    }
}

void GpuLines::drawOutline(int piece, int first, int count) const {
    if (piece < 0 || piece >= static_cast<int>(outline_.size())) {
        return;
    }
    const Range& whole = outline_[static_cast<std::size_t>(piece)];
    const int size = static_cast<int>(whole.count);
    first = std::clamp(first, 0, size);
    count = std::clamp(count, 0, size);
    const int before = std::min(count, size - first);
    draw({whole.first + static_cast<std::size_t>(first), static_cast<std::size_t>(before)});
    draw({whole.first, static_cast<std::size_t>(count - before)});
}

void GpuLines::draw(const Range& range) const {
    if (array_ == 0 || range.count == 0) {
        return;
    }
    glBindVertexArray(array_);
    glDrawElements(GL_LINES, static_cast<GLsizei>(2 * range.count), GL_UNSIGNED_INT,
                   bufferOffset(2 * range.first * sizeof(std::uint32_t)));
    glBindVertexArray(0);
    ++counts_.drawCalls;
}

void GpuLines::release() {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &vertices_);
    glDeleteBuffers(1, &indices_);
    array_ = vertices_ = indices_ = 0;
    seams_ = designer_ = {};
    seam_.clear();
    outline_.clear();
}

}  // namespace toile
