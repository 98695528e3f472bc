// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/formats/dxf/apparel_pieces.h"
#include "core/formats/dxf/dxf_curve.h"
#include "core/formats/dxf/dxf_document.h"
#include "core/formats/dxf/dxf_piece.h"
#include "core/formats/read_backs.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

/// Maximum distance by which a notch record is moved onto the cutting line, mm.
constexpr double kMovedNotch = 1;
/// On a bent line, the ends of a wide mark may be nearer by this than its middle, mm.
constexpr double kBentNotch = 0.1;

bool isNear(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b) {
    return (a - b).norm() <= kReadBackCoordinates;
}

/// Coordinates as they were read, mm.
using ReadPlace = std::pair<double, double>;
using ReadPlaces = std::set<ReadPlace>;

/// As `hasEveryPoint`, but from given first points of the read and the drawn line.
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

/// Whether a read line has every point of a drawn one in order, within kReadBackCoordinates, and no
/// others except those of `others`. A closed line may start at any point.
/// Cost: linear. Pure.
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

double distanceFromLine(const Points2& line, bool closed, const Eigen::Vector2d& point) {
    double least = std::numeric_limits<double>::infinity();
    const Eigen::Index n = line.rows();
    for (Eigen::Index k = 0; k + (closed ? 0 : 1) < n; ++k) {
        const Eigen::Vector2d a = line.row(k), b = line.row((k + 1) % n);
        least = std::min(least, (a + geometry::nearestShare(point, a, b) * (b - a) - point).norm());
    }
    return least;
}

/// The reader's roles of the two forms of a line on one of the writer's layers.
struct LineRoles {
    DxfRole keys, dense;
    LayerKind kind;
};

LineRoles rolesOf(int layer) {
    return layer == kSewLayer ? LineRoles{DxfRole::Sew, DxfRole::FineSew, LayerKind::Sew}
           : layer == kInternalLayer
               ? LineRoles{DxfRole::Internal, DxfRole::FineInternal, LayerKind::Internal}
           : layer == kHoleLayer ? LineRoles{DxfRole::CutOut, DxfRole::FineCutOut, LayerKind::Cut}
                                 : LineRoles{DxfRole::Cut, DxfRole::FineCut, LayerKind::Cut};
}

/// Checks one block against its expected contents.
class BlockReader {
public:
    /// @param place  of the block: only the unit
    BlockReader(const DxfBlock& block, const DxfPlace& place, const ApparelDrawing& made,
                std::size_t index, const Pattern& pattern, bool isAstm)
        : block_(block),
          place_(place),
          made_(made),
          drawn_(made.drawing.blocks[index]),
          lines_(made.lines[index]),
          piece_(pattern.pieces[static_cast<std::size_t>(drawn_.piece)]),
          isAstm_(isAstm) {
        std::vector<DxfEntity> withoutFold;  // otherwise the reader would unfold the piece
        for (const DxfEntity& entity : block.entities) {
            const DxfRole role = dxfRole(entity.layer);
            const auto point = entity.point();
            if (role == DxfRole::Known && entity.kind == "POINT" && point) {
                const Eigen::Vector2d at = placedPoint(entity, *point, place);
                const bool isTurn = entity.layer == std::to_string(kTurnLayer);
                isNamedTwice_ |= !named_.emplace(ReadPlace(at.x(), at.y()), isTurn).second;
            } else if (entity.kind == "LINE") {
                ++straight_[role];
            } else if (entity.kind != "POINT" && entity.kind != "TEXT") {
                ++others_;
            }
            if (role != DxfRole::Fold) {
                withoutFold.push_back(entity);
            }
        }
        std::vector<Wording> notes;
        read_ = dxfPiece(withoutFold, place, notes);
    }

