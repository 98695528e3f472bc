// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/project_bench.h"

#include <QSignalSpy>
#include <algorithm>
#include <cmath>

#include "app/widgets/banner.h"
#include "tests/app/support/garments.h"

namespace toile::test {

using namespace app;

namespace {

/// What a person has done, without what follows from it, and without what depends on the pieces'
/// own coordinates, which an edit may find otherwise than a new beginning.
DocumentState done(const Moment& moment) {
    DocumentState state = moment.state;
    std::erase_if(state.settings, [&moment](const auto& entry) {
        return std::ranges::none_of(moment.derived.garment->pieces, [&entry](const auto& piece) {
            return piece->id == entry.first;
        });
    });
    state.inputs.files.clear();          // read anew
    state.inputs.loading.known.clear();  // follows from what was read before
    for (auto& [id, piece] : state.settings) {
        piece.placement.reset();
        piece.grain.reset();
        piece.flat = 0;
    }
    return state;
}

/// Where each vertex lies on the sheet, and below the direction of the grain there.
std::vector<Points2> sheetOf(const Moment& moment) {
    std::vector<Points2> sheet;
    for (const auto& result : moment.derived.results) {
        const Points2& Q = result->flat->Q;
        const PieceSettings& said = moment.state.settings.at(result->piece->id);
        const Placement& place = *said.placement;
        const double grain = grainOf(said);
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

bool isSame(const Moment& a, const Moment& b) {
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
    workspace().cuts().change("Cut", [](SeamsFile& seams) {
        seams.cuts.push_back({"waist", UserCut::Kind::Path, {{0, 210, 0}, {300, 210, 0}}, false});
    });
    QVERIFY(waitUntilFlat());
    DocumentState next = document().state();
    PieceSettings& front = said(next, document(), 0);
    front.grain = 0.1;
    front.placement = Placement{{1.0 / 3, -700}, 0.7, true};
    said(next, document(), 1).quantity = 5;
    said(next, document(), 2).mirroredPair = true;
    next.fabric = *fabricPreset("jersey");
    document().edit("Things", std::move(next));
    workspace().setQuality(Quality::Fine);
    document().setOverlay(Overlay::Strain);
    QVERIFY(waitUntilFlat());
}

void ProjectBench::edit() {
    DocumentState next = document().state();
    ++said(next, document(), 0).quantity;
    document().edit("Quantity", std::move(next));
}

bool ProjectBench::waitUntilFlat() {
    return QTest::qWaitFor(
        [this] { return !workspace().jobs().isBusy() && document().isFlattened(); }, kPatience);
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
