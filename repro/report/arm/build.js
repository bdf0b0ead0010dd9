// Builds arm.min.js out of source/ and three.js, and says in its first lines what it was built from.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const inputs = ["build.js", "package.json", "package-lock.json", ...readdirSync("source").sort().map(name => `source/${name}`)];
const digest = createHash("sha256");
for (const name of inputs) digest.update(`${name}\0${readFileSync(name)}\0`);
const { packages } = JSON.parse(readFileSync("package-lock.json"));
const version = name => packages[`node_modules/${name}`].version;

const { outputFiles: [bundle] } = await build({
  entryPoints: ["source/page.js"],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "ascii",
  legalComments: "none",
  write: false,
});
const banner = `/*!
Contains three.js ${version("three")} (threejs.org), bundled by esbuild ${version("esbuild")}.
Built from inputs with SHA-256 ${digest.digest("hex")}.
${readFileSync("node_modules/three/LICENSE", "utf8").trim()}
*/
`;
for (const forbidden of ["</script", "<!--"]) {
  if (bundle.text.includes(forbidden)) throw new Error(`${forbidden} would end the page's script element`);
}
writeFileSync("arm.min.js", banner + bundle.text);
