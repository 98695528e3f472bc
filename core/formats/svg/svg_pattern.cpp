// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/characters.h"
#include "core/formats/dxf/dxf_piece.h"
#include "core/formats/read_pattern.h"
#include "core/formats/svg/svg_reader.h"
#include "core/geometry/polygon.h"

namespace toile {
namespace {

constexpr std::string_view kPiecePrefix = "piece-";
constexpr double kMillimetresPerPixel = 25.4 / 96;
constexpr double kClosedNear = 0.01;  // mm, between the ends of a closed line
constexpr double kMinArea = 100;      // mm2: smaller lines are marks
/// An inner line that fills more of a piece than this is its seam line, not a hole.
constexpr double kSeamLineShare = 0.3;
constexpr std::size_t kMaxOuterLines = 2000;  // of a drawing
constexpr double kMaxSvgSteps = 5e8;          // limit on containment tests

bool isClosedLine(const SvgLine& line) {
    const Eigen::Index last = line.points.rows() - 1;
    return last > 1 &&
           (line.closed || (line.points.row(last) - line.points.row(0)).norm() < kClosedNear);
}

/// Anti-clockwise, the first point not repeated.
Points2 closedPoints(const SvgLine& line) {
    Points2 points = line.points;
    Eigen::Index count = points.rows();
    while (count > 3 && points.row(count - 1) == points.row(0)) {
        --count;
    }
    points.conservativeResize(count, 2);
    return geometry::antiClockwise(points);
}

std::string layerText(const SvgLine& line) {
    return readableName(line.layer.empty() ? "-" : line.layer);
}

/// Adds a line that names its piece.
void addLine(const SvgLine& line, FilePiece& piece) {
    const DxfRole role = dxfRole(line.layer);
    const bool isClosed = isClosedLine(line);
    ++piece.layers[layerText(line)];
    if ((role == DxfRole::Cut || role == DxfRole::Sew) && isClosed) {
        Points2 points = closedPoints(line);
        Points2& outline = role == DxfRole::Cut ? piece.cut : piece.sew;
        if (geometry::signedAreaOf(points) > geometry::signedAreaOf(outline)) {
            std::swap(points, outline);
        }
        if (points.rows() > 0) {
            piece.holes.emplace_back(points.colwise().reverse());
        }
    } else if (role == DxfRole::Internal) {
        piece.internals.push_back({line.points, line.closed});
    } else if (role == DxfRole::Notch) {
        piece.notches.push_back({line.points.row(0).transpose()});
    } else if (role == DxfRole::Grain && line.points.rows() > 1 && !piece.grain) {
        piece.grain = FileChord{line.points.row(0).transpose(),
                                line.points.row(line.points.rows() - 1).transpose()};
    }
}

std::vector<FilePiece> namedPieces(const ReadSvg& svg) {
    std::vector<FilePiece> pieces;
    std::map<std::string_view, std::size_t> indices;
    for (const SvgLine& line : svg.lines) {
        if (line.piece.empty() || !line.text.empty() || line.seam || line.points.rows() == 0) {
            continue;
        }
        const auto [found, isNew] = indices.emplace(line.piece, pieces.size());
        if (isNew) {
            FilePiece& piece = pieces.emplace_back();
            piece.id = readableName(line.piece);
            piece.name = piece.id.starts_with(kPiecePrefix) ? piece.id.substr(kPiecePrefix.size())
                                                            : piece.id;
        }
        addLine(line, pieces[found->second]);
    }
    return pieces;
}

std::vector<FilePiece> outerPieces(const ReadSvg& svg) {
    struct Closed {
        Points2 points{};
        const SvgLine* line = nullptr;
        double area = 0;
    };
    std::vector<Closed> closed;
    for (const SvgLine& line : svg.lines) {
        if (isClosedLine(line) && line.text.empty() && line.layer != "check") {
            Points2 points = closedPoints(line);
            const double area = geometry::signedAreaOf(points);
            if (area > kMinArea) {
                closed.push_back({std::move(points), &line, area});
            }
        }
    }
    std::ranges::stable_sort(closed, std::greater{}, &Closed::area);
    std::vector<FilePiece> pieces;
    std::vector<Eigen::AlignedBox2d> boxes;
    double steps = 0;
    for (const Closed& line : closed) {
        const auto box = geometry::boxAround(line.points);
        FilePiece* outer = nullptr;
        bool isThere = false;  // duplicate of a line, as of a fill and its stroke
        for (std::size_t k = 0; k < pieces.size() && steps < kMaxSvgSteps && !outer; ++k) {
            ++steps;
            if (!boxes[k].contains(box)) {
                continue;
            }
            steps += static_cast<double>(pieces[k].cut.rows());
            isThere |= pieces[k].cut.rows() == line.points.rows() && boxes[k].isApprox(box);
            outer = geometry::isInside(pieces[k].cut, line.points.row(0).transpose()) ? &pieces[k]
                                                                                      : nullptr;
        }
        if (isThere) {
            continue;
        }
        if (outer && outer->sew.rows() == 0 &&
            line.area > kSeamLineShare * geometry::signedAreaOf(outer->cut)) {
            outer->sew = line.points;
        } else if (outer) {
            outer->holes.emplace_back(line.points.colwise().reverse());
        } else if (pieces.size() < kMaxOuterLines) {
            FilePiece& piece = pieces.emplace_back();
            piece.cut = line.points;
            piece.id = readableName(line.line->id);
            piece.name = line.line->label.empty() ? piece.id : readableName(line.line->label);
            piece.name = piece.name.empty() ? "piece " + std::to_string(pieces.size()) : piece.name;
            ++piece.layers[layerText(*line.line)];
            boxes.push_back(box);
        }
    }
    std::map<std::string, int> called;
    for (const FilePiece& piece : pieces) {
        ++called[piece.name];
    }
    for (FilePiece& piece : pieces) {  // a label that several have is their group's
        piece.name = called[piece.name] > 1 && !piece.id.empty() ? piece.id : piece.name;
    }
    return pieces;
}

void scale(FilePiece& piece, double factor) {
    piece.cut *= factor;
    piece.sew *= factor;
    for (Points2& hole : piece.holes) {
        hole *= factor;
    }
    for (FileLine& line : piece.internals) {
        line.points *= factor;
    }
    for (FileNotch& notch : piece.notches) {
        notch.point *= factor;
    }
    if (piece.grain) {
        piece.grain = FileChord{factor * (*piece.grain)[0], factor * (*piece.grain)[1]};
    }
}

}  // namespace

Result<PatternFile> readSvgPattern(std::string_view bytes, std::optional<FileUnit> stated) {
    const auto svg = readSvg(bytes);
    if (!svg) {
        return svg.error();
    }
    PatternFile file;
    file.pieces = namedPieces(*svg);
    const bool isOurs = !file.pieces.empty();
    if (!isOurs) {
        file.pieces = outerPieces(*svg);
    }
    std::erase_if(file.pieces, [](const FilePiece& piece) { return outlineOf(piece).rows() < 3; });
    if (file.pieces.empty()) {
        return Error{ErrorCode::NoGeometry,
                     {},
                     worded("it has no closed line that could be a piece; export the outlines of "
                            "its pieces as closed lines")};
    }
    file.format = isOurs ? worded("SVG of Toile") : worded("SVG drawing");
    if (stated) {
        file.unit = *stated;
        for (FilePiece& piece : file.pieces) {
            scale(piece, millimetresPer(*stated) / kMillimetresPerPixel);
        }
    } else if (svg->width > 0) {
        file.unitReason = worded("the size of its page");
    } else {
        file.unitReason = worded("it states no page size, so 96 units are one inch");
        file.unitInDoubt = true;
    }
    return file;
}

}  // namespace toile
