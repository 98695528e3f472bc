// SPDX-License-Identifier: GPL-3.0-or-later
// A lining in its shell: what the window asks, and pieces by material and layer, by clicks in the
// list, the views and their menus.
#include <QInputDialog>
#include <QMenu>
#include <QPushButton>
#include <QTreeView>

#include "app/actions/project_actions.h"
#include "app/panels/pieces_model.h"
#include "app/render/scene.h"
#include "app/settings/language.h"
#include "app/widgets/garment_card.h"
#include "core/project/layer_materials.h"
#include "tests/app/support/garments.h"
#include "tests/app/support/mouse.h"
#include "tests/app/support/run_test.h"
#include "tests/app/support/window_fixture.h"

using namespace toile;
using namespace toile::app;

namespace {

MeshArrays insideOf(MeshArrays strip, double x) {
    strip.V.col(0) = x + 0.96 * (strip.V.col(0).array() - x);
    strip.V.col(2) *= 0.96;
    return strip;
}

}  // namespace

class LayersOfClothTest : public QObject {
    Q_OBJECT

private:
    test::WindowFixture fixture_;

    Document& document() { return fixture_.document(); }
    QTreeView& table() { return fixture_.find<QTreeView>("pieceTable"); }
    QStringList materials() {
        QStringList found;
        for (const PieceSettings& said : document().settings()) {
            found << QString::fromStdString(said.material);
        }
        return found;
    }
    QStringList listed() {
        QStringList found;
        for (const Material& material : document().state().materials) {
            found << QString::fromStdString(material.name);
        }
        return found;
    }
    void press(const QString& text) {
        for (auto* button : fixture_.window().card().findChildren<QPushButton*>()) {
            if (button->text() == text && button->isVisible()) {
                QTest::mouseClick(button, Qt::LeftButton);
                QVERIFY(fixture_.waitForResults());
                return;
            }
        }
        QFAIL(qPrintable(text));
    }
    QMenu* shownMenu(const char* name) {
        for (auto* menu : fixture_.window().findChildren<QMenu*>(name)) {
            if (menu->isVisible()) {
                return menu;
            }
        }
        return nullptr;
    }
    /// In the menu that is shown, by the mouse.
    void chooseMaterial(const QString& text) {
        QMenu* menu = shownMenu("pieceContext");
        QVERIFY(menu);
        auto* below = menu->findChild<QMenu*>("materialMenu");
        QVERIFY(below);
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(below->menuAction()).center());
        QTRY_VERIFY_WITH_TIMEOUT(below->isVisible(), test::kPatience);
        for (QAction* entry : below->actions()) {
            if (entry->text() == text) {
                QTest::mouseClick(below, Qt::LeftButton, {}, below->actionGeometry(entry).center());
                QTRY_VERIFY_WITH_TIMEOUT(!shownMenu("pieceContext"), test::kPatience);
                return;
            }
        }
        QFAIL(qPrintable(text));
    }
    void rightClickRow(int row) {
        const QPoint at =
            table().visualRect(table().model()->index(row, PiecesModel::Name)).center();
        QContextMenuEvent asked(QContextMenuEvent::Mouse, at, table().viewport()->mapToGlobal(at));
        QCoreApplication::sendEvent(table().viewport(), &asked);
    }

