// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "app/session/cut_editor.h"
#include "app/session/workspace.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/same_state.h"

namespace toile::test {

using namespace app;

/// Replaces a job that reads a project.
class ReadingJob : public Job {
public:
    explicit ReadingJob(std::function<void()> done) : done_(std::move(done)) {}
    QString title() const override { return "Reading"; }
    Result<void> process(Progress&) override { return {}; }
    void finalize() override { done_(); }

private:
    std::function<void()> done_;
};

/// Blocks jobs while it exists, or until release().
class Hold {
public:
    ~Hold() { release(); }
    void release() { *held_ = false; }

    std::unique_ptr<Job> job() const { return std::make_unique<HeldJob>(held_); }

private:
    using Callout = std::shared_ptr<std::atomic<bool>>;

    /// Does nothing until it is released or cancelled.
    class HeldJob : public Job {
    public:
        explicit HeldJob(Callout held) : held_(std::move(held)) {}
        QString title() const override { return "Held"; }
        Result<void> process(Progress& progress) override {
            while (*held_ && !progress.isCancelled()) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return {};
        }
        void finalize() override {}

    private:
        Callout held_;
    };

    Callout held_ = std::make_shared<std::atomic<bool>>(true);
};

/// A workspace with a garment of two pieces, and files of other garments.
class WorkspaceFixture {
public:
    static constexpr int kPatience = 30000;  ///< milliseconds

    WorkspaceFixture() {
        writeObj(file("other.obj"), {{"sleeve", makeSheet(100, 200, 4, 8)}});
        writeObj(file("cap.obj"), sewnCapParts());
        writeObj(file("pair.obj"), {{"front", makeSheet(300, 400, 6, 8)},
                                    {"back", makeSheet(200, 100, 4, 2, {400, 0, 0})}});
    }

    /// A new workspace, with nothing open.
    void renew() { workspace_ = std::make_unique<Workspace>(); }
    void close() { workspace_.reset(); }
    bool openPair() {
        workspace_->open({file("pair.obj")});
        return waitUntilDone() && document().pieceCount() == 2;
    }

    Workspace& workspace() { return *workspace_; }
    Document& document() { return workspace_->document(); }
    std::filesystem::path file(const char* name) { return folder_.filePath(name).toStdU16String(); }
    QString path(const char* name) { return folder_.filePath(name); }

    bool waitUntilIdle() {
        return QTest::qWaitFor([this] { return !workspace_->jobs().isBusy(); }, kPatience);
    }
    bool waitUntilDone() {
        return QTest::qWaitFor(
            [this] { return !workspace_->jobs().isBusy() && document().isFlattened(); }, kPatience);
    }
    bool waitUntilWritten() {
        return QTest::qWaitFor([this] { return !workspace_->writing().isBusy(); }, kPatience);
    }

    void cutAcross(const std::string& name, double y) {
        workspace_->cuts().change("Cut", [name, y](SeamsFile& seams) {
            seams.cuts.push_back({name, UserCut::Kind::Path, {{0, y, 0}, {300, y, 0}}, false});
        });
    }

    /// Changes the fabric, which starts no job.
    void changeFabric(const char* preset) {
        DocumentState next = document().state();
        next.fabric = *fabricPreset(preset);
        document().edit("Fabric", std::move(next));
    }

    /// Calls `act` when the next garment is open, before anything is flat.
    void whenOpened(std::function<void()> act) {
        auto context = std::make_unique<QObject>();
        QObject::connect(&document(), &Document::opened, context.get(),
                         [this, act = std::move(act)] {
                             if (listening_) {
                                 listening_.release()->deleteLater();
                                 act();
                             }
                         });
        listening_ = std::move(context);
    }

private:
    QTemporaryDir folder_;
    std::unique_ptr<Workspace> workspace_;
    std::unique_ptr<QObject> listening_;
};

}  // namespace toile::test
