// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/typed_words.h"

#include "core/base/characters.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace toile::app {

Arguments typedWords(const char* command, const std::vector<std::string>& files,
                     const std::vector<std::string>& words) {
    std::vector<std::string> typed{"toile", command};
    for (const std::string& file : files) {
        typed.push_back(file.starts_with('-') ? "./" + file : file);
    }
    typed.insert(typed.end(), words.begin(), words.end());
    for (const std::string& word : typed) {
        if (word.find('\0') != std::string::npos) {  // what is behind it would be left out
            Arguments refused;
            refused.command = Arguments::Command::Message;
            refused.status = kExitUsage;
            refused.message = "toile: \"" + shownText(word, kMaxOfPlace) +
                              "\" has a zero byte, which no word of a command line can have.\n";
            return refused;
        }
    }
    std::vector<const char*> pointers;
    pointers.reserve(typed.size());
    for (const std::string& word : typed) {
        pointers.push_back(word.c_str());
    }
    return parseArguments(static_cast<int>(pointers.size()), pointers.data());
}

const char* wordOutOfPlace(const Arguments& typed, bool isWriting) {
    if (!typed.outputs.empty() && !isWriting) {
        return "-o";
    }
    return typed.ledger ? "--ledger" : typed.failOnDoubt ? "--fail-on" : nullptr;
}

std::string outOfPlaceSentence(std::string_view word) {
    const std::string named = word == "-o" ? "-o FILE or --report" : std::string(word);
    return named + " is of toile flatten in a terminal and does nothing here; leave it out";
}

std::string withoutSpeaker(std::string_view sentence) {
    constexpr std::string_view kSpeaker = "toile: ", kHint = "; see toile --help.";
    sentence = trimmed(sentence);
    if (sentence.starts_with(kSpeaker)) {
        sentence.remove_prefix(kSpeaker.size());
    }
    if (sentence.ends_with(kHint)) {
        sentence.remove_suffix(kHint.size());
    }
    return std::string(sentence);
}

}  // namespace toile::app
