// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/widgets/setting_fields.h"
#include "core/prove/proof_settings.h"

class QComboBox;

namespace toile::app {

class Document;
class PatternProof;

/// The settings of a proof, with measured values of the cloth in a collapsible part. Each change is
/// one undo step.
class ProofForm : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the form.
    ProofForm(Document& document, PatternProof& proof, QWidget* parent = nullptr);

    QWidget& firstField() const;

signals:
    /// The user wants to choose the mesh of a body.
    void bodyWanted();

private:
    void makeChoices();
    void makeFold();
    void show();
    void showUnit(const ProofPlan& plan);
    void take(const SettingChange& change);
    void chooseHolder(int choice);
    void chooseUnit(int choice);

    Document& document_;
    PatternProof& proof_;
    SettingFields fields_;
    QFormLayout* form_;
    QComboBox *holder_, *unit_;
    QLabel* cloth_;
    QToolButton* fold_;
    QWidget* measured_;
};

}  // namespace toile::app
