// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/navigation.h"

#include <QTest>
#include <vector>

#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

Q_DECLARE_METATYPE(toile::app::Navigation)
Q_DECLARE_METATYPE(toile::app::CameraMove)
Q_DECLARE_METATYPE(toile::app::ViewKey)

/// Which drag and which key does what, in every way of moving the view.
class NavigationTest : public QObject {
    Q_OBJECT

private slots:
    void dragsMoveTheCamera_data() {
        QTest::addColumn<Navigation>("navigation");
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::addColumn<CameraMove>("move");
        constexpr auto left = Qt::LeftButton, middle = Qt::MiddleButton, right = Qt::RightButton;
        constexpr auto none = Qt::NoModifier, shift = Qt::ShiftModifier, alt = Qt::AltModifier,
                       ctrl = Qt::ControlModifier;
        using enum CameraMove;
        struct Drag {
            const char* name;
            Qt::MouseButton button;
            Qt::KeyboardModifier key;
            CameraMove move;
        };
        struct Way {
            const char* name;
            Navigation navigation;
            std::vector<Drag> drags;
        };
        const Way ways[] = {
            {"Toile",
             Navigation::Toile,
             {{"middle turns", middle, none, Turn},
              {"right turns", right, none, Turn},
              {"Shift+middle pans", middle, shift, Pan},
              {"Shift+right pans", right, shift, Pan},
              {"Ctrl+middle zooms", middle, ctrl, Zoom}}},
            {"Blender",
             Navigation::Blender,
             {{"middle turns", middle, none, Turn},
              {"Shift+middle pans", middle, shift, Pan},
              {"Ctrl+middle zooms", middle, ctrl, Zoom},
              {"right does nothing", right, none, None},
              {"Alt+left turns", left, alt, Turn}}},
            {"CLO",
             Navigation::Clo,
             {{"right turns", right, none, Turn}, {"middle pans", middle, none, Pan}}},
            {"Rhino",
             Navigation::Rhino,
             {{"right turns", right, none, Turn},
              {"Shift+right pans", right, shift, Pan},
              {"Ctrl+right zooms", right, ctrl, Zoom},
              {"middle does nothing", middle, none, None}}}};
        for (const Way& way : ways) {
            for (const Drag& drag : way.drags) {
                QTest::addRow("%s: %s", way.name, drag.name)
                    << way.navigation << drag.button << Qt::KeyboardModifiers(drag.key)
                    << drag.move;
            }
        }
    }

    void dragsMoveTheCamera() {
        QFETCH(Navigation, navigation);
        QFETCH(Qt::MouseButton, button);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        QFETCH(CameraMove, move);
        QCOMPARE(cameraMove(navigation, button, modifiers), move);
    }

    void leftTurnsAndPansInToilesOwnWayOnly() {
        const auto left = Qt::LeftButton;
        QCOMPARE(cameraMove(Navigation::Toile, left, {}), CameraMove::Turn);
        QCOMPARE(cameraMove(Navigation::Toile, left, Qt::ShiftModifier), CameraMove::Pan);
        for (const Navigation navigation :
             {Navigation::Blender, Navigation::Clo, Navigation::Rhino}) {
            QCOMPARE(cameraMove(navigation, left, {}), CameraMove::None);
            QCOMPARE(cameraMove(navigation, left, Qt::ShiftModifier), CameraMove::None);
            QVERIFY(cameraHint(navigation, false) != cameraHint(Navigation::Toile, false));
        }
    }

    void keypadShowsTheSides() {
        const Qt::KeyboardModifiers pad = Qt::KeypadModifier, ctrl = Qt::ControlModifier;
        QCOMPARE(viewKey(Qt::Key_1, pad), std::optional(ViewKey::Front));
        QCOMPARE(viewKey(Qt::Key_1, pad | ctrl), std::optional(ViewKey::Back));
        QCOMPARE(viewKey(Qt::Key_3, pad), std::optional(ViewKey::Right));
        QCOMPARE(viewKey(Qt::Key_3, pad | ctrl), std::optional(ViewKey::Left));
        QCOMPARE(viewKey(Qt::Key_7, pad), std::optional(ViewKey::Top));
        QCOMPARE(viewKey(Qt::Key_7, pad | ctrl), std::optional(ViewKey::Bottom));
        QCOMPARE(viewKey(Qt::Key_9, pad), std::optional(ViewKey::Opposite));
        QCOMPARE(viewKey(Qt::Key_5, pad), std::optional(ViewKey::Orthographic));
        QCOMPARE(viewKey(Qt::Key_4, pad), std::optional(ViewKey::TurnLeft));
        QCOMPARE(viewKey(Qt::Key_2, pad), std::optional(ViewKey::TurnDown));
        // Without its lock the pad gives other names to the same keys.
        QCOMPARE(viewKey(Qt::Key_End, pad), std::optional(ViewKey::Front));
        QCOMPARE(viewKey(Qt::Key_Clear, pad), std::optional(ViewKey::Orthographic));
        // On a Mac every arrow key says that it is of the pad: those nudge.
        QCOMPARE(viewKey(Qt::Key_Left, pad, false), std::optional(ViewKey::TurnLeft));
        for (const int arrow : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}) {
            QVERIFY(!viewKey(arrow, pad, true));
        }
        QCOMPARE(viewKey(Qt::Key_4, pad, true), std::optional(ViewKey::TurnLeft));
        QVERIFY(!viewKey(Qt::Key_0, pad));
        QVERIFY(!viewKey(Qt::Key_1, {}));  // an overlay's
    }
};

TOILE_WINDOW_TEST(NavigationTest)
#include "navigation_test.moc"
