// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMenu;
class QWidget;

namespace toile::app {

class Document;

/// Menu entries for the material of the selected pieces: the garment's fabric and its other
/// materials.
class MaterialMenu : public QObject {
    Q_OBJECT

public:
    /// @param window  parent of the dialog. Both must outlive this object.
    MaterialMenu(Document& document, QWidget& window, QObject* parent = nullptr);

    /// Puts the entries before the menu's last separator, now and before the menu is shown.
    void fill(QMenu& menu);
    /// Asks for the name of a new material for the selected pieces.
    void askForNew();

private:
    void refill(QMenu& menu);

    Document& document_;
    QWidget& window_;
};

}  // namespace toile::app
