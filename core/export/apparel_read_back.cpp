// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/apparel_read_back.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/export/apparel_pieces.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

/// The record of a notch is put onto the line that is cut, so far from where the mark is drawn, mm.
constexpr double kMovedNotch = 1;
/// The ends of a wide mark may be by so much nearer to a bent line than its middle, mm.
constexpr double kBentNotch = 0.1;

bool isNear(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b) {
    return (a - b).norm() <= kReadBackCoordinates;
}

std::pair<double, double> placeOf(const Points2& points, Eigen::Index k) {
    return {points(k, 0), points(k, 1)};
}

/// As `hasEveryPoint`, from one point of the read line and one of the drawn.
bool walksAlong(const Points2& read, Eigen::Index first, const DrawnPath& path, Eigen::Index start,
                const ReadPlaces& others) {
    const Eigen::Index n = read.rows(), m = path.points.rows();
    Eigen::Index passed = 0;  // points of the drawn line
    const auto drawn = [&](Eigen::Index k) -> Eigen::RowVector2d {
        return path.points.row((start + k) % m);
    };
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::RowVector2d point = read.row((first + i) % n);
        const Eigen::Index before = passed;
        while (passed < m && isNear(point, drawn(passed))) {
            ++passed;
        }
        if (passed == before && !(passed > 0 && isNear(point, drawn(passed - 1))) &&
            !others.contains({point.x(), point.y()})) {
            return false;
        }
    }
    return passed == m;
}

double distanceFromLine(const Points2& line, bool closed, const Eigen::Vector2d& point) {
    double least = std::numeric_limits<double>::infinity();
    const Eigen::Index n = line.rows();
    for (Eigen::Index k = 0; k + (closed ? 0 : 1) < n; ++k) {
        const Eigen::Vector2d a = line.row(k), b = line.row((k + 1) % n);
        least = std::min(least, (a + geometry::nearestShare(point, a, b) * (b - a) - point).norm());
    }
    return least;
}

LayerKind kindOf(int layer) {
    return layer == kSewLayer        ? LayerKind::Sew
           : layer == kInternalLayer ? LayerKind::Internal
                                     : LayerKind::Cut;
}

/// One block, and what it is to hold.
class BlockReader {
public:
    BlockReader(const DxfGroupOfEntities& block, const ApparelDrawing& made, std::size_t index,
                const Pattern& pattern, bool isAstm)
        : block_(block),
          made_(made),
          drawn_(made.drawing.blocks[index]),
          lines_(made.lines[index]),
          piece_(pattern.pieces[static_cast<std::size_t>(drawn_.piece)]),
          isAstm_(isAstm) {
        for (const DxfLine& line : block.polylines) {
            byLayer_[std::string(line.layer)].push_back(&line);
        }
        for (const DxfRecord& record : block.records) {
            const std::pair<double, double> place{record.point.x(), record.point.y()};
            const bool isTurn = record.layer == std::to_string(kTurnLayer);
            if (isTurn || record.layer == std::to_string(kCurveLayer)) {
                isNamedTwice_ |= !named_.emplace(place, isTurn).second;
            }
        }
    }

