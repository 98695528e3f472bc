// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/divide.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/unique_names.h"
#include "core/garment/corner_uv.h"
#include "core/io/triangulate.h"
#include "core/mesh/repair.h"
#include "core/mesh/repair_part.h"

namespace toile {
namespace {

/// A UV map whose scale is this close to 1 is in the file's own unit: the draped cloth differs from
/// its flat panel by no more. Any other scale was normalised and is fitted.
constexpr double kExactScaleBand = 0.1;

constexpr const char* kPanel = "panel";

std::string nameOf(const std::vector<int>& ofFace, const std::vector<std::string>& names,
                   int face) {
    return ofFace.empty() || ofFace[face] < 0 ? std::string() : names[ofFace[face]];
}

/// What the file calls the piece that a face belongs to: by the mode's own kind of name, else its
/// object, its group; "panel" where a UV map's islands have no names of their own, else "piece".
std::string nameInFile(const PolygonSoup& soup, SplitMode mode, int face) {
    std::string name;
    if (mode == SplitMode::Materials) {
        name = nameOf(soup.faceMaterial, soup.materials, face);
    } else if (mode == SplitMode::Groups) {
        name = nameOf(soup.faceGroup, soup.groups, face);
    } else if (mode == SplitMode::Uv) {
        // One name over the whole garment says nothing about its panels.
        if (soup.objects.size() > 1) {
            name = nameOf(soup.faceObject, soup.objects, face);
        } else if (soup.groups.size() > 1) {
            name = nameOf(soup.faceGroup, soup.groups, face);
        }
        return name.empty() ? kPanel : name;
    }
    if (name.empty()) {
        name = nameOf(soup.faceObject, soup.objects, face);
    }
    if (name.empty()) {
        name = nameOf(soup.faceGroup, soup.groups, face);
    }
    return name.empty() ? "piece" : name;
}

/// The parts of a division one by one.
class Parts {
public:
    Parts(const SourceFile& file, const Triangulation& triangles, const Division& division)
        : file_(file), triangles_(triangles), division_(division) {
        const std::size_t parts = static_cast<std::size_t>(division.partCount) + 1;
        const std::vector<int>& partOf = division.partOfTriangle;
        std::vector<int> partOfVertex(division.positionOf.size(), 0);
        for (std::size_t t = 0; t < partOf.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                partOfVertex[division.cornerVertex(static_cast<Eigen::Index>(t), k)] = partOf[t];
            }
        }
        members_ = byPart(partOf, parts, memberEnd_);
        vertices_ = byPart(partOfVertex, parts, vertexEnd_);
        local_.resize(partOfVertex.size());
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const int part = partOfVertex[vertices_[i]];
            local_[vertices_[i]] = static_cast<int>(i) - begin(vertexEnd_, part);
        }
    }

    /// The triangles of a part. Vertices are numbered in order of their index in the division, that
    /// is of their position in the file, so that the piece does not depend on the order of corners.
    MeshPart gather(int part) const {
        const double millimetres = millimetresPer(file_.unit);
        MeshPart made;
        const int firstVertex = begin(vertexEnd_, part);
        const int vertexCount = vertexEnd_[part] - firstVertex;
        made.mesh.V.resize(vertexCount, 3);
        made.sourceVertex.resize(static_cast<std::size_t>(vertexCount));
        for (int v = 0; v < vertexCount; ++v) {
            const int position = division_.positionOf[vertices_[firstVertex + v]];
            made.sourceVertex[v] = position;
            made.mesh.V.row(v) = millimetres * withYUp(file_.up, file_.soup->positions[position]);
        }
        const int firstFace = begin(memberEnd_, part);
        const int faceCount = memberEnd_[part] - firstFace;
        made.mesh.F.resize(faceCount, 3);
        made.sourceFace.resize(static_cast<std::size_t>(faceCount));
        for (int f = 0; f < faceCount; ++f) {
            const int member = members_[firstFace + f];
            for (int k = 0; k < 3; ++k) {
                made.mesh.F(f, k) = local_[division_.cornerVertex(member, k)];
            }
            made.sourceFace[f] = triangles_.sourceFace[member];
        }
        return made;
    }

private:
    static int begin(const std::vector<int>& end, int part) { return part > 0 ? end[part - 1] : 0; }

    /// The indices by their part, in ascending order within each. @param end  gets where each ends
    static std::vector<int> byPart(const std::vector<int>& partOf, std::size_t parts,
                                   std::vector<int>& end) {
        end.assign(parts + 1, 0);
        for (const int part : partOf) {
            ++end[part + 1];
        }
        std::partial_sum(end.begin(), end.end(), end.begin());
        std::vector<int> sorted(partOf.size());
        for (std::size_t i = 0; i < partOf.size(); ++i) {
            sorted[end[partOf[i]]++] = static_cast<int>(i);
        }
        return sorted;
    }

