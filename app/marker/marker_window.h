// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "app/marker/marker_desk.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace toile::app {

class ClothView;
class MarkerForm;
class Preferences;
struct FileDialogs;

/// Lays the pieces on their cloth. Non-modal; follows the document, stores its settings there, and
/// stops when closed.
class MarkerWindow : public QDialog {
    Q_OBJECT

public:
    /// All must outlive this.
    MarkerWindow(Workspace& workspace, Preferences& preferences, FileDialogs& files,
                 QWidget* parent);
    ~MarkerWindow() override;

    MarkerDesk& desk() { return desk_; }
    ClothView& view() { return *view_; }

    void reject() override;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QLayout* makeFigures();
    QLayout* makeButtons();
    void refresh();
    QString figuresText() const;
    QString detailsText() const;
    QString notesText() const;
    void say(const QString& sentence);
    void chooseHides();
    void save();

    Preferences& preferences_;
    FileDialogs& files_;
    MarkerDesk desk_;
    MarkerForm* form_;
    ClothView* view_;
    QLabel *figures_, *details_, *notes_, *said_;
    QDoubleSpinBox* rate_;
    QPushButton *improve_, *again_, *save_;
};

}  // namespace toile::app
