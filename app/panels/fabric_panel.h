// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "app/document/document_change.h"
#include "core/garment/fabric.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QStackedWidget;

namespace toile::app {

class Document;
class FabricWatcher;
class FieldManners;
class PercentEdit;

/// What the garment is cut from: a preset, or limits that are typed. Below it, how much of the
/// garment goes beyond them. A change is a step of the history; nothing is flattened again.
class FabricPanel : public QWidget {
    Q_OBJECT

public:
    /// `document` must outlive the panel.
    explicit FabricPanel(Document& document, QWidget* parent = nullptr);

    /// Where the keyboard goes.
    QWidget& firstField() const;

signals:
    /// A piece is selected and to be shown.
    void pieceActivated();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// One end of one direction.
    struct Limit {
        StrainLimits Fabric::*direction;
        double StrainLimits::*end;
        PercentEdit* field;
    };

    QWidget* makeContents();
    void addLimits(QGridLayout& grid);
    PercentEdit* makeField(const char* name, const QString& label, const QString& tip);
    QLabel* makeNote(const QString& text);
    void addFit(QGridLayout& grid, int row);
    void onChanged(DocumentChanges what);
    void refresh();
    void showDirections();
    void showFit();
    void choosePreset(int index);
    void setLimit(const Limit& limit, double percent);
    void follow(const QString& link);

    Document& document_;
    FieldManners& manners_;
    FabricWatcher* watcher_;
    QStackedWidget* pages_;
    QComboBox* preset_;
    std::array<Limit, 6> limits_{};
    std::array<QLabel*, 3> directions_{}, shares_{};  ///< of warp, weft, bias
    QLabel *all_, *worst_;
    int gesture_ = -1;  ///< what is typed into one field, one after the other, is one step
};

/// What a fabric is called within a sentence: "jersey"; "custom" for one that is no preset.
QString fabricName(const Fabric& fabric);

}  // namespace toile::app
