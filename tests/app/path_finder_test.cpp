// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/path_finder.h"

#include <QTest>
#include <QThread>
#include <cmath>
#include <optional>

#include "core/cut/surface_point.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

std::shared_ptr<const Piece> sheet(int columns, int rows) {
    return std::make_shared<const Piece>(
        makePiece("sheet", test::makeSheet(200, 100, columns, rows)));
}

PathRequest request(const std::shared_ptr<const Piece>& piece, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to) {
    return {piece, NearestSurface(piece->mesh).find(from), NearestSurface(piece->mesh).find(to)};
}

}  // namespace

class PathFinderTest : public QObject {
    Q_OBJECT

private slots:
    void findsTheShortestWayLater() {
        PathFinder finder;
        const auto piece = sheet(20, 10);
        std::optional<double> found;
        finder.find(request(piece, {3, 4, 0}, {183, 84, 0}),
                    [&](const Result<PathPolyline>& path) { found = path->length; });
        QVERIFY(!found);  // not before the event loop runs
        QVERIFY(QTest::qWaitFor([&] { return found.has_value(); }, test::kPatience));
        QVERIFY(std::abs(*found - std::hypot(180, 80)) < 1e-6);
    }

    void followsEdgesWhereAsked() {
        PathFinder finder;
        PathRequest along = request(sheet(20, 10), {1, 51, 0}, {199, 49, 0});
        along.alongEdges = true;
        std::optional<double> found;
        finder.find(along, [&](const Result<PathPolyline>& path) { found = path->length; });
        QVERIFY(QTest::qWaitFor([&] { return found.has_value(); }, test::kPatience));
        QVERIFY(std::abs(*found - 200) < 1e-9);
    }

    void ordersAreServedInTurnOnAnyPiece() {
        PathFinder finder;
        const auto a = sheet(20, 10), b = sheet(7, 5);
        std::vector<int> served;
        for (int i = 0; i < 6; ++i) {
            finder.find(request(i % 2 == 0 ? a : b, {1, 1, 0}, {10.0 * i + 40, 60, 0}),
                        [&served, i](const Result<PathPolyline>& path) {
                            if (path) {
                                served.push_back(i);
                            }
                        });
        }
        QVERIFY(QTest::qWaitFor([&] { return served.size() == 6; }, test::kPatience));
        QCOMPARE(served, (std::vector<int>{0, 1, 2, 3, 4, 5}));
    }

    void whatIsCancelledIsNeverCalled_data() {
        QTest::addColumn<bool>("alongEdges");
        QTest::newRow("through triangles") << false;
        QTest::newRow("along edges") << true;
    }

    void whatIsCancelledIsNeverCalled() {
        QFETCH(const bool, alongEdges);
        PathFinder finder;
        const auto piece = sheet(300, 150);
        bool stale = false, fresh = false;
        std::vector<PathFinder::Ticket> tickets;
        for (int i = 0; i < 5; ++i) {
            PathRequest far = request(piece, {1, 1, 0}, {199, 99.0 - i, 0});
            far.alongEdges = alongEdges;
            tickets.push_back(finder.find(far, [&](const Result<PathPolyline>&) { stale = true; }));
        }
        for (const PathFinder::Ticket ticket : tickets) {
            finder.cancel(ticket);
        }
        finder.cancel(0);
        finder.find(request(piece, {1, 1, 0}, {20, 20, 0}),
                    [&](const Result<PathPolyline>&) { fresh = true; });
        QVERIFY(QTest::qWaitFor([&] { return fresh; }, test::kPatience));
        QVERIFY(!stale);
    }

    void answersComeWhileTheWindowWaitsForThem() {
        PathFinder finder;
        const auto piece = sheet(60, 30);
        int answers = 0;
        for (int k = 0; k < 3; ++k) {
            finder.find(request(piece, {1, 1, 0}, {199 - 30.0 * k, 99, 0}),
                        [&answers](const Result<PathPolyline>&) {
                            ++answers;
                            QCOMPARE(QThread::currentThread(),
                                     QCoreApplication::instance()->thread());
                        });
            QCOMPARE(answers, 0);  // never within the call
        }
        QVERIFY(QTest::qWaitFor([&answers] { return answers == 3; }, test::kPatience));
    }
};

TOILE_WINDOW_TEST(PathFinderTest)
#include "path_finder_test.moc"
