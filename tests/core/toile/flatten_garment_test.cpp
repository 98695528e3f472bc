// SPDX-License-Identifier: GPL-3.0-or-later
// How flattenGarment treats threads, progress and cancelling.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <limits>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/sanitized.h"
#include "core/toile/piece_work.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

const int kPanelSide = isSanitized() ? 120 : 708;  // squares: a million triangles
/// Checked code is slow and locks a lot.
const double kAllowed = isSanitized() ? 1 : kCancelSeconds;
/// The machine may be busy with something else at just the wrong moment.
constexpr int kTries = 3;

Garment garmentOf(Pieces pieces) {
    Garment garment;
    garment.pieces = std::move(pieces);
    return garment;
}

Garment smallGarment() {
    return garmentOf({test::asPiece(test::bentPanel(12), "small"),
                      test::asPiece(test::bentPanel(40), "large"),
                      test::asPiece(test::sphericalCap(14, 90, 1.2), "cap"),
                      test::asPiece(test::saddle(16, 200, 1.2), "saddle"),
                      test::asPiece(test::coneSector(20, 9, 20, 60, 2, 0.5), "cone"),
                      test::asPiece(test::tube(12, 4), "leg")});
}

/// Seconds from the cancel, given after `delay`, to the return; 0 where that came first.
double secondsToReturn(const Garment& garment, Method method, double delay, PieceResults& results,
                       EndingWorkers& ending) {
    Progress progress;
    std::chrono::steady_clock::time_point cancelled;
    std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(delay));
        cancelled = std::chrono::steady_clock::now();
        progress.cancel();
    });
    results = flattenGarment(garment, {method}, progress, 0, {}, {}, &ending);
    const auto returned = std::chrono::steady_clock::now();
    other.join();
    return std::max(0.0, std::chrono::duration<double>(returned - cancelled).count());
}

class CancelOfALargePanelClock : public testing::TestWithParam<Method> {};

TEST_P(CancelOfALargePanelClock, GivesControlBackAtOnce) {
    const Garment garment = garmentOf({test::asPiece(test::bentPanel(kPanelSide), "panel")});
    EndingWorkers ending;
    for (const double delay : {0.05, 0.2, 0.6}) {
        SCOPED_TRACE(delay);
        double least = std::numeric_limits<double>::infinity();
        PieceResults results;
        for (int attempt = 0; attempt < kTries && least > kAllowed; ++attempt) {
            least = std::min(least, secondsToReturn(garment, GetParam(), delay, results, ending));
        }
        EXPECT_LE(least, kAllowed);
        ASSERT_EQ(results.size(), 1U);
        // A fast machine may be done with a small panel before.
        EXPECT_NE(results[0]->flat.has_value(), results[0]->error.has_value());
        RecordProperty("milliseconds_after_" + std::to_string(static_cast<int>(1000 * delay)),
                       std::to_string(1000 * least));
    }
}

INSTANTIATE_TEST_SUITE_P(FlattenGarment, CancelOfALargePanelClock,
                         testing::Values(Method::Wang2005, Method::Isometric),
                         [](const auto& shown) { return std::string(name(shown.param)); });

/// Cancels once more than this fraction is done.
PieceResults cancelledAfter(double fraction, const Garment& garment, Method method,
                            Progress& progress, int threads) {
    std::thread other([&progress, fraction] {
        while (progress.fraction() <= fraction) {
            std::this_thread::yield();
        }
        progress.cancel();
    });
    PieceResults results = flattenGarment(garment, {method}, progress, threads);
    other.join();
    return results;
}

class CancelWithinAPiece : public testing::TestWithParam<Method> {};

TEST_P(CancelWithinAPiece, LeavesItUnsolved) {
    // Whoever cancels may get the processor late, and find all done: then again with a larger one.
    for (int side = 60;; side *= 2) {
        ASSERT_LT(side, 1000) << "no cancel had an effect";
        const Garment garment = garmentOf({test::asPiece(test::bentPanel(side), "panel")});
        Progress progress;
        const PieceResults results = cancelledAfter(0, garment, GetParam(), progress, 1);
        ASSERT_EQ(results.size(), 1U);
        if (!results[0]->error) {
            EXPECT_TRUE(results[0]->flat);
            continue;
        }
        EXPECT_EQ(results[0]->error->code, ErrorCode::Cancelled);
        EXPECT_EQ(results[0]->error->subject.name, "panel");
        EXPECT_FALSE(results[0]->flat);
        EXPECT_FALSE(results[0]->quality);
        EXPECT_LT(progress.fraction(), 1);
        break;
    }
}

INSTANTIATE_TEST_SUITE_P(FlattenGarment, CancelWithinAPiece,
                         testing::Values(Method::Wang2005, Method::Isometric),
                         [](const auto& shown) { return std::string(name(shown.param)); });

