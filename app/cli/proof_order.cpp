// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/proof_order.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/cli/arguments.h"
#include "core/base/characters.h"
#include "core/formats/read_pattern.h"
#include "core/prove/body_file.h"

namespace toile::app {
namespace {

/// The file of the pattern that is sewn in place of the garment's own; empty: none.
std::filesystem::path sewnFile(const Arguments& arguments, const ProofPlan& plan) {
    if (!arguments.pattern.empty()) {
        return arguments.pattern;
    }
    const bool isReference =
        plan.sewn == SewnPattern::Reference && arguments.project && arguments.project->reference;
    return isReference ? arguments.project->reference->path : std::filesystem::path();
}

}  // namespace

ProofPlan proofPlanOf(const Arguments& arguments) {
    const auto& project = arguments.project;
    ProofPlan plan = project ? project->proof : ProofPlan{};
    if (project && arguments.fabric && !(*arguments.fabric == project->fabric)) {
        plan.settings.stiffness = {};
    }
    for (const auto& take : arguments.prove.stated) {
        take(arguments.prove.typed, plan);
    }
    if (arguments.prove.rounds > 0) {
        plan.sewn = SewnPattern::Own;
    }
    return plan;
}

std::variant<ProofOrder, Refusal> orderOfOwn(const Arguments& arguments, const Garment& garment,
                                             Progress& progress) {
    const ProofPlan plan = proofPlanOf(arguments);
    ProofOrder order{.settings = plan.settings, .scale = arguments.prove.scale};
    if (plan.body.empty()) {
        return order;
    }
    auto body = readBody(plan.body, plan.bodyUnit, garment, progress);
    if (!body) {
        return Refusal(body.error());
    }
    if (!isNear(*body, garment)) {
        return Refusal(kNotProved,
                       "\"" + shownText(plan.body.string(), kMaxOfPlace) +
                           "\" is far from the garment; set its unit with --body-unit.",
                       plan.body.string());
    }
    order.body = std::move(*body);
    order.bodyName = plan.body.filename().string();
    return order;
}

std::vector<std::string> notesOf(const ProofOrder& order) {
    std::vector<std::string> notes;
    for (const Wording& note : order.file ? order.file->notes : std::vector<Wording>{}) {
        notes.push_back(shownText(note, kMaxOfDetail));
    }
    return notes;
}

std::variant<ProofOrder, Refusal> proofOrder(const Arguments& arguments, const Garment& garment,
                                             Progress& progress) {
    const ProofPlan plan = proofPlanOf(arguments);
    const std::filesystem::path file = sewnFile(arguments, plan);
    const bool isDesigners = file.empty() && plan.sewn == SewnPattern::Designer;
    const auto hasPanel = [](const auto& piece) { return piece->reference.has_value(); };
    if (isDesigners && std::ranges::none_of(garment.pieces, hasPanel)) {
        const std::string way =
            arguments.project ? "use --reference none" : "leave out --reference";
        return Refusal(kNotProved, "the garment has no reference panels; " + way + ".");
    }
    std::optional<PatternFile> pattern;
    if (!file.empty()) {
        auto read = readPatternFile(file, arguments.prove.patternUnit);
        if (!read) {
            return Refusal(read.error());
        }
        pattern = std::move(*read);
    }
    auto ordered = orderOfOwn(arguments, garment, progress);
    if (auto* order = std::get_if<ProofOrder>(&ordered)) {
        order->isReference = isDesigners;
        order->file = std::move(pattern);
    }
    return ordered;
}

}  // namespace toile::app
