// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/mesh/obj_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/formats/json.h"
#include "core/formats/writers.h"
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

namespace {

/// The layers of a drawing that are added to a UV map, with their names there.
constexpr std::array kObjLayers{std::pair(LayerKind::Cut, "pattern_cut"),
                                std::pair(LayerKind::Sew, "pattern_sew"),
                                std::pair(LayerKind::Notches, "pattern_notches"),
                                std::pair(LayerKind::Internal, "pattern_internal")};

void appendPath(std::string& out, const DrawnPath& path, double unit) {
    const Eigen::Index count = path.points.rows();
    for (Eigen::Index k = 0; k < count; ++k) {
        out += "v ";
        appendShortest(out, (path.points(k, 0) - kDrawingMargin) / unit);
        out += ' ';
        appendShortest(out, (path.points(k, 1) - kDrawingMargin) / unit);
        out += " 0\n";
    }
    out += 'l';  // counted back from here
    for (Eigen::Index k = count; k > 0; --k) {
        out += " -" + std::to_string(k);
    }
    out += path.closed ? " -" + std::to_string(count) + "\n" : "\n";
}

}  // namespace

std::string writeObjLines(const Drawing& drawing, double unit) {
    std::string out =
        "# the lines of the pattern, where its UV map lies, in the unit of the mesh\n";
    for (const auto& [layer, name] : kObjLayers) {
        if (!hasLayer(drawing, layer)) {
            continue;
        }
        out += std::string("o ") + name + "\n";
        for (const DrawnPath& path : drawing.paths) {
            if (path.layer == layer) {
                appendPath(out, path, unit);
            }
        }
    }
    return out;
}

}  // namespace toile

// Non-finite coordinates of a position are written as 0, because no reader accepts "nan", and a
// comment states this. No face of a piece uses such a position.

namespace toile {
namespace {

constexpr std::size_t kVertexBytes = 64;  // of a typical line, for reserving memory
constexpr std::size_t kFaceBytes = 48;

/// One word without blanks for a `g` line: readers treat several words as several groups.
std::string groupWord(const std::string& pieceName) {
    std::string word = cleanText(pieceName);
    for (char& c : word) {
        c = c == ' ' ? '_' : c;
    }
    return word.empty() ? "piece" : word;
}

std::vector<std::string> groupNames(const Garment& garment) {
    UniqueNames taken;
    taken.take(kUnassignedGroup);
    std::vector<std::string> names;
    for (const auto& piece : garment.pieces) {
        names.push_back(taken.free(groupWord(piece->name), "_"));
    }
    return names;
}

void appendNumbers(std::string& out, const char* keyword, std::initializer_list<double> values) {
    out += keyword;
    for (const double value : values) {
        out += ' ';
        appendShortest(out, std::isfinite(value) ? value : 0.0);
    }
    out += '\n';
}

/// The file's original text of a position on one line, without a comment.
void appendOwnText(std::string& out, std::string_view text) {
    text = text.substr(0, text.find('#'));
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    const std::size_t end = text.find_last_not_of(" \t\r\n\\");
    out += "v ";
    for (std::size_t i = begin; i != std::string_view::npos && i <= end; ++i) {
        const char c = text[i];
        out += c == '\\' || c == '\r' || c == '\n' ? ' ' : c;  // of a continued line
    }
    out += '\n';
}

/// Appends the `v` lines of a file's own positions; returns the number of those with a 0 for a
/// non-finite number.
int appendPositions(std::string& out, const PolygonSoup& soup) {
    int replaced = 0;
    out.reserve(out.size() + soup.positions.size() * kVertexBytes);
    for (std::size_t i = 0; i < soup.positions.size(); ++i) {
        const Eigen::Vector3d& p = soup.positions[i];
        const bool hasText = i < soup.positionText.size() && soup.positionText[i].length > 0;
        if (hasText && soup.text && p.allFinite()) {
            const TextSpan span = soup.positionText[i];
            appendOwnText(out, std::string_view(*soup.text).substr(span.offset, span.length));
            continue;
        }
        replaced += p.allFinite() ? 0 : 1;
        appendNumbers(out, "v", {p.x(), p.y(), p.z()});
    }
    return replaced;
}

/// Appends a `v` line for each vertex without a position in the file; returns their number.
int appendAddedVertices(std::string& out, const Garment& garment, int file, int nextIndex,
                        ObjIndices& indices) {
    const double unit = millimetresPer(garment.files[file]->unit);
    const UpAxis up = garment.files[file]->up;
    int count = 0;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const Piece& piece = *garment.pieces[p];
        for (std::size_t v = 0; piece.file == file && v < piece.sourceVertex.size(); ++v) {
            if (piece.sourceVertex[v] >= 0) {
                continue;
            }
            const auto row = asInFile(up, piece.mesh.V.row(static_cast<Eigen::Index>(v)));
            appendNumbers(out, "v", {row.x() / unit, row.y() / unit, row.z() / unit});
            indices.addedVertex[p].resize(piece.sourceVertex.size(), 0);
            indices.addedVertex[p][v] = nextIndex + count++;
        }
    }
    return count;
}

void appendUvs(std::string& out, const FlatPiece& flat, const Placement& placement) {
    out.reserve(out.size() + static_cast<std::size_t>(flat.Q.rows()) * kVertexBytes);
    const Eigen::Matrix2d linear = placement.linear();
    for (Eigen::Index v = 0; v < flat.Q.rows(); ++v) {
        const Eigen::Vector2d at = placement.offset + linear * flat.Q.row(v).transpose();
        appendNumbers(out, "vt", {at.x(), at.y()});
    }
}

void comment(std::string& out, const std::string& text) {
    out += "# " + cleanText(text) + "\n";
}

/// Counts of a file, and of its changes.
struct FileNotes {
    int first = 1, vertices = 0, added = 0, replaced = 0;
    FaceChanges faces;
};

void appendFileHead(std::string& out, const SourceFile& file, const FileNotes& notes) {
    std::string line = "v " + std::to_string(notes.first) + " to " +
                       std::to_string(notes.first + notes.vertices - 1) + ": " +
                       pathText(file.path.filename()) + ", in " + unitText(file.unit);
    comment(out, line);
    for (const Error& error : problemsOf(file)) {
        if (changesOutput(error.code)) {
            comment(out, sentence(error));
        }
    }
    if (notes.added > 0) {
        comment(out, "differs from the input: " + counted(notes.added, "vertex") +
                         " added after the file's own");
    }
    if (notes.replaced > 0) {
        comment(out, "differs from the input: " + counted(notes.replaced, "vertex") +
                         " without a finite position written with 0");
    }
    if (notes.faces.divided > 0) {
        comment(out, "differs from the input: " + counted(notes.faces.divided, "face") +
                         " written as the triangles used");
    }
    if (notes.faces.turned > 0) {
        comment(out, "differs from the input: " + counted(notes.faces.turned, "face") +
                         " flipped to agree with the neighbours");
    }
}

}  // namespace

