// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what Khronos' validator of glTF says against a file: errors and warnings. Found by NODE_PATH.
const fs = require("fs");
const validator = require("gltf-validator");

validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2]))).then((report) => {
    for (const issue of report.issues.messages.filter((one) => one.severity < 2)) {
        console.log(`${issue.code} ${issue.pointer}: ${issue.message}`);
    }
});
