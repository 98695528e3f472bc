// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/job_runner.h"

#include <QAction>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <cmath>
#include <functional>
#include <new>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "app/document/document.h"
#include "app/document/piece_edits.h"
#include "app/jobs/garment_jobs.h"
#include "app/window/window_status.h"
#include "core/toile/garment_flattener.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

/// A job put together by the test.
class TestJob : public Job {
public:
    std::function<Result<void>(Progress&)> work = [](Progress&) { return Result<void>(); };
    std::function<void()> done = [] {};
    bool cancellable = true;

    QString title() const override { return "test"; }
    bool isCancellable() const override { return cancellable; }
    Result<void> process(Progress& progress) override { return work(progress); }
    void finalize() override { done(); }
};

class PaintedWidget : public QWidget {
public:
    bool mayBePainted = true, wasPaintedTooSoon = false;

protected:
    void paintEvent(QPaintEvent*) override { wasPaintedTooSoon |= !mayBePainted; }
};

Result<void> untilCancelled(Progress& progress) {
    while (!progress.isCancelled()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return Error{ErrorCode::Cancelled};
}

}  // namespace

class JobRunnerTest : public QObject {
    Q_OBJECT

private slots:
    void worksElsewhereAndFinishesHere() {
        JobRunner runner;
        const QThread* here = QThread::currentThread();
        const QThread *worked = nullptr, *finished = nullptr;
        auto job = std::make_unique<TestJob>();
        job->work = [&](Progress&) { return worked = QThread::currentThread(), Result<void>(); };
        job->done = [&] { finished = QThread::currentThread(); };
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(std::move(job));
        QVERIFY(runner.isBusy());
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, test::kPatience);
        QVERIFY(worked && worked != here);
        QCOMPARE(finished, here);
        QVERIFY(!runner.isBusy());
    }

    /// A progress bar paints the window as it is set. Where a job starts while a change is still
    /// being told, the views would paint what is no more.
    void aJobThatStartsDoesNotPaint() {
        JobRunner runner;
        QWidget window;
        auto* painted = new PaintedWidget;
        painted->setMinimumSize(50, 50);
        connect(&runner, &JobRunner::started, painted, [painted] {
            painted->mayBePainted = false;
            painted->update();
        });
        QAction cancel;
        auto* row = new QHBoxLayout(&window);
        row->addWidget(painted);
        row->addWidget(new WorkDisplay({&runner}, cancel));
        connect(&runner, &JobRunner::started, painted, [painted] { painted->mayBePainted = true; });
        window.show();
        std::atomic<bool> seen = false;
        auto first = std::make_unique<TestJob>();
        first->work = [&seen](Progress& progress) {
            progress.report(0.5);
            while (!seen) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return Result<void>();
        };
        auto second = std::make_unique<TestJob>();
        second->work = untilCancelled;
        runner.start(std::move(first));
        runner.start(std::move(second));
        const auto* bar = window.findChild<QProgressBar*>("progress");
        QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && 2 * bar->value() == bar->maximum(),
                                 test::kPatience);
        seen = true;
        QTRY_COMPARE_WITH_TIMEOUT(bar->value(), 0, test::kPatience);
        QVERIFY(bar->isVisible());
        QVERIFY(!painted->wasPaintedTooSoon);
    }

    void reportsProgressWhileTheWorkerWorks() {
        JobRunner runner;
        std::atomic<bool> seen = false;
        auto job = std::make_unique<TestJob>();
        job->work = [&](Progress& progress) {
            progress.start(4);
            progress.advance(1);
            while (!seen) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return Result<void>();
        };
        double fraction = 0;
        connect(&runner, &JobRunner::progressed, this, [&](double value) {
            fraction = value;
            seen = value > 0;  // the worker may not have begun when it is looked at first
        });
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(std::move(job));
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, test::kPatience);
        QCOMPARE(fraction, 0.25);
    }

    void cancelledJobIsNotFinalized() {
        JobRunner runner;
        bool finalized = false;
        auto job = std::make_unique<TestJob>();
        job->work = untilCancelled;
        job->done = [&] { finalized = true; };
        QSignalSpy cancelled(&runner, &JobRunner::cancelled);
        QSignalSpy failed(&runner, &JobRunner::failed);
        runner.start(std::move(job));
        runner.cancel();
        QTRY_COMPARE_WITH_TIMEOUT(cancelled.count(), 1, test::kPatience);
        QCOMPARE(failed.count(), 0);
        QVERIFY(!finalized);
    }

    void cancelComingTooLateStillDropsTheResult() {
        JobRunner runner;
        bool finalized = false;
        std::atomic<bool> started = false;
        auto job = std::make_unique<TestJob>();
        job->work = [&](Progress& progress) {
            started = true;
            while (!progress.isCancelled()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return Result<void>();  // had finished all the same
        };
        job->done = [&] { finalized = true; };
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(std::move(job));
        QTRY_VERIFY_WITH_TIMEOUT(started, test::kPatience);
        runner.cancel();
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, test::kPatience);
        QVERIFY(!finalized);
    }

    void errorBecomesASentence() {
        JobRunner runner;
        auto job = std::make_unique<TestJob>();
        job->work = [](Progress&) {
            return Result<void>(
                Error{ErrorCode::FileUnreadable, Subject::file("coat.obj"), "no such file"});
        };
        QSignalSpy failed(&runner, &JobRunner::failed);
        runner.start(std::move(job));
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
        QVERIFY(failed.first().at(1).toString().contains("coat.obj"));
    }

    void faultOfTheProgramIsCaughtAndNamed() {
        JobRunner runner;
        auto job = std::make_unique<TestJob>();
        job->work = [](Progress&) -> Result<void> { throw std::runtime_error("broken"); };
        QSignalSpy failed(&runner, &JobRunner::failed);
        runner.start(std::move(job));
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
        QVERIFY(failed.first().at(1).toString().contains("broken"));
    }

    void lackOfMemoryIsNoFaultToReport() {
        JobRunner runner;
        auto job = std::make_unique<TestJob>();
        job->work = [](Progress&) -> Result<void> { throw std::bad_alloc(); };
        QSignalSpy failed(&runner, &JobRunner::failed);
        runner.start(std::move(job));
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, test::kPatience);
        const QString said = failed.first().at(1).toString();
        QVERIFY2(said.contains("not enough memory") && said.contains("Close other programs"),
                 qPrintable(said));
        QVERIFY2(!said.contains("report"), qPrintable(said));
    }

    void jobsRunOneAfterTheOther() {
        JobRunner runner;
        std::vector<int> order;
        for (int i = 0; i < 3; ++i) {
            auto job = std::make_unique<TestJob>();
            job->done = [&order, i] { order.push_back(i); };
            runner.start(std::move(job));
        }
        QSignalSpy idle(&runner, &JobRunner::idle);
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, test::kPatience);
        QCOMPARE(order, (std::vector<int>{0, 1, 2}));
    }

    void replacingCancelsWhatRanAndWaited() {
        JobRunner runner;
        std::vector<QString> order;
        const auto make = [&order](const QString& name, bool endless) {
            auto job = std::make_unique<TestJob>();
            if (endless) {
                job->work = untilCancelled;
            }
            job->done = [&order, name] { order.push_back(name); };
            return job;
        };
        runner.start(make("running", true));
        runner.start(make("waiting", false));
        auto written = make("written", false);
        written->cancellable = false;
        runner.start(std::move(written));
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.replace(make("wanted", false));
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, test::kPatience);
        QCOMPARE(order, (std::vector<QString>{"written", "wanted"}));
    }

    void aJobSaysWhetherAnotherHasTakenItsPlace() {
        JobRunner runner;
        const auto endless = [] {
            auto job = std::make_unique<TestJob>();
            job->work = untilCancelled;
            return job;
        };
        std::vector<bool> replaced;
        connect(&runner, &JobRunner::cancelled, this,
                [&](const QString&, bool other) { replaced.push_back(other); });
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(endless());
        runner.start(endless());
        runner.replace(endless());                      // of the other two
        QCOMPARE(replaced, (std::vector<bool>{true}));  // the waiting one is gone at once
        runner.cancel();
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, test::kPatience);
        QCOMPARE(replaced, (std::vector<bool>{true, false, true}));

        replaced.clear();
        runner.start(endless());
        auto written = std::make_unique<TestJob>();
        written->cancellable = false;
        runner.start(std::move(written));
        runner.cancel();
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 2, test::kPatience);
        QCOMPARE(replaced, (std::vector<bool>{false}));  // whatever else waits
    }

    void oneJobIsDroppedAndTheOthersAreDone() {
        JobRunner runner;
        std::vector<int> done;
        const auto make = [&done](int number, bool endless) {
            auto job = std::make_unique<TestJob>();
            if (endless) {
                job->work = untilCancelled;
            }
            job->done = [&done, number] { done.push_back(number); };
            return job;
        };
        QVERIFY(!runner.isUnderWay(0));
        const auto first = runner.start(make(1, true));
        const auto second = runner.start(make(2, false));
        const auto third = runner.start(make(3, false));
        QCOMPARE(runner.title(), QString("test"));
        for (const auto job : {first, second, third}) {
            QVERIFY(runner.isUnderWay(job));
        }
        std::vector<bool> replaced;
        connect(&runner, &JobRunner::cancelled, this,
                [&](const QString&, bool other) { replaced.push_back(other); });
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.drop(second);
        QCOMPARE(replaced, (std::vector<bool>{true}));  // it waited
        runner.drop(first);
        QVERIFY(!runner.isUnderWay(first) && !runner.isUnderWay(second));
        QVERIFY(runner.isUnderWay(third));
        QTRY_COMPARE_WITH_TIMEOUT(idle.count(), 1, test::kPatience);
        QCOMPARE(replaced, (std::vector<bool>{true, true}));
        QCOMPARE(done, (std::vector<int>{3}));
        QVERIFY(!runner.isUnderWay(third));
        QVERIFY(runner.title().isEmpty());
        runner.drop(third);  // it is over
    }

    void finishingDoesAllThereIs() {
        JobRunner runner;
        std::atomic<int> done = 0;
        bool finalized = false;
        for (int i = 0; i < 3; ++i) {
            auto job = std::make_unique<TestJob>();
            job->work = [&](Progress& progress) {
                done += progress.isCancelled() ? 0 : 1;
                return Result<void>();
            };
            job->done = [&] { finalized = true; };
            runner.start(std::move(job));
        }
        runner.finish();
        QCOMPARE(done.load(), 3);
        QVERIFY(!finalized);
        QVERIFY(!runner.isBusy() && !runner.hasWaiting());
    }

    void endingTheRunnerDoesWhatIsBetterWholeThanHalf() {
        std::atomic<int> done = 0;
        bool finalized = false;
        {
            JobRunner runner;
            auto first = std::make_unique<TestJob>();
            first->work = untilCancelled;
            runner.start(std::move(first));
            for (const bool cancellable : {false, true, false}) {
                auto job = std::make_unique<TestJob>();
                job->cancellable = cancellable;
                job->work = [&](Progress&) { return ++done, Result<void>(); };
                job->done = [&] { finalized = true; };
                runner.start(std::move(job));
            }
        }
        QCOMPARE(done.load(), 2);
        QVERIFY(!finalized);
    }

    void endingTheRunnerWaitsForTheWorker() {
        std::atomic<bool> begun = false, over = false;
        {
            JobRunner runner;
            auto job = std::make_unique<TestJob>();
            job->work = [&](Progress& progress) {
                begun = true;
                const Result<void> result = untilCancelled(progress);
                over = true;
                return result;
            };
            runner.start(std::move(job));
        }
        // Either it never began or it is over: nothing works on a destroyed job.
        QCOMPARE(over.load(), begun.load());
    }

    void flatteningIsAtItsEndWhenTheSceneIsMade() {
        Document document;
        test::setGarment(document, test::makeSewnCap(), nullptr);
        const std::unique_ptr<Job> job =
            recomputeJob(document, {.flatten = true}, std::make_shared<GarmentFlattener>(), {},
                         [](const Derivation&) {});
        Progress progress;
        QVERIFY(job->process(progress));
        QVERIFY(std::abs(progress.fraction() - 1) < 1e-12);
        // The parts of the job share the bar: flattening alone does not fill it.
        Progress shared;
        shared.setShare(0, 0.5);
        (void)flattenGarment(*document.garment(), {}, shared);
        QVERIFY(std::abs(shared.fraction() - 0.5) < 1e-12);
    }

    void flatteningSaysWhichPieceItIsAt() {
        Document document;
        test::setGarment(document, test::makeSewnCap(), nullptr);
        for (int k = 0; k < 2; ++k) {
            renamePiece(document, k, "Teil");
        }
        const std::unique_ptr<Job> job =
            recomputeJob(document, {.flatten = true}, std::make_shared<GarmentFlattener>(), {},
                         [](const Derivation&) {});
        QVERIFY(job->detail().isEmpty());
        Progress progress;
        QVERIFY(job->process(progress));
        const QString said = job->detail();  // the last that was begun, maybe beside the other
        QVERIFY2(QRegularExpression("^[12] of 2: Teil( 2)?$").match(said).hasMatch(),
                 qPrintable(said));
    }

    void aFollowerAnswersTheLastQuestionAndCancelsTheOthers() {
        std::vector<int> answers;
        Follower<int, int> follower(
            [](int asked, Progress& progress) {
                while (asked < 3 && !progress.isCancelled()) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                return asked * 10;
            },
            [&](const Attempt<int>& made, int, bool isLast) {
                QVERIFY(isLast);
                answers.push_back(*made.answer);
            });
        for (const int asked : {1, 2, 1, 3, 3}) {
            follower.ask(asked);
            QVERIFY(follower.isBusy());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!follower.isBusy(), test::kPatience);
        follower.ask(3);  // is answered already
        QVERIFY(!follower.isBusy());
        QCOMPARE(answers, std::vector<int>{30});
    }

    void aFollowerHandsOlderAnswersOverThatCannotBeCancelled() {
        std::atomic<bool> mayEnd = false;
        std::vector<std::pair<int, bool>> answers;
        Follower<int, int> follower(
            [&mayEnd](int asked) {
                while (asked > 0 && !mayEnd) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                return asked;
            },
            [&](const Attempt<int>& made, int, bool isLast) {
                answers.emplace_back(*made.answer, isLast);
            },
            [](int asked) { return asked == 0; });
        follower.ask(1);
        follower.ask(2);
        mayEnd = true;
        QTRY_VERIFY_WITH_TIMEOUT(!follower.isBusy(), test::kPatience);
        const std::vector<std::pair<int, bool>> both{{1, false}, {2, true}};
        QVERIFY(answers == both);
        mayEnd = false;
        follower.ask(0);  // small: at once, and here
        QCOMPARE(answers.size(), std::size_t(3));
    }

    void aFollowerWaitsForFurtherQuestions() {
        std::vector<int> answers;
        Follower<int, int> follower(
            [](int asked) { return asked; },
            [&](const Attempt<int>& made, int, bool) { answers.push_back(*made.answer); },
            [](int) { return true; }, 20);
        for (const int asked : {1, 2, 3}) {
            follower.ask(asked);
        }
        QVERIFY(answers.empty());
        QTRY_COMPARE_WITH_TIMEOUT(answers, std::vector<int>{3}, test::kPatience);
        follower.ask(4);
        follower.forget();
        QVERIFY(!follower.isBusy());
        follower.ask(3);  // was forgotten, too
        QTRY_COMPARE_WITH_TIMEOUT(answers, (std::vector{3, 3}), test::kPatience);
    }
};

TOILE_WINDOW_TEST(JobRunnerTest)
#include "job_runner_test.moc"