std::string writeObj(const Garment& garment, const PieceResults& results, const Marker& marker) {
    std::vector<Placement> placements(garment.pieces.size());
    for (const PlacedCopy& copy : marker.copies) {
        placements[static_cast<std::size_t>(copy.piece)] = copy.placement;
    }
    ObjIndices indices{groupNames(garment), {}, {}, {}};
    indices.addedVertex.resize(garment.pieces.size());
    std::vector<FileNotes> notes(garment.files.size());
    std::string vertices;
    int next = 1;
    for (std::size_t f = 0; f < garment.files.size(); ++f) {
        const PolygonSoup& soup = *garment.files[f]->soup;
        const int file = static_cast<int>(f), own = static_cast<int>(soup.positions.size());
        indices.firstVertex.push_back(next);
        notes[f].first = next;
        notes[f].vertices = own;
        notes[f].replaced = appendPositions(vertices, soup);
        notes[f].added = appendAddedVertices(vertices, garment, file, next + own, indices);
        next += own + notes[f].added;
    }
    int nextUv = 1;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const bool flat = results[p]->flat.has_value();
        indices.firstUv.push_back(flat ? nextUv : 0);
        if (flat) {
            appendUvs(vertices, *results[p]->flat, placements[p]);
            nextUv += static_cast<int>(results[p]->flat->Q.rows());
        }
    }
    std::string faces;
    for (std::size_t f = 0; f < garment.files.size(); ++f) {
        const SourceFile& file = *garment.files[f];
        faces.reserve(faces.size() + static_cast<std::size_t>(file.soup->faceCount()) * kFaceBytes);
        notes[f].faces = appendFaces(faces, garment, static_cast<int>(f), indices);
    }

    std::string out;
    comment(out, "Toile " + std::string(version()) + ": a garment with its pattern as UV map");
    comment(out, "vt in mm, y up, true scale; g names the piece; faces without vt are not flat");
    comment(out, "Not repeated: normals, materials, and the input's own UV map and groups");
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        if (results[p]->flat && placements[p].mirrored) {
            comment(out, "mirrored, wrong side of the fabric up: " + indices.group[p]);
        }
    }
    for (std::size_t f = 0; f < garment.files.size(); ++f) {
        appendFileHead(out, *garment.files[f], notes[f]);
    }
    out.reserve(out.size() + vertices.size() + faces.size());
    return out.append(vertices).append(faces);
}

}  // namespace toile