    /// Adds its lines to those of the file. @param keys  by key points  @param dense  exact
    std::optional<Error> readInto(ReadDrawing& keys, ReadDrawing& dense) {
        std::map<std::string, std::size_t> next;
        ReadPlaces places;
        for (const auto& [path, layer] : lines_) {
            const DrawnPath& drawn = made_.drawing.paths[path];
            const DxfLine* key = taken(next, layer);
            const DxfLine* exact = isAstm_ ? taken(next, validationLayer(layer)) : key;
            if (!key || !exact) {
                return notReadBack(drawn.id, "it is missing");
            }
            ReadPlaces own;
            int turns = 0;
            for (Eigen::Index k = 0; k < key->points.rows(); ++k) {
                own.insert(placeOf(key->points, k));
                const auto named = named_.find(placeOf(key->points, k));
                turns += named != named_.end() && named->second ? 1 : 0;
            }
            if (isAstm_ && !(exact->points.rows() > 0 && key->points.rows() > 0 &&
                             exact->points.row(0) == key->points.row(0) &&
                             hasEveryPoint(exact->points, drawn, own))) {
                return notReadBack(drawn.id, "its validation curve is another line");
            }
            places.insert(own.begin(), own.end());
            keys.lines.push_back({kindOf(layer), drawn.id, key->points, key->closed, true,
                                  drawn.closed ? turns : turns - 1});
            dense.lines.push_back({kindOf(layer), drawn.id, exact->points, exact->closed});
        }
        if (block_.polylines.size() != lines_.size() * (isAstm_ ? 2 : 1)) {
            return notReadBack(block_.name, "it has other lines too");
        }
        const bool isNamed =
            !isNamedTwice_ && named_.size() == places.size() &&
            std::ranges::all_of(places, [&](const auto& at) { return named_.contains(at); });
        return isNamed ? std::nullopt
                       : std::optional(notReadBack(
                             block_.name, "turn and curve points are not those of its lines"));
    }

    /// Texts, grain and mirror line, notches and drill holes.
    std::optional<Error> othersFault() const {
        const auto name = block_.said.find("piece name");
        if (name == block_.said.end() || name->second != block_.name) {
            return notReadBack(block_.name, "no piece name");
        }
        for (const char* key : {"quantity", "annotation", "category", "material", "size"}) {
            if (!block_.said.contains(key)) {
                return notReadBack(block_.name, std::string("no ") + key);
            }
        }
        const bool isOnFold = piece_.cutAs == CutAs::OnFold;
        if (linesOn(kGrainLayer) != 1 || linesOn(kMirrorLayer) != (isOnFold ? 1 : 0)) {
            return notReadBack(block_.name, "grain or mirror line");
        }
        if (auto fault = lineFault()) {
            return fault;
        }
        if (auto fault = notchFault()) {
            return fault;
        }
        return drillFault();
    }

private:
    const DxfLine* taken(std::map<std::string, std::size_t>& next, int layer) const {
        const auto found = byLayer_.find(std::to_string(layer));
        std::size_t& at = next[std::to_string(layer)];
        return found == byLayer_.end() || at >= found->second.size() ? nullptr
                                                                     : found->second[at++];
    }

    long linesOn(int layer) const {
        return std::ranges::count(block_.lines, std::string_view(std::to_string(layer)),
                                  &DxfLine::layer);
    }

    std::vector<const DxfRecord*> recordsOn(std::initializer_list<int> layers) const {
        std::vector<const DxfRecord*> records;
        for (const DxfRecord& record : block_.records) {
            for (const int layer : layers) {
                if (record.layer == std::to_string(layer)) {
                    records.push_back(&record);
                }
            }
        }
        return records;
    }

