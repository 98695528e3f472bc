// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf/dxf_piece.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/wording.h"
#include "core/formats/dxf/dxf_curve.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

constexpr double kFarthestPlace = 1e9;  // mm: larger coordinates are invalid
constexpr double kMinNear = 0.02;       // mm, smallest distance for joining ends
constexpr double kNearShare = 1e-4;     // of the extent
constexpr double kGapShare = 0.05;      // of a line's length: wider gaps are intended
constexpr int kMaxNotMirrored = 100;    // texts "NM" per piece: each searches all lines
constexpr int kMaxQuantity = 100000;    // limit for malformed files

constexpr Word<DxfRole> kNumbers[] = {
    {DxfRole::Cut, "1"},           {DxfRole::Notch, "4"},       {DxfRole::Fold, "6"},
    {DxfRole::Grain, "7"},         {DxfRole::Internal, "8"},    {DxfRole::CutOut, "11"},
    {DxfRole::Drill, "13"},        {DxfRole::Sew, "14"},        {DxfRole::Text, "15"},
    {DxfRole::Text, "19"},         {DxfRole::Notch, "80"},      {DxfRole::Notch, "81"},
    {DxfRole::Notch, "82"},        {DxfRole::Notch, "83"},      {DxfRole::FineCut, "84"},
    {DxfRole::FineInternal, "85"}, {DxfRole::FineCutOut, "86"}, {DxfRole::FineSew, "87"},
    {DxfRole::Cut, "cut"},         {DxfRole::Sew, "sew"},       {DxfRole::Grain, "grain"},
    {DxfRole::Notch, "notches"},   {DxfRole::Notch, "notch"},   {DxfRole::Internal, "internal"},
    {DxfRole::Text, "text"},       {DxfRole::Drill, "drill"},   {DxfRole::Fold, "fold"},
    {DxfRole::Cut, "outline"},     {DxfRole::Cut, "boundary"},  {DxfRole::Sew, "seam"},
    {DxfRole::Known, "2"},         {DxfRole::Known, "3"},       {DxfRole::Known, "check"},
};

std::string trimmedLower(std::string_view text) {
    std::string word(trimmed(text));
    std::ranges::transform(word, word.begin(), lowered);
    return word;
}

Points2 placed(const Points2& points, const DxfPlace& place) {
    return (points * place.map.linear().transpose()).rowwise() +
           place.map.translation().transpose();
}

Eigen::AlignedBox2d boxOf(const Points2& points) {
    Eigen::AlignedBox2d box;
    for (const auto& row : points.rowwise()) {
        box.extend(row.transpose());
    }
    return box;
}

std::optional<FileLine> lineOf(const DxfEntity& entity, const DxfPlace& place) {
    auto line = dxfCurve(entity, place.map.linear().norm());
    if (line) {
        line->points = placed(line->points, place);
    }
    const bool isLine = line && (line->points.array().abs() < kFarthestPlace).all();
    return isLine ? std::move(line) : std::nullopt;
}

std::vector<Points2> closedOf(const std::vector<FileLine>& lines) {
    std::vector<Points2> closed;
    for (const FileLine& line : lines) {
        if (line.closed && line.points.rows() > 2) {
            closed.push_back(line.points);
        }
    }
    std::ranges::stable_sort(closed, [](const Points2& a, const Points2& b) {
        return std::abs(geometry::signedAreaOf(a)) > std::abs(geometry::signedAreaOf(b));
    });
    return closed;
}

/// The form of a line with more points, if both forms have about the same box; else `line`.
Points2 finer(const Points2& line, const Points2& fine) {
    if (fine.rows() <= line.rows()) {
        return line;
    }
    const auto box = boxOf(line), other = boxOf(fine);
    const double apart =
        std::max((box.min() - other.min()).norm(), (box.max() - other.max()).norm());
    return line.rows() == 0 || apart < kGapShare * box.diagonal().norm() ? fine : line;
}

/// Whether all points are on the mirror line, so that they need no mirror image.
bool isOnLine(const Points2& points, const FileChord& line, double near) {
    return (mirroredAcross(points, line) - points).rowwise().norm().maxCoeff() <= 2 * near;
}

