// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/pdf_read_back.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "tests/core/readers/pdf_reader.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double kUnit = 72 / 25.4;     // points per mm
constexpr double kScaleWithin = 1e-6;   // of it
constexpr double kBoxWithin = 1e-3;     // points
constexpr double kSquareWithin = 1e-3;  // mm
constexpr double kShownWithin = 1e-2;   // points
constexpr double kLookedAtEvery = 5;    // mm along the lines
constexpr double kMaxOfPage = 14400;    // points

/// Width and height of a paper, mm; 0: as long as need be.
struct ExpectedPaper {
    double width, height;
    bool isForTiles = false;
};

ExpectedPaper expected(Paper paper) {
    switch (paper) {
        case Paper::A4:
            return {210, 297, true};
        case Paper::Letter:
            return {215.9, 279.4, true};
        case Paper::Shared:
            return {210, 279, true};
        case Paper::A0:
            return {841, 1189};
        case Paper::ArchD:
            return {609.6, 914.4};
        case Paper::ArchE:
            return {914.4, 1219.2};
        case Paper::Roll610:
            return {610, 0};
        case Paper::Roll841:
            return {841, 0};
        case Paper::Roll914:
            return {914, 0};
        case Paper::Projector:
            break;
    }
    return {0, 0};
}

bool isSide(double points, double millimetres) {
    return millimetres == 0 ? points > 0 && points <= kMaxOfPage + kBoxWithin
                            : std::abs(points - kUnit * millimetres) <= kBoxWithin;
}

bool isOnPaper(const Vector2d& size, const ExpectedPaper& paper) {
    const bool isUpright = isSide(size.x(), paper.width) && isSide(size.y(), paper.height);
    const bool isLying = isSide(size.y(), paper.width) && isSide(size.x(), paper.height);
    return isUpright || (isLying && !paper.isForTiles);
}

Result<void> comparePages(const ReadPdf& read, Paper paper) {
    const ExpectedPaper own = expected(paper);
    for (std::size_t k = 0; k < read.pages.size(); ++k) {
        const bool isMap = k == 0 && read.pages[k].views.empty();
        const ExpectedPaper mapPaper = own.isForTiles ? own : expected(Paper::A4);
        if (!isOnPaper(read.pages[k].size, isMap ? mapPaper : own)) {
            return notReadBack({}, "page " + std::to_string(k + 1) + ": it has another size");
        }
        for (const ReadPdfView& view : read.pages[k].views) {
            const Eigen::Matrix2d linear = view.matrix.leftCols<2>() / kUnit;
            const Eigen::Matrix2d square = linear.transpose() * linear;
            const double off = (square - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff();
            if (!(off <= kScaleWithin) || !(linear.determinant() > 0)) {
                return notReadBack({},
                                   "page " + std::to_string(k + 1) + ": it is not in true scale");
            }
        }
    }
    return {};
}

/// Where pages show a part of the drawing; remembers the last one that did.
class Windows {
public:
    explicit Windows(const ReadPdf& read) {
        for (const ReadPdfPage& page : read.pages) {
            const Eigen::AlignedBox2d paper(Vector2d::Zero(), page.size);
            for (const ReadPdfView& view : page.views) {
                views_.push_back({view.matrix, view.clip.intersection(paper)});
            }
        }
    }

    bool show(const Vector2d& point) {
        for (std::size_t k = 0; k < views_.size(); ++k) {
            const std::size_t tried = (last_ + k) % views_.size();
            const auto& [matrix, clip] = views_[tried];
            const Vector2d place = matrix.leftCols<2>() * point + matrix.col(2);
            if (!clip.isEmpty() && clip.exteriorDistance(place) <= kShownWithin) {
                last_ = tried;
                return true;
            }
        }
        return false;
    }

private:
    std::vector<ReadPdfView> views_;
    std::size_t last_ = 0;
};

bool isAllShown(const DrawnPath& path, Windows& windows) {
    const Eigen::Index count = path.points.rows();
    const Eigen::Index last = path.closed ? count : count - 1;
    for (Eigen::Index k = 0; k < last; ++k) {
        const Vector2d a = path.points.row(k), b = path.points.row((k + 1) % count);
        const int parts = static_cast<int>(std::ceil((b - a).norm() / kLookedAtEvery)) + 1;
        for (int part = 0; part <= parts; ++part) {
            if (!windows.show(a + (b - a) * part / parts)) {
                return false;
            }
        }
    }
    return true;
}

Result<void> compareSquare(const ReadPdf& read, const std::string& id, double side) {
    int count = 0;
    bool isRight = true;
    for (const ReadPdfPage& page : read.pages) {
        for (const ReadLine& line : page.lines) {
            if (line.id != id) {
                continue;
            }
            ++count;
            isRight = isRight && line.closed && line.points.rows() == 4;
            for (Eigen::Index k = 0; isRight && k < 4; ++k) {
                const Vector2d edge = line.points.row((k + 1) % 4) - line.points.row(k);
                const Vector2d next = line.points.row((k + 2) % 4) - line.points.row((k + 1) % 4);
                isRight = std::abs(edge.norm() / kUnit - side) <= kSquareWithin &&
                          std::abs(edge.dot(next)) <= kSquareWithin * side * kUnit;
            }
        }
    }
    return count == 1 && isRight
               ? Result<void>()
               : notReadBack({}, id + ": it is no square of " + fixed(side, 1) + " mm");
}

Result<void> comparePdfLayers(const ReadPdf& read, const std::vector<LayerKind>& layers,
                              bool isGrid) {
    constexpr std::array<const char*, 8> kNames{"cut",   "seam line", "notches", "internal lines",
                                                "marks", "grain",     "labels",  "check"};
    static_assert(kNames.size() == kLayerKinds.size());
    for (const LayerKind layer : layers) {
        const std::string name = kNames[static_cast<std::size_t>(layer)];
        if (std::ranges::find(read.layers, name) == read.layers.end()) {
            return notReadBack({}, "layer " + name + ": it is missing");
        }
    }
    const std::vector<std::string> hidden =
        isGrid ? std::vector<std::string>{"grid"} : std::vector<std::string>{};
    return read.hiddenLayers == hidden
               ? Result<void>()
               : notReadBack({}, "other layers are hidden than are meant to be");
}

}  // namespace

Result<ReadBack> readBackPdf(std::string_view bytes, const Drawing& drawing,
                             const PdfOptions& options) {
    const auto read = readPdf(bytes);
    if (!read) {
        return notReadBack({}, read.error().detail);
    }
    // Where the first page is a map it has squares, and the drawing has none.
    const bool hasMap = !read->pages.empty() && read->pages.front().views.empty();
    std::vector<LayerKind> layers;
    for (const LayerKind kind : kLayerKinds) {
        if (hasLayer(drawing, kind) && (kind != LayerKind::Check || !hasMap)) {
            layers.push_back(kind);
        }
    }
    auto found = comparedWithDrawing(read->drawing, drawing, layers);
    if (!found) {
        return found;
    }
    const Result<void> others[] = {
        comparePages(*read, options.paper), compareSquare(*read, "square-50-mm", 50),
        compareSquare(*read, "square-1-in", 25.4),
        comparePdfLayers(*read, layers, options.paper == Paper::Projector)};
    for (const Result<void>& other : others) {
        if (!other) {
            return other.error();
        }
    }
    Windows windows(*read);
    for (const DrawnPath& path : drawing.paths) {
        if (std::ranges::find(layers, path.layer) != layers.end() && !isAllShown(path, windows)) {
            return notReadBack({}, path.id + ": no page shows all of it");
        }
    }
    return found;
}

}  // namespace toile
