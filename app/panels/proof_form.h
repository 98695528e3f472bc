// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/prove/proof_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QToolButton;

namespace toile::app {

class Document;
class FieldGuard;
class LengthEdit;
class PatternProof;
class StiffnessForm;

/// How a pattern is proved: what is sewn, what holds the cloth meanwhile, how finely it is divided;
/// below a fold what has been measured of the cloth. What is changed is a step of the history.
class ProofForm : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the form.
    ProofForm(Document& document, PatternProof& proof, QWidget* parent = nullptr);

    QWidget& firstField() const;

signals:
    /// A mesh to wear the pattern on is to be asked for.
    void bodyWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeFields();
    void makeCloth();
    void connectFields();
    void show();
    void showUnit(const ProofPlan& plan);
    void showCloth();
    /// Changes the plan as somebody has said, by a step of this name. What is changed in a field is
    /// one step until it is entered again.
    template <class Change>
    void change(const QString& text, const Change& change, int gesture = -1);
    void chooseHolder(int choice);

    Document& document_;
    PatternProof& proof_;
    FieldGuard* guard_;
    QFormLayout* form_;
    QComboBox *sewn_, *holder_, *unit_;
    QDoubleSpinBox* pressure_;
    LengthEdit *edge_, *thickness_;
    QCheckBox *gravity_, *touching_;
    QLabel* cloth_;
    QToolButton* fold_;
    StiffnessForm* stiffness_;
    int gesture_ = -1;
};

}  // namespace toile::app
