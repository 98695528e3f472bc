// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/soup_of_arrays.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/content_hash.h"
#include "core/base/text.h"
#include "core/io/soup_builder.h"

namespace toile {
namespace {

/// Names face by face, like a file with a line for each change.
class ArrayFaceNames {
public:
    ArrayFaceNames(const ArrayNames& given, std::vector<std::string>& names,
                   std::vector<int>& perFace)
        : given_(given), taken_(names, perFace) {}

    /// Sets the name of a face, before it is added as number `faceCount`.
    void change(std::size_t face, int faceCount) {
        const int index = given_.ofFace.empty() ? -1 : given_.ofFace[face];
        if (index != current_) {
            const auto at = static_cast<std::size_t>(index);
            taken_.change(index >= 0 && at < given_.names.size() ? given_.names[at] : "",
                          faceCount);
            current_ = index;
        }
    }
    void addFace() { taken_.addFace(); }

private:
    const ArrayNames& given_;
    io::FaceNames taken_;
    int current_ = -1;
};

/// Writes the positions as text, as in a file.
void giveText(PolygonSoup& soup, int decimals) {
    auto text = std::make_shared<std::string>();
    for (const Eigen::Vector3d& position : soup.positions) {
        TextSpan span{text->size(), 0};
        if (position.allFinite()) {
            for (int axis = 0; axis < 3; ++axis) {
                *text += axis == 0 ? "" : " ";
                appendFixed(*text, position[axis], decimals);
            }
            span.length = static_cast<std::uint32_t>(text->size() - span.offset);
        }
        soup.positionText.push_back(span);
    }
    soup.text = std::move(text);
}

template <class Number>
std::string_view bytesOf(std::span<const Number> numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

/// Identifies a mesh, like the hash of a file's bytes.
std::uint64_t hashOfArrays(const MeshInArrays& mesh) {
    const std::array hashes{
        contentHash(bytesOf(mesh.positions)),     contentHash(bytesOf(mesh.uvs)),
        contentHash(bytesOf(mesh.faceStart)),     contentHash(bytesOf(mesh.corners)),
        contentHash(bytesOf(mesh.cornerUvs)),     contentHash(bytesOf(mesh.objects.ofFace)),
        contentHash(bytesOf(mesh.groups.ofFace)), contentHash(bytesOf(mesh.materials.ofFace))};
    return contentHash(bytesOf(std::span<const std::uint64_t>(hashes)));
}

}  // namespace

Result<PolygonSoup> soupOfArrays(const MeshInArrays& mesh, const std::string& name) {
    io::SoupBuilder builder(name, "row");
    PolygonSoup& soup = builder.soup();
    soup.positions.reserve(mesh.positions.size() / 3);
    for (std::size_t k = 0; k + 2 < mesh.positions.size(); k += 3) {
        builder.addPosition({mesh.positions[k], mesh.positions[k + 1], mesh.positions[k + 2]},
                            static_cast<int>(k / 3));
    }
    for (std::size_t k = 0; k + 1 < mesh.uvs.size(); k += 2) {
        soup.uvs.emplace_back(mesh.uvs[k], mesh.uvs[k + 1]);
    }
    ArrayFaceNames objects(mesh.objects, soup.objects, soup.faceObject);
    ArrayFaceNames groups(mesh.groups, soup.groups, soup.faceGroup);
    ArrayFaceNames materials(mesh.materials, soup.materials, soup.faceMaterial);
    const std::array<ArrayFaceNames*, 3> kinds{&objects, &groups, &materials};
    for (std::size_t face = 0; face + 1 < mesh.faceStart.size(); ++face) {
        for (ArrayFaceNames* kind : kinds) {
            kind->change(face, soup.faceCount());
        }
        for (int c = mesh.faceStart[face]; c < mesh.faceStart[face + 1]; ++c) {
            const auto corner = static_cast<std::size_t>(c);
            soup.corners.push_back(mesh.corners[corner]);
            if (!mesh.cornerUvs.empty()) {
                const int uv = mesh.cornerUvs[corner];
                soup.cornerUvs.push_back(uv < io::kNoUv ? io::kNoSuchUv : uv);
            }
        }
        if (builder.endFace(static_cast<int>(face))) {
            for (ArrayFaceNames* kind : kinds) {
                kind->addFace();
            }
        }
    }
    if (mesh.decimals >= 0) {
        giveText(soup, mesh.decimals);
    }
    Result<PolygonSoup> made = builder.finish();
    if (made) {
        made->contentHash = hashOfArrays(mesh);
    }
    return made;
}

}  // namespace toile
