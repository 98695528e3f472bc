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

/// Edits the fabric of the garment and of its materials: none, a preset, or typed limits. Below
/// that it shows how much of the garment exceeds the limits. A worker thread computes this for
/// large garments. A change is one undo step and flattens no piece again.
class FabricPanel : public QWidget {
    Q_OBJECT

public:
    using FitWork = std::function<std::optional<FabricFit>(const FabricQuestion&)>;

    /// `document` must outlive the panel.
    explicit FabricPanel(Document& document, QWidget* parent = nullptr,
                         const FitWork& work = fabricFit);

    QWidget& firstField() const;
    /// Empty if no piece is flat. Belongs to an earlier fabric or grain if `isUpToDate` is false.
    const std::optional<FabricFit>& fit() const { return fit_; }
    bool isUpToDate() const { return !follower_.isBusy(); }

signals:
    /// The user clicked the link to the worst piece, which is now selected.
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
    /// Shows the cloth length that the layout needs of the shown fabric.
    void showNeed();
    void askForFit();
    void setFit(const std::optional<FabricFit>& fit, const QString& problem = {});
    void showFit();
    void showMaterials();
    /// Returns the fabric that the panel edits in `state`: the garment's, or that of a material.
    Fabric& shownFabric(DocumentState& state) const;
    void choosePreset(int index);
    void take(const SettingChange& change);
    void follow(const QString& link);

    Document& document_;
    SettingFields fields_;
    QStackedWidget* pages_;
    QLabel* materialTitle_;
    QComboBox *material_, *preset_;
    std::string shown_{};  ///< name of the material; empty: the garment's own fabric
    std::array<QLabel*, 3> directions_{}, shares_{};   ///< of warp, weft, bias
    std::vector<QWidget*> limitWidgets_, fitWidgets_;  ///< hidden if no limits are set
    QLabel *all_, *worst_, *unstated_ = nullptr, *need_ = nullptr;
    std::optional<FabricFit> fit_;
    QString problem_;  ///< why the fit could not be computed
    Follower<FabricQuestion, std::optional<FabricFit>> follower_;
};

}  // namespace toile::app