private slots:
    void initTestCase() {
        SKIP_WITHOUT_GL();
        const MeshArrays front = test::makeBentStrip(0), back = test::makeBentStrip(300);
        test::writeObj(fixture_.path("coat.obj").toStdString(),
                       {{"front", front},
                        {"back", back},
                        {"front inside", insideOf(front, 0)},
                        {"back inside", insideOf(back, 300)}});
        test::writeObj(fixture_.path("plain.obj").toStdString(),
                       {{"front", front}, {"back", back}});
    }

    void init() {
        fixture_.open();
        fixture_.workspace().setUnit(LengthUnit::Millimetre);
        QVERIFY(fixture_.openAndWait(fixture_.path("coat.obj")));
    }

    void cleanup() { fixture_.close(); }

    void theCardAsksAndLayersAreMaterials() {
        QVERIFY(fixture_.window().card().isVisible());
        QVERIFY2(fixture_.window().card().sentence().contains("contains 2 layers of cloth"),
                 qPrintable(fixture_.window().card().sentence()));
        QCOMPARE(document().pieceCount(), 4);
        QCOMPARE(materials(), QStringList({"", "", "Lining", "Lining"}));
        QCOMPARE(listed(), QStringList({"Lining"}));
        QVERIFY(!table().isColumnHidden(PiecesModel::MaterialName));
        QVERIFY(!table().isColumnHidden(PiecesModel::Layer));
        QCOMPARE(table().model()->index(2, PiecesModel::Layer).data().toString(), QString("2"));
        QVERIFY(!fixture_.window().isWindowModified());

        press("Inner only");
        QVERIFY(!fixture_.window().card().isVisible());
        QCOMPARE(document().pieceCount(), 2);
        QCOMPARE(materials(), QStringList({"", ""}));
        QVERIFY(!document().scene()->garmentLines.leftOut.empty());
        QVERIFY(fixture_.action(ActionId::ReadInnerLayer).isChecked());
        QVERIFY(table().isColumnHidden(PiecesModel::Layer));
        fixture_.action(ActionId::Undo).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(materials(), QStringList({"", "", "Lining", "Lining"}));
        QCOMPARE(listed(), QStringList({"Lining"}));
    }

    void sheetsThatAreNoLayersAreOfOneFabric() {
        press("No layers");
        QCOMPARE(document().pieceCount(), 4);
        QCOMPARE(materials(), QStringList({"", "", "", ""}));
        QVERIFY(listed().isEmpty());
        fixture_.action(ActionId::ReadLayers).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(materials(), QStringList({"", "", "Lining", "Lining"}));
        QCOMPARE(listed(), QStringList({"Lining"}));
    }

    void theGarmentsFabricStaysWhereAPersonSaidIt() {
        document().setSelection({2});
        rightClickRow(2);
        chooseMaterial("Garment's &fabric");
        press("No layers");
        QCOMPARE(materials(), QStringList({"", "", "", ""}));
        const QString project = fixture_.path("said.toile");
        fixture_.window().garmentActions().project().session().save(project.toStdString());
        QVERIFY(fixture_.waitUntilIdle());
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(project));
        fixture_.action(ActionId::ReadLayers).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(materials(), QStringList({"", "", "", "Lining"}));
    }

    void whatAPersonSaysStaysThroughReloadAndSaving() {
        table().setFocus();
        document().setSelection({2});
        rightClickRow(2);
        chooseMaterial("Garment's &fabric");
        QCOMPARE(materials(), QStringList({"", "", "", "Lining"}));
        fixture_.action(ActionId::NewMaterial).trigger();
        auto& dialog = fixture_.find<QInputDialog>("newMaterial");
        dialog.setTextValue("Felt");
        dialog.accept();
        QCOMPARE(materials(), QStringList({"", "", "Felt", "Lining"}));
        QCOMPARE(listed(), QStringList({"Lining", "Felt"}));
        const QStringList said = materials();
        fixture_.action(ActionId::Reload).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(materials(), said);
        const QString project = fixture_.path("coat.toile");
        fixture_.window().garmentActions().project().session().save(project.toStdString());
        QVERIFY(fixture_.waitUntilIdle());
        fixture_.close();
        fixture_.open();
        QVERIFY(fixture_.openAndWait(project));
        QCOMPARE(materials(), said);
        QCOMPARE(listed(), QStringList({"Lining", "Felt"}));
    }

    void piecesAreGroupedInTheViewsToo() {
        const QPointF at =
            *fixture_.garmentView().onScreen(0, 300, Eigen::Vector3d::Constant(1.0 / 3));
        test::moveTo(fixture_.garmentView(), at);
        test::sendMouse(fixture_.garmentView(), QEvent::MouseButtonPress, at, Qt::RightButton,
                        Qt::RightButton);
        test::sendMouse(fixture_.garmentView(), QEvent::MouseButtonRelease, at, Qt::RightButton,
                        Qt::NoButton);
        QCOMPARE(document().selection(), Document::Selection{0});
        chooseMaterial("Lining");
        QCOMPARE(materials(), QStringList({"Lining", "", "Lining", "Lining"}));
        QCOMPARE(document().history().undoText(), QString("Set material of front to Lining"));
    }

    void alikePiecesAreSelectedTogether() {
        document().setSelection({3});
        fixture_.action(ActionId::SelectSameMaterial).trigger();
        QCOMPARE(document().selection(), (Document::Selection{2, 3}));
        document().setSelection({0});
        fixture_.action(ActionId::SelectSameLayer).trigger();
        QCOMPARE(document().selection(), (Document::Selection{0, 1}));
        QVERIFY(fixture_.openAndWait(fixture_.path("plain.obj")));
        document().setSelection({0});
        QVERIFY(!fixture_.action(ActionId::SelectSameLayer).isEnabled());
        QVERIFY(fixture_.action(ActionId::SelectSameMaterial).isEnabled());
        QVERIFY(!fixture_.window().card().isVisible());
    }

    /// The last: what has been translated stays.
    void aLiningIsOneInAnyLanguage() {
        const QString project = fixture_.path("lined.toile");
        fixture_.window().garmentActions().project().session().save(project.toStdString());
        QVERIFY(fixture_.waitUntilIdle());
        fixture_.close();
        useLanguage(Language::German);
        fixture_.open();
        QVERIFY(fixture_.openAndWait(project));
        QCOMPARE(materials(), QStringList({"", "", "Lining", "Lining"}));  // named by then
        fixture_.action(ActionId::ReadSheet).trigger();
        QVERIFY(fixture_.waitForResults());
        QCOMPARE(materials(), QStringList({"", "", "", ""}));
    }
};

TOILE_WINDOW_TEST(LayersOfClothTest)
#include "layers_of_cloth_test.moc"
