// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace toile::app {

class Document;
class FieldGuard;
class LengthEdit;
class PatternProof;
struct ProofPlan;

/// How a pattern is proved: what is sewn, what holds the cloth meanwhile, how finely it is divided.
class ProofForm : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the form.
    ProofForm(const Document& document, PatternProof& proof, QWidget* parent = nullptr);

    QWidget& firstField() const;

signals:
    /// A mesh to wear the pattern on is to be asked for.
    void bodyWanted();

private:
    void makeFields();
    void show();
    /// Changes the plan as somebody has said.
    template <class Change>
    void change(const Change& change);
    void chooseHolder(int choice);

    const Document& document_;
    PatternProof& proof_;
    FieldGuard* guard_;
    QComboBox *sewn_, *holder_;
    QDoubleSpinBox* pressure_;
    LengthEdit* edge_;
    QCheckBox *gravity_, *touching_;
    QLabel* cloth_;
};

}  // namespace toile::app
