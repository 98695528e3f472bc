// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gpu_lines.h"

namespace toile {

void GpuLines::uploadVertices(Gl& gl, const void* data, std::size_t count, std::size_t stride,
                              std::span<const VertexAttribute> attributes) {
    release(gl);
    vertices_ = makeVertexBuffer(gl, data, count * stride);
    array_ = makeVertexArray(gl, vertices_, stride, attributes);
}

void GpuLines::draw(Gl& gl, const VertexRun& run) const {
    if (array_ == 0 || run.count < 2) {
        return;
    }
    gl.glBindVertexArray(array_);
    gl.glDrawArrays(GL_LINE_STRIP, static_cast<GLint>(run.first), static_cast<GLsizei>(run.count));
    gl.glBindVertexArray(0);
}

void GpuLines::release(Gl& gl) {
    gl.glDeleteVertexArrays(1, &array_);
    gl.glDeleteBuffers(1, &vertices_);
    array_ = vertices_ = 0;
}

}  // namespace toile
