// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/worker.h"
#include "app/jobs/job.h"
#include "core/base/error.h"
#include "core/formats/export_options.h"
#include "core/formats/export_source.h"
#include "core/marker/cloth_marker.h"
#include "core/marker/marker_settings.h"

namespace toile {
struct Exported;
}  // namespace toile

namespace toile::app {

class PatternNow;

/// The pattern that is laid on cloth, and what a file of the marker needs.
struct ClothGround {
    Garment garment;
    PieceResults results;
    LaidOutPattern laid;
    DrawingWords words;
    LineSettings lines;
    Fabric fabric;  ///< of pieces without a material
};

/// The document's pattern as it is now, cold. Cost: that of `makePattern`.
/// Errors: Cancelled.
Result<std::shared_ptr<const ClothGround>> clothGround(const PatternNow& now, Progress& progress);

/// The inputs of a marker.
struct MarkerOrder {
    std::shared_ptr<const Pattern> pattern;  ///< as it lies (`patternOnCloth`)
    std::string material{};
    Fabric fabric{};  ///< of this material
    MarkerPlan plan{};
};

/// Lays pieces on a thread of its own, and improves the marker until it is stopped. GUI thread
/// only.
class MarkerSearch : public QObject {
    Q_OBJECT

public:
    /// How often better markers are announced, milliseconds.
    static constexpr int kPause = 100;

    explicit MarkerSearch(QObject* parent = nullptr);
    ~MarkerSearch() override;

    /// Starts another search, which replaces the one before.
    /// @param rounds  number of rounds; none: until it is stopped
    void begin(MarkerOrder order, std::optional<int> rounds);
    /// Continues the search until it is stopped.
    void goOn();
    /// Stops the search, and keeps the best marker.
    void stop();
    /// Forgets order and marker.
    void clear();

    bool isRunning() const { return isWanted_; }
    /// The best marker of the present order, or of the one before until there is one; null: none
    /// yet.
    const std::shared_ptr<const ClothMarker>& best() const { return best_; }
    /// True if `best` belongs to the present order.
    bool isOfOrder() const { return best_ && bestOf_ == begun_; }
    const MarkerOrder& order() const { return order_; }
    /// Why nothing can be laid.
    const std::optional<Error>& problem() const { return problem_; }

signals:
    /// Best, problem, or `isRunning` has changed.
    void changed();
    void failed(const QString& sentence);

private:
    struct Outcome {
        std::shared_ptr<MarkerNester> nester;
        std::optional<Error> problem;
    };

    void start();
    void fetch();
    void onDone(const Attempt<Outcome>& made, bool isCancelled);

    MarkerOrder order_;
    std::shared_ptr<MarkerNester> nester_;           ///< of the order; null while it works
    std::shared_ptr<Mailbox<ClothMarker>> mailbox_;  ///< of the order
    std::shared_ptr<const ClothMarker> best_;
    std::optional<Error> problem_;
    std::optional<int> rounds_;
    bool isWanted_ = false;
    int begun_ = 0, working_ = 0;  ///< numbers of the present order and of the one in work
    int bestOf_ = 0;               ///< number of the order of `best_`
    QTimer poll_;
    Worker<Outcome> worker_;
};

/// A marker to write.
struct MarkerSheet {
    std::shared_ptr<const ClothGround> ground;
    std::shared_ptr<const Pattern> pattern;  ///< on the cloth
    ClothMarker marker{};
    MarkerSettings settings{};
    std::vector<std::string> title{};  ///< above the cloth, line by line
};

/// Writes a marker in the format of the path's ending (`holdsMarkers`).
/// @param done  not called if it cannot be written
std::unique_ptr<Job> markerFileJob(MarkerSheet sheet, std::filesystem::path path,
                                   const ExportOptions& options,
                                   std::function<void(const Exported&)> done);

}  // namespace toile::app
