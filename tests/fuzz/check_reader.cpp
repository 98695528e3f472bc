// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/check_reader.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/assemble/divide.h"
#include "core/assemble/slits.h"
#include "core/io/triangulate.h"
#include "tests/core/io/soup_promises.h"

namespace toile::fuzz {
namespace {

/// True where every index is one of `count` entries.
template <class Indices>
bool inRange(const Indices& indices, int least, Eigen::Index count) {
    return std::all_of(indices.data(), indices.data() + indices.size(),
                       [=](int index) { return index >= least && index < count; });
}

std::string brokenByError(const Error& error) {
    const bool expected =
        error.code == ErrorCode::MalformedFile || error.code == ErrorCode::NoGeometry;
    if (!expected || error.subject.name.empty() || error.detail.empty()) {
        return "refused without a proper reason: " + sentence(error);
    }
    return "";
}

std::string brokenByTriangles(const PolygonSoup& soup) {
    const Triangulation triangles = triangulate(soup, "fuzz");
    if (triangles.F.rows() != static_cast<Eigen::Index>(triangles.sourceFace.size()) ||
        !inRange(triangles.sourceFace, 0, soup.faceCount()) ||
        !inRange(triangles.F, 0, static_cast<Eigen::Index>(soup.positions.size()))) {
        return "a triangle's indices are out of range";
    }
    return "";
}

std::string brokenByDivision(const SourceFile& file, const DivideOptions& options) {
    DividedFile divided = divide(file, 0, "", options);
    for (const bool areShut : {false, true}) {
        if (areShut) {
            closeSlits(divided.pieces);
        }
        for (const auto& piece : divided.pieces) {
            std::string broken = whatBreaksIn(*piece, *file.soup);
            if (!broken.empty()) {
                return broken;
            }
        }
    }
    return "";
}

}  // namespace

std::string whatBreaksIn(const Piece& piece, const PolygonSoup& soup) {
    if (static_cast<Eigen::Index>(piece.sourceVertex.size()) != piece.mesh.V.rows() ||
        static_cast<Eigen::Index>(piece.sourceFace.size()) != piece.mesh.F.rows()) {
        return "a piece does not say where each vertex and face comes from";
    }
    if (!inRange(piece.mesh.F, 0, piece.mesh.V.rows()) ||
        !inRange(piece.sourceVertex, -1, static_cast<Eigen::Index>(soup.positions.size())) ||
        !inRange(piece.sourceFace, -1, soup.faceCount())) {
        return "a piece's indices are out of range";
    }
    if (!piece.defect && piece.boundary.size() < 3) {
        return "a piece without defect has no boundary";
    }
    return piece.defect && sentence(*piece.defect).empty() ? "a defect without words" : "";
}

std::string whatBreaks(ReadFunction reader, std::string bytes) {
    if (bytes.size() > kMaxBytes) {
        return "";
    }
    Progress progress;
    Result<PolygonSoup> soup =
        reader(std::make_shared<const std::string>(std::move(bytes)), "fuzz", progress);
    if (!soup) {
        return brokenByError(soup.error());
    }
    if (std::string broken = test::brokenPromise(*soup); !broken.empty()) {
        return broken;
    }
    if (soup->faceCount() > kMaxFaces) {
        return "";
    }
    if (std::string broken = brokenByTriangles(*soup); !broken.empty()) {
        return broken;
    }
    SourceFile file;
    file.path = "fuzz";
    file.soup = std::make_shared<const PolygonSoup>(std::move(*soup));
    std::vector<DivideOptions> ways = {{}, {SplitMode::Components, false}};
    if (!file.soup->uvs.empty()) {
        ways.push_back({SplitMode::Uv, true});
    }
    if (!file.soup->materials.empty()) {
        ways.push_back({SplitMode::Materials, true});
    }
    for (const DivideOptions& way : ways) {
        if (std::string broken = brokenByDivision(file, way); !broken.empty()) {
            return broken;
        }
    }
    return "";
}

}  // namespace toile::fuzz
