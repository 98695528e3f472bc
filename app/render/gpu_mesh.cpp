// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/gpu_mesh.h"

namespace toile {

GLuint makeVertexBuffer(Gl& gl, const void* data, std::size_t bytes) {
    GLuint buffer = 0;
    gl.glGenBuffers(1, &buffer);
    gl.glBindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
    return buffer;
}

GLuint makeVertexArray(Gl& gl, GLuint buffer, std::size_t stride,
                       std::span<const VertexAttribute> attributes) {
    GLuint array = 0;
    gl.glGenVertexArrays(1, &array);
    gl.glBindVertexArray(array);
    gl.glBindBuffer(GL_ARRAY_BUFFER, buffer);
    for (const VertexAttribute& attribute : attributes) {
        gl.glEnableVertexAttribArray(attribute.location);
        gl.glVertexAttribPointer(attribute.location, attribute.size, GL_FLOAT, GL_FALSE,
                                 static_cast<GLsizei>(stride),
                                 reinterpret_cast<const void*>(attribute.offset));
    }
    gl.glBindVertexArray(0);
    gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
    return array;
}

void GpuMesh::uploadVertices(Gl& gl, const void* data, std::size_t count, std::size_t stride,
                             std::span<const VertexAttribute> attributes) {
    release(gl);
    ++uploads_;
    vertices_ = makeVertexBuffer(gl, data, count * stride);
    array_ = makeVertexArray(gl, vertices_, stride, attributes);
    counts_.uploadedBytes += count * stride;
}

void GpuMesh::uploadIndices(Gl& gl, const IndexLists& lists) {
    std::size_t total = 0;
    for (std::size_t i = 0; i < lists.size(); ++i) {
        runs_[i] = {total, static_cast<GLsizei>(lists[i].size())};
        total += lists[i].size_bytes();
    }
    gl.glGenBuffers(1, &indices_);
    gl.glBindVertexArray(array_);
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);  // stays with the vertex array
    gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr,
                    GL_STATIC_DRAW);
    for (std::size_t i = 0; i < lists.size(); ++i) {
        gl.glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(runs_[i].offset),
                           static_cast<GLsizeiptr>(lists[i].size_bytes()), lists[i].data());
    }
    gl.glBindVertexArray(0);
    counts_.uploadedBytes += total;
}

void GpuMesh::draw(Gl& gl, GLenum mode, std::size_t list) const {
    if (array_ == 0 || runs_[list].count == 0) {
        return;
    }
    gl.glBindVertexArray(array_);
    gl.glDrawElements(mode, runs_[list].count, GL_UNSIGNED_INT,
                      reinterpret_cast<const void*>(runs_[list].offset));
    gl.glBindVertexArray(0);
    ++counts_.drawCalls;
}

void GpuMesh::release(Gl& gl) {
    gl.glDeleteVertexArrays(1, &array_);
    gl.glDeleteBuffers(1, &vertices_);
    gl.glDeleteBuffers(1, &indices_);
    array_ = vertices_ = indices_ = 0;
    runs_ = {};
}

}  // namespace toile
