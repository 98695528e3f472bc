// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/formats/dxf/dxf_curve.h"
#include "core/formats/dxf/dxf_document.h"
#include "core/formats/dxf/dxf_piece.h"
#include "core/formats/read_pattern.h"
#include "core/geometry/polygon.h"

namespace toile {
namespace {

constexpr std::size_t kMaxOutlines = 2000;  // of a drawing without blocks
constexpr double kMaxWork = 5e8;            // limit on point tests that assign parts to pieces
constexpr double kRectangle = 0.98;         // of its box: a line that fills more is a rectangle
constexpr double kSideNear = 1e-3;          // of a border's size: distance of a title block's sides
constexpr double kMaxHoles = 0.2;           // of a piece's area
constexpr double kLargeHole = 0.03;         // likewise: no piece has two such holes
constexpr double kSeamLine = 0.6;           // likewise: a larger line may be the seam line

/// Placement of a block: by its first INSERT, or unchanged if it has none.
DxfPlace placeOf(const DxfBlock& block, const DxfEntity* insert, double unit) {
    DxfPlace place;
    place.scale = unit;
    place.map.linear() *= unit;
    if (insert) {
        const Eigen::Affine2d map = insertionOf(block, *insert);
        place.map = place.map * map;
        place.scale *= map.linear().col(0).norm();
    }
    return place;
}

Eigen::AlignedBox2d boxOfOutline(const FilePiece& piece) {
    Eigen::AlignedBox2d box;
    for (const auto& row : outlineOf(piece).rowwise()) {
        box.extend(row.transpose());
    }
    return box;
}

double extentOf(const std::vector<FilePiece>& pieces) {
    double extent = 0;
    for (const FilePiece& piece : pieces) {
        if (outlineOf(piece).rows() > 0) {
            extent = std::max(extent, boxOfOutline(piece).sizes().maxCoeff());
        }
    }
    return extent;
}

/// The reason to leave out a piece; empty if it is valid.
Wording faultOf(const FilePiece& piece) {
    const Points2& outline = outlineOf(piece);
    if (outline.rows() < 3) {
        return worded("it has no closed outline");
    }
    return std::abs(geometry::signedAreaOf(outline)) > 0 ? Wording()
                                                         : worded("its outline has no area");
}

/// The name of a block without a suffix that repeats the size, as in "front_36".
std::string nameOfBlock(const std::string& block, const std::string& size) {
    for (const char* joint : {"_", "-"}) {
        const std::string ending = joint + size;
        if (!size.empty() && block.size() > ending.size() && block.ends_with(ending)) {
            return block.substr(0, block.size() - ending.size());
        }
    }
    return block;
}

/// Copies material, category and quantities from one size of a piece to the sizes without them.
void shareTexts(std::vector<FilePiece>& pieces) {
    std::map<std::string, const FilePiece*> told;
    for (const FilePiece& piece : pieces) {
        const FilePiece*& best = told[piece.name];
        if (!best || (best->material.empty() && best->category.empty())) {
            best = &piece;
        }
    }
    for (FilePiece& piece : pieces) {
        const FilePiece& from = *told.at(piece.name);
        if (piece.material.empty() && piece.category.empty()) {
            piece.material = from.material;
            piece.category = from.category;
            piece.quantity = from.quantity;
            piece.mirroredQuantity = from.mirroredQuantity;
        }
    }
}

bool isText(const DxfEntity& entity) {
    return entity.kind == "TEXT" || entity.kind == "MTEXT";
}

/// A closed line of a drawing.
struct DrawnOutline {
    Points2 points = Points2(0, 2);  ///< anti-clockwise
    std::string_view layer{};
    double area = 0;
    Eigen::AlignedBox2d box{};

    DrawnOutline(Points2 line, std::string_view onLayer)
        : points(std::move(line)),
          layer(onLayer),
          area(geometry::signedAreaOf(points)),
          box(geometry::boxAround(points)) {}

