// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gpu_mesh.h"

namespace toile {

GLuint makeVertexBuffer(const void* data, std::size_t bytes) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return buffer;
}

GLuint makeVertexArray(GLuint buffer, std::size_t stride,
                       std::span<const VertexAttribute> attributes) {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    for (const VertexAttribute& attribute : attributes) {
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.size, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(stride), bufferOffset(attribute.offset));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return array;
}

void GpuMesh::uploadVertices(const void* data, std::size_t count, std::size_t stride,
                             std::span<const VertexAttribute> attributes) {
    release();
    ++uploads_;
    vertices_ = makeVertexBuffer(data, count * stride);
    array_ = makeVertexArray(vertices_, stride, attributes);
    counts_.uploadedBytes += count * stride;
}

void GpuMesh::uploadIndices(const IndexLists& lists) {
    std::size_t total = 0;
    for (std::size_t i = 0; i < lists.size(); ++i) {
        runs_[i] = {total, static_cast<GLsizei>(lists[i].size())};
        total += lists[i].size_bytes();
    }
    glGenBuffers(1, &indices_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);  // stays with the vertex array
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr, GL_STATIC_DRAW);
    for (std::size_t i = 0; i < lists.size(); ++i) {
        glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(runs_[i].offset),
                        static_cast<GLsizeiptr>(lists[i].size_bytes()), lists[i].data());
    }
    glBindVertexArray(0);
    counts_.uploadedBytes += total;
}

void GpuMesh::draw(GLenum mode, std::size_t list) const {
    if (array_ == 0 || runs_[list].count == 0) {
        return;
    }
    glBindVertexArray(array_);
    glDrawElements(mode, runs_[list].count, GL_UNSIGNED_INT, bufferOffset(runs_[list].offset));
    glBindVertexArray(0);
    ++counts_.drawCalls;
}

void GpuMesh::release() {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &vertices_);
    glDeleteBuffers(1, &indices_);
    array_ = vertices_ = indices_ = 0;
    runs_ = {};
}

}  // namespace toile
