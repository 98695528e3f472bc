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

/// Context menus of views and lists, for a piece, a seam or the ground. The object under the
/// pointer is selected first, unless it is already selected. A drag with the right button moves the
/// camera and opens no menu.
class WindowContextMenus : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    WindowContextMenus(QWidget& window, Document& document, const ActionRegistry& actions,
                       MaterialMenu& materials, ViewArea& views);

    /// Shows a menu of the table (menu_table.h) for the rows of a list.
    void serve(QAbstractItemView& list, const char* menu);

    /// Where "Dart here" puts the tip: the place on a flat piece where the menu was opened, or the
    /// worst spot marked there. Otherwise the spot with the ring, or the first marked spot of the
    /// selected piece.
    std::optional<WorstSpot> placeForDart() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// @param pointed  at the object under the pointer; otherwise the menu is for the selection
    void showInView(SceneView& view, const QPointF& at, bool pointed);
    void showOnRow(QAbstractItemView& list, const char* menu, const QPoint& at);
    void show(const char* menu, const QPoint& onScreen);

    QWidget& window_;
    Document& document_;
    const ActionRegistry& actions_;
    MaterialMenu& materials_;
    ViewArea& views_;
    QPointer<QMenu> shown_;
    std::optional<WorstSpot> pointed_;  ///< while the menu is open
};

}  // namespace toile::app