    bool isRectangle() const { return area > kRectangle * box.volume(); }
    bool holds(const DrawnOutline& other) const {
        return box.contains(other.box) &&
               geometry::isInside(points, other.points.colwise().mean().transpose());
    }
    /// Number of sides of its box that lie on those of the other's box.
    int sidesOn(const DrawnOutline& other) const {
        const double near = kSideNear * other.box.diagonal().norm();
        return static_cast<int>(((box.min() - other.box.min()).array().abs() < near).count() +
                                ((box.max() - other.box.max()).array().abs() < near).count());
    }
};

/// Whether the first, largest line is the border of a sheet rather than a piece with holes. It must
/// be a rectangle around all other lines. Also, either one of these contains lines or texts, or
/// several lie beside each other and are too large for holes.
/// @param texts  positions of texts
bool hasBorder(const std::vector<DrawnOutline>& lines, const std::vector<Eigen::Vector2d>& texts) {
    constexpr std::size_t kMaxCompared = 200;
    const DrawnOutline& outer = lines.front();
    if (lines.size() < 2 || !outer.isRectangle()) {
        return false;
    }
    double held = 0;
    int large = 0, side = 0;
    bool isAlone = true, isNested = false;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        if (!outer.holds(lines[k])) {
            return false;
        }
        isAlone = isAlone && lines[k].layer != outer.layer;
        bool isInner = false;
        for (std::size_t other = 1; other < std::min(k, kMaxCompared) && k < kMaxCompared;
             ++other) {
            isInner = isInner || lines[other].holds(lines[k]);
        }
        isNested = isNested || isInner ||
                   (k < kMaxCompared && std::ranges::any_of(texts, [&](const Eigen::Vector2d& at) {
                        return lines[k].box.contains(at) && geometry::isInside(lines[k].points, at);
                    }));
        side += isInner ? 0 : 1;
        held += isInner ? 0 : lines[k].area;
        large += lines[k].area > kLargeHole * outer.area ? 1 : 0;
    }
    const bool areLarge = held > kMaxHoles * outer.area || large > 1 || (isAlone && large > 0);
    const bool isSeamLine = lines.size() == 2 && held > kSeamLine * outer.area;
    return (isNested && !isSeamLine) || (side > 1 && areLarge);
}

/// Removes the borders of a sheet, and rectangles on their layer or in their corners.
/// @param lines  largest first
void takeBorders(std::vector<DrawnOutline>& lines, const std::vector<Eigen::Vector2d>& texts,
                 std::vector<Wording>& notes) {
    constexpr int kMaxBorders = 8;  // of one sheet; each costs a pass over all lines
    for (int k = 0; k < kMaxBorders && !lines.empty() && hasBorder(lines, texts); ++k) {
        const DrawnOutline border = lines.front();
        const bool isOwnLayer = std::ranges::all_of(lines, [&border](const DrawnOutline& line) {
            return line.layer != border.layer || line.isRectangle();
        });
        std::vector<DrawnOutline> rest;
        std::copy_if(
            lines.begin() + 1, lines.end(), std::back_inserter(rest),
            [&](const DrawnOutline& line) {
                return !line.isRectangle() ||
                       (line.sidesOn(border) < 2 && !(isOwnLayer && line.layer == border.layer));
            });
        if (rest.empty()) {
            rest.assign(lines.begin() + 1, lines.end());  // all pieces are rectangles
        }
        notes.push_back(
            worded("the border of the sheet is left out: %1 on layer \"%2\"",
                   {countWording(static_cast<long long>(lines.size() - rest.size()), "rectangle"),
                    Wording(readableName(border.layer))}));
        lines = std::move(rest);
    }
}

/// Adds a note for pieces with large holes, which may be pieces themselves.
void doubtHoles(const std::vector<FilePiece>& pieces, std::vector<Wording>& notes) {
    constexpr double kMinDoubt = 0.002;  // of a rectangle: a larger hole may be a small piece
    for (const FilePiece& piece : pieces) {
        const DrawnOutline outer(outlineOf(piece), {});
        double held = 0, largest = 0;
        for (const Points2& hole : piece.holes) {
            const double area = std::abs(geometry::signedAreaOf(hole));
            held += area;
            largest = std::max(largest, area);
        }
        if (held > kMaxHoles * outer.area ||
            (outer.isRectangle() && largest > kMinDoubt * outer.area)) {
            notes.push_back(
                worded("check %1: it has %2, which cover %3 % of it; if they are pieces, remove "
                       "the line around them from the drawing",
                       {Wording(piece.name),
                        countWording(static_cast<long long>(piece.holes.size()), "hole"),
                        figure(100 * held / outer.area, 1)}));
        }
    }
}

/// Pieces of a drawing: each outer line is a piece that owns everything inside it.
class DrawingPieces {
public:
    DrawingPieces(const std::vector<DxfEntity>& entities, const DxfPlace& place,
                  std::vector<Wording>& notes)
        : entities_(entities), place_(place), notes_(notes) {}

