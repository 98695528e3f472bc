// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/face_table.h"

#include <algorithm>

namespace toile {

namespace {

constexpr std::size_t kFacesPerRow = kFaceTableWidth / 2;
static_assert(sizeof(FaceValues) == sizeof(float[2][4]));

}  // namespace

std::vector<FaceValues> garmentFaces(const Scene& scene) {
    std::vector<FaceValues> faces(scene.garment.triangles.size() / 3, FaceValues{});
    for (const PieceScene& piece : scene.pieces) {
        const auto from = scene.faces.begin() + piece.patternRun.first;
        std::copy_n(from, piece.patternRun.count, faces.begin() + piece.garmentRun.first);
    }
    return faces;
}

bool FaceTable::upload(std::span<const FaceValues> faces) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::size_t rows =
        std::max<std::size_t>(1, (faces.size() + kFacesPerRow - 1) / kFacesPerRow);
    if (rows > static_cast<std::size_t>(most)) {
        return false;
    }
    if (texture_ == 0) {
        glGenTextures(1, &texture_);
    }
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kFaceTableWidth, static_cast<GLsizei>(rows), 0,
                 GL_RGBA, GL_FLOAT, nullptr);
    const std::size_t whole = faces.size() / kFacesPerRow, rest = faces.size() % kFacesPerRow;
    if (whole > 0) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kFaceTableWidth, static_cast<GLsizei>(whole),
                        GL_RGBA, GL_FLOAT, faces.data());
    }
    if (rest > 0) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(whole),
                        static_cast<GLsizei>(2 * rest), 1, GL_RGBA, GL_FLOAT,
                        faces.data() + whole * kFacesPerRow);
    }
    counts_.uploadedBytes += faces.size_bytes();
    return true;
}

void FaceTable::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_);
}

void FaceTable::release() {
    glDeleteTextures(1, &texture_);
    texture_ = 0;
}

}  // namespace toile
