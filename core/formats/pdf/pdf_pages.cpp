// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pdf/pdf_pages.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kClear = 1;        // mm around the content: lines have a width
constexpr double kRounding = 1e-6;  // mm
constexpr double kMargins = 2 * kPageMargin;

enum class PaperKind { Tile, Sheet, Roll, Projector };

struct PaperRow {
    PaperKind kind;
    double width, height;  ///< mm; for a roll its width only
};

/// In the order of the papers. The shared layout is as narrow as A4 and as short as Letter, and so
/// fits on both.
constexpr PaperRow kPaperRows[] = {
    {PaperKind::Tile, 210, 297},      {PaperKind::Tile, 215.9, 279.4},
    {PaperKind::Tile, 210, 279},      {PaperKind::Sheet, 841, 1189},
    {PaperKind::Sheet, 609.6, 914.4}, {PaperKind::Sheet, 914.4, 1219.2},
    {PaperKind::Roll, 610, 0},        {PaperKind::Roll, 841, 0},
    {PaperKind::Roll, 914, 0},        {PaperKind::Projector, 0, 0}};
static_assert(std::size(kPaperRows) == static_cast<std::size_t>(Paper::Projector) + 1);

Vector2d turnedQuarter(const Vector2d& point) {
    return {-point.y(), point.x()};
}

AlignedBox2d turnedQuarter(const AlignedBox2d& box) {
    return AlignedBox2d(turnedQuarter(box.min())).extend(turnedQuarter(box.max()));
}

Points2 turnedQuarter(const Points2& line) {
    Points2 turned(line.rows(), 2);
    turned << -line.col(1), line.col(0);
    return turned;
}

/// The number of tiles for a length, if neighbours share `overlap`.
double tilesFor(double length, double tile, double overlap) {
    return std::max(1.0, std::ceil((length - overlap - kRounding) / (tile - overlap)));
}

bool fits(const Vector2d& size, const Vector2d& room) {
    return (size.array() <= room.array() + kRounding).all();
}

/// Marks the tiles of a grid that have content.
class TileGrid {
public:
    /// @param corner  of the lower left tile's own area  @param overlap  half of it on either side
    TileGrid(const Vector2d& corner, const Vector2d& step, double overlap, int columns, int rows)
        : corner_(corner),
          step_(step),
          beyond_(0.5 * overlap),
          columns_(columns),
          rows_(rows),
          isUsed_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    /// The visible part of the tile. @param row  from the top
    AlignedBox2d window(int column, int row) const {
        const Vector2d low = corner_ + step_.cwiseProduct(Vector2d(column, rows_ - 1 - row));
        const Vector2d beyond = Vector2d::Constant(beyond_);
        return {low - beyond, low + step_ + beyond};
    }

    /// The visible part, cut along the joints with neighbours.
    AlignedBox2d frame(int column, int row) const {
        const AlignedBox2d shown = window(column, row);
        const Vector2d low(column > 0 ? beyond_ : 0, row + 1 < rows_ ? beyond_ : 0);
        const Vector2d high(column + 1 < columns_ ? beyond_ : 0, row > 0 ? beyond_ : 0);
        return {shown.min() + low, shown.max() - high};
    }

    bool isUsed(int column, int row) const { return isUsed_[index(column, row)]; }

    void addLine(const Points2& line) {
        for (Eigen::Index k = 0; k + 1 < line.rows(); ++k) {
            addSegment(line.row(k), line.row(k + 1));
        }
    }

    /// Marks tiles inside of the area; a tile that no line crosses is inside or outside as a whole.
    void addInside(const Points2& area) {
        if (area.rows() < 3) {
            return;
        }
        const auto [low, high] = cellsOf(area.colwise().minCoeff(), area.colwise().maxCoeff());
        for (int row = low.y(); row <= high.y(); ++row) {
            for (int column = low.x(); column <= high.x(); ++column) {
                if (!isUsed(column, row) &&
                    geometry::isInside(area, window(column, row).center())) {
                    isUsed_[index(column, row)] = true;
                }
            }
        }
    }

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    /// First and last column and row of the tiles around a box.
    std::pair<Eigen::Vector2i, Eigen::Vector2i> cellsOf(const Eigen::RowVector2d& low,
                                                        const Eigen::RowVector2d& high) const {
        const auto place = [](double at, int count) -> int {
            return static_cast<int>(std::clamp(std::floor(at), 0.0, count - 1.0));
        };
        const auto column = [&](double x) -> int {
            return place((x - corner_.x()) / step_.x(), columns_);
        };
        const auto row = [&](double y) -> int {
            return rows_ - 1 - place((y - corner_.y()) / step_.y(), rows_);
        };
        return {{column(low.x() - kRounding), row(high.y() + kRounding)},
                {column(high.x() + kRounding), row(low.y() - kRounding)}};
    }