    std::vector<FilePiece> taken() {
        addOutlines(DxfRole::Cut);
        addOutlines(DxfRole::Sew);
        std::set<DxfRole> unread{DxfRole::Text,    DxfRole::Fold,         DxfRole::FineCut,
                                 DxfRole::FineSew, DxfRole::FineInternal, DxfRole::FineCutOut};
        if (pieces_.empty()) {
            addOutlines(DxfRole::Other);  // layers with unknown names
        } else {
            unread.insert(DxfRole::Other);
        }
        addOutlines(DxfRole::CutOut);
        DxfLeftOut left;
        left.addUnread(entities_, unread);
        for (const DxfEntity& entity : entities_) {
            addEntity(entity, left);
        }
        left.tell(notes_);
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            if (pieces_[k].name.empty()) {
                pieces_[k].name = "piece " + std::to_string(k + 1);
            }
        }
        doubtHoles(pieces_, notes_);
        return std::move(pieces_);
    }

private:
    FilePiece* around(const Eigen::Vector2d& point) {
        for (std::size_t k = 0; k < pieces_.size() && work_ < kMaxWork; ++k) {
            ++work_;
            if (!boxes_[k].contains(point)) {
                continue;
            }
            work_ += static_cast<double>(outlineOf(pieces_[k]).rows());
            if (geometry::isInside(outlineOf(pieces_[k]), point)) {
                return &pieces_[k];
            }
        }
        return nullptr;
    }

    /// Adds closed lines, largest first, so that outer lines come before those inside them.
    void addOutlines(DxfRole role) {
        std::vector<DrawnOutline> closed;
        DxfLayersAt layers;
        long long open = 0, beside = 0;
        for (const FileLine& line : dxfLines(entities_, role, place_, &layers)) {
            if (line.closed && line.points.rows() > 2) {
                closed.emplace_back(geometry::antiClockwise(line.points),
                                    layers[{line.points(0, 0), line.points(0, 1)}]);
            } else {
                ++open;
            }
        }
        std::ranges::stable_sort(closed, std::greater{}, &DrawnOutline::area);
        std::vector<Eigen::Vector2d> texts;
        for (const DxfEntity& entity : entities_) {
            if (const auto at = isText(entity) ? entity.point() : std::nullopt) {
                texts.push_back(placedPoint(entity, *at, place_));
            }
        }
        if (role != DxfRole::CutOut) {
            takeBorders(closed, texts, notes_);
        }
        for (const DrawnOutline& outline : closed) {
            const Points2& line = outline.points;
            FilePiece* const outer = around(line.row(0).transpose());
            if (outer && role == DxfRole::Sew && outer->sew.rows() == 0) {
                outer->sew = line;
            } else if (outer) {
                outer->holes.emplace_back(line.colwise().reverse());
            } else if (pieces_.size() < kMaxOutlines && role != DxfRole::CutOut) {
                FilePiece& piece = pieces_.emplace_back();
                (role == DxfRole::Sew ? piece.sew : piece.cut) = line;
                boxes_.push_back(outline.box);
            } else {
                ++beside;
            }
        }
        if (open > 0) {
            notes_.push_back(toile::worded("left out because they are not closed: %1",
                                           {countWording(open, "line")}));
        }
        if (beside > 0) {
            notes_.push_back(toile::worded(
                "left out because they are in no piece or not among the largest %2 outlines: %1",
                {countWording(beside, "closed line"), figure(1.0 * kMaxOutlines)}));
        }
    }

