// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>

#include "app/actions/action_registry.h"
#include "app/base/text.h"
#include "app/platform_choice.h"
#include "app/settings/language.h"
#include "app/text/error_text.h"
#include "core/base/error.h"
#include "core/compare/comparison.h"
#include "core/io/conventions.h"
#include "core/pattern/piece_marks.h"
#include "tests/app/support/run_test.h"

using namespace toile;
using namespace toile::app;

namespace {

/// A missing German text is a warning, so that a feature can be added before it is translated; the
/// nightly run fails on it.
bool isStrict() {
    return qEnvironmentVariableIsSet("TOILE_STRICT_TRANSLATION");
}

struct Message {
    QString context, source, translation;
    bool unfinished = false;
};

/// The text, or its first form where it depends on a number.
QString firstForm(QXmlStreamReader& xml) {
    QString text;
    while (xml.readNext() != QXmlStreamReader::EndElement || xml.name() != u"translation") {
        if (xml.isStartElement() && xml.name() == u"numerusform") {
            const QString form = xml.readElementText();
            text = text.isEmpty() ? form : text;
        } else if (xml.isCharacters() && !xml.isWhitespace()) {
            text += xml.text();
        }
    }
    return text;
}

QList<Message> messagesOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"message") {
            messages.push_back({context, {}, {}});
        } else if (xml.name() == u"source") {
            messages.back().source = xml.readElementText();
        } else if (xml.name() == u"translation") {
            messages.back().unfinished = xml.attributes().value("type") == u"unfinished";
            messages.back().translation = firstForm(xml);
        }
    }
    return messages;
}

QStringList placeholders(const QString& text) {
    static const QRegularExpression pattern("%(L?\\d|n)");
    QStringList found;
    for (auto match = pattern.globalMatch(text); match.hasNext();) {
        found << match.next().captured();
    }
    found.sort();
    return found;
}

/// What the pattern finds first in every file of the window that it fits, by the file's name.
QMap<QString, QString> firstInFiles(const QRegularExpression& pattern) {
    QMap<QString, QString> found;
    QDirIterator files(TOILE_SOURCE_DIR "/app", {"*.cpp", "*.h"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (file.open(QIODevice::ReadOnly)) {
            if (const auto match = pattern.match(QString::fromUtf8(file.readAll()));
                match.hasMatch()) {
                found[file.fileName()] = match.captured(1);
            }
        }
    }
    return found;
}

bool hasMnemonic(const QString& text) {
    return withoutMnemonic(text) != text;
}

}  // namespace

/// The translations as files, and one of them at work.
class TranslationTest : public QObject {
    Q_OBJECT

private:
    QList<Message> german_;

    /// All texts of some folders, as `cmake --build BUILD --target translations` finds them.
    static QList<Message> collected(const QStringList& folders) {
        QTemporaryDir folder;
        const QString fresh = folder.filePath("fresh.ts");
        QProcess lupdate;
        lupdate.setWorkingDirectory(TOILE_SOURCE_DIR);
        lupdate.setStandardOutputFile(QProcess::nullDevice());
        lupdate.setStandardErrorFile(QProcess::nullDevice());
        lupdate.start(
            TOILE_LUPDATE,
            folders + QStringList{"-I", ".", "-extensions", "cpp,h", "-tr-function-alias",
                                  "QT_TR_NOOP+=TR,QT_TR_NOOP+=worded,"
                                  "QT_TR_NOOP+=translatable",
                                  "-locations", "none", "-target-language", "de", "-ts", fresh});
        const bool isDone = lupdate.waitForFinished(120000) && lupdate.exitCode() == 0;
        return isDone ? messagesOf(fresh) : QList<Message>();
    }

private slots:
    void initTestCase() {
        loadResources();
        german_ = messagesOf(TOILE_SOURCE_DIR "/resources/translations/toile_de.ts");
        QVERIFY(german_.size() > 300);
    }

    void germanIsComplete() {
        int unfinished = 0;
        for (const Message& message : german_) {
            if (message.unfinished || message.translation.isEmpty()) {
                ++unfinished;
                qWarning().noquote() << "not translated:" << message.context << message.source;
            }
        }
        QVERIFY2(unfinished == 0 || !isStrict(), qPrintable(QString::number(unfinished)));
    }

