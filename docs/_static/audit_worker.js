// Runs the audit in Python, beside the page, which so stays usable meanwhile.

import { loadPyodide } from "../pyodide/pyodide.mjs";

const place = new URL("../pyodide/", import.meta.url);

async function answering() {
  const python = await loadPyodide({ indexURL: place.href });
  const packed = await (await fetch(new URL("repro.zip", place))).arrayBuffer();
  python.FS.writeFile("/repro.zip", new Uint8Array(packed));
  python.runPython("import sys; sys.path.insert(0, '/repro.zip')");
  return python.pyimport("audit_here").answer;
}

const ready = answering();
ready.then(
  () => postMessage({ ready: true }),
  (error) => postMessage({ broken: String(error) }),
);

addEventListener("message", async ({ data }) => {
  const answer = await ready;
  try {
    postMessage({ answer: JSON.parse(answer(data.text, JSON.stringify(data.options))) });
  } catch (error) {
    postMessage({ broken: String(error) });
  }
});
