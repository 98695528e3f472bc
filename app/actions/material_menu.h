// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMenu;
class QWidget;

namespace toile::app {

class Document;

/// What the selected pieces are cut from, as entries of menus: the garment's fabric and its other
/// materials.
class MaterialMenu : public QObject {
    Q_OBJECT

public:
    /// @param window  parent of the question. Both must outlive this.
    MaterialMenu(Document& document, QWidget& window, QObject* parent = nullptr);

    /// Puts the entries before the menu's last separator, now and whenever it is about to be shown.
    void fill(QMenu& menu);
    /// Asks for the name of another material for the selected pieces.
    void askForNew();

private:
    void refill(QMenu& menu);

    Document& document_;
    QWidget& window_;
};

}  // namespace toile::app