    void germanKnowsEveryTextOfTheWindow() {
        // A text that the file lacks would be shown in English, unnoticed.
        const auto texts = [](const QList<Message>& messages) {
            QSet<QString> set;
            for (const Message& message : messages) {
                set.insert(message.context + ": " + message.source);
            }
            return set;
        };
        const QSet<QString> used = texts(collected({"app", "core"})), known = texts(german_);
        QVERIFY(used.size() > 300);
        for (const QString& text : used - known) {
            qWarning().noquote() << "not in toile_de.ts:" << text;
        }
        for (const QString& text : known - used) {
            qWarning().noquote() << "no more in the program:" << text;
        }
        QVERIFY2(used == known || !isStrict(),
                 "bring the file up to date: cmake --build BUILD --target translations");
    }

    void textsOfTheCoreAreLookedUpWhereTheyAreCollected() {
        const QList<Message> messages = collected({"core"});
        QVERIFY(messages.size() > 100);
        for (const Message& message : messages) {
            QVERIFY2(message.context == "toile", qPrintable(message.context + message.source));
        }
    }

    void freeTextsAreLookedUpWhereTheyAreCollected() {
        // lupdate files the tr() of a free function under its namespace, whatever it calls.
        static const QRegularExpression helper(
            R"(QString tr\(const char\*[^{]*\{[^}]*?translate\("([\w:]+)\")");
        const auto contexts = firstInFiles(helper);
        for (const QString& file : contexts.keys()) {
            QVERIFY2(contexts[file] == "toile::app", qPrintable(file));
        }
        QVERIFY(!contexts.isEmpty());
    }

    void translationsKeepWhatTheProgramFillsIn() {
        for (const Message& message : german_) {
            if (message.translation.isEmpty()) {
                continue;
            }
            QVERIFY2(placeholders(message.source) == placeholders(message.translation),
                     qPrintable(message.source));
            QVERIFY2(hasMnemonic(message.source) == hasMnemonic(message.translation),
                     qPrintable(message.source));
            QVERIFY2(message.source.endsWith(u'…') == message.translation.endsWith(u'…'),
                     qPrintable(message.source));
            QVERIFY2(message.source.endsWith(u' ') == message.translation.endsWith(u' '),
                     qPrintable(message.source));
        }
    }

    void chosenLanguageIsSpoken() {
        QCOMPARE(ActionRegistry().title(ActionId::Wireframe), QString("Show wireframe"));
        useLanguage(Language::German);
        QCOMPARE(QLocale().decimalPoint(), QString(","));
        const ActionRegistry actions;
        QVERIFY(actions.title(ActionId::Wireframe) != QString("Show wireframe"));
        QVERIFY(actions.title(ActionId::Undo) != QString("Undo"));
    }

    void particularsOfTheCoreAreSpokenToo() {
        useLanguage(Language::German);
        QCOMPARE(wordingText(guessUnit(1.52).reason),
                 QString("größte Ausdehnung 1,52, als Meter gelesen: 1.520 mm"));
        const QString said = errorText({ErrorCode::CutImpossible, Subject::cut("Abnäher"),
                                        worded("it needs %1 points or more", {figure(3)})});
        QVERIFY2(said.contains("mindestens 3 Punkte sind nötig"), qPrintable(said));
        QCOMPARE(drawingWords().cutPairs, std::string("%1 Paare zuschneiden"));
    }

    void namesAreLookedUpWhereTheyAreCollected() {
        // The macro's name is the one asked for at run time, the class's the one collected.
        static const QRegularExpression macro(R"(Q_DECLARE_TR_FUNCTIONS\(([\w:]+)\))");
        QSet<QString> contexts;
        for (const Message& message : german_) {
            contexts.insert(message.context);
        }
        const auto asked = firstInFiles(macro);
        for (const QString& file : asked.keys()) {
            QVERIFY2(contexts.contains(asked[file]), qPrintable(file));
        }
        QVERIFY(asked.size() > 3);
    }

    void freeTextsAreSpokenToo() {
        useLanguage(Language::German);
        int free = 0;
        for (const Message& message : german_) {
            if (message.context == "toile::app" && !message.source.contains("%n")) {
                const QByteArray source = message.source.toUtf8();
                QVERIFY2(toile::app::tr(source) == message.translation, source);
                ++free;
            }
        }
        QVERIFY(free > 300);
    }

    void comparisonIsSpokenToo() {
        useLanguage(Language::German);
        for (const CriterionTraits& criterion : allCriteria()) {
            for (const char* text : {criterion.title, criterion.tip}) {
                QVERIFY2(!text || toile::app::tr(text) != text, text);
            }
        }
    }
};

TOILE_WINDOW_TEST(TranslationTest)
#include "translation_test.moc"
