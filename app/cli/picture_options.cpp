// SPDX-License-Identifier: GPL-3.0-or-later
// Includes CLI11 as `arguments.cpp` does; both are compiled together.
#include "app/cli/picture_options.h"

#include <algorithm>

#include "app/cli/check_arguments.h"
#include "app/cli/choice_options.h"

namespace toile::app {
namespace {

constexpr Word<ViewsShown> kViewWords[] = {
    {ViewsShown::Garment, "garment"}, {ViewsShown::Pattern, "pattern"}, {ViewsShown::Both, "both"}};

constexpr Word<bool> kSwitchWords[] = {{true, "on"}, {false, "off"}};

}  // namespace

void addPicture(CLI::App& command, TypedOptions& typed, Arguments& arguments,
                const std::string& overlay) {
    PictureArguments& picture = arguments.picture;
    addChoice(command, "--view", picture.views, kViewWords, "What to draw; both lie side by side")
        ->default_str("both");
    addChoice(command, "--overlay", arguments.overlay, kOverlayWords, overlay);
    command.add_option("--size", typed.size, "Width and height in pixels [1600x800]")
        ->type_name("WxH");
    command
        .add_option("--look", typed.look,
                    "From where the garment is seen, a side or degrees around and upwards")
        ->type_name("front|back|left|right|top|bottom|YAW,PITCH");
    command.add_flag("--dark", picture.dark, "On a dark ground");
}

void addRenderedPicture(CLI::App& command, PictureArguments& picture) {
    command
        .add_option("--morph", picture.morph,
                    "The garment on its way to the pattern: 0 as it is worn, 1 flat")
        ->type_name("SHARE")
        ->check(within(0.0, 1.0))
        ->capture_default_str();
    command.add_flag("--wireframe", picture.wireframe, "Draw the mesh's edges");
    command.add_flag("--xray", picture.xray, "Let cloth show what is behind it");
    addChoice(command, "--seams-shown", picture.seams, kSwitchWords,
              "Seam lines, each pair in one colour")
        ->default_str("on");
    addChoice(command, "--bar", picture.bar, kSwitchWords,
              "The colour bar below [on where the overlay is measured]");
    command
        .add_option("--thumbnail", picture.thumbnail,
                    "A square picture of the garment alone, so many pixels wide, for file "
                    "managers, made quickly; its name may end in anything")
        ->type_name("PIXELS")
        ->check(within(kMinPicture, kMaxPicture))
        ->excludes("--size", "--view", "--overlay", "--morph");
}

std::string wrongWithoutPicture(const CLI::App& app, const Arguments& arguments) {
    if (arguments.command != Arguments::Command::Prove ||
        std::ranges::any_of(arguments.outputs, isPicture)) {
        return {};
    }
    const CLI::App* prove = app.get_subcommand("prove");
    for (const char* option : {"--view", "--overlay", "--size", "--look", "--dark", "--sewn"}) {
        if (prove->count(option) > 0) {
            return std::string(option) + " is of a picture: ask for one with -o FILE.png";
        }
    }
    return {};
}

}  // namespace toile::app
