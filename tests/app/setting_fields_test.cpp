// SPDX-License-Identifier: GPL-3.0-or-later
// Forms made from descriptions of settings: what the fields show, and what a change of one changes.
#include "app/widgets/setting_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <memory>

#include "core/pattern/line_fields.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

class SettingFieldsTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QWidget> form_;
    std::unique_ptr<SettingFields> fields_;
    std::vector<SettingChange> changes_;
    int gestures_ = 0;

    template <class Widget>
    Widget& find(const char* name) {
        return *form_->findChild<Widget*>(name);
    }
    void type(const char* name, const QString& text) {
        auto& field = find<QDoubleSpinBox>(name);
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    LineSettings changed(const LineSettings& lines) {
        return fields_->changed(kLineFields, lines, changes_.back());
    }

private slots:
    void init() {
        changes_.clear();
        form_ = std::make_unique<QWidget>();
        fields_ = std::make_unique<SettingFields>(
            *form_, [this] { return ++gestures_; },
            [this](const SettingChange& change) { changes_.push_back(change); });
    }

    void cleanup() {
        fields_.reset();
        form_.reset();
    }

    void everyFieldHasAnObjectNameAnAccessibleNameAndAToolTip() {
        fields_->make<SegmentSettings>(kSegmentFields, "segment");
        for (const char* name : {"segmentLength", "segmentTolerance", "segmentStraight",
                                 "segmentAllowance", "segmentCorner", "segmentExtension"}) {
            const auto* field = form_->findChild<QWidget*>(name);
            QVERIFY2(field, name);
            QVERIFY2(!field->accessibleName().isEmpty() && !field->toolTip().isEmpty(), name);
        }
        QVERIFY(changes_.empty());
    }

    void aChangeLeavesAllElseAsItWas() {
        fields_->make<LineSettings>(kLineFields, {});
        LineSettings lines = withPattern({});
        lines.notches->notches.push_back({});
        lines.internalLines.push_back({"pocket", {{1, 2, 3}}});
        lines.facings.push_back({"facing", {}, 40});
        fields_->show(kLineFields, lines);
        type("allowanceHem", "25");
        LineSettings expected = lines;
        expected.allowance->hem = 25;
        QVERIFY(changed(lines) == expected);
        QTest::keyClick(&find<QComboBox>("notchesForm"), Qt::Key_Down);
        expected = lines;
        expected.notches->form = NotchForm::V;
        QVERIFY(changed(lines) == expected);
    }

    void aGroupIsSwitchedOnWithTheValuesOfItsFields() {
        fields_->make<LineSettings>(kLineFields, {});
        type("allowanceSeam", "12");
        LineSettings expected;
        expected.allowance = AllowanceWidths{12, 30};
        QVERIFY(changed({}) == expected);
        find<QCheckBox>("allowance").click();
        QVERIFY(changed({}) == expected);
        find<QCheckBox>("allowance").click();
        QVERIFY(changed(expected) == LineSettings{});
        QVERIFY(changes_.back().text.contains("off"));
        QCOMPARE(changes_.back().gesture, -1);
    }

    void aNumberWithASwitchIsZeroWhenItIsOff() {
        LineSettings proposed;
        proposed.trueBelow = kProposedTrueing;
        fields_->make(kLineFields, {}, proposed);
        fields_->show(kLineFields, LineSettings{}, proposed);
        auto& box = find<QCheckBox>("trueBelowOn");
        QVERIFY(!box.isChecked());
        QCOMPARE(find<QDoubleSpinBox>("trueBelow").value(), 10.0);
        box.click();
        QVERIFY(std::abs(changed({}).trueBelow - kProposedTrueing) < 1e-9);
        box.click();
        QCOMPARE(changed(proposed).trueBelow, 0.0);
    }

    void aValueThatIsSetIsBoldAndCanBeRemoved() {
        fields_->make<SegmentSettings>(kSegmentFields, "segment");
        SegmentSettings usual, settings;
        usual.length = 100;
        fields_->show(kSegmentFields, settings, usual);
        auto& length = find<QDoubleSpinBox>("segmentLength");
        auto& reset = find<QToolButton>("segmentLengthReset");
        QCOMPARE(length.value(), 100.0);
        QVERIFY(!length.font().bold() && !reset.isEnabled());
        settings.length = 90;
        fields_->show(kSegmentFields, settings, usual);
        QCOMPARE(length.value(), 90.0);
        QVERIFY(length.font().bold() && reset.isEnabled());
        QVERIFY(changes_.empty());  // only what the user does is a change
        reset.click();
        QVERIFY(!fields_->changed(kSegmentFields, settings, changes_.back()).length);
        QCOMPARE(changes_.back().gesture, gestures_);
    }

    void zeroRemovesAValueWhoseFieldSaysNone() {
        fields_->make<SegmentSettings>(kSegmentFields, "segment");
        SegmentSettings settings;
        settings.extension = 20;
        fields_->show(kSegmentFields, settings);
        type("segmentExtension", "0.2");
        QCOMPARE(fields_->changed(kSegmentFields, settings, changes_.back()).extension,
                 std::optional(kMinStrip));
        type("segmentExtension", "0");
        QVERIFY(!fields_->changed(kSegmentFields, settings, changes_.back()).extension);
    }

    void textIsTakenWithoutSpareBlanks() {
        fields_->make<LineSettings>(kLineFields, {});
        auto& size = find<QLineEdit>("labelSize");
        QTest::keyClicks(&size, " 38  long ");
        QTest::keyClick(&size, Qt::Key_Return);
        QCOMPARE(changed({}).label.size, std::string("38 long"));
    }
};

TOILE_WINDOW_TEST(SettingFieldsTest)
#include "setting_fields_test.moc"
