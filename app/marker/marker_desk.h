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

/// The marker that is looked at: what the document says of laying one material, the search for the
/// best, and what a person has laid by hand over it. Follows the document while it is active; what
/// is said here is said in the document, a step of its history each. GUI thread only.
class MarkerDesk : public QObject {
    Q_OBJECT

public:
    /// That are searched by themselves, so that the first sight is no bad one.
    static constexpr int kFirstRounds = 10;

    enum class Stage {
        Nothing,  ///< no garment, or nothing of it is flat
        Waiting,  ///< for the pattern
        Failed,   ///< `problem` says why
        Laid,     ///< there is a marker, or will be soon
    };

    explicit MarkerDesk(Workspace& workspace, QObject* parent = nullptr);
    ~MarkerDesk() override;

    /// From now on it works, and until `end`.
    void begin();
    void end();

    Document& document() const { return document_; }
    Workspace& workspace() const { return workspace_; }
    Stage stage() const;
    /// What is the matter, a sentence; empty where there is nothing to say.
    QString problem() const;

    /// The garment's own first.
    const std::vector<std::string>& materials() const { return materials_; }
    const std::string& material() const { return material_; }
    void setMaterial(const std::string& material);
    const Fabric& fabric() const;
    const MarkerPlan& plan() const;
    const MarkerSettings& settings() const { return plan().settings; }
    /// A step of the history. @param gesture  as for Document::edit
    void setSettings(const QString& text, const MarkerSettings& settings, int gesture = -1);

    /// As it lies, with what was laid by hand; null where there is none yet.
    const ClothMarker* marker() const { return marker_ ? &*marker_ : nullptr; }
    /// Whether it is laid as the settings ask, and not as they asked before.
    bool isCurrent() const { return marker_ && search_.isOfOrder(); }
    /// Whether there is something to look for.
    bool canImprove() const;
    /// Of the marker.
    const std::shared_ptr<const Pattern>& pattern() const { return search_.order().pattern; }
    /// What a file of the marker is made of.
    const std::shared_ptr<const ClothGround>& ground() const { return ground_; }
    const std::vector<int>& misplaced() const { return misplaced_; }
    const MarkerFigures& figures() const { return figures_; }

    bool isRunning() const { return search_.isRunning(); }
    /// Searches until it is stopped.
    void improve();
    void stop() { search_.stop(); }
    /// Forgets what was found; what is kept stays.
    void startAgain();

    /// Shows a copy elsewhere while it is dragged; nothing is stored yet.
    void tryPlacement(int copy, const Placement& placement);
    /// It is where it was before it was tried.
    void takeBack();
    /// The copy stays there, a step of the history.
    void keep(int copy, Placement placement, const QString& text);
    void release(int copy);
    void releaseAll();
    /// What a copy is called.
    QString nameOf(int copy) const;

signals:
    /// Another marker, or another stage.
    void changed();
    /// Another cloth: the view shows all of it again.
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
    bool isImproving_ = false;  ///< else the first rounds are searched
    std::string material_;
    std::vector<std::string> materials_;
    std::shared_ptr<const ClothGround> ground_;
    std::optional<Error> groundProblem_;
    MarkerPlan plan_;  ///< of the material, as it was last
    std::optional<std::pair<CopyKey, Placement>> tried_;
    std::optional<ClothMarker> marker_;
    std::vector<int> misplaced_;
    /// While one is dragged: those among the others, and in which marker.
    std::vector<int> misplacedOthers_;
    std::shared_ptr<const ClothMarker> othersOf_;
    MarkerFigures figures_;
    MarkerSearch search_;
    Follower<PatternNow, Result<std::shared_ptr<const ClothGround>>> grounds_;
};

}  // namespace toile::app
