// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>
#include <vector>

#include "app/widgets/command_search.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace toile::app {

/// A text field and the matching commands, near the top of the window. The focus stays in the
/// field: arrows and page keys move through the list, Enter runs a command, and Esc or a click
/// elsewhere closes the palette.
class CommandPalette : public QFrame {
    Q_OBJECT

public:
    /// Item data of a row: its menu path, its keys, and the indices of the matched letters.
    enum Role { PlaceRole = Qt::UserRole, KeysRole, LettersRole };

    /// @param parent  the window that the palette covers
    explicit CommandPalette(QWidget* parent);

    /// Opens with an empty field.
    void open(std::vector<Command> commands);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void updateList();
    void updatePlace();
    void updateTip();
    bool pressKey(int key);
    void moveBy(int rows);
    void runCurrent();
    void closeAndGiveBack();

    std::vector<Command> commands_;
    std::vector<FoundCommand> found_;
    QLineEdit* line_;
    QListWidget* list_;
    QLabel* tip_;
    QPointer<QWidget> focusBefore_;
};

}  // namespace toile::app
