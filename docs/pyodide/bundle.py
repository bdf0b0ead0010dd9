"""Put what the page of pasted tables runs beside it: Pyodide, and our sources as a zip.

python docs/pyodide/bundle.py FOLDER, after `npm ci --ignore-scripts` in this folder; FOLDER is the
manual's.
"""

import shutil
import sys
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
ENGINE = HERE.parent.parent / "repro"
CORE = (
    "pyodide.mjs",
    "pyodide.asm.mjs",
    "pyodide.asm.wasm",
    "pyodide-lock.json",
    "python_stdlib.zip",
)
COMMANDS = ("__init__", "audit_settings", "table_files")  # what the command takes and refuses
LONG_AGO = (1980, 1, 1, 0, 0, 0)  # equal sources give equal bytes


def sources() -> dict[str, bytes]:
    """Return the modules that the page needs, which use the standard library alone, by path."""
    files = [ENGINE / "__init__.py", ENGINE / "errors.py", *(ENGINE / "tables").rglob("*.py")]
    files += [ENGINE / "commands" / f"{name}.py" for name in COMMANDS]
    paths = {str(file.relative_to(ENGINE.parent).as_posix()): file for file in sorted(files)}
    found = {path: file.read_bytes() for path, file in paths.items()}
    return {**found, "audit_here.py": (HERE / "audit_here.py").read_bytes()}


def bundle(folder: Path) -> None:
    """Write Pyodide's core and the zip of sources into folder/pyodide."""
    target = folder / "pyodide"
    target.mkdir(parents=True, exist_ok=True)
    for name in CORE:
        shutil.copyfile(HERE / "node_modules" / "pyodide" / name, target / name)
    with zipfile.ZipFile(target / "repro.zip", "w", zipfile.ZIP_DEFLATED) as packed:
        for path, text in sources().items():
            packed.writestr(zipfile.ZipInfo(path, LONG_AGO), text)


if __name__ == "__main__":
    bundle(Path(sys.argv[1]))