/// The closed lines of a role, joined, largest first, and the number of open ones.
struct Outlines {
    std::vector<Points2> closed{};
    std::size_t open = 0;
};

/// Closes half outlines that are open along the fold.
std::vector<FileLine> closedByFold(std::vector<FileLine> lines,
                                   const std::optional<FileChord>& fold) {
    for (FileLine& line : lines) {
        if (fold && !line.closed && line.points.rows() > 2) {
            Points2 ends(2, 2);
            ends << line.points.row(0), line.points.row(line.points.rows() - 1);
            line.closed = isOnLine(ends, *fold, dxfNearness(geometry::perimeterOf(line.points)));
        }
    }
    return lines;
}

Outlines outlinesOf(const std::vector<DxfEntity>& entities, DxfRole role, DxfRole fine,
                    const DxfPlace& place, const std::optional<FileChord>& fold) {
    const std::vector<FileLine> lines = closedByFold(dxfLines(entities, role, place), fold);
    Outlines found{closedOf(lines)};
    found.open = lines.size() - found.closed.size();
    const std::vector<Points2> other =
        closedOf(closedByFold(dxfLines(entities, fine, place), fold));
    if (!other.empty()) {
        if (found.closed.empty()) {
            found.closed.emplace_back(0, 2);
        }
        found.closed.front() = finer(found.closed.front(), other.front());
    }
    return found;
}

std::string valueOf(const DxfFields& fields, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        if (const auto found = fields.find(key); found != fields.end() && !found->second.empty()) {
            return found->second;
        }
    }
    return {};
}

/// Reads "1" or "1,1": number cut as drawn, and number cut mirrored.
void readQuantity(const std::string& text, FilePiece& piece) {
    int numbers[2] = {1, 0};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int& number : numbers) {
        while (at < end && (*at == ' ' || *at == ',')) {
            ++at;
        }
        int value = 0;
        const auto [after, error] = std::from_chars(at, end, value);
        if (error != std::errc()) {
            break;
        }
        number = std::clamp(value, 0, kMaxQuantity);
        at = after;
    }
    piece.quantity = numbers[0];
    piece.mirroredQuantity = numbers[1];
}

void readTexts(const DxfFields& fields, FilePiece& piece) {
    piece.name = valueOf(fields, {"piece name"});
    piece.size = valueOf(fields, {"size"});
    piece.material = valueOf(fields, {"material", "fabric"});
    piece.category = valueOf(fields, {"category"});
    piece.annotation = valueOf(fields, {"annotation"});
    if (const std::string quantity = valueOf(fields, {"quantity"}); !quantity.empty()) {
        readQuantity(quantity, piece);
    }
}

/// Reads notches and drills: points with more values; in drawings notches are strokes.
void readPoints(const std::vector<DxfEntity>& entities, const DxfPlace& place, FilePiece& piece) {
    const auto scaled = [&place](const DxfEntity& entity, double length) {
        const double size =
            std::abs(length) * place.scale * std::sqrt(std::abs(entity.map.linear().determinant()));
        return size > 0 && size < kFarthestPlace ? std::optional(size) : std::nullopt;
    };
    for (const DxfEntity& entity : entities) {
        auto point = entity.point();
        if (point) {
            point = placedPoint(entity, *point, place);
            point = (point->array().abs() < kFarthestPlace).all() ? point : std::nullopt;
        }
        const DxfRole role = dxfRole(entity.layer);
        if (role == DxfRole::Notch && entity.kind == "POINT" && point) {
            FileNotch& notch = piece.notches.emplace_back(FileNotch{*point});
            if (const auto degrees = entity.number(50)) {
                const double angle = std::fmod(*degrees, 360.0) * kDegree;
                const Eigen::Vector2d way = (place.map * entity.map).linear() *
                                            Eigen::Vector2d(std::cos(angle), std::sin(angle));
                notch.angle = std::atan2(way.y(), way.x());
            }
            notch.depth = scaled(entity, entity.number(30).value_or(0));
        } else if (role == DxfRole::Notch) {
            if (const auto line = lineOf(entity, place)) {
                piece.notches.push_back({line->points.row(0).transpose()});
            }
        } else if (role == DxfRole::Drill && entity.kind == "POINT" && point) {
            piece.drills.push_back({*point, scaled(entity, entity.number(30).value_or(0))});
        } else if (role == DxfRole::Drill && entity.kind == "CIRCLE" && point) {
            piece.drills.push_back({*point, scaled(entity, 2 * entity.number(40).value_or(0))});
        }
    }
}

