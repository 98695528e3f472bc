// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/check_patterns.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/formats/read_pattern.h"
#include "core/formats/tables/pattern_match.h"
#include "core/geometry/polygon.h"
#include "tests/core/readers/mesh_file.h"
#include "tests/core/readers/pdf_reader.h"
#include "tests/core/readers/plt_reader.h"

namespace toile::fuzz {
namespace {

constexpr std::size_t kMaxPatternBytes = 16 * 1024;
/// Beyond, lines are not compared: a fuzzer wants many runs.
constexpr Eigen::Index kMaxComparedPoints = 500;
constexpr auto kPatternName = "fuzz";

/// All that a reader found, one after the other: equal where two readings are.
class Seen {
public:
    void add(double number) {
        isFinite_ = isFinite_ && std::isfinite(number);
        appendShortest(all_, number);
        all_ += ' ';
    }
    void add(const std::string& text) { all_ += text + '\n'; }
    template <class Derived>
    void add(const Eigen::MatrixBase<Derived>& numbers) {
        add(static_cast<double>(numbers.rows()));
        for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
            for (Eigen::Index column = 0; column < numbers.cols(); ++column) {
                add(static_cast<double>(numbers(row, column)));
            }
        }
    }
    template <class Value>
    void add(const std::optional<Value>& value) {
        add(value ? 1.0 : 0.0);
        if (value) {
            add(*value);
        }
    }
    void add(const FileChord& chord) {
        add(chord[0]);
        add(chord[1]);
    }
    void add(const FilePiece& piece) {
        for (const std::string* text : {&piece.id, &piece.name, &piece.size, &piece.material,
                                        &piece.category, &piece.annotation}) {
            add(*text);
        }
        add(static_cast<double>(piece.quantity));
        add(static_cast<double>(piece.mirroredQuantity));
        add(piece.cut);
        add(piece.sew);
        for (const Points2& hole : piece.holes) {
            add(hole);
        }
        for (const FileLine& line : piece.internals) {
            add(line.points);
        }
        for (const FileNotch& notch : piece.notches) {
            add(notch.point);
            add(notch.angle);
            add(notch.depth);
        }
        for (const FileDrill& drill : piece.drills) {
            add(drill.point);
            add(drill.diameter);
        }
        add(piece.grain);
        add(piece.fold);
        for (const Points2* outline : {&piece.cut, &piece.sew}) {
            add(geometry::perimeterOf(*outline));
            add(geometry::signedAreaOf(*outline));
        }
    }
    void add(const PatternFile& file) {
        for (const Wording* text : {&file.format, &file.unitReason}) {
            add(*text);
        }
        add(millimetresPer(file.unit));
        add(file.style);
        add(file.sampleSize);
        for (const std::string& size : file.sizes) {
            add(size);
        }
        for (const FilePiece& piece : file.pieces) {
            add(piece);
        }
        for (const Wording& note : file.notes) {
            add(note);
        }
    }
    void add(const ReadLine& line) {
        add(line.id);
        add(line.points);
    }
    void add(const ReadPdf& pdf) {
        for (const auto* names : {&pdf.layers, &pdf.hiddenLayers}) {
            for (const std::string& name : *names) {
                add(name);
            }
        }
        for (const ReadPdfPage& page : pdf.pages) {
            add(page.size);
            for (const ReadPdfView& view : page.views) {
                add(view.matrix);
                add(view.clip.isEmpty() ? Eigen::Vector2d(0, 0) : view.clip.min());
                add(view.clip.isEmpty() ? Eigen::Vector2d(0, 0) : view.clip.max());
            }
            for (const ReadLine& line : page.lines) {
                add(line);
            }
        }
        for (const ReadLine& line : pdf.drawing.lines) {
            add(line);
        }
    }
    void add(const std::vector<PltLine>& lines) {
        for (const PltLine& line : lines) {
            add(static_cast<double>(line.pen));
            add(line.points);
        }
    }
    void add(const MeshFile& file) {
        for (const auto* meshes : {&file.meshes, &file.flat}) {
            for (const FileMesh& mesh : *meshes) {
                add(mesh.name);
                add(mesh.V);
                add(mesh.F);
                add(mesh.uv);
            }
        }
        for (const FileSeam& seam : file.seams) {
            add(seam.name);
            for (std::size_t k = 0; k < 2; ++k) {
                add(seam.mesh[k]);
                for (const int vertex : seam.vertices[k]) {
                    add(static_cast<double>(vertex));
                }
            }
        }
    }

