// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "app/base/worker.h"
#include "app/document/document_change.h"
#include "app/render/overlay_values.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QStackedWidget;

namespace toile::app {

class Document;
struct DocumentState;
class FieldGuard;
class LengthEdit;
class PercentEdit;

/// What the garment is cut from, and what pieces of another material are: not stated, a preset, or
/// limits that are typed. Below it, how much of the
/// garment goes beyond them: of a small one at once; that of a large one is worked out on another
/// thread and comes a moment later. A change is a step of the history; nothing is flattened again.
class FabricPanel : public QWidget {
    Q_OBJECT

public:
    using FitWork = std::function<std::optional<FabricFit>(const FabricQuestion&)>;

    /// `document` must outlive the panel.
    explicit FabricPanel(Document& document, QWidget* parent = nullptr,
                         const FitWork& work = fabricFit);

    /// Where the keyboard goes.
    QWidget& firstField() const;
    /// None where nothing is flat; of an earlier fabric or grain while `isUpToDate` is false.
    const std::optional<FabricFit>& fit() const { return fit_; }
    bool isUpToDate() const { return !answerer_.isBusy(); }

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
    void addCloth(QGridLayout& grid, int row);
    void addLimits(QGridLayout& grid);
    PercentEdit* makeField(const char* name, const QString& label, const QString& tip);
    QLabel* makeNote(const QString& text);
    void addFit(QGridLayout& grid, int row);
    void onChanged(DocumentChanges what);
    void refresh();
    void showDirections();
    /// How much of the cloth that is shown the arrangement takes.
    void showNeed();
    void askForFit();
    void setFit(const std::optional<FabricFit>& fit, const QString& problem = {});
    void showFit();
    void showMaterials();
    /// What is shown, of this state: the garment's own fabric, or that of a material.
    Fabric& shownFabric(DocumentState& state) const;
    void choosePreset(int index);
    void setLimit(const Limit& limit, double percent);
    void setWidth(double millimetres);
    void follow(const QString& link);

    Document& document_;
    FieldGuard& fieldGuard_;
    QStackedWidget* pages_;
    QLabel* materialTitle_;
    QComboBox *material_, *preset_;
    std::string shown_{};  ///< the material; empty: the garment's own fabric
    std::array<Limit, 6> limits_{};
    std::array<QLabel*, 3> directions_{}, shares_{};   ///< of warp, weft, bias
    std::vector<QWidget*> limitWidgets_, fitWidgets_;  ///< nothing to see where none is stated
    QLabel *all_, *worst_, *unstated_ = nullptr, *need_ = nullptr;
    LengthEdit* width_ = nullptr;
    int gesture_ = -1;  ///< what is typed into one field, one after the other, is one step
    std::optional<FabricFit> fit_;
    QString problem_;  ///< why the fit could not be worked out
    Answerer<FabricQuestion, std::optional<FabricFit>> answerer_;
};

}  // namespace toile::app