    /// Adds its lines to those of the file. @param keys  by key points  @param dense  exact
    std::optional<Error> readInto(ReadDrawing& keys, ReadDrawing& dense) {
        std::map<DxfRole, std::size_t> next;
        ReadPlaces places;
        for (const auto& [path, layer] : lines_) {
            const DrawnPath& drawn = made_.drawing.paths[path];
            const LineRoles roles = rolesOf(layer);
            const FileLine* key = taken(next, roles.keys);
            const FileLine* exact = isAstm_ ? taken(next, roles.dense) : key;
            if (!key || !exact) {
                return notReadBack(drawn.id, "it is missing");
            }
            ReadPlaces own;
            int turns = 0;
            for (Eigen::Index k = 0; k < key->points.rows(); ++k) {
                const ReadPlace at{key->points(k, 0), key->points(k, 1)};
                own.insert(at);
                const auto named = named_.find(at);
                turns += named != named_.end() && named->second ? 1 : 0;
            }
            if (isAstm_ && !(exact->points.rows() > 0 && key->points.rows() > 0 &&
                             exact->points.row(0) == key->points.row(0) &&
                             hasEveryPoint(exact->points, drawn, own))) {
                return notReadBack(drawn.id, "its validation curve differs");
            }
            places.insert(own.begin(), own.end());
            keys.lines.push_back({roles.kind, drawn.id, key->points, key->closed, true,
                                  drawn.closed ? turns : turns - 1});
            dense.lines.push_back({roles.kind, drawn.id, exact->points, exact->closed});
        }
        if (others_ != lines_.size() * (isAstm_ ? 2 : 1)) {
            return notReadBack(block_.name, "it has additional lines");
        }
        const bool isNamed =
            !isNamedTwice_ && named_.size() == places.size() &&
            std::ranges::all_of(places, [&](const auto& at) { return named_.contains(at); });
        return isNamed ? std::nullopt
                       : std::optional(notReadBack(
                             block_.name, "its turn and curve points differ from its lines"));
    }