    double fromCut(const Eigen::Vector2d& point) const {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [path, layer] : lines_) {
            if (layer == kCutLayer || layer == kHoleLayer) {
                const DrawnPath& drawn = made_.drawing.paths[path];
                least = std::min(least, distanceFromLine(drawn.points, true, point));
            }
        }
        return least;
    }

    /// How far a point is from the drawn marks, and the ends of the nearest from the line that is
    /// cut.
    std::pair<double, double> fromMarks(const Eigen::Vector2d& point) const {
        double least = std::numeric_limits<double>::infinity(), off = least;
        for (std::size_t k = drawn_.path; k < drawn_.path + drawn_.pathCount; ++k) {
            const DrawnPath& path = made_.drawing.paths[k];
            if (path.layer != LayerKind::Notches) {
                continue;
            }
            if (const double here = distanceFromLine(path.points, path.closed, point);
                here < least) {
                least = here;
                off = std::max(fromCut(path.points.row(0).transpose()),
                               fromCut(path.points.row(path.points.rows() - 1).transpose()));
            }
        }
        return {least, off};
    }

    /// The grain line along the grain, as it is drawn, if it is.
    bool isGrain(const Points2& line) const {
        const double angle = directionOnSheet(drawn_.placement, grainOf(piece_));
        const Eigen::Vector2d way = (line.row(1) - line.row(0)).transpose();
        const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
        bool isThere = std::abs(geometry::cross(along, way)) <= kReadBackLengths;
        for (std::size_t k = drawn_.path; k < drawn_.path + drawn_.pathCount; ++k) {
            const DrawnPath& path = made_.drawing.paths[k];
            if (path.layer == LayerKind::Grain) {
                isThere = isThere && isNear(line.row(0), path.points.row(0)) &&
                          isNear(line.row(1), path.points.row(1));
            }
        }
        return isThere;
    }

    std::optional<Error> lineFault() const {
        for (const DxfLine& line : block_.lines) {
            const bool isRight = line.layer == std::to_string(kGrainLayer)
                                     ? isGrain(line.points)
                                     : fromCut(line.points.row(0)) <= kReadBackCoordinates &&
                                           fromCut(line.points.row(1)) <= kReadBackCoordinates;
            if (!isRight) {
                return notReadBack(block_.name, "grain or mirror line is elsewhere");
            }
        }
        return {};
    }

    std::optional<Error> notchFault() const {
        const auto records = recordsOn({kNotchLayer, kTNotchLayer, kCastleNotchLayer});
        const int count =
            std::accumulate(piece_.notches.begin(), piece_.notches.end(), 0,
                            [](int sum, const PieceNotch& notch) { return sum + notch.count; });
        if (static_cast<int>(records.size()) != count) {
            return notReadBack(block_.name,
                               counted(static_cast<long long>(records.size()), "notch record") +
                                   " instead of " + std::to_string(count));
        }
        for (const DxfRecord* record : records) {
            if (!record->height || !record->angle) {
                return notReadBack(block_.name, "a notch without depth or angle");
            }
            const Eigen::Vector2d end =
                record->point + *record->height * Eigen::Vector2d(std::cos(*record->angle),
                                                                  std::sin(*record->angle));
            const auto [onMark, off] = fromMarks(end);
            const double moved = std::min(kMovedNotch, off + kBentNotch);
            if (!(onMark <= kReadBackCoordinates ||
                  (onMark <= moved && fromCut(record->point) <= kReadBackCoordinates))) {
                return notReadBack(block_.name, "a notch is not where it is drawn");
            }
        }
        return {};
    }

    /// Drill holes are circles in the drawing.
    std::optional<Error> drillFault() const {
        const auto records = recordsOn({kDrillLayer});
        std::size_t next = 0;
        for (std::size_t k = drawn_.path; k < drawn_.path + drawn_.pathCount; ++k) {
            const DrawnPath& path = made_.drawing.paths[k];
            const bool isDrill =
                path.closed && path.layer == LayerKind::Marks &&
                (path.id.ends_with("-drill") || path.id.find("--point-") != std::string::npos);
            if (!isDrill) {
                continue;
            }
            const Eigen::Vector2d middle = path.points.colwise().mean().transpose();
            if (next >= records.size() || !records[next]->height ||
                !isNear(records[next]->point.transpose(), middle.transpose()) ||
                !(std::abs(*records[next]->height - kDrillDiameter) <= kReadBackLengths)) {
                return notReadBack(path.id, "no drill hole");
            }
            ++next;
        }
        return next == records.size()
                   ? std::nullopt
                   : std::optional(notReadBack(block_.name, "it has other drill holes too"));
    }

    const DxfGroupOfEntities& block_;
    const ApparelDrawing& made_;
    const DrawnBlock& drawn_;
    const std::vector<ApparelDrawing::Line>& lines_;
    const PatternPiece& piece_;
    bool isAstm_;
    std::map<std::string, std::vector<const DxfLine*>> byLayer_;
    std::map<std::pair<double, double>, bool> named_;  ///< by place: whether it is a turn point
    bool isNamedTwice_ = false;
};