    void addSegment(const Eigen::RowVector2d& from, const Eigen::RowVector2d& to) {
        const auto [low, high] = cellsOf(from.cwiseMin(to), from.cwiseMax(to));
        const bool isOne = low == high;
        for (int row = low.y(); row <= high.y(); ++row) {
            for (int column = low.x(); column <= high.x(); ++column) {
                const AlignedBox2d box = frame(column, row);
                const auto share = geometry::shareInBox<Eigen::RowVector2d>(
                    from, to - from, box.min().transpose(), box.max().transpose());
                if (isOne || share.first <= share.last) {
                    isUsed_[index(column, row)] = true;
                }
            }
        }
    }

    Vector2d corner_, step_;
    double beyond_;
    int columns_, rows_;
    std::vector<bool> isUsed_;
};

/// The paper, and whether the drawing is turned for it; the content may change both.
struct Layout {
    bool turned = false;
    Vector2d paper;
    double overlap = 0;
};

Layout layoutOnSheet(const Vector2d& size, const PaperRow& row, double overlap) {
    const Vector2d upright(row.width, row.height), lying(row.height, row.width);
    const auto pages = [&](const Vector2d& paper) -> double {
        const Vector2d room = paper - Vector2d::Constant(kMargins);
        return tilesFor(size.x(), room.x(), overlap) * tilesFor(size.y(), room.y(), overlap);
    };
    return {false, pages(lying) < pages(upright) ? lying : upright, overlap};
}

/// The turn that uses less of the roll, then the length it needs, in pages of equal length.
Layout layoutOnRoll(const Vector2d& size, const PaperRow& row, double overlap) {
    const auto strips = [&](double across) -> double {
        return tilesFor(across, row.width - kMargins, overlap);
    };
    const double across = strips(size.x()), acrossTurned = strips(size.y());
    // Prefer one strip, whatever its length.
    const bool turned =
        (across > 1 && acrossTurned == 1) ||
        ((across == 1) == (acrossTurned == 1) && acrossTurned * size.x() < across * size.y());
    const double length = turned ? size.x() : size.y();
    const double longest = kLongestPage - kMargins;
    const double parts = tilesFor(length, longest, overlap);
    const double part = (length + (parts - 1) * overlap) / parts;
    return {turned, {row.width, std::min(std::ceil(part), longest) + kMargins}, overlap};
}

Error tooLarge(const Vector2d& size) {
    return {ErrorCode::PageTooSmall,
            {},
            worded("%1 mm x %2 mm; a page can be %3 mm long",
                   {figure(size.x()), figure(size.y()), figure(kLongestPage)})};
}

Vector2d coverOf(Paper paper) {
    const PaperRow& row = kPaperRows[static_cast<std::size_t>(paper)];
    const PaperRow& a4 = kPaperRows[static_cast<std::size_t>(Paper::A4)];
    const PaperRow& own = row.kind == PaperKind::Tile ? row : a4;
    return {own.width, own.height};
}

void findShared(PdfPlan& plan) {
    std::vector<int> at(
        static_cast<std::size_t>(plan.rows) * static_cast<std::size_t>(plan.columns), -1);
    const auto place = [&](int row, int column) -> int& {
        return at[static_cast<std::size_t>(row) * static_cast<std::size_t>(plan.columns) +
                  static_cast<std::size_t>(column)];
    };
    for (std::size_t k = 0; k < plan.pages.size(); ++k) {
        place(plan.pages[k].row, plan.pages[k].column) = static_cast<int>(k);
    }
    for (std::size_t k = 0; k < plan.pages.size(); ++k) {
        const auto& [row, column, window, frame] = plan.pages[k];
        const int right = column + 1 < plan.columns ? place(row, column + 1) : -1;
        const int below = row + 1 < plan.rows ? place(row + 1, column) : -1;
        if (right >= 0) {
            plan.shared.push_back(
                {static_cast<int>(k), right, {frame.max().x(), frame.center().y()}});
        }
        if (below >= 0) {
            plan.shared.push_back(
                {static_cast<int>(k), below, {frame.center().x(), frame.min().y()}});
        }
    }
}