    /// Checks texts, grain and mirror line, notches and drill holes.
    std::optional<Error> othersFault() const {
        const DxfFields fields = dxfFields(block_.entities);
        const auto name = fields.find("piece name");
        if (name == fields.end() || name->second != block_.name) {
            return notReadBack(block_.name, "the piece name is missing");
        }
        for (const char* key : {"quantity", "annotation", "category", "material", "size"}) {
            if (!fields.contains(key)) {
                return notReadBack(block_.name, std::string("no ") + key);
            }
        }
        const bool isOnFold = piece_.cutAs == CutAs::OnFold;
        const auto count = [this](DxfRole role) {
            const auto found = straight_.find(role);
            return found == straight_.end() ? 0 : found->second;
        };
        if (count(DxfRole::Grain) != 1 || count(DxfRole::Fold) != (isOnFold ? 1 : 0)) {
            return notReadBack(block_.name, "the grain or mirror line is missing");
        }
        if (!read_.grain || !isGrain(*read_.grain) || !isMirrorOnCut()) {
            return notReadBack(block_.name, "the grain or mirror line is in another place");
        }
        if (auto fault = notchFault()) {
            return fault;
        }
        return drillFault();
    }

private:
    /// The next line in a role; null if there is none.
    const FileLine* taken(std::map<DxfRole, std::size_t>& next, DxfRole role) {
        auto found = byRole_.find(role);
        if (found == byRole_.end()) {
            found = byRole_.emplace(role, dxfLines(block_.entities, role, place_)).first;
        }
        std::size_t& at = next[role];
        return at < found->second.size() ? &found->second[at++] : nullptr;
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

    /// Distance of a point from the drawn marks, and of the ends of the nearest mark from the
    /// cutting line.
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

    /// Whether a line is on the drawn grain line, if there is one, and along the grain.
    bool isGrain(const FileChord& line) const {
        const double angle = directionOnSheet(drawn_.placement, grainOf(piece_));
        const Eigen::Vector2d way = line[1] - line[0];
        const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
        bool isThere = std::abs(geometry::cross(along, way)) <= kReadBackLengths;
        for (std::size_t k = drawn_.path; k < drawn_.path + drawn_.pathCount; ++k) {
            const DrawnPath& path = made_.drawing.paths[k];
            if (path.layer == LayerKind::Grain) {
                isThere = isThere && isNear(line[0].transpose(), path.points.row(0)) &&
                          isNear(line[1].transpose(), path.points.row(1));
            }
        }
        return isThere;
    }

    bool isMirrorOnCut() const {
        for (const FileLine& line : dxfLines(block_.entities, DxfRole::Fold, place_)) {
            for (const auto& row : line.points.rowwise()) {
                if (!(fromCut(row.transpose()) <= kReadBackCoordinates)) {
                    return false;
                }
            }
        }
        return true;
    }

    std::optional<Error> notchFault() const {
        const int count =
            std::accumulate(piece_.notches.begin(), piece_.notches.end(), 0,
                            [](int sum, const PieceNotch& notch) { return sum + notch.count; });
        if (static_cast<int>(read_.notches.size()) != count) {
            return notReadBack(
                block_.name, counted(static_cast<long long>(read_.notches.size()), "notch record") +
                                 " instead of " + std::to_string(count));
        }
        for (const FileNotch& notch : read_.notches) {
            if (!notch.depth || !notch.angle) {
                return notReadBack(block_.name, "a notch without depth or angle");
            }
            const Eigen::Vector2d end =
                notch.point +
                *notch.depth * Eigen::Vector2d(std::cos(*notch.angle), std::sin(*notch.angle));
            const auto [onMark, off] = fromMarks(end);
            const double moved = std::min(kMovedNotch, off + kBentNotch);
            if (!(onMark <= kReadBackCoordinates ||
                  (onMark <= moved && fromCut(notch.point) <= kReadBackCoordinates))) {
                return notReadBack(block_.name, "a notch is in another place");
            }
        }
        return {};
    }

    /// Drill holes are circles in the drawing.
    std::optional<Error> drillFault() const {
        std::size_t next = 0;
        for (std::size_t k = drawn_.path; k < drawn_.path + drawn_.pathCount; ++k) {
            const DrawnPath& path = made_.drawing.paths[k];
            if (!(path.isDrill && path.closed && path.layer == LayerKind::Marks)) {
                continue;
            }
            const Eigen::Vector2d middle = path.points.colwise().mean().transpose();
            if (next >= read_.drills.size() || !read_.drills[next].diameter ||
                !isNear(read_.drills[next].point.transpose(), middle.transpose()) ||
                !(std::abs(*read_.drills[next].diameter - kDrillDiameter) <= kReadBackLengths)) {
                return notReadBack(path.id, "a drill hole is missing");
            }
            ++next;
        }
        return next == read_.drills.size()
                   ? std::nullopt
                   : std::optional(notReadBack(block_.name, "it has additional drill holes"));
    }

    const DxfBlock& block_;
    DxfPlace place_;
    const ApparelDrawing& made_;
    const DrawnBlock& drawn_;
    const std::vector<ApparelDrawing::Line>& lines_;
    const PatternPiece& piece_;
    bool isAstm_;
    FilePiece read_{};  ///< half, if it is on the fold
    std::map<DxfRole, std::vector<FileLine>> byRole_{};
    std::map<DxfRole, int> straight_{};  ///< entities that are one straight line
    std::size_t others_ = 0;             ///< entities that are neither these nor points nor texts
    std::map<ReadPlace, bool> named_{};  ///< by place: whether it is a turn point
    bool isNamedTwice_ = false;
};

/// Checks that all blocks are inserted once, at 0,0, in order, with valid unique names.
std::optional<Error> insertFault(const DxfDocument& document) {
    std::vector<const DxfEntity*> inserts;
    for (const DxfEntity& entity : document.entities) {
        if (entity.kind == "INSERT") {
            inserts.push_back(&entity);
        }
    }
    std::set<std::string_view> names;
    for (std::size_t k = 0; k < document.blocks.size(); ++k) {
        const DxfBlock& block = document.blocks[k];
        if (block.name.empty() || block.name.size() > 20 || !names.insert(block.name).second) {
            return notReadBack(block.name, "a piece has no name");
        }
        if (k >= inserts.size() || inserts[k]->text(2) != block.name ||
            insertionOf(block, *inserts[k]).matrix() != Eigen::Matrix3d::Identity()) {
            return notReadBack(block.name, "it is in another place");
        }
    }
    return inserts.size() == document.blocks.size()
               ? std::nullopt
               : std::optional(notReadBack("inserts", "it has more than blocks"));
}

std::optional<Error> controlFault(const DxfBlock& block, const DxfPlace& place, bool isAstm,
                                  const Drawing& drawing) {
    for (const DrawnPath& path : drawing.paths) {
        if (path.layer != LayerKind::Check) {
            continue;
        }
        for (const DxfRole role : {DxfRole::Cut, DxfRole::FineCut}) {
            const std::vector<FileLine> lines = dxfLines(block.entities, role, place);
            const bool isRight = block.name == kControlName &&
                                 lines.size() == (isAstm || role == DxfRole::Cut ? 1U : 0U) &&
                                 std::ranges::all_of(lines, [&](const FileLine& line) {
                                     return line.closed &&
                                            line.points.rows() == path.points.rows() &&
                                            hasEveryPoint(line.points, path, {});
                                 });
            if (!isRight) {
                return notReadBack(kControlName, "it is not a square of 100 mm");
            }
        }
    }
    return {};
}

/// `readDxfBack` for the profiles Astm and Aama.
Result<ReadBack> readApparelBack(const DxfDocument& document, const ExportSource& source) {
    const DxfOptions& options = source.options().dxf;
    const ApparelDrawing made = apparelDrawing(source);
    const std::size_t pieces = made.drawing.blocks.size();
    if (document.blocks.size() != pieces + (options.controlPiece ? 1 : 0)) {
        return notReadBack("blocks", std::to_string(document.blocks.size()) + " instead of " +
                                         std::to_string(pieces));
    }
    const DxfFields fields = dxfFields(document.entities);
    const auto units = fields.find("units");
    if (units == fields.end() ||
        units->second != (options.unit == LengthUnit::Inch ? "ENGLISH" : "METRIC")) {
        return notReadBack("units", "another unit is stated");
    }
    if (const auto fault = insertFault(document)) {
        return *fault;
    }
    DxfPlace place;
    place.scale = millimetresPer(options.unit);
    place.map.linear() *= place.scale;
    ReadDrawing keys, dense;
    keys.pieces = dense.pieces = static_cast<int>(pieces);
    const bool isAstm = options.profile == DxfProfile::Astm;
    for (std::size_t b = 0; b < pieces; ++b) {
        BlockReader block(document.blocks[b], place, made, b, source.laid().pattern, isAstm);
        if (const auto fault = block.readInto(keys, dense)) {
            return *fault;
        }
        if (const auto fault = block.othersFault()) {
            return *fault;
        }
    }
    if (options.controlPiece) {
        if (const auto fault = controlFault(document.blocks.back(), place, isAstm, made.drawing)) {
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

/// Lines of the plain profile have no names; those of a layer are in the drawing's order.
Result<ReadBack> readPlainBack(const DxfDocument& document, double unit, const Drawing& drawing) {
    ReadDrawing lines;
    std::map<LayerKind, std::vector<Points2>> byLayer;
    std::size_t texts = 0;
    for (const DxfEntity& entity : document.entities) {
        texts += entity.kind == "TEXT" ? 1 : 0;
        const auto line = dxfCurve(entity, unit);
        if (!line) {
            continue;
        }
        const auto layer = layerNamed(entity.layer, &LayerNames::dxf);
        if (!layer) {
            return notReadBack({}, "layer \"" + std::string(entity.layer) + "\"");
        }
        lines.lines.push_back({*layer, {}, line->points * unit, line->closed});
        byLayer[*layer].push_back(lines.lines.back().points);
    }
    std::map<LayerKind, std::size_t> next;
    std::size_t holes = 0, words = 0;
    for (const DrawnPath& path : drawing.paths) {
        const std::size_t at = next[path.layer]++;
        if (at < byLayer[path.layer].size() && !hasEveryPoint(byLayer[path.layer][at], path, {})) {
            return notReadBack({}, path.id + ": points are missing or in another place");
        }
        holes += path.layer == LayerKind::Cut ? 1 : 0;
    }
    holes -= std::min(holes, drawing.blocks.size());
    lines.pieces = static_cast<int>(byLayer[LayerKind::Cut].size()) - static_cast<int>(holes);
    for (const DrawnText& text : drawing.texts) {
        words += text.lines.size();
    }
    if (texts != words) {
        return notReadBack({}, countWording(static_cast<long long>(texts), "text") +
                                   " instead of " + std::to_string(words));
    }
    return comparedWithDrawing(
        lines, drawing,
        {LayerKind::Cut, LayerKind::Sew, LayerKind::Notches, LayerKind::Internal, LayerKind::Marks,
         LayerKind::Grain, LayerKind::Check});
}

/// Checks a grade table with one size.
bool isRuleTable(std::string_view bytes, LengthUnit unit) {
    const std::string units =
        std::string("\r\nUnits: ") + (unit == LengthUnit::Inch ? "ENGLISH" : "METRIC") + "\r\n";
    return bytes.find(units) != std::string_view::npos &&
           bytes.find("\r\nNumber of Sizes: 1\r\n") != std::string_view::npos &&
           bytes.ends_with("\r\nEnd\r\n");
}

}  // namespace

Result<ReadBack> readDxfBack(const ExportedFiles& files, const ExportSource& source) {
    if (files.empty()) {
        return notReadBack({}, "there is no file");
    }
    const auto document = readDxfDocument(files.front().bytes);
    if (!document) {
        return notReadBack({}, document.error().detail);
    }
    if (!document->hasEnd) {
        return notReadBack({}, "its end is missing");
    }
    const DxfOptions& options = source.options().dxf;
    if (options.profile == DxfProfile::Plain) {
        if (headerUnit(*document) != options.unit) {
            return notReadBack({}, "its unit differs");
        }
        return readPlainBack(*document, millimetresPer(options.unit), source.drawing());
    }
    for (const ExportedFile& file : files) {
        if (file.beside == ".rul" && !isRuleTable(file.bytes, options.unit)) {
            return notReadBack({}, "the rule table is invalid");
        }
    }
    return readApparelBack(*document, source);
}

}  // namespace toile
