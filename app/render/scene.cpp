// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene.h"

namespace toile {

namespace {

template <class Value>
std::size_t bytesOf(const std::vector<Value>& values) {
    return values.capacity() * sizeof(Value);
}

template <class Vertex>
std::size_t bytesOf(const MeshBuffers<Vertex>& mesh) {
    return bytesOf(mesh.vertices) + bytesOf(mesh.triangles) + bytesOf(mesh.edges) +
           bytesOf(mesh.outline);
}

template <class Vertex>
std::size_t bytesOf(const LineBuffers<Vertex>& lines) {
    return bytesOf(lines.vertices) + bytesOf(lines.runs.seams) + bytesOf(lines.runs.designer) +
           bytesOf(lines.runs.outlines);
}

}  // namespace

std::size_t bytesOf(const Scene& scene) {
    std::size_t bytes = sizeof(Scene) + bytesOf(scene.garment) + bytesOf(scene.pattern) +
                        bytesOf(scene.garmentLines) + bytesOf(scene.patternLines) +
                        bytesOf(scene.faces) + bytesOf(scene.crosses.vertices) +
                        bytesOf(scene.pieces) + bytesOf(scene.seams);
    for (const PieceScene& piece : scene.pieces) {
        bytes += piece.garmentTree.bytes() + piece.patternTree.bytes() + bytesOf(piece.corners);
    }
    return bytes;
}

}  // namespace toile
