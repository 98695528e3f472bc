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

/// A line to type into and the commands that fit, in the upper middle of the window. The keyboard
/// stays in the line: arrows and page keys move through the list, Enter runs, Esc closes, as does
/// a click elsewhere.
class CommandPalette : public QFrame {
    Q_OBJECT

public:
    /// Of a row: where else it is found, its keys, and the places of the letters that were matched.
    enum Role { PlaceRole = Qt::UserRole, KeysRole, LettersRole };

    /// @param parent the window to lie over
    explicit CommandPalette(QWidget* parent);

    /// Opens with nothing typed.
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
