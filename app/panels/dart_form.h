// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "core/pattern/dart_places.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace toile::app {

class AngleEdit;
class Document;
class FieldGuard;
class LengthEdit;

/// The dart that is selected: how wide it opens at its mouth, as a length or as the angle at its
/// tip, and over which leg it is laid. Hidden where no dart is selected. Says what is to be said
/// of it.
class DartForm : public QWidget {
    Q_OBJECT

public:
    DartForm(Document& document, FieldGuard& guard, QWidget* parent = nullptr);

    /// Shows what is selected now.
    void refresh();

signals:
    /// A decision about a dart. @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeRows(FieldGuard& guard);
    /// As it lies in the pattern now.
    std::optional<double> drawnIntake() const;
    /// Its legs with the lengths that they are to have in the pattern.
    DartPlace asDrawn() const;
    /// Intake and lay as the document has them.
    void showSaid();
    void setIntake(std::optional<double> intake);
    /// Why no dart with these legs opens so wide; empty where one does.
    QString refusalOf(double intake) const;
    void setLay(int row);

    Document& document_;
    QLabel *title_, *legs_, *refusal_;
    LengthEdit* intake_;
    AngleEdit* angle_;
    QToolButton* asItLies_;
    QComboBox* lay_;
    int gesture_ = -1;
    int dart_ = -1;      ///< index into Garment::seams
    DartPlace place_{};  ///< in 3D
    DartPlace drawn_{};  ///< the same in the pattern
};

}  // namespace toile::app
