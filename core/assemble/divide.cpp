// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/assemble/divide.h"

#include <cmath>
#include <optional>
#include <utility>

#include "core/assemble/corner_uv.h"
#include "core/assemble/split.h"
#include "core/base/text.h"
#include "core/geometry/buckets.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

/// A UV map whose scale is this close to 1 is in the file's own unit: draped cloth differs from its
/// flat panel by no more. Maps of any other scale were normalised and are fitted.
constexpr double kExactScaleBand = 0.1;

constexpr const char* kPanel = "panel";

std::string nameOf(const std::vector<int>& ofFace, const std::vector<std::string>& names,
                   int face) {
    return ofFace.empty() || ofFace[face] < 0 ? std::string() : names[ofFace[face]];
}

/// The file's name for the piece of a face: by the mode's own kind of name, else its object, its
/// group; "panel" if the islands of a UV map have no names of their own, else "piece".
std::string nameInFile(const PolygonSoup& soup, SplitMode mode, int face) {
    std::string name;
    if (mode == SplitMode::Materials) {
        name = nameOf(soup.faceMaterial, soup.materials, face);
    } else if (mode == SplitMode::Groups) {
        name = nameOf(soup.faceGroup, soup.groups, face);
    } else if (mode == SplitMode::Uv) {
        // One name for the whole garment does not distinguish its panels.
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

/// Triangles and vertices of a division by part, ascending in each. Vertices are in order of their
/// position in the file, so that a piece does not depend on the order of corners.
struct Parts {
    geometry::Buckets<> triangles, vertices;
};

Parts partsOf(const Division& division) {
    const std::vector<int>& partOf = division.partOfTriangle;
    const auto byPart = [&division](const std::vector<int>& part) {
        return geometry::Buckets<>(division.partCount, [&part](auto add) {
            for (std::size_t i = 0; i < part.size(); ++i) {
                add(part[i], static_cast<int>(i));
            }
        });
    };
    std::vector<int> partOfVertex(division.positionOf.size(), 0);
    for (Eigen::Index corner = 0; corner < division.cornerVertex.size(); ++corner) {
        partOfVertex[division.cornerVertex.data()[corner]] = partOf[corner / 3];
    }
    return {byPart(partOf), byPart(partOfVertex)};
}

/// @param local  as long as the division's vertices; scratch space
MeshPart gather(const SourceFile& file, const Triangulation& triangles, const Division& division,
                const Parts& parts, int part, std::vector<int>& local) {
    const double millimetres = millimetresPer(file.unit);
    MeshPart made;
    const std::span<const int> vertices = parts.vertices[part];
    made.mesh.V.resize(std::ssize(vertices), 3);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const int position = division.positionOf[vertices[v]];
        local[vertices[v]] = static_cast<int>(v);
        made.sourceVertex.push_back(position);
        made.mesh.V.row(static_cast<Eigen::Index>(v)) =
            millimetres * withYUp(file.up, file.soup->positions[position]);
    }
    made.mesh.F = division.cornerVertex(parts.triangles[part], Eigen::all);
    for (int& v : cornersOf(made.mesh.F)) {
        v = local[v];
    }
    for (const int triangle : parts.triangles[part]) {
        made.sourceFace.push_back(triangles.sourceFace[triangle]);
    }
    return made;
}

/// The uv of each vertex of a piece, by its corners' faces; nothing if a corner has none.
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
        divided_.partCount = division.partCount;
        if (division.partCount > kMaxPiecesOfFile) {
            return std::move(divided_);
        }
        if (divided_.split.mode == SplitMode::Uv) {
            uvScale_ = measureUvScale(*file_.soup, triangles);
            if (uvScale_ && std::abs(uvScale_->ratio - 1) < kExactScaleBand) {
                uvScale_->ratio = 1;
            }
        }
        const Parts parts = partsOf(division);
        std::vector<int> local(division.positionOf.size());
        for (int p = 0; p < division.partCount; ++p) {
            addPieces(gather(file_, triangles, division, parts, p, local));
        }
        return std::move(divided_);
    }

private:
    /// Adds the piece, or the pieces, of one part of the division.
    void addPieces(MeshPart part) {
        const std::string wanted =
            nameInFile(*file_.soup, divided_.split.mode, part.sourceFace.front());
        std::string name = uniqueName(wanted);
        if (options_.repair) {
            RepairResult repaired = repair(std::move(part), prefix_ + name);
            part = std::move(repaired.part);
            if (repaired.validTable) {
                add(makePiece(prefix_ + name, std::move(part.mesh),
                              *std::move(repaired.validTable)),
                    part);
                return;
            }
            divided_.problems.insert(divided_.problems.end(), repaired.repairs.begin(),
                                     repaired.repairs.end());
        }
        for (auto& [connected, ignored] : connectedParts(std::move(part))) {
            if (name.empty()) {
                name = uniqueName(wanted);  // the part was divided: its pieces share the name
            }
            add(makePiece(prefix_ + std::exchange(name, ""), std::move(connected.mesh)), connected);
        }
    }

    /// Panels without a name are numbered from 1 on.
    std::string uniqueName(const std::string& wanted) {
        return wanted == kPanel ? names_.numbered(wanted) : names_.free(wanted);
    }

    /// @param sources  the piece's origin; moved from
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

namespace {

constexpr SplitMode kCandidates[] = {SplitMode::Uv, SplitMode::Objects, SplitMode::Groups,
                                     SplitMode::Materials, SplitMode::Components};

/// Whether the file has the names or the map that the mode needs.
bool isThere(SplitMode mode, const PolygonSoup& soup) {
    switch (mode) {
        case SplitMode::Uv:
            return !soup.cornerUvs.empty();
        case SplitMode::Objects:
            return soup.objects.size() > 1;
        case SplitMode::Groups:
            return soup.groups.size() > 1;
        case SplitMode::Materials:
            return soup.materials.size() > 1;
        default:
            return true;
    }
}

bool isBetter(const DivisionCount& a, const DivisionCount& b) {
    const auto left = static_cast<long long>(a.flat) * b.pieces;
    const auto right = static_cast<long long>(b.flat) * a.pieces;
    return left != right ? left > right : a.pieces < b.pieces;
}

}  // namespace

std::optional<DivisionCount> betterDivision(const PolygonSoup& soup, const DivisionCount& present,
                                            const Progress& progress) {
    const Triangulation triangles = triangulate(soup, {});
    std::optional<DivisionCount> best;
    for (const SplitMode mode : kCandidates) {
        if (progress.isCancelled()) {
            return std::nullopt;
        }
        if (mode == present.mode || !isThere(mode, soup)) {
            continue;
        }
        const Division division = splitTriangles(mode, soup, triangles);
        const DivisionCount count{mode, division.partCount, diskCount(division)};
        if (count.flat > present.flat && isBetter(count, best.value_or(present)) &&
            static_cast<double>(triangles.F.rows()) >= kMinTrianglesPerPart * count.pieces) {
            best = count;
        }
    }
    return best;
}

}  // namespace toile
