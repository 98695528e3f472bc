// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a USD scene by three.js and writes what it sees as JSON beside it: of each mesh its name, what
// it is of, and of each corner of each triangle place and texture coordinates. Found by NODE_PATH.
const fs = require("fs");

async function main(file) {
    const { USDLoader } = await import(require.resolve("three/examples/jsm/loaders/USDLoader.js"));
    const scene = new USDLoader().parse(fs.readFileSync(file, "utf8"));
    scene.updateMatrixWorld(true);
    const meshes = [];
    scene.traverse((mesh) => {
        if (!mesh.isMesh) return;
        const { position, uv } = mesh.geometry.attributes;
        const triangles = [];
        for (let k = 0; k < position.count; k++) {
            if (k % 3 === 0) triangles.push([]);
            const place = mesh.position.clone().fromBufferAttribute(position, k);
            place.applyMatrix4(mesh.matrixWorld);
            triangles.at(-1).push([place.x, place.y, place.z, uv.getX(k), uv.getY(k)]);
        }
        meshes.push({ name: mesh.name, of: mesh.parent.name, corners: triangles });
    });
    fs.writeFileSync(`${file}.scene.json`, JSON.stringify(meshes));
}

main(process.argv[2]).catch((error) => {
    console.error(error);
    process.exit(1);
});
