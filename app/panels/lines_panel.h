// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/document_change.h"
#include "app/document/line_facts.h"

class QCheckBox;
class QLabel;

namespace toile::app {

class AllowanceForm;
class AngleEdit;
class DartForm;
class Document;
class FieldGuard;
class LabelForm;
class LengthEdit;
class SeamEndsList;
class SegmentForm;

/// How the lines of the pattern are drawn: fair or exact, true at the ends of seams, with seam
/// allowances and notches, and what is said of the selected dart and segment. Works out segments
/// and kinks only while it is seen.
class LinesPanel : public QWidget {
    Q_OBJECT

public:
    /// The document must outlive the panel.
    explicit LinesPanel(Document& document, QWidget* parent = nullptr);

    /// Where the keyboard goes.
    QWidget& firstField() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeSettings();
    void onChanged(DocumentChanges what);
    void refresh();
    void showSettings();
    void showStraying();
    void showSelected();
    void setFair(bool fair);
    void setFairing(double Fairing::*field, double value, const QString& text);
    void setTrueing(bool trued);
    void setTrueBelow(double degrees);

    Document& document_;
    FieldGuard* fieldGuard_;
    QCheckBox *fair_, *true_;
    LengthEdit *tolerance_, *smoothing_;
    AngleEdit* trueBelow_;
    QLabel* straying_;
    AllowanceForm* allowance_;
    LabelForm* label_;
    SeamEndsList* ends_;
    DartForm* dart_;
    SegmentForm* segment_;
    LineFacts facts_;
    int gesture_ = -1;
    bool isStale_ = true;
};

}  // namespace toile::app