/// All blocks are inserted once, where they lie, in their order; names are fit and used once.
std::optional<Error> insertFault(const DxfDrawing& read) {
    std::set<std::string_view> names;
    for (std::size_t k = 0; k < read.blocks.size(); ++k) {
        const std::string_view name = read.blocks[k].name;
        if (name.empty() || name.size() > 20 || !names.insert(name).second) {
            return notReadBack(name, "no name for a piece");
        }
        if (k >= read.page.inserts.size() || read.page.inserts[k].first != name ||
            read.page.inserts[k].second != Eigen::Vector2d(0, 0)) {
            return notReadBack(name, "it is not where it lies");
        }
    }
    return read.page.inserts.size() == read.blocks.size()
               ? std::nullopt
               : std::optional(notReadBack("inserts", "more than blocks"));
}

std::optional<Error> controlFault(const DxfGroupOfEntities& block, const Drawing& drawing) {
    for (const DrawnPath& path : drawing.paths) {
        if (path.layer != LayerKind::Check) {
            continue;
        }
        const bool isRight = block.name == kControlName && !block.polylines.empty() &&
                             std::ranges::all_of(block.polylines, [&](const DxfLine& line) {
                                 return line.closed && line.points.rows() == path.points.rows() &&
                                        hasEveryPoint(line.points, path, {});
                             });
        if (!isRight) {
            return notReadBack(kControlName, "it is no square of 100 mm");
        }
    }
    return {};
}

}  // namespace

bool hasEveryPoint(const Points2& read, const DrawnPath& path, const ReadPlaces& others) {
    if (read.rows() == 0 || path.points.rows() == 0) {
        return read.rows() == path.points.rows();
    }
    if (!path.closed) {
        return walksAlong(read, 0, path, 0, others);
    }
    for (Eigen::Index first = 0; first < read.rows(); ++first) {
        bool hasStart = false;
        for (Eigen::Index start = 0; start < path.points.rows(); ++start) {
            if (isNear(read.row(first), path.points.row(start))) {
                hasStart = true;
                if (walksAlong(read, first, path, start, others)) {
                    return true;
                }
            }
        }
        if (hasStart) {
            return false;
        }
    }
    return false;
}

Result<ReadBack> readApparelBack(const DxfDrawing& read, const ExportSource& source) {
    const DxfOptions& options = source.options().dxf;
    const ApparelDrawing made = apparelDrawing(source);
    const std::size_t pieces = made.drawing.blocks.size();
    if (read.blocks.size() != pieces + (options.controlPiece ? 1 : 0)) {
        return notReadBack(
            "blocks", std::to_string(read.blocks.size()) + " instead of " + std::to_string(pieces));
    }
    const auto units = read.page.said.find("units");
    if (units == read.page.said.end() ||
        units->second != (options.unit == LengthUnit::Inch ? "ENGLISH" : "METRIC")) {
        return notReadBack("units", "another unit is stated");
    }
    if (const auto fault = insertFault(read)) {
        return *fault;
    }
    ReadDrawing keys, dense;
    keys.pieces = dense.pieces = static_cast<int>(pieces);
    const bool isAstm = options.profile == DxfProfile::Astm;
    for (std::size_t b = 0; b < pieces; ++b) {
        BlockReader block(read.blocks[b], made, b, source.laid().pattern, isAstm);
        if (const auto fault = block.readInto(keys, dense)) {
            return *fault;
        }
        if (const auto fault = block.othersFault()) {
            return *fault;
        }
    }
    if (options.controlPiece) {
        if (const auto fault = controlFault(read.blocks.back(), made.drawing)) {
            return *fault;
        }
    }
    const std::vector layers{LayerKind::Cut, LayerKind::Sew, LayerKind::Internal};
    Result<ReadBack> found = comparedWithDrawing(keys, made.drawing, layers);
    if (!found || !isAstm) {
        return found;
    }
    Result<ReadBack> exact = comparedWithDrawing(dense, made.drawing, layers);
    if (exact) {
        exact->largest = std::max(exact->largest, found->largest);
    }
    return exact;
}

}  // namespace toile
