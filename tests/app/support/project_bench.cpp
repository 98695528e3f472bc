// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/project_bench.h"

#include <QSignalSpy>
#include <cmath>

#include "app/widgets/banner.h"
#include "tests/app/support/garments.h"

namespace toile::test {

namespace {

/// What a person has done, without what follows from it, and without what depends on the pieces'
/// own coordinates, which an edit may find otherwise than a new beginning.
DocumentState done(DocumentState state) {
    state.garment.reset();
    state.results.clear();
    state.scene.reset();
    for (PieceSettings& piece : state.settings) {
        piece.placement.reset();
        piece.grain.reset();
    }
    return state;
}

/// Where each vertex lies on the sheet, and below the direction of the grain there.
std::vector<Points2> sheetOf(const DocumentState& state) {
    std::vector<Points2> sheet;
    for (std::size_t i = 0; i < state.results.size(); ++i) {
        const Points2& Q = state.results[i]->flat->Q;
        const Placement& place = *state.settings[i].placement;
        const double grain = grainOf(state.settings[i]);
        Points2 points(Q.rows() + 1, 2);
        points.topRows(Q.rows()) = Q * place.linear().transpose();
        points.topRows(Q.rows()).rowwise() += place.offset.transpose();
        points.bottomRows(1) =
            (place.linear() * Eigen::Vector2d(std::cos(grain), std::sin(grain))).transpose();
        sheet.push_back(std::move(points));
    }
    return sheet;
}

}  // namespace

bool isSame(const DocumentState& a, const DocumentState& b) {
    const auto one = sheetOf(a), other = sheetOf(b);
    if (!(done(a) == done(b)) || one.size() != other.size()) {
        return false;
    }
    for (std::size_t i = 0; i < one.size(); ++i) {
        const double apart =
            one[i].rows() == other[i].rows() ? (one[i] - other[i]).cwiseAbs().maxCoeff() : HUGE_VAL;
        if (!(apart < kSameShape)) {
            qWarning("piece %zu is %g mm from where it was", i, apart);
            return false;
        }
    }
    return true;
}

void ProjectBench::initTestCase() {
    SKIP_WITHOUT_GL();
}

void ProjectBench::init() {
    fixture_ = std::make_unique<WindowFixture>();
    answer_ = SaveAnswer::Cancel;
    overwrite_ = OverwriteAnswer::Cancel;
    asked_ = askedAboutOthers_ = 0;
    target_.clear();
    foundMesh_.clear();
    lookedFor_.clear();
    writeMesh("dress.obj");
    openWindow();
    QVERIFY(fixture_->openAndWait(path("dress.obj")));
}

void ProjectBench::cleanup() {
    fixture_->close();
    fixture_.reset();
}

void ProjectBench::openWindow() {
    fixture_->open();
    FileDialogs& dialogs = window().garmentActions().fileDialogs();
    dialogs.askToSave = [this](QWidget*, const QString&) {
        ++asked_;
        return answer_;
    };
    dialogs.askToOverwrite = [this](QWidget*, const QString& name) {
        ++askedAboutOthers_;
        return name.endsWith(".toile") ? overwrite_ : OverwriteAnswer::Cancel;
    };
    dialogs.saveProject = [this](QWidget*, const QString&) { return target_; };
    dialogs.findMesh = [this](QWidget*, const QString&, const QString& name) {
        lookedFor_ << name;
        return foundMesh_;
    };
}

void ProjectBench::reopenWindow() {
    fixture_->close();
    openWindow();
}

void ProjectBench::writeMesh(const QString& name, double width) {
    writeObj(path(name).toStdString(), {{"front", makeSheet(width, 400, 6, 8)},
                                        {"back", makeSheet(200, 100, 4, 2, {400, 0, 0})},
                                        {"cap", makeCap(900)}});
}

void ProjectBench::doThings() {
    workspace().changeSeams("Cut", [](SeamsFile& seams) {
        seams.cuts.push_back({"waist", UserCut::Kind::Path, {{0, 210, 0}, {300, 210, 0}}, false});
    });
    QVERIFY(waitUntilFlat());
    DocumentState next = document().state();
    next.settings[0].placement = Placement{{1.0 / 3, -700}, 0.7, true};
    next.settings[0].grain = 0.1;
    next.settings[1].quantity = 5;
    next.settings[2].mirroredPair = true;
    next.fabric = *fabricPreset("jersey");
    document().edit("Things", std::move(next));
    workspace().setQuality(Quality::Fine);
    document().setOverlay(Overlay::Strain);
    QVERIFY(waitUntilFlat());
}

void ProjectBench::edit() {
    DocumentState next = document().state();
    ++next.settings[0].quantity;
    document().edit("Quantity", std::move(next));
}

bool ProjectBench::waitUntilFlat() {
    return QTest::qWaitFor(
        [this] { return !workspace().jobs().isBusy() && isFlattened(document().state()); },
        kPatience);
}

bool ProjectBench::waitForBanner() {
    return QTest::qWaitFor([this] { return !window().banner().isHidden(); }, kPatience);
}

void ProjectBench::saveAs(const QString& name) {
    target_ = path(name);
    QSignalSpy saved(&session(), &ProjectSession::saved);
    fixture_->action(ActionId::SaveAs).trigger();
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, kPatience);
}

}  // namespace toile::test