TEST(FlattenGarment, KeepsWhatIsDoneWhenCancelled) {
    const auto flap = test::bentPanel(8);
    for (int flaps = 256;; flaps *= 2) {
        ASSERT_LT(flaps, 20000) << "no cancel had an effect";
        Pieces pieces;
        for (int k = 0; k < flaps; ++k) {
            pieces.push_back(test::asPiece(flap, "flap " + std::to_string(k)));
        }
        Progress progress;
        const PieceResults results =
            cancelledAfter(0.1, garmentOf(pieces), Method::Curvature, progress, 2);
        ASSERT_EQ(results.size(), pieces.size());
        int cancelled = 0;
        for (std::size_t k = 0; k < results.size(); ++k) {
            ASSERT_TRUE(results[k]);
            EXPECT_EQ(results[k]->piece, pieces[k]);
            EXPECT_NE(results[k]->flat.has_value(), results[k]->error.has_value());
            EXPECT_EQ(results[k]->flat.has_value(), results[k]->quality.has_value());
            if (results[k]->error) {
                EXPECT_EQ(results[k]->error->code, ErrorCode::Cancelled);
                EXPECT_EQ(results[k]->error->subject.name, pieces[k]->name);
                ++cancelled;
            }
        }
        EXPECT_LT(cancelled, flaps);  // a tenth was done
        if (cancelled > 0) {
            EXPECT_LT(progress.fraction(), 1);
            break;
        }
    }
}

TEST(FlattenGarment, CancelledBeforeItBeginsDoesNothing) {
    Progress progress;
    progress.cancel();
    const PieceResults results = flattenGarment(smallGarment(), {}, progress);
    EXPECT_EQ(results.size(), smallGarment().pieces.size());
    for (const auto& result : results) {
        ASSERT_TRUE(result->error);
        EXPECT_EQ(result->error->code, ErrorCode::Cancelled);
    }
    EXPECT_EQ(progress.fraction(), 0);
}

TEST(FlattenGarment, CancelledRepeatedlyHasNoMoreEndingWorkersThanCores) {
    const Garment garment = garmentOf({test::asPiece(test::bentPanel(kPanelSide / 2), "panel")});
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    EndingWorkers ending;
    for (int k = 0; k < 12; ++k) {
        Progress progress;
        std::thread other([&progress] {
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            progress.cancel();
        });
        const PieceResults results = flattenGarment(garment, {}, progress, 0, {}, {}, &ending);
        other.join();
        ASSERT_EQ(results.size(), 1U);
        EXPECT_LE(ending.count(), cores);
    }
    Progress progress;
    EXPECT_TRUE(flattenGarment(smallGarment(), {}, progress)[0]->flat);
}

/// Number of threads of this process.
int threadCount() {
    int count = 0;
    for ([[maybe_unused]] const auto& entry :
         std::filesystem::directory_iterator("/proc/self/task")) {
        ++count;
    }
    return count;
}

TEST(FlattenGarment, LeavesNoThreadBehind) {
    if (!std::filesystem::exists("/proc/self/task")) {
        GTEST_SKIP() << "the system does not list threads";
    }
    const Garment garment = garmentOf({test::asPiece(test::bentPanel(kPanelSide / 4), "panel")});
    Progress first;
    flattenGarment(garment, {}, first);  // libraries start threads of their own, once
    const int before = threadCount();
    for (const bool waits : {true, false}) {
        std::optional<EndingWorkers> ending(std::in_place);
        Progress progress;
        std::thread other([&progress] {
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            progress.cancel();
        });
        flattenGarment(garment, {}, progress, 0, {}, {}, waits ? nullptr : &*ending);
        other.join();
        if (!waits) {
            ending.reset();
        }
        EXPECT_EQ(threadCount(), before);
    }
}

TEST(FlattenGarment, GivesTheSameBytesWithOneThreadAndWithMany) {
    const Garment garment = smallGarment();
    for (const MethodTraits& method : allMethods()) {
        SCOPED_TRACE(method.name);
        Progress progress;
        const PieceResults one = flattenGarment(garment, {method.method}, progress, 1);
        for (const int threads : {2, 5, 0}) {
            const PieceResults many = flattenGarment(garment, {method.method}, progress, threads);
            ASSERT_EQ(many.size(), one.size());
            for (std::size_t k = 0; k < one.size(); ++k) {
                ASSERT_EQ(many[k]->flat.has_value(), one[k]->flat.has_value());
                if (one[k]->flat) {
                    EXPECT_TRUE((many[k]->flat->Q.array() == one[k]->flat->Q.array()).all());
                } else {
                    EXPECT_EQ(many[k]->error->code, one[k]->error->code);
                }
            }
        }
    }
}

TEST(FlattenGarment, ReportsProgressThatGrowsWithinAPieceAndEndsAtOne) {
    // Whoever looks on may get the processor late, and see the end only.
    for (int side = 100, steps = 0; steps < 2; side *= 2) {
        ASSERT_LT(side, 1000) << "nothing was seen on the way";
        const Garment garment = garmentOf({test::asPiece(test::bentPanel(side), "panel")});
        Progress progress;
        progress.setShare(0.25, 0.75);
        std::atomic<bool> isDone{false};
        double last = 0;
        steps = 0;  // 0.25, and what is on the way
        std::thread watcher([&] {
            while (!isDone) {
                const double now = progress.fraction();
                EXPECT_GE(now, last);
                EXPECT_LE(now, 0.75);
                steps += now > last && now < 0.75 ? 1 : 0;
                last = now;
                std::this_thread::yield();
            }
        });
        const PieceResults results = flattenGarment(garment, {Method::Wang2005}, progress);
        EXPECT_DOUBLE_EQ(progress.fraction(), 0.75);
        isDone = true;
        watcher.join();
        EXPECT_TRUE(results[0]->flat);
    }
}

TEST(FlattenGarment, TakesAGarmentWithoutPieces) {
    Progress progress;
    EXPECT_TRUE(flattenGarment(Garment{}, {}, progress).empty());
    EXPECT_EQ(progress.fraction(), 1);
}

}  // namespace
}  // namespace toile