/// One page with everything in its middle.
void placeOnOne(PdfPlan& plan, const AlignedBox2d& box, const Vector2d& room) {
    const AlignedBox2d window(box.center() - 0.5 * room, box.center() + 0.5 * room);
    plan.rows = plan.columns = 1;
    plan.pages.push_back({0, 0, window, window});
}

Result<void> placeOnTiles(PdfPlan& plan, const AlignedBox2d& box, const PrintedContent& content,
                          const Vector2d& room, double overlap) {
    const Vector2d step = room - Vector2d::Constant(overlap);
    const double columns = tilesFor(box.sizes().x(), room.x(), overlap);
    const double rows = tilesFor(box.sizes().y(), room.y(), overlap);
    if (!(columns * rows <= kMaxTiles)) {
        return Error{ErrorCode::PageTooSmall,
                     {},
                     worded("%1 mm x %2 mm, more than %3 pages",
                            {figure(box.sizes().x()), figure(box.sizes().y()), figure(kMaxTiles)})};
    }
    plan.isTiled = true;
    plan.columns = static_cast<int>(columns);
    plan.rows = static_cast<int>(rows);
    const Vector2d corner = box.center() - 0.5 * step.cwiseProduct(Vector2d(columns, rows));
    TileGrid grid(corner, step, overlap, plan.columns, plan.rows);
    for (const Points2& line : content.lines) {
        grid.addLine(plan.turned ? turnedQuarter(line) : line);
    }
    for (const Points2& area : content.areas) {
        grid.addInside(plan.turned ? turnedQuarter(area) : area);
    }
    for (int row = 0; row < plan.rows; ++row) {
        for (int column = 0; column < plan.columns; ++column) {
            if (grid.isUsed(column, row)) {
                plan.pages.push_back(
                    {row, column, grid.window(column, row), grid.frame(column, row)});
            }
        }
    }
    if (plan.pages.empty()) {  // a pattern without a flat piece gets one empty page
        plan.pages.push_back({0, 0, grid.window(0, 0), grid.frame(0, 0)});
    }
    findShared(plan);
    return {};
}

}  // namespace

Result<PdfPlan> planPages(const PrintedContent& content, const PdfOptions& options, bool hasMap) {
    const PaperRow& row = kPaperRows[static_cast<std::size_t>(options.paper)];
    AlignedBox2d box = content.box;
    if (box.isEmpty()) {
        box = AlignedBox2d(Vector2d::Zero());
    }
    box = {box.min() - Vector2d::Constant(kClear), box.max() + Vector2d::Constant(kClear)};
    const Vector2d size = box.sizes();
    if (!size.allFinite()) {
        return tooLarge(size);
    }
    Layout layout{false, {row.width, row.height}, options.overlap};
    if (row.kind == PaperKind::Sheet) {
        layout = layoutOnSheet(size, row, options.overlap);
    } else if (row.kind == PaperKind::Roll) {
        layout = layoutOnRoll(size, row, options.overlap);
    } else if (row.kind == PaperKind::Projector) {
        layout.paper = size + Vector2d::Constant(kMargins);
        if (!(layout.paper.maxCoeff() <= kLongestPage)) {
            return tooLarge(layout.paper);
        }
    }
    PdfPlan plan{.turned = layout.turned,
                 .paper = layout.paper,
                 .origin = Vector2d::Constant(kPageMargin),
                 .coverPaper = coverOf(options.paper)};
    box = plan.turned ? turnedQuarter(box) : box;
    const Vector2d room = plan.paper - Vector2d::Constant(kMargins);
    if (!hasMap && row.kind != PaperKind::Tile && fits(box.sizes(), room)) {
        placeOnOne(plan, box, room);
    } else if (const auto placed = placeOnTiles(plan, box, content, room, layout.overlap);
               !placed) {
        return placed.error();
    }
    return plan;
}

std::string tileName(const PdfPage& page) {
    std::string letters;
    for (int row = page.row; row >= 0; row = row / 26 - 1) {
        letters.insert(letters.begin(), static_cast<char>('A' + row % 26));
    }
    return letters + std::to_string(page.column + 1);
}

Vector2d onSheet(const PdfPlan& plan, const Vector2d& point) {
    return plan.turned ? turnedQuarter(point) : point;
}

}  // namespace toile