    /// The point that decides which piece contains the entity.
    std::optional<Eigen::Vector2d> placeOf(const DxfEntity& entity, DxfRole role) const {
        const auto line = isText(entity) ? std::nullopt : dxfCurve(entity, place_.scale);
        if (!line) {
            const auto point = entity.point(isText(entity) && entity.point(11) ? 11 : 10);
            return point ? std::optional(placedPoint(entity, *point, place_)) : std::nullopt;
        }
        if (role == DxfRole::Cut || role == DxfRole::Sew) {
            return place_.map * Eigen::Vector2d(line->points.colwise().mean().transpose());
        }
        return place_.map * Eigen::Vector2d(line->points.row(0).transpose());
    }

    void addEntity(const DxfEntity& entity, DxfLeftOut& left) {
        const DxfRole role = dxfRole(entity.layer);
        const std::vector<DxfEntity> alone{entity};
        std::vector<Wording> ignored;
        const bool isDetail = role == DxfRole::Internal || role == DxfRole::Notch ||
                              role == DxfRole::Drill || role == DxfRole::Grain;
        FilePiece inside;
        if (!isText(entity) && isDetail) {
            inside = dxfPiece(alone, place_, ignored);
        }
        const auto first = placeOf(entity, role);
        FilePiece* const piece = first ? around(*first) : nullptr;
        if (!piece) {
            if (!isText(entity) && isDetail) {
                left.add(DxfLeftOut::InNoPiece, entity);
            }
            return;
        }
        ++piece->layers[readableName(entity.layer)];
        if (isText(entity) && role == DxfRole::Text && piece->name.empty()) {
            piece->name = readableName(entity.text(1));
        }
        std::ranges::move(inside.internals, std::back_inserter(piece->internals));
        std::ranges::move(inside.notches, std::back_inserter(piece->notches));
        std::ranges::move(inside.drills, std::back_inserter(piece->drills));
        piece->grain = piece->grain ? piece->grain : inside.grain;
    }

    const std::vector<DxfEntity>& entities_;
    DxfPlace place_;
    std::vector<Wording>& notes_;
    double work_ = 0;
    std::vector<FilePiece> pieces_;
    std::vector<Eigen::AlignedBox2d> boxes_;
};

/// Whether a block is a layout, dimension or the like, which is never a piece.
bool isOfDrawing(const DxfBlock& block) {
    return block.name.starts_with('*') || block.name.starts_with('$');
}

/// Whether a block without a name is a sheet with pieces rather than a piece.
bool isSheet(const FilePiece& piece) {
    if (!piece.name.empty() || outlineOf(piece).rows() < 3) {
        return false;
    }
    std::vector<DrawnOutline> lines{{outlineOf(piece), {}}};
    for (const Points2& hole : piece.holes) {
        lines.emplace_back(geometry::antiClockwise(hole), std::string_view());
    }
    std::ranges::stable_sort(lines, std::greater{}, &DrawnOutline::area);
    return hasBorder(lines, {});
}

