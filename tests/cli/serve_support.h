// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/cli/serve.h"

// For the tests of `toile serve`.
namespace toile {

using ServedJson = nlohmann::json;

inline const std::string kServeSources = TOILE_SOURCE_DIR;
inline const std::string kServedShirt = kServeSources + "/resources/samples/tshirt.obj";

/// A garment and who asks for it.
struct Served {
    app::ServeSession session;

    ServedJson said(const ServedJson& request) {
        Progress progress;
        return ServedJson::parse(session.answer(app::readServeRequest(request.dump()), progress));
    }

    ServedJson done(const ServedJson& request) {
        ServedJson asked = request;
        asked["id"] = 1;
        const ServedJson answer = said(asked);
        EXPECT_TRUE(answer.contains("result")) << answer.dump().substr(0, 2000);
        return answer.value("result", ServedJson());
    }

    ServedJson refused(const ServedJson& request) {
        ServedJson asked = request;
        asked["id"] = 1;
        return said(asked).value("error", ServedJson{{"code", "none"}});
    }
};

inline ServedJson loadOf(const std::vector<std::string>& args) {
    return {{"do", "load"}, {"args", args}};
}

}  // namespace toile
