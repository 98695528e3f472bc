// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/dxf_pattern.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/geometry/polygon.h"
#include "core/reading/dxf_document.h"
#include "core/reading/dxf_piece.h"
#include "core/reading/dxf_unit.h"

namespace toile {
namespace {

constexpr double kFarthestFactor = 1e9;      // of an INSERT
constexpr std::size_t kMostOutlines = 2000;  // of a drawing without blocks
constexpr double kMostWork = 5e8;  // points looked at to find in which piece things of it lie

/// A block as it is placed: by the first INSERT of it, or as it stands.
DxfPlace placeOf(const DxfBlock& block, const DxfEntity* insert, double unit) {
    DxfPlace place;
    place.scale = unit;
    place.map.linear() *= unit;
    if (!insert) {
        return place;
    }
    const auto factor = [insert](int code) {
        const double value = insert->number(code).value_or(1);
        return value != 0 && std::abs(value) < kFarthestFactor ? value : 1;
    };
    const double turn = std::fmod(insert->number(50).value_or(0), 360.0) * kDegree;
    const Eigen::Matrix2d linear = Eigen::Rotation2Dd(turn).toRotationMatrix() *
                                   Eigen::Vector2d(factor(41), factor(42)).asDiagonal();
    place.map.linear() = unit * linear;
    place.map.translation() =
        unit * (insert->point().value_or(Eigen::Vector2d(0, 0)) - linear * block.base);
    place.scale = unit * std::abs(factor(41));
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

/// What is wrong with a piece so that it is left out; empty: nothing.
Wording faultOf(const FilePiece& piece) {
    const Points2& outline = outlineOf(piece);
    if (outline.rows() < 3) {
        return worded("it has no closed outline");
    }
    return std::abs(geometry::signedAreaOf(outline)) > 0 ? Wording()
                                                         : worded("its outline has no area");
}

/// The end of a name that only says the size again: "front_36".
std::string nameOfBlock(const std::string& block, const std::string& size) {
    for (const char* joint : {"_", "-"}) {
        const std::string ending = joint + size;
        if (!size.empty() && block.size() > ending.size() && block.ends_with(ending)) {
            return block.substr(0, block.size() - ending.size());
        }
    }
    return block;
}

std::vector<FilePiece> piecesOfBlocks(const DxfDocument& document, double unit,
                                      std::vector<Wording>& notes) {
    std::map<std::string_view, const DxfEntity*> inserts;
    for (const DxfEntity& entity : document.entities) {
        if (entity.kind == "INSERT") {
            inserts.emplace(entity.text(2), &entity);
        }
    }
    std::vector<FilePiece> pieces;
    for (const DxfBlock& block : document.blocks) {
        if (block.name.starts_with('*') || block.name.starts_with('$')) {
            continue;  // of the drawing itself
        }
        const auto insert = inserts.find(block.name);
        FilePiece piece = dxfPiece(
            block.entities,
            placeOf(block, insert == inserts.end() ? nullptr : insert->second, unit), notes);
        piece.id = readableName(block.name);
        piece.name = piece.name.empty() ? nameOfBlock(piece.id, piece.size) : piece.name;
        if (const Wording fault = faultOf(piece); !fault.empty()) {
            notes.push_back(worded("%1 is left out: %2", {Wording(piece.id), fault}));
            continue;
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

/// What one size says of a piece holds for the others that say nothing.
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

/// A drawing: outer lines are pieces, what lies in one belongs to it.
class DrawingPieces {
public:
    DrawingPieces(const DxfDocument& document, double unit) : document_(document) {
        place_.scale = unit;
        place_.map.linear() *= unit;
    }

    std::vector<FilePiece> taken() {
        addOutlines(DxfRole::Cut);
        addOutlines(DxfRole::Sew);
        if (pieces_.empty()) {
            addOutlines(DxfRole::Other);  // names that say nothing
        }
        for (const DxfEntity& entity : document_.entities) {
            addEntity(entity);
        }
        for (std::size_t k = 0; k < pieces_.size(); ++k) {
            if (pieces_[k].name.empty()) {
                pieces_[k].name = "piece " + std::to_string(k + 1);
            }
        }
        return std::move(pieces_);
    }

private:
    FilePiece* around(const Eigen::Vector2d& point) {
        for (std::size_t k = 0; k < pieces_.size() && work_ < kMostWork; ++k) {
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

    /// Largest first, so that what is inside comes after what it is in.
    void addOutlines(DxfRole role) {
        std::vector<Points2> closed;
        for (const FileLine& line : dxfLines(document_.entities, role, place_)) {
            if (line.closed && line.points.rows() > 2) {
                closed.push_back(geometry::antiClockwise(line.points));
            }
        }
        std::ranges::stable_sort(closed, [](const Points2& a, const Points2& b) {
            return geometry::signedAreaOf(a) > geometry::signedAreaOf(b);
        });
        for (const Points2& line : closed) {
            FilePiece* const outer = around(line.row(0).transpose());
            if (outer && role == DxfRole::Sew && outer->sew.rows() == 0) {
                outer->sew = line;
            } else if (outer) {
                outer->holes.emplace_back(line.colwise().reverse());
            } else if (pieces_.size() < kMostOutlines) {
                FilePiece& piece = pieces_.emplace_back();
                (role == DxfRole::Sew ? piece.sew : piece.cut) = line;
                boxes_.push_back(boxOfOutline(piece));
            }
        }
    }

    /// By which it is in a piece.
    static std::optional<Eigen::Vector2d> placeOf(const DxfEntity& entity, DxfRole role) {
        if (entity.points.rows() == 0) {
            const bool isText = entity.kind == "TEXT" || entity.kind == "MTEXT";
            return entity.point(isText && entity.point(11) ? 11 : 10);
        }
        if (role == DxfRole::Cut || role == DxfRole::Sew) {
            return entity.points.colwise().mean().transpose();  // its points are on the edge
        }
        return entity.points.row(0).transpose();
    }

    void addEntity(const DxfEntity& entity) {
        const DxfRole role = dxfRole(entity.layer);
        const std::vector<DxfEntity> alone{entity};
        std::vector<Wording> ignored;
        const bool isText = entity.kind == "TEXT" || entity.kind == "MTEXT";
        FilePiece inside;
        if (!isText && (role == DxfRole::Internal || role == DxfRole::Notch ||
                        role == DxfRole::Drill || role == DxfRole::Grain)) {
            inside = dxfPiece(alone, place_, ignored);
        }
        const auto first = placeOf(entity, role);
        FilePiece* const piece = first ? around(place_.map * *first) : nullptr;
        if (!piece) {
            return;
        }
        ++piece->layers[readableName(entity.layer)];
        if (isText && role == DxfRole::Text && piece->name.empty()) {
            piece->name = readableName(entity.text(1));
        }
        std::ranges::move(inside.internals, std::back_inserter(piece->internals));
        std::ranges::move(inside.notches, std::back_inserter(piece->notches));
        std::ranges::move(inside.drills, std::back_inserter(piece->drills));
        piece->grain = piece->grain ? piece->grain : inside.grain;
    }

    const DxfDocument& document_;
    DxfPlace place_{};
    double work_ = 0;
    std::vector<FilePiece> pieces_;
    std::vector<Eigen::AlignedBox2d> boxes_;
};

std::string styleField(const DxfFields& fields, const char* key) {
    const auto found = fields.find(key);
    return found == fields.end() ? std::string() : found->second;
}

/// Who wrote it, and after which standard, as far as its texts tell.
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
    const std::string standard = document.blocks.empty() ? "drawing"
                                 : isAstm || hasQuality  ? "ASTM"
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
    const auto read = [&document](double unit, std::vector<Wording>& notes) {
        std::vector<FilePiece> pieces = piecesOfBlocks(*document, unit, notes);
        return pieces.empty() ? DrawingPieces(*document, unit).taken() : std::move(pieces);
    };
    PatternFile file;
    file.format = formatOf(*document, fields);
    std::vector<Wording> ignored;
    if (stated) {
        file.unit = *stated;
    } else {
        // How near ends must be is said in mm: what is found of the size in the file's own unit
        // does not hang on it.
        const DxfUnit found =
            dxfUnit(*document, styleField(fields, "units"), extentOf(read(1, ignored)));
        file.unit = found.unit;
        file.unitReason = found.reason;
        file.unitInDoubt = found.inDoubt;
    }
    file.pieces = read(millimetresPer(file.unit), file.notes);
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
