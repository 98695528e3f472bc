// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/jobs/marker_job.h"

namespace toile::app {

class Workspace;

/// The marker being edited: the document's settings for one material, the search for the best
/// layout, and copies placed by hand. Follows the document while active. Changes are stored in the
/// document, one undo step each. GUI thread only.
class MarkerDesk : public QObject {
    Q_OBJECT

public:
    /// Rounds searched automatically, for a reasonable first layout.
    static constexpr int kFirstRounds = 10;

    enum class Stage {
        Nothing,  ///< no garment, or no flat piece
        Waiting,  ///< for the pattern
        Failed,   ///< `problem` is set
        Laid,     ///< a marker exists or is being computed
    };

    explicit MarkerDesk(Workspace& workspace, QObject* parent = nullptr);
    ~MarkerDesk() override;

    /// Starts working, until `end`.
    void begin();
    void end();

    Document& document() const { return document_; }
    Workspace& workspace() const { return workspace_; }
    Stage stage() const;
    /// A message about the problem; empty if there is none.
    QString problem() const;

    /// The garment's own material comes first.
    const std::vector<std::string>& materials() const { return materials_; }
    const std::string& material() const { return material_; }
    void setMaterial(const std::string& material);
    const Fabric& fabric() const;
    const MarkerPlan& plan() const;
    const MarkerSettings& settings() const { return plan().settings; }
    /// One undo step. @param gesture  as for Document::edit
    void setSettings(const QString& text, const MarkerSettings& settings, int gesture = -1);

    /// The layout including copies placed by hand; null if there is none yet.
    const ClothMarker* marker() const { return marker_ ? &*marker_ : nullptr; }
    /// Whether the layout matches the current settings.
    bool isCurrent() const { return marker_ && search_.isOfOrder(); }
    /// Whether a search could find a better layout.
    bool canImprove() const;
    /// The pattern of the marker.
    const std::shared_ptr<const Pattern>& pattern() const { return search_.order().pattern; }
    /// Input for writing the marker to a file.
    const std::shared_ptr<const ClothGround>& ground() const { return ground_; }
    const std::vector<int>& misplaced() const { return misplaced_; }
    const MarkerFigures& figures() const { return figures_; }

    bool isRunning() const { return search_.isRunning(); }
    /// Searches until stopped.
    void improve();
    void stop() { search_.stop(); }
    /// Drops the found layout; copies placed by hand stay.
    void startAgain();

    /// Shows a copy at a place during a drag, without storing it.
    void tryPlacement(int copy, const Placement& placement);
    /// Undoes `tryPlacement`.
    void takeBack();
    /// Fixes the copy at a place; one undo step.
    void keep(int copy, Placement placement, const QString& text);
    void release(int copy);
    void releaseAll();
    QString nameOf(int copy) const;

signals:
    /// The marker or the stage has changed.
    void changed();
    /// The cloth has changed, so the view has to frame it again.
    void clothChanged();
    void failed(const QString& sentence);

private:
    void store(const QString& text, MarkerPlan next, int gesture = -1);
    void onOpened();
    void onDocumentChanged(const DocumentChange& what);
    void askForGround();
    void takeGround(std::shared_ptr<const ClothGround> ground);
    std::optional<int> rounds() const;
    void beginSearch(std::optional<int> rounds);
    MarkerOrder orderNow() const;
    void compose();
    void findMisplaced();

    Workspace& workspace_;
    Document& document_;
    bool isActive_ = false;
    bool isImproving_ = false;  ///< otherwise only the first rounds are searched
    std::string material_;
    std::vector<std::string> materials_;
    std::shared_ptr<const ClothGround> ground_;
    std::optional<Error> groundProblem_;
    MarkerPlan plan_;  ///< last known plan of the material
    std::optional<std::pair<CopyKey, Placement>> tried_;
    std::optional<ClothMarker> marker_;
    std::vector<int> misplaced_;
    /// Cache for a drag: misplaced ones among the other copies, and their marker.
    std::vector<int> misplacedOthers_;
    std::shared_ptr<const ClothMarker> othersOf_;
    MarkerFigures figures_;
    MarkerSearch search_;
    Follower<PatternNow, Result<std::shared_ptr<const ClothGround>>> grounds_;
};

}  // namespace toile::app
