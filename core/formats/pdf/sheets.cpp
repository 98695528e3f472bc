// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pdf/sheets.h"

#include <algorithm>

#include "core/base/characters.h"
#include "core/base/text.h"

namespace toile {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kInch = 25.4;
constexpr double kThin = 0.15, kMarkWidth = 0.25, kSquareWidth = 0.2;  // mm
constexpr double kPale = 0.65, kGrey = 0.4;                            // of frames and names
constexpr double kMarkSize = 4;    // mm, from the middle of a diamond to its corners
constexpr double kSquareGap = 8;   // mm, about the squares
constexpr double kSquareText = 3;  // mm
constexpr double kTileName = 7, kTileText = 2.5, kTileInset = 4;  // mm
constexpr double kTitle = 7, kPlain = 3, kSmallPlain = 2.5;       // mm, on the cover
constexpr std::size_t kMaxOfName = 60;                            // characters
constexpr int kCheckLayer = static_cast<int>(LayerKind::Check);

const DrawnPath* checkSquare(const Drawing& drawing) {
    const auto at = std::ranges::find_if(drawing.paths, [](const DrawnPath& path) -> bool {
        return path.layer == LayerKind::Check;
    });
    return at == drawing.paths.end() || at->points.rows() == 0 ? nullptr : &*at;
}

/// Both squares, from the lower left corner of the first.
void addSquares(SheetCanvas& out, const Vector2d& corner) {
    out.beginLayer(kCheckLayer);
    out.save();
    out.setGrey(0);
    out.setWidth(kSquareWidth);
    const auto square = [&](const Vector2d& low, double side, const char* id, const char* text) {
        out.beginItem(id);
        out.box({low, low + Vector2d::Constant(side)});
        out.end();
        const Vector2d middle = low + Vector2d::Constant(0.5 * side);
        out.text(text, middle - Vector2d(0, 0.5 * kSquareText), kSquareText, TextStart::Middle);
    };
    square(corner, kMetricSquare, "square-50-mm", "50 mm");
    square(corner + Vector2d(kMetricSquare + kSquareGap, 0), kInchSquare, "square-1-in", "1 in");
    out.restore();
    out.end();
}

/// The translation from the sheet to a page.
Vector2d moveOf(const PdfPlan& plan, const PdfPage& page) {
    return plan.origin - page.window.min();
}

void useDrawing(SheetCanvas& out, const PdfPlan& plan, const PdfPage& page) {
    if (plan.turned) {
        out.transform(0, 1, -1, 0, moveOf(plan, page));
    } else {
        out.transform(1, 0, 0, 1, moveOf(plan, page));
    }
}

void addDrawing(SheetCanvas& out, const PdfPlan& plan, const PdfPage& page) {
    out.save();
    out.clip({plan.origin, plan.origin + page.window.sizes()});
    useDrawing(out, plan, page);
    out.drawing();
    out.restore();
}

std::string styleName(const Drawing& drawing) {
    return shownText(drawing.title, kMaxOfName);
}

/// The marks of the edges that a page shares, with the names of the neighbours.
void addSharedEdges(SheetCanvas& out, const PdfPlan& plan, std::size_t index) {
    const PdfPage& page = plan.pages[index];
    for (const SharedEdge& edge : plan.shared) {
        const bool isFirst = edge.page == static_cast<int>(index);
        if (!isFirst && edge.other != static_cast<int>(index)) {
            continue;
        }
        const PdfPage& other =
            plan.pages[static_cast<std::size_t>(isFirst ? edge.other : edge.page)];
        const Vector2d middle = edge.middle + moveOf(plan, page);
        Points2 diamond(4, 2);
        diamond << kMarkSize, 0, 0, kMarkSize, -kMarkSize, 0, 0, -kMarkSize;
        diamond.rowwise() += middle.transpose();
        out.setGrey(0);
        out.setWidth(kMarkWidth);
        out.line(diamond, true);
        const bool isBeside = other.row == page.row;
        const Vector2d along = isBeside ? Vector2d(0, kMarkSize) : Vector2d(kMarkSize, 0);
        out.segment(middle - along, middle + along);
        const Vector2d inwards =
            isBeside ? Vector2d(isFirst ? -1 : 1, 0) : Vector2d(0, isFirst ? 1 : -1);
        out.setGrey(kGrey);
        out.text(tileName(other),
                 middle + (kMarkSize + kTileText + 1) * inwards - Vector2d(0, 0.5 * kTileText),
                 kTileText, TextStart::Middle);
    }
}

/// "page %1 of %2" with the numbers inserted, split at each number.
std::vector<std::string> withNumbers(std::string_view words, std::size_t first,
                                     std::size_t second) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t place = std::min(words.find('%', at), words.size());
        if (place > at) {
            parts.emplace_back(words.substr(at, place - at));
        }
        if (place < words.size()) {
            parts.push_back(std::to_string(words.substr(place).starts_with("%1") ? first : second));
        }
        at = place + 2;
    }
    return parts;
}