    const SourceFile& file_;
    const Triangulation& triangles_;
    const Division& division_;
    std::vector<int> members_, memberEnd_;   ///< triangles
    std::vector<int> vertices_, vertexEnd_;  ///< of the division
    std::vector<int> local_;                 ///< per vertex of the division: its index in its part
};

/// The uv of each vertex of a piece, by its corners' faces; nothing where a corner has none.
std::optional<Points2> flatPanel(const PolygonSoup& soup, const Piece& piece, double scale) {
    CornerUvs uvs(soup);
    Points2 panel = Points2::Constant(piece.mesh.V.rows(), 2, std::nan(""));
    for (int f = 0; f < piece.mesh.F.rows(); ++f) {
        if (piece.sourceFace[f] < 0) {
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const int v = piece.mesh.F(f, k);
            const int uv = uvs.at(piece.sourceFace[f], piece.sourceVertex[v]);
            if (uv >= 0) {
                panel.row(v) = scale * soup.uvs[uv];
            }
        }
    }
    return panel.allFinite() ? std::optional(panel) : std::nullopt;
}

class Divider {
public:
    Divider(const SourceFile& file, int fileIndex, const std::string& namePrefix,
            const DivideOptions& options)
        : file_(file), fileIndex_(fileIndex), prefix_(namePrefix), options_(options) {}

    DividedFile run() {
        Triangulation triangles = triangulate(*file_.soup, file_.path.filename().string());
        divided_.problems = std::move(triangles.problems);
        divided_.split = chooseSplit(options_.split, *file_.soup, triangles);
        const Division division = splitTriangles(divided_.split.mode, *file_.soup, triangles);
        if (divided_.split.mode == SplitMode::Uv) {
            uvScale_ = measureUvScale(*file_.soup, triangles);
            if (uvScale_ && std::abs(uvScale_->ratio - 1) < kExactScaleBand) {
                uvScale_->ratio = 1;
            }
        }
        const Parts parts(file_, triangles, division);
        for (int p = 0; p < division.partCount; ++p) {
            addPieces(parts.gather(p));
        }
        return std::move(divided_);
    }

private:
    /// Adds the piece, or the pieces, that a part of the division becomes.
    void addPieces(MeshPart part) {
        const std::string wanted =
            nameInFile(*file_.soup, divided_.split.mode, part.sourceFace.front());
        std::string name = uniqueName(wanted);
        if (options_.repair) {
            RepairResult mended = repair(std::move(part), RepairOptions{}, prefix_ + name);
            part = std::move(mended.part);
            if (mended.soundTable) {
                add(makeSoundPiece(prefix_ + name, std::move(part.mesh),
                                   *std::move(mended.soundTable)),
                    part);
                return;
            }
            divided_.problems.insert(divided_.problems.end(), mended.repairs.begin(),
                                     mended.repairs.end());
        }
        for (auto& [connected, ignored] : connectedParts(std::move(part))) {
            if (name.empty()) {
                name = uniqueName(wanted);  // the part fell apart: its pieces share the name
            }
            add(makePiece(prefix_ + std::exchange(name, ""), std::move(connected.mesh)), connected);
        }
    }

    /// Panels without a name are numbered from 1: there will be more.
    std::string uniqueName(const std::string& wanted) {
        return wanted == kPanel ? names_.numbered(wanted) : names_.free(wanted);
    }

    /// @param sources  where the piece comes from; gives them away
    void add(Piece made, MeshPart& sources) {
        auto piece = std::make_shared<Piece>(std::move(made));
        piece->file = fileIndex_;
        piece->sourceVertex = std::move(sources.sourceVertex);
        piece->sourceFace = std::move(sources.sourceFace);
        if (uvScale_) {
            piece->reference =
                flatPanel(*file_.soup, *piece, millimetresPer(file_.unit) * uvScale_->ratio);
        }
        divided_.pieces.push_back(std::move(piece));
    }

    const SourceFile& file_;
    const int fileIndex_;
    const std::string& prefix_;
    const DivideOptions& options_;
    std::optional<UvScale> uvScale_;
    UniqueNames names_;
    DividedFile divided_;
};

}  // namespace

DividedFile divide(const SourceFile& file, int fileIndex, const std::string& namePrefix,
                   const DivideOptions& options) {
    return Divider(file, fileIndex, namePrefix, options).run();
}

}  // namespace toile
