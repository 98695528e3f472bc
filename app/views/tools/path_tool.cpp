// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/path_tool.h"

#include <QKeyEvent>
#include <algorithm>

#include "app/document/mirrored_edits.h"
#include "app/render/render_style.h"
#include "app/session/workspace.h"
#include "app/text/figures.h"
#include "app/views/tools/tool_paint.h"

namespace toile::app {

bool isSameQuestion(const DraftedCut& a, const DraftedCut& b) {
    return a.garment == b.garment && a.symmetry == b.symmetry && a.results == b.results &&
           a.cut == b.cut;
}

namespace {

/// A barycentric weight this near to 1 puts a point at a vertex.
constexpr double kAtVertex = 1 - 1e-9;

bool isEnter(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

}  // namespace

PathTool::PathTool(Workspace& workspace, PathFinder& finder, UserCut::Kind kind, std::size_t least)
    : workspace_(workspace),
      draft_(finder),
      kind_(kind),
      least_(least),
      images_(
          [](const DraftedCut& drawn) {
              return imageOfCut(*drawn.garment, drawn.results, *drawn.symmetry, drawn.cut);
          },
          [this](Attempt<std::optional<CutImage>> made, const DraftedCut&, bool isLast) {
              if (isLast && !draft_.isEmpty()) {
                  image_ = std::move(made.answer).value_or(std::nullopt);
                  emit changed();
              }
          }) {
    draft_.setClosed(kind == UserCut::Kind::Loop);
    connect(&draft_, &PathDraft::changed, this, &Tool::changed);
    connect(&draft_, &PathDraft::changed, this, &PathTool::finishWhenKnown);
    connect(&draft_, &PathDraft::changed, this, &PathTool::findImage);
}

std::optional<ClothPoint> PathTool::placeAt(const ToolView& view, const Pointer& pointer) {
    const auto& garment = workspace_.document().garment();
    if (garment && !draft_.isEmpty() && pointer.modifiers.testFlag(Qt::AltModifier)) {
        const auto hit = view.hitAt(pointer.at);
        return hit ? std::optional(ClothPoint{
                         hit->piece, {hit->face, hit->barycentric}, ClothPoint::On::Cloth, -1})
                   : std::nullopt;
    }
    return garment ? snapper_.find(view, *garment, pointer.at, draft_.points()) : std::nullopt;
}

bool PathTool::fits(const ClothPoint& point) const {
    return draft_.isEmpty() || (point.piece == draft_.points().front().piece &&
                                !samePlace(point.at, draft_.points().back().at));
}

void PathTool::add(const ClothPoint& point) {
    const auto& pieces = workspace_.document().garment()->pieces;
    draft_.setTip(std::nullopt);
    draft_.add(point, pieces[static_cast<std::size_t>(point.piece)]);
}

void PathTool::click(ToolView& view, const Pointer& pointer) {
    const auto place = placeAt(view, pointer);
    isMeant_ = false;
    if (!place || isFinishing_) {
        return;
    }
    if (draft_.isEmpty() && goesAround() && pointer.modifiers.testFlag(Qt::AltModifier)) {
        workspace_.cuts().cutAround(place->piece, place->at);
        return;
    }
    draft_.setAlongEdges(pointer.modifiers.testFlag(Qt::ControlModifier));
    const bool closes =
        kind_ == UserCut::Kind::Loop && place->on == ClothPoint::On::Own && place->own == 0;
    if (closes && hasEnough()) {
        finish();
    } else if (fits(*place) && remark(*place).isEmpty()) {
        add(*place);
        isMeant_ = true;
    } else {
        isMeant_ = !draft_.isEmpty() && place->piece == draft_.points().back().piece &&
                   samePlace(place->at, draft_.points().back().at);
    }
}

void PathTool::doubleClick(ToolView&, const Pointer&) {
    // The first of the two clicks has set the place, unless it was refused.
    if (isMeant_ && hasEnough()) {
        finish();
    }
}

void PathTool::hover(ToolView& view, const Pointer& pointer) {
    const auto place = placeAt(view, pointer);
    if (draft_.isEmpty()) {
        draft_.setAlongEdges(pointer.modifiers.testFlag(Qt::ControlModifier));
    }
    follow(view, pointer, place);
}

void PathTool::follow(ToolView& view, const Pointer& pointer, const std::optional<ClothPoint>& at) {
    if (isFinishing_) {
        return;
    }
    pointer_ = pointer.at;
    pointerView_ = view.kind();
    isInView_ = true;
    under_ = at;
    remark_.clear();
    if (at) {
        remark_ = !draft_.isEmpty() && at->piece != draft_.points().front().piece ? elsewhere()
                                                                                  : remark(*at);
    }
    draft_.setTip(at && !draft_.isEmpty() && remark_.isEmpty() ? at : std::nullopt);
    view.repaintSoon();  // handle and note appear in this view only
}

QString PathTool::elsewhere() const {
    return tr("a cut must stay on one piece");
}

void PathTool::leave(ToolView& view) {
    isInView_ = false;
    under_.reset();
    draft_.setTip(std::nullopt);
    view.repaintSoon();
}

bool PathTool::wants(const QKeyEvent& event) const {
    // Take Backspace even if nothing is left, or a held key would reach the window's shortcut.
    return event.key() == Qt::Key_Escape || event.key() == Qt::Key_Backspace ||
           (!draft_.isEmpty() && isEnter(event.key()));
}

void PathTool::key(ToolView&, const QKeyEvent& event) {
    if (event.key() == Qt::Key_Backspace) {
        isFinishing_ = false;
        draft_.removeLast();
    } else if (isEnter(event.key())) {
        if (hasEnough()) {
            finish();
        }
    } else if (draft_.isEmpty()) {
        emit finished();
    } else {
        cancel();
    }
}

void PathTool::cancel() {
    snapper_.keep(workspace_.document().garment().get());
    under_.reset();
    remark_.clear();
    isMeant_ = isFinishing_ = false;
    draft_.clear();
}

bool PathTool::bends() const {
    const auto& uncut = workspace_.document().garment()->uncut;
    return std::ranges::find(uncut, draft_.piece()) == uncut.end() && !draft_.alongEdges();
}

std::vector<Eigen::Vector3d> PathTool::cutPoints() {
    const Piece& piece = *draft_.piece();
    std::vector<Eigen::Vector3d> points;
    for (const ClothPoint& point : draft_.points()) {
        points.push_back(positionOf(piece.mesh, point.at));
    }
    if (!bends()) {
        return points;
    }
    // The cut is applied to the piece as it was before other cuts. Fix the points where the path
    // bends around the end of such a cut, or the new cut would cross it.
    const PieceRim& rim = snapper_.rim(draft_.piece());
    std::vector<Eigen::Vector3d> bent;
    std::size_t leg = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        bent.push_back(points[i]);
        if (leg >= draft_.legs().size() || !draft_.legs()[leg].path) {
            ++leg;
            continue;
        }
        const std::vector<SurfacePoint>& way = draft_.legs()[leg++].path->points;
        for (std::size_t k = 1; k + 1 < way.size(); ++k) {
            int corner = 0;
            if (way[k].barycentric.maxCoeff(&corner) > kAtVertex &&
                rim.isOnRim[static_cast<std::size_t>(piece.mesh.F(way[k].face, corner))] != 0) {
                bent.push_back(positionOf(piece.mesh, way[k]));
            }
        }
    }
    return bent;
}

void PathTool::finishWhenKnown() {
    if (isFinishing_ && !draft_.isSearching()) {
        finish();
    }
}

void PathTool::findImage() {
    const Document& document = workspace_.document();
    std::vector<ClothPoint> places = draft_.points();
    if (draft_.tip()) {
        places.push_back(*draft_.tip());
    }
    if (draft_.isEmpty() || places.size() < std::max<std::size_t>(least_, 2) ||
        !editSymmetry(document)) {
        image_.reset();
        return;
    }
    UserCut cut{{}, kind_, {}, draft_.alongEdges()};
    for (const ClothPoint& place : places) {
        cut.points.push_back(positionOf(draft_.piece()->mesh, place.at));
    }
    images_.ask({document.garment(), document.results(), document.derived().symmetry, cut});
}

void PathTool::finish() {
    draft_.setTip(std::nullopt);
    isFinishing_ = bends() && draft_.isSearching();
    if (isFinishing_) {
        return;
    }
    UserCut cut{{}, kindFor(draft_.points()), cutPoints(), draft_.alongEdges()};
    const int piece = draft_.points().front().piece;
    cancel();
    workspace_.cuts().add(std::move(cut), piece);
}

bool PathTool::isDetour() const {
    // The way half around a round tube is only about 1.6 times its diameter.
    constexpr double kDetour = 3;
    return !draft_.alongEdges() && std::ranges::any_of(draft_.legs(), [this](const auto& leg) {
        const MeshArrays& mesh = draft_.piece()->mesh;
        return leg.path &&
               leg.path->length >
                   kDetour * (positionOf(mesh, leg.to) - positionOf(mesh, leg.from)).norm();
    });
}

void PathTool::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    if (image_) {
        paintClothLine(view, painter, style, image_->piece, image_->line.points,
                       {style.seam, false});
    }
    draft_.paint(view, painter, style, style.seam);
    if (under_ && remark_.isEmpty()) {
        paintHandle(view, painter, style, *under_, style.seam, false);
    }
    if (!isInView_ || view.kind() != pointerView_) {
        return;
    }
    QStringList note;
    if (!remark_.isEmpty()) {
        note << remark_;
    } else if (const auto length = draft_.length(); length && *length > 0) {
        note << lengthWithUnit(*length);
        if (isDetour()) {
            note << tr("much longer than a straight line; check the layer");
        }
    }
    paintNote(painter, style, pointer_, note);
}

}  // namespace toile::app
