// Writes the hash of the client's sources beside the built files, so that a stale build is noticed.
// How it is computed is said in API.md; swifttailor.studio computes the same from Python.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const single = ["index.html", "package-lock.json", "package.json", "tsconfig.json", "vite.config.ts"];

function filesUnder(folder) {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? filesUnder(path) : [path];
  });
}

const paths = [
  ...single.map((name) => join(root, name)),
  ...filesUnder(join(root, "src")),
  ...filesUnder(join(root, "public")),
]
  .map((path) => relative(root, path).split(sep).join("/"))
  .sort((a, b) => (a < b ? -1 : 1));

const hash = createHash("sha256");
for (const path of paths) {
  hash.update(`${path}\n`);
  hash.update(
    createHash("sha256")
      .update(readFileSync(join(root, path)))
      .digest("hex"),
  );
  hash.update("\n");
}
const digest = hash.digest("hex");
if (process.argv.includes("--print")) console.log(digest);
else writeFileSync(join(root, "../src/swifttailor/studio/client/sources.sha256"), `${digest}\n`);
