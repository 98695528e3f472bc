// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "app/panels/preferences_dialog.h"
#include "app/render/render_style.h"
#include "app/session/autosave.h"
#include "app/settings/language.h"
#include "app/settings/length_display.h"
#include "app/settings/preferences.h"
#include "app/settings/theme.h"
#include "app/text/figures.h"
#include "app/views/view_text.h"
#include "app/widgets/number_edits.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

double linearChannel(double channel) {
    return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    return 0.2126 * linearChannel(colour.red() / 255.0) +
           0.7152 * linearChannel(colour.green() / 255.0) +
           0.0722 * linearChannel(colour.blue() / 255.0);
}

/// As the web's accessibility guidelines define it.
double contrast(const QColor& a, const QColor& b) {
    const double lighter = std::max(luminance(a), luminance(b));
    const double darker = std::min(luminance(a), luminance(b));
    return (lighter + 0.05) / (darker + 0.05);
}

template <class Widget>
Widget& in(QWidget& parent, const char* name) {
    return *parent.findChild<Widget*>(name);
}

void type(QAbstractSpinBox& edit, const QString& text) {
    edit.selectAll();
    QTest::keyClicks(&edit, text);
    QTest::keyClick(&edit, Qt::Key_Return);
}

}  // namespace

/// Preferences and their dialog, themes, languages, and how lengths are shown and typed.
class SettingsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void cleanup() {
        LengthDisplay::instance().choose(LengthUnit::Millimetre);
        QLocale::setDefault(QLocale::c());
        setMarkColours({}, {});
    }

    void choicesAreKept() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        const Choices choices{.lengthUnit = LengthUnit::Inch,
                              .inchDenominator = 32,
                              .theme = Theme::Dark,
                              .language = Language::German,
                              .navigation = Navigation::Clo,
                              .newGarment = NewGarment::Exact,
                              .menus = Menus::Plain,
                              .selectionColour = QColor(1, 2, 3),
                              .seamColour = QColor(4, 5, 6),
                              .autosaveMinutes = 0,
                              .autoFlattenTriangles = 1234};
        Preferences(file).setChoices(choices);
        QCOMPARE(Preferences(file).choices(), choices);
    }

    void nonsenseInTheSettingsFileReadsAsTheDefault() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        {
            QSettings settings(file, QSettings::IniFormat);
            for (const char* name : {"lengthUnit", "inchDenominator", "theme", "language",
                                     "navigation", "newGarment", "menus", "selectionColour",
                                     "seamColour", "autosaveMinutes", "autoFlattenTriangles"}) {
                settings.setValue(QString("choices/%1").arg(name), "-7 furlongs");
            }
        }
        QCOMPARE(Preferences(file).choices(), Choices{});
    }

    void noMoreMinutesBetweenCopiesThanTheDialogOffers() {
        QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini");
        QSettings(file, QSettings::IniFormat).setValue("choices/autosaveMinutes", 2147483647);
        const int minutes = Preferences(file).choices().autosaveMinutes;
        QCOMPARE(minutes, Choices::kMaxAutosaveMinutes);
        QCOMPARE(autosaveTimes(minutes)->apart, 60 * 60'000);  // and no overflow
    }

    void onlyWhatChangesIsSaid() {
        Preferences preferences{QString()};
        std::vector<Choices> before;
        connect(&preferences, &Preferences::choicesChanged, this,
                [&before](const Choices& choices) { before.push_back(choices); });
        preferences.setChoices({.navigation = Navigation::Rhino});
        preferences.setChoices({.navigation = Navigation::Rhino});
        QCOMPARE(before, std::vector{Choices{}});
        preferences.setChoices({.theme = Theme::Dark});
        QCOMPARE(before.back(), Choices{.navigation = Navigation::Rhino});
    }

    void dialogAppliesAtOnceAndCancelPutsBack() {
        Preferences preferences{QString()};
        const Choices before{.lengthUnit = LengthUnit::Centimetre, .autosaveMinutes = 9};
        preferences.setChoices(before);
        PreferencesDialog dialog(preferences, nullptr);
        dialog.show();
        auto& unit = in<QComboBox>(dialog, "lengthUnitChoice");
        QCOMPARE(unit.currentIndex(), 1);
        QTest::keyClick(&unit, Qt::Key_End);
        QCOMPARE(preferences.choices().lengthUnit, LengthUnit::Inch);
        QCOMPARE(preferences.choices().inchDenominator, 32);
        QTest::keyClick(&in<QComboBox>(dialog, "themeChoice"), Qt::Key_End);
        QCOMPARE(preferences.choices().theme, Theme::Dark);
        QTest::keyClick(&in<QSpinBox>(dialog, "autosaveMinutes"), Qt::Key_Down);
        QCOMPARE(preferences.choices().autosaveMinutes, 8);
        QTest::keyClick(&in<QComboBox>(dialog, "newGarmentChoice"), Qt::Key_Home);
        QCOMPARE(preferences.choices().newGarment, NewGarment::Exact);
        QVERIFY(!in<QWidget>(dialog, "restartNote").isVisible());
        QTest::keyClick(&in<QComboBox>(dialog, "languageChoice"), Qt::Key_End);
        QCOMPARE(preferences.choices().language, Language::German);
        QVERIFY(in<QWidget>(dialog, "restartNote").isVisible());
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
        QCOMPARE(preferences.choices(), before);
    }

    void dialogResetsAndKeepsOnOk() {
        Preferences preferences{QString()};
        preferences.setChoices({.theme = Theme::Dark, .navigation = Navigation::Blender});
        PreferencesDialog dialog(preferences, nullptr);
        dialog.show();
        auto& buttons = in<QDialogButtonBox>(dialog, "preferencesButtons");
        QTest::mouseClick(buttons.button(QDialogButtonBox::RestoreDefaults), Qt::LeftButton);
        QCOMPARE(preferences.choices(), Choices{});
        QCOMPARE(in<QComboBox>(dialog, "themeChoice").currentIndex(), 0);
        QTest::keyClick(&in<QComboBox>(dialog, "navigationChoice"), Qt::Key_End);
        QTest::mouseClick(buttons.button(QDialogButtonBox::Ok), Qt::LeftButton);
        QVERIFY(!dialog.isVisible());
        QCOMPARE(preferences.choices().navigation, Navigation::Rhino);
    }

    void bothPalettesAreLegible() {
        for (const QPalette& palette : {lightPalette(), darkPalette()}) {
            const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
                {QPalette::WindowText, QPalette::Window},
                {QPalette::Text, QPalette::Base},
                {QPalette::Text, QPalette::AlternateBase},
                {QPalette::ButtonText, QPalette::Button},
                {QPalette::HighlightedText, QPalette::Highlight},
                {QPalette::PlaceholderText, QPalette::Base},
                {QPalette::PlaceholderText, QPalette::Window},
                {QPalette::Link, QPalette::Base},
                {QPalette::ToolTipText, QPalette::ToolTipBase}};
            for (const auto& [ink, paper] : pairs) {
                QVERIFY2(contrast(palette.color(ink), palette.color(paper)) >= 4.5,
                         qPrintable(QString("role %1 on %2").arg(ink).arg(paper)));
            }
        }
        QVERIFY(!isDark(lightPalette()));
        QVERIFY(isDark(darkPalette()));
    }

    void themeIsAppliedAtOnceAndTakenBack() {
        const QPalette desktop = QApplication::palette();
        const QString style = QApplication::style()->name();
        applyTheme(Theme::Dark);
        QVERIFY(isDark(QApplication::palette()));
        QVERIFY(isDark(QWidget().palette()));
        applyTheme(Theme::Light);
        QVERIFY(!isDark(QApplication::palette()));
        applyTheme(Theme::System);
        QCOMPARE(QApplication::palette().color(QPalette::Window), desktop.color(QPalette::Window));
        QCOMPARE(QApplication::style()->name(), style);
    }

    void chosenColoursReplaceThoseOfTheTheme() {
        const RenderStyle usual = renderStyle(lightPalette());
        setMarkColours(QColor(1, 2, 3), {});
        QCOMPARE(renderStyle(lightPalette()).selection, QColor(1, 2, 3));
        QCOMPARE(renderStyle(darkPalette()).selection, QColor(1, 2, 3));
        QCOMPARE(renderStyle(lightPalette()).seam, usual.seam);
        setMarkColours({}, {});
        QCOMPARE(renderStyle(lightPalette()).selection, usual.selection);
    }

    void languageOfTheDesktopIsTakenWhereThereIsOne() {
        const QLocale german("de_AT"), french("fr_FR");
        QCOMPARE(resolved(Language::System, german), Language::German);
        QCOMPARE(resolved(Language::System, french), Language::English);
        QCOMPARE(resolved(Language::English, german), Language::English);
        QCOMPARE(resolved(Language::German, french), Language::German);
    }

    void figuresFollowTheUnit() {
        LengthDisplay& display = LengthDisplay::instance();
        const QSignalSpy changed(&display, &LengthDisplay::changed);
        QCOMPARE(lengthWithUnit(412.34), QString("412.3 mm"));
        QCOMPARE(signedFineLength(-0.5), QString("−0.50"));
        display.choose(LengthUnit::Centimetre);
        QCOMPARE(lengthWithUnit(412.34), QString("41.23 cm"));
        QCOMPARE(areaWithUnit(41230), QString("412.3 cm²"));
        QCOMPARE(areaWithUnit(999000), QString("9990.0 cm²"));
        QCOMPARE(areaWithUnit(1948600), QString("1.95 m²"));  // nobody reads 19486.0 cm²
        QCOMPARE(fineLength(0.5), QString("0.050"));
        display.choose(LengthUnit::Inch, 16);
        display.choose(LengthUnit::Inch, 16);
        QCOMPARE(lengthWithUnit(412.34), QString("16 1/4 in"));
        QCOMPARE(lengthNumber(-9.525), QString("−3/8"));
        QCOMPARE(areaWithUnit(64516), QString("100.0 in²"));
        QCOMPARE(areaWithUnit(3 * 914.4 * 914.4), QString("3.00 yd²"));
        QCOMPARE(signedFineLength(0.254), QString("+0.010"));
        QCOMPARE(changed.size(), 2);
    }

    void scaleBarIsRoundInInchesToo() {
        LengthDisplay::instance().choose(LengthUnit::Inch, 16);
        for (const double pixelsPerMillimetre : {0.03, 0.1, 0.6, 3.0, 20.0, 45.0}) {
            const ScaleBar bar = scaleBarFor(150, pixelsPerMillimetre);
            const double eighths = bar.millimetres / 25.4 * 8;
            QVERIFY(std::abs(eighths - std::round(eighths)) < 1e-9);
            QVERIFY(bar.millimetres * pixelsPerMillimetre <= 150.001);
            QVERIFY(bar.text.endsWith(" in"));
        }
    }

    void lengthsAreTypedInAnyUnit_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("millimetres");
        QTest::addColumn<QString>("shown");
        QTest::newRow("own unit") << "12,5" << 125.0 << "12.50 cm";
        QTest::newRow("inches") << "12 3/8\"" << 314.325 << "31.43 cm";
        QTest::newRow("sum") << "2*45 mm + 1 cm" << 100.0 << "10.00 cm";
    }

    void lengthsAreTypedInAnyUnit() {
        QFETCH(QString, typed);
        QFETCH(double, millimetres);
        QFETCH(QString, shown);
        LengthDisplay::instance().choose(LengthUnit::Centimetre);
        LengthEdit edit;
        edit.show();
        type(edit, typed);
        QVERIFY(std::abs(edit.value() - millimetres) < 1e-5);
        QCOMPARE(edit.text(), shown);
    }

    void lengthKeepsItsValueWhateverIsShown() {
        LengthEdit edit;
        edit.show();
        edit.setValue(10.37);
        LengthDisplay::instance().choose(LengthUnit::Inch, 8);
        QCOMPARE(edit.text(), QString("3/8 in"));
        QTest::keyClick(&edit, Qt::Key_Return);
        QCOMPARE(edit.value(), 10.37);
        LengthDisplay::instance().choose(LengthUnit::Millimetre);
        QCOMPARE(edit.text(), QString("10.4 mm"));
        QTest::keyClick(&edit, Qt::Key_Up);
        QVERIFY(std::abs(edit.value() - 11.37) < 1e-9);
        type(edit, "no length");
        QVERIFY(std::abs(edit.value() - 11.37) < 1e-9);
    }

    void anglesAreTypedInDegrees() {
        AngleEdit edit;
        edit.show();
        type(edit, "90 - 12,5");
        QVERIFY(std::abs(edit.value() - 77.5) < 1e-9);
        QCOMPARE(edit.text(), QString("77.5°"));
        edit.setValue(180);
        QTest::keyClick(&edit, Qt::Key_Up);
        QCOMPARE(edit.text(), QString("-180°"));
        type(edit, "400");
        QVERIFY(std::abs(edit.value()) <= 180);
    }
};

TOILE_WINDOW_TEST(SettingsTest)
#include "settings_test.moc"