std::optional<FileChord> chordOf(const std::vector<DxfEntity>& entities, DxfRole role,
                                 const DxfPlace& place) {
    for (const DxfEntity& entity : entities) {
        if (const auto line = dxfRole(entity.layer) == role ? lineOf(entity, place) : std::nullopt;
            line && line->points.row(0) != line->points.row(line->points.rows() - 1)) {
            return FileChord{line->points.row(0).transpose(),
                             line->points.row(line->points.rows() - 1).transpose()};
        }
    }
    return {};
}

/// For each internal line: whether it is the nearest one to a text "NM" and so is not mirrored.
std::vector<char> notMirrored(const std::vector<DxfEntity>& entities, const DxfPlace& place,
                              const std::vector<FileLine>& lines) {
    std::vector<char> isKept(lines.size(), 0);
    int left = kMaxNotMirrored;
    for (const DxfEntity& entity : entities) {
        const auto point = entity.point();
        if (!point || (entity.kind != "TEXT" && entity.kind != "MTEXT") ||
            !equalsIgnoringCase(trimmed(entity.text(1)), "nm") || left-- <= 0) {
            continue;
        }
        const Eigen::Vector2d at = placedPoint(entity, *point, place);
        double least = std::numeric_limits<double>::infinity();
        std::size_t nearest = lines.size();
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const Points2& line = lines[k].points;
            for (Eigen::Index row = 0; row + 1 < line.rows(); ++row) {
                const double distance = geometry::distanceToSegment<Eigen::Vector2d>(
                    at, line.row(row).transpose(), line.row(row + 1).transpose());
                if (distance < least) {
                    least = distance;
                    nearest = k;
                }
            }
        }
        if (nearest < lines.size()) {
            isKept[nearest] = 1;
        }
    }
    return isKept;
}

/// Mirrors holes, internal lines, notches and drills of a half piece across the fold.
/// @param isKept  per internal line: it is not mirrored
void mirrorInside(FilePiece& piece, double near, const std::vector<char>& isKept) {
    const FileChord& fold = *piece.fold;
    const auto image = [&fold](const Eigen::Vector2d& point) -> Eigen::Vector2d {
        return mirroredAcross(point.transpose(), fold).row(0).transpose();
    };
    const Eigen::Vector2d along = fold[1] - fold[0];
    const double direction = std::atan2(along.y(), along.x());
    const std::size_t holes = piece.holes.size(), lines = piece.internals.size(),
                      notches = piece.notches.size(), drills = piece.drills.size();
    for (std::size_t k = 0; k < holes; ++k) {
        const Unfolded whole = unfolded(piece.holes[k], fold, near);
        if (whole.isWhole) {
            piece.holes[k] = whole.line;
        } else {
            piece.holes.emplace_back(mirroredAcross(piece.holes[k], fold).colwise().reverse());
        }
    }
    for (std::size_t k = 0; k < lines; ++k) {
        if (isKept[k] == 0 && !isOnLine(piece.internals[k].points, fold, near)) {
            piece.internals.push_back(
                {mirroredAcross(piece.internals[k].points, fold), piece.internals[k].closed});
        }
    }
    for (std::size_t k = 0; k < notches; ++k) {
        FileNotch notch = piece.notches[k];
        if (!isOnLine(notch.point.transpose(), fold, near)) {
            notch.point = image(notch.point);
            if (notch.angle) {
                notch.angle = std::remainder(2 * direction - *notch.angle, 2 * kPi);
            }
            piece.notches.push_back(notch);
        }
    }
    for (std::size_t k = 0; k < drills; ++k) {
        FileDrill drill = piece.drills[k];
        if (!isOnLine(drill.point.transpose(), fold, near)) {
            drill.point = image(drill.point);
            piece.drills.push_back(drill);
        }
    }
}

