// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_context_menus.h"

#include <QAbstractItemView>
#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QTimer>
#include <algorithm>

#include "app/document/document.h"
#include "app/views/feature_at.h"
#include "app/views/garment_view.h"
#include "app/views/pattern_view.h"
#include "app/views/view_area.h"
#include "app/window/window_menus.h"

namespace toile::app {

namespace {

constexpr auto kPieceMenu = "pieceContext", kSeamMenu = "seamContext",
               kGroundMenu = "groundContext";

/// Selects the object under the pointer, preferring a line to its piece. @return its menu
const char* selectAt(const SceneView& view, Document& document, const QPointF& at) {
    const auto feature = document.scene() ? featureAt(view, document, at) : std::nullopt;
    if (!feature) {
        return kGroundMenu;
    }
    if (feature->kind == Feature::Kind::Seam) {
        document.setSeam(feature->seam);
        return kSeamMenu;
    }
    if (!document.isSelected(feature->piece)) {
        document.setSelection({feature->piece});
    }
    return kPieceMenu;
}

/// The place on a flat piece under the pointer, or the worst spot if its mark is there.
std::optional<WorstSpot> placeAt(const SceneView& view, const Document& document,
                                 const QPointF& at) {
    constexpr double kOnMark = 12;  // pixels
    if (auto spot = view.markedSpotAt(at, kOnMark)) {
        return spot;
    }
    const auto hit = view.hitAt(at);
    const PieceResult* result = hit ? document.result(hit->piece) : nullptr;
    if (!result || !result->flat || !document.isCurrent()) {
        return std::nullopt;
    }
    WorstSpot place;
    place.piece = hit->piece;
    place.flat =
        flatPositionOf(result->flat->Q, result->piece->mesh.F, {hit->face, hit->barycentric})
            .transpose();
    return place;
}

const char* menuOfSelection(const Document& document) {
    return !document.selection().empty() ? kPieceMenu : document.seam() ? kSeamMenu : kGroundMenu;
}

}  // namespace

WindowContextMenus::WindowContextMenus(QWidget& window, Document& document,
                                       const ActionRegistry& actions, MaterialMenu& materials,
                                       ViewArea& views)
    : window_(window),
      document_(document),
      actions_(actions),
      materials_(materials),
      views_(views) {
    for (SceneView* view :
         std::initializer_list<SceneView*>{views.garmentView(), views.patternView()}) {
        if (view) {
            view->installEventFilter(this);
            connect(
                view, &SceneView::menuWanted, this,
                [this, view](const QPointF& at, bool pointed) { showInView(*view, at, pointed); });
        }
    }
}

void WindowContextMenus::serve(QAbstractItemView& list, const char* menu) {
    list.installEventFilter(this);
    list.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&list, &QWidget::customContextMenuRequested, this,
            [this, &list, menu](const QPoint& at) { showOnRow(list, menu, at); });
}

bool WindowContextMenus::eventFilter(QObject* watched, QEvent* event) {
    // Shift+F10 opens the menu, too. Not every platform sends a context menu event for it.
    if (event->type() == QEvent::KeyPress) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (key.key() == Qt::Key_F10 && key.modifiers() == Qt::ShiftModifier) {
            auto* widget = static_cast<QWidget*>(watched);
            const QPoint middle = widget->rect().center();
            QContextMenuEvent asked(QContextMenuEvent::Keyboard, middle,
                                    widget->mapToGlobal(middle));
            QCoreApplication::sendEvent(widget, &asked);
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

void WindowContextMenus::showInView(SceneView& view, const QPointF& at, bool pointed) {
    if (!document_.garment()) {
        return;
    }
    pointed_ = pointed ? placeAt(view, document_, at) : std::nullopt;
    const char* menu = pointed ? selectAt(view, document_, at) : menuOfSelection(document_);
    show(menu, view.mapToGlobal(at.toPoint()));
}

std::optional<WorstSpot> WindowContextMenus::placeForDart() const {
    if (pointed_ && document_.isSelected(pointed_->piece)) {
        return pointed_;
    }
    const auto isOfSelected = [this](const WorstSpot& spot) {
        return document_.isSelected(spot.piece);
    };
    if (auto ring = views_.shownSpot(); ring && isOfSelected(*ring)) {
        return ring;
    }
    const SceneView* pattern = views_.patternView();
    if (pattern) {
        const auto found = std::ranges::find_if(pattern->spots().spots, isOfSelected);
        if (found != pattern->spots().spots.end()) {
            return *found;
        }
    }
    return std::nullopt;
}

void WindowContextMenus::showOnRow(QAbstractItemView& list, const char* menu, const QPoint& at) {
    const QModelIndex under = list.indexAt(at);
    const QModelIndex meant = under.isValid() ? under : list.currentIndex();
    if (!meant.isValid() || !list.selectionModel()->hasSelection()) {
        return;
    }
    const QPoint place = under.isValid() ? at : list.visualRect(meant).bottomLeft();
    pointed_.reset();
    show(menu, list.viewport()->mapToGlobal(place));
}

void WindowContextMenus::show(const char* menu, const QPoint& onScreen) {
    if (shown_ && shown_->isVisible()) {
        return;  // the key arrived twice
    }
    shown_ = makeContextMenu(menu, actions_, materials_, &window_);
    shown_->setAttribute(Qt::WA_DeleteOnClose);
    connect(shown_, &QMenu::aboutToHide, this, [this] {
        // The chosen action runs after aboutToHide, so reset later.
        QTimer::singleShot(0, this, [this] { pointed_.reset(); });
    });
    shown_->popup(onScreen);
}

}  // namespace toile::app
