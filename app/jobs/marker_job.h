// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
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

/// What is laid on cloth, and what a file of it is made of.
struct ClothGround {
    Garment garment;
    PieceResults results;
    LaidOutPattern laid;
    DrawingWords words;
    LineSettings lines;
    Fabric fabric;  ///< of pieces that are of no material
};

/// The document's pattern as it is now, cold. Cost: that of `makePattern`.
/// Errors: Cancelled.
Result<std::shared_ptr<const ClothGround>> clothGround(const PatternNow& now, Progress& progress);

/// What a marker follows from.
struct MarkerOrder {
    std::shared_ptr<const Pattern> pattern;  ///< as it lies (`patternOnCloth`)
    std::string material{};
    Fabric fabric{};  ///< of this material
    MarkerPlan plan{};
};

/// Lays pieces on a thread of its own, better and better until it is stopped. GUI thread only.
class MarkerSearch : public QObject {
    Q_OBJECT

public:
    /// How often the window hears of a better marker, milliseconds.
    static constexpr int kPause = 100;

    explicit MarkerSearch(QObject* parent = nullptr);
    ~MarkerSearch() override;

    /// Begins anew; what was begun before is dropped.
    /// @param rounds  to search; none: until it is stopped
    void begin(MarkerOrder order, std::optional<int> rounds);
    /// Goes on with what was begun, until it is stopped.
    void goOn();
    /// It rests, and keeps the best.
    void stop();
    /// Nothing is laid any more.
    void clear();

    bool isRunning() const { return isWanted_; }
    /// Of what was begun last, or before that as long as there is none; null: none yet.
    const std::shared_ptr<const ClothMarker>& best() const { return best_; }
    /// Whether the best is of the order, and not of one before it that is shown meanwhile.
    bool isOfOrder() const { return best_ && bestOf_ == begun_; }
    const MarkerOrder& order() const { return order_; }
    /// Why nothing can be laid.
    const std::optional<Error>& problem() const { return problem_; }

signals:
    /// Best, problem, or whether it runs.
    void changed();
    void failed(const QString& sentence);

private:
    using Found = std::shared_ptr<const ClothMarker>;

    /// Where the search leaves what it has found, for the window to fetch.
    struct Tray {
        std::mutex mutex;
        Found found;
    };

    struct Outcome {
        std::shared_ptr<MarkerNester> nester;
        std::optional<Error> problem;
    };

    void start();
    void fetch();
    void onDone(const Attempt<Outcome>& made, bool isCancelled);

    MarkerOrder order_;
    std::shared_ptr<MarkerNester> nester_;  ///< of the order; null while it is at work
    std::shared_ptr<Tray> tray_;            ///< of the order
    Found best_;
    std::optional<Error> problem_;
    std::optional<int> rounds_;
    bool isWanted_ = false;
    int begun_ = 0, working_ = 0;  ///< which order is wanted, and which is worked on
    int bestOf_ = 0;               ///< which order `best_` is of
    QTimer poll_;
    Worker<Outcome> worker_;
};

/// A marker as it is to be written.
struct MarkerSheet {
    std::shared_ptr<const ClothGround> ground;
    std::shared_ptr<const Pattern> pattern;  ///< that is laid
    ClothMarker marker{};
    MarkerSettings settings{};
    std::vector<std::string> title{};  ///< above the cloth, line by line
};

/// Writes a marker as a file, by its ending (`holdsMarkers`).
/// @param done  not called where it cannot be written
std::unique_ptr<Job> markerFileJob(MarkerSheet sheet, std::filesystem::path path,
                                   const ExportOptions& options,
                                   std::function<void(const Exported&)> done);

}  // namespace toile::app