void unfold(FilePiece& piece, const std::vector<char>& isKept, std::vector<Wording>& notes) {
    const double near = dxfNearness(boxOf(outlineOf(piece)).diagonal().norm());
    for (Points2* line : {&piece.cut, &piece.sew}) {
        if (line->rows() == 0) {
            continue;
        }
        Unfolded whole = unfolded(*line, *piece.fold, near);
        piece.isUnfolded |= whole.isWhole;
        *line = std::move(whole.line);
    }
    if (piece.isUnfolded) {
        mirrorInside(piece, near, isKept);
    } else {
        notes.push_back(
            worded("%1: the mirror line is not on the outline, so the piece is not unfolded",
                   {Wording(piece.name)}));
    }
}

}  // namespace

DxfRole dxfRole(std::string_view layer) {
    const std::string word = trimmedLower(layer);
    return parseWord(kNumbers, word).value_or(DxfRole::Other);
}

std::optional<DxfField> dxfField(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || colon == 0) {
        return {};
    }
    const std::string_view rest = text.substr(colon + 1);
    const std::size_t from = rest.find_first_not_of(' ');
    return DxfField{trimmedLower(text.substr(0, colon)), from == std::string_view::npos
                                                             ? std::string()
                                                             : readableName(rest.substr(from))};
}

DxfFields dxfFields(const std::vector<DxfEntity>& entities) {
    DxfFields fields;
    for (const DxfEntity& entity : entities) {
        if (entity.kind == "TEXT" || entity.kind == "MTEXT") {
            if (auto field = dxfField(entity.text(1))) {
                fields.emplace(std::move(field->key), std::move(field->value));
            }
        }
    }
    return fields;
}

double dxfNearness(double extent) {
    return std::max(kMinNear, kNearShare * (std::isfinite(extent) ? extent : 0));
}

std::vector<FileLine> dxfLines(const std::vector<DxfEntity>& entities, DxfRole role,
                               const DxfPlace& place, DxfLayersAt* layers) {
    std::vector<FileLine> lines;
    Eigen::AlignedBox2d box;
    double length = 0;
    for (const DxfEntity& entity : entities) {
        if (dxfRole(entity.layer) == role) {
            if (auto line = lineOf(entity, place)) {
                box.extend(boxOf(line->points));
                length += geometry::perimeterOf(line->points) / 2;
                for (const Eigen::Index row : {Eigen::Index{0}, line->points.rows() - 1}) {
                    if (layers) {
                        layers->emplace(std::pair(line->points(row, 0), line->points(row, 1)),
                                        entity.layer);
                    }
                }
                lines.push_back(std::move(*line));
            }
        }
    }
    if (lines.empty()) {
        return {};
    }
    const double near = dxfNearness(box.diagonal().norm());
    const bool isInside = role == DxfRole::Internal || role == DxfRole::FineInternal;
    if (isInside) {
        return lines;  // internal lines whose ends meet may be separate lines
    }
    return joinedLines(lines, near, kGapShare * std::min(length, box.diagonal().norm()));
}

void DxfLeftOut::add(Reason reason, const DxfEntity& entity) {
    std::string what = reason == InsertedAgain ? "INSERT of " + readableName(entity.text(2))
                                               : std::string(entity.kind);
    if (reason == LayerNotRead) {
        what += " (layer " + readableName(entity.layer) + ")";
    }
    ++counts_[reason][what];
}

