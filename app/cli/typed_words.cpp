// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/typed_words.h"

#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace toile::app {
namespace {

Arguments refusedWord(const std::string& word, const char* why) {
    Arguments refused;
    refused.command = Arguments::Command::Message;
    refused.status = kExitUsage;
    refused.message = "toile: \"" + shownText(word, kMaxOfPlace) + "\" " + why + ".\n";
    return refused;
}

}  // namespace

Arguments typedWords(const char* command, const std::vector<std::string>& files,
                     const std::vector<std::string>& words, unsigned taken) {
    std::vector<std::string> typed{"toile", command};
    for (const std::string& file : files) {
        typed.push_back(file.starts_with('-') ? "./" + file : file);
    }
    typed.insert(typed.end(), words.begin(), words.end());
    std::vector<const char*> pointers;
    pointers.reserve(typed.size());
    for (const std::string& word : typed) {
        if (word.find('\0') != std::string::npos) {  // what is behind it would be left out
            return refusedWord(word, "contains a zero byte, which is not allowed");
        }
        pointers.push_back(word.c_str());
    }
    Arguments arguments = parseArguments(static_cast<int>(pointers.size()), pointers.data(), taken);
    if ((taken & kInputFiles) == 0 && arguments.inputs.size() > files.size()) {
        return refusedWord(arguments.inputs.back().string(),
                           "is an input file, which is not used here; leave it out");
    }
    return arguments;
}

std::string withoutSpeaker(std::string_view sentence) {
    constexpr std::string_view kSpeaker = "toile: ", kHint = "; see toile ";
    sentence = trimmed(sentence);
    if (sentence.starts_with(kSpeaker)) {
        sentence.remove_prefix(kSpeaker.size());
    }
    if (const std::size_t hint = sentence.rfind(kHint);
        hint != std::string_view::npos && sentence.ends_with("--help.")) {
        sentence.remove_suffix(sentence.size() - hint);
    }
    return std::string(sentence);
}

}  // namespace toile::app