std::vector<std::string> pageNumber(std::size_t number, const PdfPlan& plan,
                                    const Drawing& drawing) {
    return withNumbers(drawing.words.page, number, plan.pages.size() + 1);
}

/// A column of lines of text from the top of a page down.
class TextColumn {
public:
    TextColumn(SheetCanvas& out, const Vector2d& top, double width)
        : out_(out), at_(top), width_(width) {}

    void add(std::string_view line, double height, double grey) {
        at_.y() -= height;
        out_.setGrey(grey);
        out_.text(line, at_, height, TextStart::Left, 0, width_);
        at_.y() -= 0.9 * height;
    }

    /// Adds a text line by line.
    void addLines(std::string_view lines, double height, double grey) {
        for (std::size_t at = 0; at <= lines.size();) {
            const std::size_t end = std::min(lines.find('\n', at), lines.size());
            add(lines.substr(at, end - at), height, grey);
            at = end + 1;
        }
    }

    /// Adds a line in parts, so that parts shared by several lines are stored once in the file.
    void addParts(const std::vector<std::string>& parts, double height, double grey) {
        at_.y() -= height;
        out_.setGrey(grey);
        double right = 0;
        for (const std::string& part : parts) {
            right += out_.text(part, at_ + Vector2d(right, 0), height, TextStart::Left);
        }
        at_.y() -= 0.9 * height;
    }

    double bottom() const { return at_.y(); }

private:
    SheetCanvas& out_;
    Vector2d at_;
    double width_;
};

/// Points of a map nearer to each other than this are merged, mm.
constexpr double kMapStep = 0.25;

void addMapLine(SheetCanvas& out, const PdfPlan& plan, const DrawnPath& path, double scale,
                const Vector2d& move) {
    Points2 line(path.points.rows(), 2);
    Eigen::Index count = 0;
    for (Eigen::Index k = 0; k < path.points.rows(); ++k) {
        const Vector2d point = scale * onSheet(plan, path.points.row(k)) + move;
        if (count == 0 || k + 1 == path.points.rows() ||
            (line.row(count - 1).transpose() - point).norm() >= kMapStep) {
            line.row(count++) = point.transpose();
        }
    }
    if (count > 1) {
        out.line(line.topRows(count), path.closed);
    }
}

/// The tiles and the cutting lines, reduced, from the top of a box.
void addMap(SheetCanvas& out, const Drawing& drawing, const PdfPlan& plan,
            const AlignedBox2d& room) {
    AlignedBox2d sheet;
    for (const PdfPage& page : plan.pages) {
        sheet.extend(page.frame);
    }
    if (sheet.isEmpty() || !(room.sizes().minCoeff() > 0)) {
        return;
    }
    const double scale = room.sizes().cwiseQuotient(sheet.sizes()).minCoeff();
    const Vector2d move(room.center().x() - scale * sheet.center().x(),
                        room.max().y() - scale * sheet.max().y());
    const auto placed = [&](const Vector2d& p) -> Vector2d { return scale * p + move; };
    double smallest = sheet.sizes().maxCoeff();
    for (const PdfPage& page : plan.pages) {
        smallest = std::min(smallest, page.frame.sizes().minCoeff());
    }
    const double height = std::min(5.0, 0.3 * scale * smallest);
    for (const PdfPage& page : plan.pages) {
        out.setWidth(kThin);
        out.setGrey(kPale);
        out.box({placed(page.frame.min()), placed(page.frame.max())});
        out.text(tileName(page), placed(page.frame.center()) - Vector2d(0, 0.5 * height), height,
                 TextStart::Middle);
    }
    out.setGrey(0);
    out.setWidth(kMarkWidth);
    for (const DrawnPath& path : drawing.paths) {
        if (path.layer == LayerKind::Cut) {
            addMapLine(out, plan, path, scale, move);
        }
    }
}