void DxfLeftOut::addUnread(const std::vector<DxfEntity>& entities, const std::set<DxfRole>& roles) {
    constexpr double kCoarse = 1e-9;  // mm a unit: only tests whether it is a line
    for (const DxfEntity& entity : entities) {
        const DxfRole role = dxfRole(entity.layer);
        const bool isPoint = entity.kind == "POINT";
        if (entity.kind == "TEXT" || entity.kind == "MTEXT" || role == DxfRole::Known) {
            continue;
        }
        const bool isUsed =
            isPoint ? role == DxfRole::Notch || role == DxfRole::Drill
                    : !roles.contains(role) && (role != DxfRole::Drill || entity.kind == "CIRCLE");
        if (!isPoint && !dxfCurve(entity, kCoarse)) {
            add(KindNotRead, entity);
        } else if (!isUsed) {
            add(LayerNotRead, entity);
        }
    }
}

void DxfLeftOut::tell(std::vector<Wording>& notes) const {
    constexpr std::size_t kMaxKinds = 12;
    for (const auto& [reason, counts] : counts_) {
        std::string list;
        std::size_t count = 0;
        for (const auto& [what, number] : counts) {
            if (++count > kMaxKinds) {
                list += ", ...";
                break;
            }
            list += (list.empty() ? "" : ", ") + std::to_string(number) + " " + what;
        }
        notes.push_back(
            reason == KindNotRead
                ? toile::worded("left out because Toile does not read them: %1", {list})
            : reason == LayerNotRead
                ? toile::worded("left out because Toile does not use their layers: %1", {list})
            : reason == InsertedAgain
                ? toile::worded("left out because Toile reads each block once: %1", {list})
                : toile::worded("left out because they belong to no piece: %1", {list}));
    }
}

FilePiece dxfPiece(const std::vector<DxfEntity>& entities, const DxfPlace& place,
                   std::vector<Wording>& notes) {
    FilePiece piece;
    readTexts(dxfFields(entities), piece);
    for (const DxfEntity& entity : entities) {
        ++piece.layers[readableName(entity.layer)];
    }
    piece.fold = chordOf(entities, DxfRole::Fold, place);
    const auto linesOf = [&](DxfRole role, DxfRole fine) {
        return outlinesOf(entities, role, fine, place, piece.fold);
    };
    const Outlines cut = linesOf(DxfRole::Cut, DxfRole::FineCut);
    const Outlines sew = linesOf(DxfRole::Sew, DxfRole::FineSew);
    const Outlines holes = linesOf(DxfRole::CutOut, DxfRole::FineCutOut);
    if (!cut.closed.empty()) {
        piece.cut = geometry::antiClockwise(cut.closed.front());
        std::copy_if(cut.closed.begin() + 1, cut.closed.end(), std::back_inserter(piece.holes),
                     [&piece](const Points2& line) {
                         return geometry::isInside(piece.cut, line.colwise().mean().transpose());
                     });
        if (const auto beside = cut.closed.size() - 1 - piece.holes.size(); beside > 0) {
            notes.push_back(worded("%1: left out because they are outside its outline: %2",
                                   {Wording(piece.name),
                                    countWording(static_cast<long long>(beside), "closed line")}));
        }
    }
    if (!sew.closed.empty()) {
        piece.sew = geometry::antiClockwise(sew.closed.front());
    }
    piece.holes.insert(piece.holes.end(), holes.closed.begin(), holes.closed.end());
    for (Points2& hole : piece.holes) {
        hole = geometry::antiClockwise(hole).colwise().reverse().eval();
    }
    if (const std::size_t open = cut.open + sew.open + holes.open; open > 0) {
        notes.push_back(
            worded("%1: %2 in its outlines that are not closed",
                   {Wording(piece.name), countWording(static_cast<long long>(open), "line")}));
    }
    piece.internals = dxfLines(entities, DxfRole::Internal, place);
    const auto fine = dxfLines(entities, DxfRole::FineInternal, place);
    if (fine.size() == piece.internals.size()) {
        for (std::size_t k = 0; k < fine.size(); ++k) {
            const Points2 better = finer(piece.internals[k].points, fine[k].points);
            piece.internals[k].points = better;
        }
    }
    readPoints(entities, place, piece);
    piece.grain = chordOf(entities, DxfRole::Grain, place);
    if (piece.fold && outlineOf(piece).rows() > 0) {
        unfold(piece, notMirrored(entities, place, piece.internals), notes);
    }
    return piece;
}

}  // namespace toile
