// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/garment/fabric_stiffness.h"
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
class StatedEdit;

/// How a cloth resists and what it weighs, as far as somebody has measured it.
class StiffnessForm : public QWidget {
    Q_OBJECT

public:
    /// @param guard  must outlive the form
    explicit StiffnessForm(FieldGuard& guard, QWidget* parent = nullptr);

    /// @param usual  of the fabric, which holds where nothing is stated; none: of several
    void showStated(const StatedStiffness& stated, const std::optional<ClothStiffness>& usual);

signals:
    /// Somebody wants it to be so.
    /// @param isFirst  whether the field has been entered since the last
    void wanted(const toile::StatedStiffness& stated, bool isFirst);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// One of them, and its field.
    struct Row {
        std::optional<double> StatedStiffness::*stated;
        double ClothStiffness::*usual;
        double unit;  ///< of the field
        StatedEdit* field;
    };

    void add(const QString& name, const char* objectName, const QString& toolTip, Row row);
    void state(const Row& row);

    FieldGuard& guard_;
    std::vector<Row> rows_;
    StatedStiffness stated_;  ///< as it is shown
    bool isFirst_ = true;
};

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