/// @param page  the entities outside of blocks, with INSERTs not replaced
std::vector<FilePiece> piecesOfBlocks(const DxfDocument& document,
                                      const std::vector<DxfEntity>& page, double unit,
                                      std::vector<Wording>& notes) {
    DxfLeftOut left;
    std::map<std::string_view, const DxfEntity*> inserts;
    std::set<std::string_view> known;
    for (const DxfBlock& block : document.blocks) {
        if (!isOfDrawing(block)) {
            known.insert(block.name);
        }
    }
    for (const DxfEntity& entity : page) {
        if (entity.kind == "INSERT" && known.contains(entity.text(2))) {
            if (!inserts.emplace(entity.text(2), &entity).second) {
                left.add(DxfLeftOut::InsertedAgain, entity);
            }
        } else if (entity.kind == "INSERT") {
            DxfEntity missing = entity;
            missing.kind = DxfBlockInserter::kMissingBlock;
            left.add(DxfLeftOut::KindNotRead, missing);
        } else if (!isText(entity)) {
            left.add(DxfLeftOut::InNoPiece, entity);
        }
    }
    std::vector<FilePiece> pieces;
    DxfBlockInserter inserter(document);
    for (const DxfBlock& block : document.blocks) {
        if (isOfDrawing(block)) {
            continue;
        }
        const auto insert = inserts.find(block.name);
        const DxfPlace place =
            placeOf(block, insert == inserts.end() ? nullptr : insert->second, unit);
        const std::vector<DxfEntity> entities = inserter.replaced(block.entities);
        std::vector<Wording> own;
        FilePiece piece = dxfPiece(entities, place, own);
        piece.id = readableName(block.name);
        if (isSheet(piece)) {
            own.clear();
            for (FilePiece& part : DrawingPieces(entities, place, own).taken()) {
                part.id = piece.id + " " + part.name;
                pieces.push_back(std::move(part));
            }
            std::ranges::move(own, std::back_inserter(notes));
            continue;
        }
        std::ranges::move(own, std::back_inserter(notes));
        left.addUnread(entities, {DxfRole::Other, DxfRole::Text});
        piece.name = piece.name.empty() ? nameOfBlock(piece.id, piece.size) : piece.name;
        if (const Wording fault = faultOf(piece); !fault.empty()) {
            notes.push_back(worded("%1 is left out: %2", {Wording(piece.id), fault}));
            continue;
        }
        pieces.push_back(std::move(piece));
    }
    if (!pieces.empty()) {
        left.tell(notes);
        doubtHoles(pieces, notes);
    }
    return pieces;
}

/// Reads blocks as pieces if one of them has a name or details of a piece, or if the drawing has no
/// outlines of its own; else reads their entities as part of the drawing.
std::vector<FilePiece> piecesOf(const DxfDocument& document, double unit,
                                std::vector<Wording>& notes) {
    DxfPlace place;
    place.scale = unit;
    place.map.linear() *= unit;
    std::vector<DxfEntity> page = document.entities;
    std::erase_if(page, [](const DxfEntity& entity) { return entity.number(67) == 1; });
    const auto hasOutline = [&](DxfRole role) {
        return std::ranges::any_of(dxfLines(page, role, place), &FileLine::closed);
    };
    const auto isDetail = [](const DxfEntity& entity) {
        const DxfRole role = dxfRole(entity.layer);
        return role == DxfRole::Sew || role == DxfRole::Notch || role == DxfRole::Grain ||
               role == DxfRole::Fold;
    };
    const bool arePieces = std::ranges::any_of(document.blocks, [&](const DxfBlock& block) {
        return !isOfDrawing(block) && (dxfFields(block.entities).contains("piece name") ||
                                       std::ranges::any_of(block.entities, isDetail));
    });
    std::vector<Wording> own;
    std::vector<FilePiece> pieces;
    if (arePieces ||
        !(hasOutline(DxfRole::Cut) || hasOutline(DxfRole::Sew) || hasOutline(DxfRole::Other))) {
        pieces = piecesOfBlocks(document, page, unit, own);
    }
    if (pieces.empty()) {
        own.clear();
        const std::vector<DxfEntity> entities = DxfBlockInserter(document).replaced(page);
        pieces = DrawingPieces(entities, place, own).taken();
    }
    if (const auto paper = document.entities.size() - page.size(); paper > 0) {
        own.push_back(worded("left out because they are on the printed sheet (paper space): %1",
                             {std::to_string(paper)}));
    }
    std::ranges::move(own, std::back_inserter(notes));
    return pieces;
}

