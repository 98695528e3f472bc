// SPDX-License-Identifier: GPL-3.0-or-later
// Follows first_steps.txt, the steps of docs/first-steps.md.
// With TOILE_UPDATE_DOCS set, the page's pictures are taken on the way.
#include <QLocale>
#include <QPixmap>

#include "app/render/gl_support.h"
#include "tests/app/support/guide.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class FirstStepsTest : public QObject {
    Q_OBJECT

private:
    static constexpr int kPictureWidth = 1200;

    test::WindowFixture fixture_;

private slots:
    void initTestCase() { SKIP_WITHOUT_GL(); }

    void stepsCanBeFollowed() {
        const QString docs = TOILE_SOURCE_DIR "/docs/";
        const auto steps = test::readGuide(TOILE_SOURCE_DIR "/tests/app/first_steps.txt");
        QVERIFY(steps.size() > 20);
        fixture_.open({1400, 900}, test::NewGarment::Pattern);
        test::GuideWalker walker(fixture_, TOILE_SOURCE_DIR);
        for (const test::GuideStep& step : steps) {
            if (step.kind == test::GuideStep::Kind::Do) {
                const QString wrong = walker.follow(step.text);
                QVERIFY2(wrong.isEmpty(), qPrintable(QString("first_steps.txt:%1: %2: %3")
                                                         .arg(step.line)
                                                         .arg(step.text, wrong)));
                continue;
            }
            const QString file = docs + step.text;
            if (qEnvironmentVariableIsSet("TOILE_UPDATE_DOCS")) {
                const QPixmap picture = fixture_.window().grab();
                QVERIFY(picture.scaledToWidth(kPictureWidth, Qt::SmoothTransformation).save(file));
            }
            QVERIFY2(!QPixmap(file).isNull(), qPrintable(file));
        }
        fixture_.close();
    }
};

TOILE_WINDOW_TEST(FirstStepsTest)
#include "first_steps_test.moc"
