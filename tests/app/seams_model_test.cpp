// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/seams_model.h"

#include <QBrush>
#include <QFont>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/render/scene_builder.h"
#include "app/text/figures.h"
#include "app/text/seam_fit.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/moment.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

void flattenInto(Document& document, Method method) {
    FlattenOptions options;
    options.method = method;
    Progress progress;
    PieceResults results = flattenGarment(*document.garment(), options, progress);
    auto scene = buildScene(*document.garment(), results, progress);
    test::setResults(document, std::move(results), std::move(scene));
}

float wornLength(const std::vector<LineVertex>& vertices, VertexRun run) {
    float sum = 0;
    for (std::uint32_t i = run.first + 1; i < run.first + run.count; ++i) {
        const auto &a = vertices[i - 1].position, &b = vertices[i].position;
        sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return sum;
}

float flatLength(const std::vector<LineVertex>& vertices, VertexRun run) {
    float sum = 0;
    for (std::uint32_t i = run.first + 1; i < run.first + run.count; ++i) {
        const auto &a = vertices[i - 1].flat, &b = vertices[i].flat;
        sum += std::hypot(a[0] - b[0], a[1] - b[1]);
    }
    return sum;
}

}  // namespace

/// The seam between two parts of a cap: row 0 of the model; free edges follow.
class SeamsModelTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<Document> document_;
    std::unique_ptr<SeamsModel> model_;

    QVariant at(int column, int role = Qt::DisplayRole) const {
        return model_->data(model_->index(0, column), role);
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void init() {
        document_ = std::make_unique<Document>();
        model_ = std::make_unique<SeamsModel>(*document_);
        test::setGarment(*document_, test::makeSewnCap(), nullptr);
    }

    void cleanup() {
        model_.reset();
        document_.reset();
    }

    void seamsAndFreeEdgesAreListedBeforeTheyAreFlat() {
        QVERIFY(model_->rowCount() >= 3);
        QCOMPARE(at(SeamsModel::Kind).toString(), QString("seam"));
        QVERIFY(!at(SeamsModel::Kind, SeamsModel::FreeRole).toBool());
        QCOMPARE(at(SeamsModel::FlatLeft).toString(), QString(QChar(0x2013)));
        QVERIFY(!at(SeamsModel::Error, Qt::BackgroundRole).isValid());
        QVERIFY(model_->summary().startsWith("1 seam · not measured"));
        const QModelIndex last = model_->index(model_->rowCount() - 1, SeamsModel::Kind);
        QCOMPARE(last.data().toString(), QString("free edge"));
        QVERIFY(last.data(SeamsModel::FreeRole).toBool());
    }

    void keptSeamLinesMatchToTheMicrometre() {
        flattenInto(*document_, Method::Wang2005);
        QCOMPARE(at(SeamsModel::Error).toString(), QString("0.00"));
        QCOMPARE(at(SeamsModel::Difference).toString(), QString("0.00"));
        QCOMPARE(at(SeamsModel::Fit).toString(), QString("matches"));
        QCOMPARE(at(SeamsModel::FlatLeft).toString(), at(SeamsModel::Length3d).toString());
        QCOMPARE(model_->summary(), QString("1 seam · worst 0.00 mm"));
        const QColor tint = at(SeamsModel::Error, Qt::BackgroundRole).value<QBrush>().color();
        QCOMPARE(tint.rgb(), fitColour(SeamFit::Matches).rgb());
    }

    void freeOutlinesDoNot() {
        flattenInto(*document_, Method::Natural);
        const auto measure = measured(*document_->garment(), document_->results(), 0);
        QVERIFY(std::abs(measure->errorMm) > kNearlyMm);
        QCOMPARE(at(SeamsModel::Error).toString(), signedNumber(measure->errorMm, 2));
        QCOMPARE(at(SeamsModel::Fit).toString(), QString("does not match"));
        const QColor tint = at(SeamsModel::Error, Qt::BackgroundRole).value<QBrush>().color();
        QCOMPARE(tint.rgb(), fitColour(SeamFit::Differs).rgb());
        QVERIFY(tint.alphaF() < 0.5F);  // the number is read on it
        QVERIFY(model_->summary().contains("1 does not match"));
    }

    void boundsOfTheColours() {
        const Seam& seam = document_->garment()->seams.seams.front();
        const auto fit = [&seam](double error) {
            SeamMeasure measure;
            measure.errorMm = error;
            return seamFit(seam, measure);
        };
        QCOMPARE(fit(0.5), SeamFit::Matches);
        QCOMPARE(fit(-0.51), SeamFit::Nearly);
        QCOMPARE(fit(-1.6), SeamFit::Nearly);
        QCOMPARE(fit(1.61), SeamFit::Differs);
        QCOMPARE(seamFit(seam, std::nullopt), SeamFit::Unknown);
    }

    void numbersStandRight() {
        QCOMPARE(at(SeamsModel::Error, Qt::TextAlignmentRole).toInt(),
                 int(Qt::AlignRight | Qt::AlignVCenter));
        QCOMPARE(at(SeamsModel::Name, Qt::TextAlignmentRole).toInt(),
                 int(Qt::AlignLeft | Qt::AlignVCenter));
        QCOMPARE(signedNumber(-0.0004, 2), QString("0.00"));
        QCOMPARE(signedNumber(-1.204, 2), QString(QChar(0x2212)) + "1.20");
        QCOMPARE(signedNumber(3, 1), QString("+3.0"));
    }

    void percentagesAreReadAsTyped() {
        QCOMPARE(*parsePercent(" +2.5 % ")->fraction, 0.025);
        QCOMPARE(*parsePercent(QString(QChar(0x2212)) + "3")->fraction, -0.03);
        QVERIFY(parsePercent("") && !parsePercent("")->fraction);
        for (const auto language : {QLocale::English, QLocale::German}) {
            QLocale::setDefault(language);
            QCOMPARE(*parsePercent("0.125")->fraction, 0.00125);
            QCOMPARE(*parsePercent("0,125")->fraction, 0.00125);
            QCOMPARE(*parsePercent("1,5 %")->fraction, 0.015);
            QVERIFY(!parsePercent("1,250.5"));
        }
        QLocale::setDefault(QLocale::c());
        for (const char* nonsense : {"two", "-100", "1e9", "nan"}) {
            QVERIFY2(!parsePercent(nonsense), nonsense);
        }
    }

    void editingAsksForTheEaseAndShowsItAsStated() {
        flattenInto(*document_, Method::Natural);
        const auto measure = *measured(*document_->garment(), document_->results(), 0);
        connect(
            model_.get(), &SeamsModel::easeWanted, document_.get(),
            [this](int seam, std::optional<double> ease) { document_->setSeamEase(seam, ease); });
        QVERIFY(model_->flags(model_->index(0, SeamsModel::Ease)).testFlag(Qt::ItemIsEditable));
        QVERIFY(!at(SeamsModel::Ease, Qt::FontRole).value<QFont>().bold());
        QCOMPARE(at(SeamsModel::Ease, Qt::EditRole).toString(), QString());

        // The ease that the flat edges happen to have: nothing is wrong then.
        const double ease = measure.length2dLeft / measure.length2dRight - 1;
        const QString typed = QString::number(100 * ease, 'f', 4);
        QVERIFY(model_->setData(model_->index(0, SeamsModel::Ease), typed, Qt::EditRole));
        QCOMPARE(at(SeamsModel::Error).toString(), QString("0.00"));
        QCOMPARE(at(SeamsModel::Fit).toString(), QString("matches"));
        QVERIFY(at(SeamsModel::Ease, Qt::FontRole).value<QFont>().bold());
        QVERIFY(!document_->results().empty());

        QVERIFY(!model_->setData(model_->index(0, SeamsModel::Ease), "much", Qt::EditRole));
        QVERIFY(model_->setData(model_->index(0, SeamsModel::Ease), "", Qt::EditRole));
        QVERIFY(!document_->garment()->seams.seams[0].ease);
        QCOMPARE(at(SeamsModel::Fit).toString(), QString("does not match"));
    }

    void freeEdgesHaveNoEase() {
        const QModelIndex index = model_->index(model_->rowCount() - 1, SeamsModel::Ease);
        QVERIFY(!model_->flags(index).testFlag(Qt::ItemIsEditable));
        QSignalSpy wanted(model_.get(), &SeamsModel::easeWanted);
        QVERIFY(!model_->setData(index, "2", Qt::EditRole));
        QCOMPARE(wanted.count(), 0);
    }

    void theSceneHasBothSidesOfTheSeamInBothViews() {
        flattenInto(*document_, Method::Natural);
        const Scene& scene = *document_->scene();
        const Seam& seam = document_->garment()->seams.seams.front();
        QCOMPARE(scene.seams.size(), document_->garment()->seams.seams.size());
        const auto& inSpace = scene.garmentLines.seams.front();
        const auto& inPattern = scene.patternLines.seams.front();
        const double left = double(wornLength(scene.lineVertices, inSpace[0]));
        QVERIFY(std::abs(left - seam.length3d[0]) < 1e-2);
        QVERIFY(std::abs(left - double(wornLength(scene.lineVertices, inSpace[1]))) < 1e-2);
        const auto measure = *measured(*document_->garment(), document_->results(), 0);
        QVERIFY(std::abs(double(flatLength(scene.lineVertices, inPattern[0])) -
                         measure.length2dLeft) < 1e-2);
        QVERIFY(std::abs(double(flatLength(scene.lineVertices, inPattern[1])) -
                         measure.length2dRight) < 1e-2);
        // Each lies on its own piece; framing holds both.
        QCOMPARE(scene.lineVertices[inPattern[0].first].piece, float(seam.left.piece));
        QCOMPARE(scene.lineVertices[inPattern[1].first].piece, float(seam.right.piece));
        for (int k = 0; k < 2; ++k) {
            const SeamScene::Side& side = scene.seams.front().sides[std::size_t(k)];
            QCOMPARE(side.piece, k == 0 ? seam.left.piece : seam.right.piece);
            QVERIFY(scene.pieces[std::size_t(side.piece)].flatBox.contains(side.flatBox));
        }
        QVERIFY(!scene.seams.front().box.isEmpty());
    }

    void beforeFlatteningSeamsAreInSpaceOnly() {
        Progress progress;
        const auto scene = buildScene(*document_->garment(), {}, progress);
        QVERIFY(scene->garmentLines.seams.front()[1].count > 1);
        QCOMPARE(scene->patternLines.seams.front()[0].count, 0U);
        QVERIFY(placedBox(scene->seams.front(), {}).isEmpty());
    }
};

TOILE_WINDOW_TEST(SeamsModelTest)
#include "seams_model_test.moc"