std::string styleField(const DxfFields& fields, const char* key) {
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
}

/// The program and the standard of the file, as far as its texts tell.
Wording formatOf(const DxfDocument& document, const DxfFields& fields) {
    const std::string program = styleField(fields, "author") + ' ' + styleField(fields, "product");
    const auto names = [&program](std::string_view word) {
        return std::search(program.begin(), program.end(), word.begin(), word.end(),
                           [](char a, char b) { return lowered(a) == b; }) != program.end();
    };
    const bool isAstm = std::ranges::any_of(
        fields, [](const auto& field) { return field.first.starts_with("astm"); });
    std::set<std::string_view> layers;
    for (const DxfBlock& block : document.blocks) {
        for (const DxfEntity& entity : block.entities) {
            layers.insert(entity.layer);
        }
    }
    const bool hasQuality = layers.contains("84");
    const std::string standard = std::ranges::all_of(document.blocks, isOfDrawing) ? "drawing"
                                 : isAstm || hasQuality                            ? "ASTM"
                                                                                   : "AAMA";
    const std::string who = names("accumark") || names("gerber") ? "AccuMark"
                            : names("clo ") || names("clo virtual") || names("marvelous") ? "CLO"
                            : names("optitex") ? "Optitex"
                            : names("toile")   ? "Toile"
                                               : "";
    return who.empty() ? worded("DXF (%1)", {Wording(standard)})
                       : worded("DXF of %1 (%2)", {Wording(who), Wording(standard)});
}

}  // namespace

Result<PatternFile> readDxfPattern(std::string_view bytes, std::optional<FileUnit> stated) {
    const auto document = readDxfDocument(bytes);
    if (!document) {
        return document.error();
    }
    const DxfFields fields = dxfFields(document->entities);
    PatternFile file;
    file.notes = document->notes;
    file.format = formatOf(*document, fields);
    std::vector<Wording> ignored;
    if (stated) {
        file.unit = *stated;
    } else {
        if (auto tooMany = refusalOfCurves(*document, 1)) {
            return *std::move(tooMany);
        }
        // The unit is not known yet, so ends are joined as if it were mm; the extent does not
        // depend on that.
        const std::string unit = styleField(fields, "unit");
        const bool isExact =
            unit == symbol(LengthUnit::Millimetre) || unit == symbol(LengthUnit::Centimetre);
        const DxfUnit found = dxfUnit(*document, isExact ? unit : styleField(fields, "units"),
                                      extentOf(piecesOf(*document, 1, ignored)));
        file.unit = found.unit;
        file.unitReason = found.reason;
        file.unitInDoubt = found.inDoubt;
    }
    if (auto tooMany = refusalOfCurves(*document, millimetresPer(file.unit))) {
        return *std::move(tooMany);
    }
    file.pieces = piecesOf(*document, millimetresPer(file.unit), file.notes);
    std::erase_if(file.pieces, [](const FilePiece& piece) { return !faultOf(piece).empty(); });
    if (file.pieces.empty()) {
        return Error{ErrorCode::NoGeometry,
                     {},
                     worded("it has no closed line that could be a piece; export the outlines of "
                            "its pieces as closed lines")};
    }
    shareTexts(file.pieces);
    file.style = styleField(fields, "style name");
    file.sampleSize = styleField(fields, "sample size");
    std::set<std::string_view> known;
    for (const FilePiece& piece : file.pieces) {
        if (!piece.size.empty() && known.insert(piece.size).second) {
            file.sizes.push_back(piece.size);
        }
    }
    return file;
}

}  // namespace toile