void drawCover(SheetCanvas& out, const Drawing& drawing, const PdfPlan& plan) {
    const Vector2d paper = plan.coverPaper;
    const Vector2d top(2 * kPageMargin, paper.y() - 2 * kPageMargin);
    const double width = paper.x() - 4 * kPageMargin;
    out.beginLayer(kPageLayer);
    TextColumn head(out, top, width);
    head.add(styleName(drawing), kTitle, 0);
    head.addParts(withNumbers(drawing.words.pages, drawing.blocks.size(), plan.pages.size()),
                  kPlain, 0);
    out.end();
    const Vector2d squares(top.x(), head.bottom() - kSquareGap - kMetricSquare);
    addSquares(out, squares);
    out.beginLayer(kPageLayer);
    const double right = squares.x() + kMetricSquare + kInchSquare + 2 * kSquareGap;
    TextColumn how(out, {right, squares.y() + kMetricSquare}, top.x() + width - right);
    how.addLines(drawing.words.printing, kPlain, 0);
    how.add("", kPlain, 0);
    how.addLines(drawing.words.joining, kSmallPlain, kGrey);
    TextColumn(out, {top.x(), 1.5 * kPageMargin + kTileText}, width)
        .addParts(pageNumber(1, plan, drawing), kTileText, kGrey);
    const AlignedBox2d room(Vector2d(top.x(), 2.5 * kPageMargin),
                            Vector2d(top.x() + width, squares.y() - 1.5 * kSquareGap));
    addMap(out, drawing, plan, room);
    out.end();
}

void drawTile(SheetCanvas& out, const Drawing& drawing, const PdfPlan& plan, std::size_t index) {
    const PdfPage& page = plan.pages[index];
    const Vector2d move = moveOf(plan, page);
    const AlignedBox2d frame(page.frame.min() + move, page.frame.max() + move);
    out.beginLayer(kPageLayer);
    out.save();
    out.clip({plan.origin, plan.origin + page.window.sizes()});
    out.setWidth(kThin);
    out.setGrey(kPale);
    out.box(frame);
    addSharedEdges(out, plan, index);
    TextColumn names(out, {frame.min().x() + kTileInset, frame.max().y() - kTileInset},
                     0.4 * frame.sizes().x());
    names.add(tileName(page), kTileName, kPale);
    names.addParts(pageNumber(index + 2, plan, drawing), kTileText, kGrey);
    names.add(styleName(drawing), kTileText, kGrey);
    out.restore();
    out.end();
    addDrawing(out, plan, page);
}

void drawAll(SheetCanvas& out, const Drawing& drawing, const PdfPlan& plan, bool hasGrid) {
    const PdfPage& page = plan.pages.front();
    if (hasGrid) {
        out.beginLayer(kGridLayer);
        out.save();
        out.setGrey(kPale);
        out.setWidth(2 * kMarkWidth);
        for (int k = 1; k * kInch < plan.paper.x(); ++k) {
            out.segment({k * kInch, 0}, {k * kInch, plan.paper.y()});
        }
        for (int k = 1; k * kInch < plan.paper.y(); ++k) {
            out.segment({0, k * kInch}, {plan.paper.x(), k * kInch});
        }
        out.restore();
        out.end();
    }
    addDrawing(out, plan, page);
    if (const AlignedBox2d squares = squaresBeside(drawing); !squares.isEmpty()) {
        out.save();
        useDrawing(out, plan, page);
        addSquares(out, squares.min());
        out.restore();
    }
}

}  // namespace

AlignedBox2d squaresBeside(const Drawing& drawing) {
    const DrawnPath* check = checkSquare(drawing);
    if (!check) {
        return {};
    }
    const Vector2d corner(check->points.col(0).minCoeff(),
                          check->points.col(1).maxCoeff() + kSquareGap);
    return {corner, corner + Vector2d(kMetricSquare + kSquareGap + kInchSquare, kMetricSquare)};
}

std::size_t sheetCount(const PdfPlan& plan) {
    return plan.pages.size() + (plan.isTiled ? 1 : 0);
}

Vector2d sheetPaper(const PdfPlan& plan, std::size_t sheet) {
    return plan.isTiled && sheet == 0 ? plan.coverPaper : plan.paper;
}

void drawSheet(SheetCanvas& out, const Drawing& drawing, const PdfPlan& plan, std::size_t sheet,
               bool hasGrid) {
    if (!plan.isTiled) {
        drawAll(out, drawing, plan, hasGrid);
    } else if (sheet == 0) {
        drawCover(out, drawing, plan);
    } else {
        drawTile(out, drawing, plan, sheet - 1);
    }
}

}  // namespace toile
