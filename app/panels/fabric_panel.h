// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "app/base/worker.h"
#include "app/render/overlay_values.h"
#include "app/widgets/setting_fields.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QStackedWidget;

namespace toile::app {

class Document;
class DocumentChange;
struct DocumentState;

/// The fabric of the garment and of other materials: not stated, a preset, or limits that the user
/// types. Below it, how much of the garment exceeds them: for a small garment at once, for a large
/// one a moment later, from another thread. A change is a step of the history; no piece is
/// flattened again.
class FabricPanel : public QWidget {
    Q_OBJECT

public:
    using FitWork = std::function<std::optional<FabricFit>(const FabricQuestion&)>;

    /// `document` must outlive the panel.
    explicit FabricPanel(Document& document, QWidget* parent = nullptr,
                         const FitWork& work = fabricFit);

    QWidget& firstField() const;
    /// None if no piece is flat; of an earlier fabric or grain while `isUpToDate` is false.
    const std::optional<FabricFit>& fit() const { return fit_; }
    bool isUpToDate() const { return !follower_.isBusy(); }

signals:
    /// A piece is selected and to be shown.
    void pieceActivated();

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeContents();
    void addCloth(QGridLayout& grid, int row);
    void addLimits(QGridLayout& grid);
    void addFit(QGridLayout& grid, int row);
    void onChanged(const DocumentChange& what);
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
    void take(const SettingChange& change);
    void follow(const QString& link);

    Document& document_;
    SettingFields fields_;
    QStackedWidget* pages_;
    QLabel* materialTitle_;
    QComboBox *material_, *preset_;
    std::string shown_{};  ///< the material; empty: the garment's own fabric
    std::array<QLabel*, 3> directions_{}, shares_{};   ///< of warp, weft, bias
    std::vector<QWidget*> limitWidgets_, fitWidgets_;  ///< nothing to see where none is stated
    QLabel *all_, *worst_, *unstated_ = nullptr, *need_ = nullptr;
    std::optional<FabricFit> fit_;
    QString problem_;  ///< why the fit could not be worked out
    Follower<FabricQuestion, std::optional<FabricFit>> follower_;
};

}  // namespace toile::app
