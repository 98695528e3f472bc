// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QObject>
#include <QPointer>
#include <optional>

#include "app/render/overlay_figures.h"

class QAbstractItemView;

namespace toile::app {

class ActionRegistry;
class Document;
class MaterialMenu;
class SceneView;
class ViewArea;

/// What the right button and the menu key show: what can be done with the piece or the seam that is
/// meant, or with the ground beside all. What is under the pointer is selected first, unless it
/// belongs to the selection; a drag with the right button moves the camera and shows none.
class WindowContextMenus : public QObject {
    Q_OBJECT

public:
    /// All must outlive this.
    WindowContextMenus(QWidget& window, Document& document, const ActionRegistry& actions,
                       MaterialMenu& materials, ViewArea& views);

    /// Shows one of the table's menus (menu_table.h) on the rows of a list.
    void serve(QAbstractItemView& list, const char* menu);

    /// Where a dart is meant to end: the place on a flat piece that the menu was asked for, or the
    /// worst place nearest to it where that one is marked; else the place with the ring, else the
    /// first marked one of the selected piece.
    std::optional<WorstSpot> placeForDart() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// @param pointed  at what lies under the pointer; else what is selected is meant
    void showInView(SceneView& view, const QPointF& at, bool pointed);
    void showOnRow(QAbstractItemView& list, const char* menu, const QPoint& at);
    void show(const char* menu, const QPoint& onScreen);

    QWidget& window_;
    Document& document_;
    const ActionRegistry& actions_;
    MaterialMenu& materials_;
    ViewArea& views_;
    QPointer<QMenu> shown_;
    std::optional<WorstSpot> pointed_;  ///< as long as the menu is there
};

}  // namespace toile::app
