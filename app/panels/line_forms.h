// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "core/pattern/dart_places.h"
#include "core/pattern/line_settings.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace toile::app {

class AngleEdit;
class Document;
class FieldGuard;
class LengthEdit;

/// Seam allowances by kind, and notches, for all pieces. Emits `wanted` with the new settings.
class AllowanceForm : public QWidget {
    Q_OBJECT

public:
    AllowanceForm(Document& document, FieldGuard& guard, QWidget* parent = nullptr);

    /// Shows the settings of the document.
    void refresh();

signals:
    /// @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeRows(FieldGuard& guard);
    void setAllowance(bool has);
    void setWidth(double AllowanceWidths::*field, double width, const QString& text);
    void setNotched(bool notched);
    void setForm(int row);
    void setDepth(double depth);
    /// Those of the document; where it has none those it had, as the fields have them.
    NotchRules rules() const;

    Document& document_;
    QCheckBox *allowance_, *notched_;
    LengthEdit *seams_, *hems_, *depth_;
    QComboBox* form_;
    NotchRules rules_{};  ///< that were there last: what was placed by hand comes back with them
    int gesture_ = -1;
};

/// Size and date on the labels of all pieces. Emits `wanted` with the new settings.
class LabelForm : public QWidget {
    Q_OBJECT

public:
    explicit LabelForm(Document& document, QWidget* parent = nullptr);

    /// Shows what the document says now.
    void refresh();

signals:
    /// @param gesture  as for Document::edit
    void wanted(const toile::LineSettings& lines, const QString& text, int gesture);

private:
    void take(std::string LabelTexts::*field, const QString& typed, const QString& text);

    Document& document_;
    QLineEdit *size_, *date_;
};

/// The selected dart: its width as a length or as the angle at its tip, and the leg that it is
/// folded to. Hidden if no dart is selected. Emits `wanted` with the new settings.
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
