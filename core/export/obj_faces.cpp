// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/obj_faces.h"

#include <algorithm>
#include <charconv>
#include <span>

#include "core/geometry/buckets.h"

namespace toile {
namespace {

constexpr int kNoPiece = -1;
/// A face with more corners is written as its triangles: comparing it costs the square of them.
constexpr std::size_t kMaxCorners = 2000;

struct PieceTriangle {
    int piece, triangle;
};

/// The triangles of a file by their face, after those without a face.
geometry::Buckets<PieceTriangle> trianglesByFace(const Garment& garment, int file, int faceCount) {
    return {faceCount + 1, [&garment, file](auto add) {
                for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
                    const Piece& piece = *garment.pieces[p];
                    for (std::size_t t = 0; piece.file == file && t < piece.sourceFace.size();
                         ++t) {
                        add(std::max(piece.sourceFace[t], -1) + 1,
                            PieceTriangle{static_cast<int>(p), static_cast<int>(t)});
                    }
                }
            }};
}

/// The vertex of these triangles of one piece that represents a position of the file, or -1.
int vertexFor(const Piece& piece, std::span<const PieceTriangle> triangles, int position) {
    for (const PieceTriangle& t : triangles) {
        for (int k = 0; k < 3; ++k) {
            const int vertex = piece.mesh.F(t.triangle, k);
            if (piece.sourceVertex[vertex] == position) {
                return vertex;
            }
        }
    }
    return -1;
}

class FaceWriter {
public:
    FaceWriter(std::string& out, const Garment& garment, int file, const ObjIndices& indices)
        : out_(out), garment_(garment), indices_(indices), file_(file) {}

    /// Writes a face of the input.
    void face(std::span<const int> corners, std::span<const PieceTriangle> triangles) {
        if (triangles.empty()) {
            enter(kNoPiece);
            out_ += 'f';
            for (const int corner : corners) {
                integer(' ', indices_.firstVertex[file_] + corner);
            }
            out_ += '\n';
            return;
        }
        if (!isWhole(corners, triangles)) {
            for (const PieceTriangle& t : triangles) {
                triangle(t);
            }
            ++changes_.divided;
            return;
        }
        const int p = triangles.front().piece;
        const bool turned = isTurned(corners, triangles.front());
        enter(p);
        out_ += 'f';
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const int corner = corners[turned ? corners.size() - 1 - k : k];
            vertex(p, vertexFor(*garment_.pieces[p], triangles, corner));
        }
        out_ += '\n';
        changes_.turned += turned ? 1 : 0;
    }

    const FaceChanges& changes() const { return changes_; }

    void triangle(const PieceTriangle& t) {
        enter(t.piece);
        out_ += 'f';
        for (int k = 0; k < 3; ++k) {
            vertex(t.piece, garment_.pieces[t.piece]->mesh.F(t.triangle, k));
        }
        out_ += '\n';
    }

private:
    /// Whether the triangles still divide the polygon: they are in one piece, on its corners only,
    /// and every corner is one vertex.
    bool isWhole(std::span<const int> corners, std::span<const PieceTriangle> triangles) const {
        const int p = triangles.front().piece;
        const Piece& piece = *garment_.pieces[p];
        if (corners.size() > kMaxCorners || triangles.size() + 2 != corners.size()) {
            return false;  // too many, or repair removed or divided a triangle
        }
        for (const PieceTriangle& t : triangles) {
            if (t.piece != p) {
                return false;
            }
            for (int k = 0; k < 3; ++k) {
                const int v = piece.mesh.F(t.triangle, k);
                const int position = piece.sourceVertex[v];
                if (std::find(corners.begin(), corners.end(), position) == corners.end() ||
                    vertexFor(piece, triangles, position) != v) {
                    return false;
                }
            }
        }
        for (const int corner : corners) {
            if (vertexFor(piece, triangles, corner) < 0) {
                return false;
            }
        }
        return true;
    }

    /// Whether a triangle has the opposite winding of its polygon.
    bool isTurned(std::span<const int> corners, const PieceTriangle& t) const {
        const Piece& piece = *garment_.pieces[t.piece];
        std::ptrdiff_t place[3];
        for (int k = 0; k < 3; ++k) {
            const int position = piece.sourceVertex[piece.mesh.F(t.triangle, k)];
            place[k] = std::find(corners.begin(), corners.end(), position) - corners.begin();
        }
        // Along the polygon the places increase, except for one step back to the start.
        const int rises = (place[0] < place[1]) + (place[1] < place[2]) + (place[2] < place[0]);
        return rises == 1;
    }

    void enter(int piece) {
        if (piece != current_ || first_) {
            out_ += "g ";
            out_ += piece == kNoPiece ? kUnassignedGroup : indices_.group[piece];
            out_ += '\n';
        }
        current_ = piece;
        first_ = false;
    }

    void vertex(int p, int v) {
        const int position = garment_.pieces[p]->sourceVertex[v];
        integer(' ', position >= 0 ? indices_.firstVertex[file_] + position
                                   : indices_.addedVertex[p][v]);
        if (indices_.firstUv[p] > 0) {
            integer('/', indices_.firstUv[p] + v);
        }
    }

    void integer(char before, int value) {
        char digits[12];
        const auto end = std::to_chars(digits, digits + sizeof digits, value);
        out_ += before;
        out_.append(digits, end.ptr);
    }

    std::string& out_;
    const Garment& garment_;
    const ObjIndices& indices_;
    int file_;
    FaceChanges changes_;
    int current_ = kNoPiece;
    bool first_ = true;  // the first face of a file always gets its `g`
};

}  // namespace

FaceChanges appendFaces(std::string& out, const Garment& garment, int file,
                        const ObjIndices& indices) {
    const PolygonSoup& soup = *garment.files[file]->soup;
    const geometry::Buckets<PieceTriangle> triangles =
        trianglesByFace(garment, file, soup.faceCount());
    FaceWriter writer(out, garment, file, indices);
    for (int face = 0; face < soup.faceCount(); ++face) {
        const std::span corners(soup.corners.data() + soup.faceStart[face],
                                static_cast<std::size_t>(soup.cornerCount(face)));
        writer.face(corners, triangles[face + 1]);
    }
    for (const PieceTriangle& added : triangles[0]) {
        writer.triangle(added);
    }
    return writer.changes();
}

}  // namespace toile