    bool isFinite() const { return isFinite_; }
    bool operator==(const Seen& other) const { return all_ == other.all_; }

private:
    std::string all_;
    bool isFinite_ = true;
};

/// @param isNamed  whether a refusal names the file
template <class Value, class Again>
std::string brokenByReading(const Result<Value>& read, const Again& again, bool isNamed) {
    if (!read) {
        const Error& error = read.error();
        const bool expected =
            error.code == ErrorCode::MalformedFile || error.code == ErrorCode::NoGeometry;
        return expected && !error.detail.empty() && error.subject.name.empty() != isNamed
                   ? ""
                   : "refused without a proper reason: " + sentence(error);
    }
    Seen seen, seenAgain;
    seen.add(*read);
    if (!seen.isFinite()) {
        return "a number is not finite";
    }
    const Result<Value> second = again();
    if (second) {
        seenAgain.add(*second);
    }
    return second && seen == seenAgain ? "" : "a second reading is another";
}

Pattern twoPieces() {
    Pattern pattern;
    for (const double width : {200.0, 350.0}) {
        PatternPiece& piece = pattern.pieces.emplace_back();
        piece.name = piece.slug = pattern.pieces.size() == 1 ? "front" : "back";
        piece.outline.resize(5, 2);
        piece.outline << 0, 0, width, 0, width, 400, width / 3, 420, 0, 300;
    }
    return pattern;
}

std::string brokenByMatch(const PatternFile& file) {
    for (const FilePiece& piece : file.pieces) {
        if (piece.cut.rows() + piece.sew.rows() > kMaxComparedPoints) {
            return "";
        }
    }
    static const Pattern ours = twoPieces();
    const PatternMatch match = matchPatterns(ours, file);
    const auto isPiece = [&file](int k) {
        return k >= 0 && k < static_cast<int>(file.pieces.size());
    };
    if (!std::ranges::all_of(match.aloneInFile, isPiece)) {
        return "a piece without partner is out of range";
    }
    for (const PieceMatch& pair : match.pairs) {
        if (pair.piece < 0 || pair.piece > 1 || !isPiece(pair.filePiece) ||
            !std::ranges::all_of(pair.rivals, isPiece)) {
            return "a pair is out of range";
        }
        for (const LineMatch& line : pair.lines) {
            if (!line.fit.laid.allFinite() || !std::isfinite(line.fit.mean) ||
                !std::isfinite(line.fit.farthest)) {
                return "a line is laid nowhere";
            }
        }
    }
    return "";
}

std::string whatBreaksInPattern(const std::string& bytes, PatternFileKind kind) {
    if (bytes.size() > kMaxPatternBytes) {
        return "";
    }
    const auto read = [&] { return readPattern(bytes, kind, kPatternName); };
    const Result<PatternFile> file = read();
    std::string broken = brokenByReading(file, read, true);
    if (!broken.empty() || !file) {
        return broken;
    }
    for (const FilePiece& piece : file->pieces) {
        if (outlineOf(piece).rows() < 3) {
            return "a piece without outline";
        }
    }
    return file->pieces.empty() ? "a pattern without pieces" : brokenByMatch(*file);
}

/// By a reader of our own files.
template <class Read>
std::string whatBreaksReadBack(const std::string& bytes, const Read& reader) {
    const auto read = [&] { return reader(bytes); };
    return bytes.size() > kMaxPatternBytes ? "" : brokenByReading(read(), read, false);
}

std::string brokenByIndices(const Result<MeshFile>& file) {
    if (!file) {
        return "";
    }
    for (const auto* meshes : {&file->meshes, &file->flat}) {
        for (const FileMesh& mesh : *meshes) {
            const auto count = static_cast<int>(mesh.V.rows());
            if ((mesh.F.array() < 0).any() || (mesh.F.array() >= count).any() ||
                (mesh.uv.rows() != 0 && mesh.uv.rows() != mesh.V.rows())) {
                return "a mesh's indices are out of range";
            }
        }
    }
    for (const FileSeam& seam : file->seams) {
        for (std::size_t k = 0; k < 2; ++k) {
            const bool isThere = std::ranges::any_of(file->meshes, [&](const FileMesh& mesh) {
                return mesh.name == seam.mesh[k] &&
                       std::ranges::all_of(seam.vertices[k], [&mesh](int vertex) {
                           return vertex >= 0 && vertex < mesh.V.rows();
                       });
            });
            if (!isThere) {
                return "a seam is of no mesh, or out of its range";
            }
        }
    }
    return "";
}

}  // namespace

std::string whatBreaksInDxf(std::string bytes) {
    return whatBreaksInPattern(bytes, PatternFileKind::Dxf);
}

std::string whatBreaksInSvg(std::string bytes) {
    return whatBreaksInPattern(bytes, PatternFileKind::Svg);
}

std::string whatBreaksInGarmentCode(std::string bytes) {
    return whatBreaksInPattern(bytes, PatternFileKind::GarmentCode);
}

std::string whatBreaksInPdf(std::string bytes) {
    return whatBreaksReadBack(bytes, readPdf);
}

std::string whatBreaksInPlt(std::string bytes) {
    return whatBreaksReadBack(bytes, readPlt);
}

std::string whatBreaksInGlb(std::string bytes) {
    std::string broken = whatBreaksReadBack(bytes, readGlb);
    return broken.empty() ? brokenByIndices(readGlb(bytes)) : broken;
}

std::string whatBreaksInUsda(std::string bytes) {
    std::string broken = whatBreaksReadBack(bytes, readUsda);
    return broken.empty() ? brokenByIndices(readUsda(bytes)) : broken;
}

}  // namespace toile::fuzz
