// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/cross_painter.h"

#include <cstddef>

#include "app/render/gpu_mesh.h"

namespace toile {

namespace {

/// Logical pixels between crosses, at least; at most half as many again.
constexpr double kLeastSpacing = 25;
/// A stroke leaves this much of the way to its neighbour free.
constexpr double kStrokeShare = 0.88;

constexpr VertexAttribute kCrossAttributes[] = {
    {0, 3, offsetof(CrossVertex, position)},  {1, 2, offsetof(CrossVertex, flat)},
    {2, 2, offsetof(CrossVertex, flatAlong)}, {3, 3, offsetof(CrossVertex, along)},
    {4, 3, offsetof(CrossVertex, across)},    {5, 2, offsetof(CrossVertex, strain)},
    {6, 1, offsetof(CrossVertex, piece)},
};

}  // namespace

CrossPainter::CrossPainter(FrameCounts& counts) : counts_(counts) {}

CrossPainter::~CrossPainter() = default;

bool CrossPainter::initialize(const std::vector<std::string_view>& files, QString& problem) {
    program_ = loadProgram(files, problem);
    return program_ != nullptr;
}

void CrossPainter::upload(const StretchCrosses& crosses) {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &vertices_);
    vertices_ =
        makeVertexBuffer(crosses.vertices.data(), crosses.vertices.size() * sizeof(CrossVertex));
    counts_.uploadedBytes += crosses.vertices.size() * sizeof(CrossVertex);
    array_ = makeVertexArray(vertices_, sizeof(CrossVertex), kCrossAttributes);
}

ShaderProgram& CrossPainter::begin() {
    program_->bind();
    return *program_;
}

void CrossPainter::draw(const StretchCrosses& crosses, double millimetresPerPixel) {
    const CrossRun run = crossesAt(crosses, kLeastSpacing * millimetresPerPixel);
    if (run.count == 0) {
        return;
    }
    program_->setUniformValue("halfLength", static_cast<float>(kStrokeShare * run.spacing / 2));
    glBindVertexArray(array_);
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(run.count));
    ++counts_.drawCalls;
    glBindVertexArray(0);
}

void CrossPainter::release() {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &vertices_);
    array_ = vertices_ = 0;
    program_.reset();
}

}  // namespace toile
