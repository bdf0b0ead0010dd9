# /// script
# dependencies = ["nox[uv]>=2025.2"]
# ///
"""What can be done here; `nox -l` lists it."""

import contextlib
import json
import os
import pathlib
import shutil
import time
from collections.abc import Iterator

import nox

nox.needs_version = ">=2025.2"
nox.options.default_venv_backend = "uv|virtualenv"
nox.options.sessions = ["lint", "types", "tests"]
nox.options.reuse_venv = "yes"

# one thread per run: the engine itself spreads runs over the cores
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
# tests start many processes, which load faster what is compiled once
TESTING = {**ONE_THREAD, "PYTHONDONTWRITEBYTECODE": ""}
# the longest file comes first, and a file's tests share what they make once; numbers of a machine
# under load are no benchmarks
SPREAD = (
    *("-n", "auto", "--dist", "loadfile", "--no-loadscope-reorder", "--benchmark-disable"),
    "--durations=20",
)
LOCKS = {
    "run": [],
    "test": ["test"],
    "docs": ["docs", "test"],
    "lint": ["lint"],
    "types": ["types"],
    "cluster": ["cluster", "test"],
    "references": ["references", "urdf", "test"],
    "browser": ["browser", "test"],
}
LOWEST = (3, 11)  # the Python of pyproject.toml
PEERS = ("peers", "mealpy")  # two environments: mealpy wants an older NumPy than others do


def _install(session: nox.Session, lock: str) -> None:
    session.install("--require-hashes", "-r", f"requirements/{lock}.lock")
    session.install("--no-deps", "--no-build-isolation", "-e", ".")


@contextlib.contextmanager
def _noted(command: str, *, whole: bool = True) -> Iterator[None]:
    """Note for the benchmarks how long a whole command took, unless it fails."""
    begun = time.monotonic()
    yield
    if whole:
        took = f"{time.monotonic() - begun:.1f}\t{time.strftime('%Y-%m-%d')}"
        pathlib.Path(".nox").mkdir(exist_ok=True)  # environments may be elsewhere
        with pathlib.Path(".nox/took.tsv").open("a", encoding="utf-8") as file:
            file.write(f"{command}\t{took}\n")


def _readme(session: nox.Session) -> None:
    parts = ("reports/finding.md", "reports/verdicts.md")
    session.run("python", "-m", "repro.report.readme", "README.md", *parts)


@nox.session
def reproduce(session: nox.Session) -> None:
    """Run every paper's protocol as far as it is missing, then write reports/ (arguments go on)."""
    command = " ".join(("nox -s reproduce", *(("--", *session.posargs) if session.posargs else ())))
    with _noted(command, whole=not pathlib.Path(".repro").exists()):
        _install(session, "run")
        session.run("repro", "reproduce", *session.posargs, env=ONE_THREAD)
        if not session.posargs:
            _readme(session)


@nox.session
def report(session: nox.Session) -> None:
    """Write reports/ from the store without running anything."""
    _install(session, "run")
    session.run("repro", "report", *session.posargs, env=ONE_THREAD)
    if not session.posargs:
        _readme(session)


@nox.session
def expect(session: nox.Session) -> None:
    """Write the lists of expected verdicts anew from reports/: say in CHANGELOG.md what and why."""
    _install(session, "run")
    session.run("python", "-m", "tests.verdict_list")


@nox.session
def calibrate(session: nox.Session) -> None:
    """Judge tables whose truth is known, some ten minutes: writes repro/judge/calibration.json."""
    _install(session, "run")
    session.run("python", "-m", "tests.calibrate", env=ONE_THREAD)


@nox.session(name="false-alarms")
def false_alarms(session: nox.Session) -> None:
    """Audit 100,000 true tables and planted errors, ten minutes: writes docs/false_alarms.md."""
    _install(session, "run")
    session.run("python", "-m", "tests.false_alarms", *session.posargs, env=ONE_THREAD)


@nox.session(name="another-seed")
def another_seed(session: nox.Session) -> None:
    """Run every protocol under another master seed, and say on the index what it changes."""
    _install(session, "run")
    repeats = ("--repeats", *(session.posargs or ["10"]))
    places = ("--store", ".repro/another-seed", "--reports", ".repro/another-seed/reports")
    again = ("--protocol-only", "--master-seed", "another", *repeats, *places)
    session.run("repro", "reproduce", *again, env=ONE_THREAD)
    results = ("reports/results.json", ".repro/another-seed/reports/results.json")
    told = session.run("repro", "flips", *results, "--json", silent=True)
    pathlib.Path("reports/another-seed.json").write_text(str(told), encoding="utf-8")
    session.run("repro", "report", *repeats, env=ONE_THREAD)


@nox.session
def again(session: nox.Session) -> None:
    """Run one printed number again: -- KEY NAME, as its page calls it."""
    _install(session, "run")
    session.run("repro", "again", *session.posargs, env=ONE_THREAD)


@nox.session
def tests(session: nox.Session) -> None:
    """Run the tests, a full-size re-run of the papers' protocols among them."""
    with _noted("nox -s tests", whole=not session.posargs):
        _install(session, "test")
        session.install("--require-hashes", "--no-deps", "-r", "requirements/urdf.lock")
        kinds = ("-m", "not browser and not cluster and not adapters")
        session.run("pytest", *kinds, *SPREAD, *session.posargs, env=TESTING)


@nox.session(venv_backend="uv")  # pip knows no lowest versions
def lowest(session: nox.Session) -> None:
    """Run the tests with the lowest versions that pyproject.toml allows: its bounds are true."""
    oldest = ("--upgrade", "--resolution", "lowest-direct")  # what is there may be newer
    session.install(
        *oldest, "-r", "pyproject.toml", "--extra", "test", "-r", "requirements/build.in"
    )
    session.install("--no-deps", "--no-build-isolation", "-e", ".")
    kinds = ("-m", "not browser and not cluster and not full_size")
    session.run("pytest", *kinds, *SPREAD, *session.posargs, env=TESTING)


@nox.session(venv_backend="uv")
def built(session: nox.Session) -> None:
    """Build sdist and wheel, and try the wheel with every Python here that it allows."""
    folder = pathlib.Path(session.create_tmp()).resolve()
    session.install("uv", "-r", "requirements/build.in")
    shutil.rmtree(folder / "dist", ignore_errors=True)
    # the wheel is made of the sdist, so that both are whole
    build = ("uv", "build", "--quiet", "--no-build-isolation", "--out-dir", str(folder / "dist"))
    session.run(*build)
    (wheel,) = (folder / "dist").glob("*.whl")
    tried = str(pathlib.Path("tests/installed_trial.py").resolve())
    for version, python in sorted(_pythons(session).items()):
        session.log(f"with Python {'.'.join(map(str, version))}")
        place = folder / f"python{version[1]}"
        session.run("uv", "venv", "--quiet", "--clear", "--python", python, str(place))
        # the lowest versions of all are installed with the lowest Python
        oldest = ("--resolution", "lowest-direct") if version == LOWEST else ()
        own = str(place / "bin" / "python")
        session.run("uv", "pip", "install", "--quiet", "--python", own, *oldest, str(wheel))
        with session.chdir(session.create_tmp()):
            session.run(own, "-I", tried, env=ONE_THREAD, external=True)


@nox.session
def browser(session: nox.Session) -> None:
    """Look at the pages in Chromium: by mouse, by keyboard, without script, on a phone, printed."""
    _install(session, "browser")
    environment = {**TESTING, "REPRO_BROWSER": _chromium(session)}
    # one file holds most of these tests, and tests of one view of a paper share its open pages
    spread = (*SPREAD, "--dist", "loadscope")
    asked = session.posargs or ("tests/browser",)
    session.run("pytest", "-m", "browser", *spread, *asked, env=environment)


@nox.session
def faults(session: nox.Session) -> None:
    """Kill, damage and misuse everything, at length: what `tests` does in short."""
    _install(session, "test")
    environment = {**TESTING, "REPRO_FAULTS": "long", "HYPOTHESIS_PROFILE": "faults"}
    session.run("pytest", "-m", "faults", *session.posargs, env=environment)
    try:
        session.install("atheris>=2.3")  # no wheel for every Python and system
    except nox.command.CommandFailed:
        session.log("atheris does not install here: no coverage-guided fuzzing, Hypothesis alone")
        return
    seconds = os.environ.get("FUZZ_SECONDS", "60")
    for target in ("table", "store", "page"):
        session.run(
            *("python", "-m", "tests.fuzzing", target, f"-max_total_time={seconds}"), env=ONE_THREAD
        )


@nox.session
def fuzz(session: nox.Session) -> None:
    """Run the property-based tests with many more examples."""
    _install(session, "test")
    environment = {**TESTING, "HYPOTHESIS_PROFILE": "fuzz"}
    kinds = "not browser and not full_size and not cluster"
    session.run("pytest", "-m", kinds, *session.posargs, env=environment)


@nox.session
def cluster(session: nox.Session) -> None:
    """Run every paper's protocol on a Dask cluster that loses workers and its scheduler."""
    _install(session, "cluster")
    environment = {**ONE_THREAD, "REPRO_CLUSTER": "whole"}
    session.run(
        "pytest", "tests/runs/workers/test_real_cluster.py", *session.posargs, env=environment
    )


@nox.session
def adapters(session: nox.Session) -> None:
    """Compare a search of each library for which the manual has an adapter."""
    _install(session, "test")
    session.install("-r", "requirements/adapters.in")
    session.install(
        "--no-deps", "mealpy==3.0.3", "opfunu==1.0.4"
    )  # it asks for an older NumPy, and runs with ours
    session.run("pytest", "-m", "adapters", *session.posargs, env=TESTING)


@nox.session
def references(session: nox.Session) -> None:
    """Ask two other planners: writes repro/judge/planners.json, and tests that they agree."""
    _install(session, "references")
    session.run("repro", "references", *session.posargs)
    session.run("python", "-m", "tests.outside_times")
    asked = (
        "judge/test_outside_planners",
        "robotics/test_chain",
        "commands/test_motions_of_others",
    )
    session.run("pytest", *(f"tests/{name}.py" for name in asked), env=ONE_THREAD)


@nox.session
def lint(session: nox.Session) -> None:
    """Check style with ruff: all rules less the list in pyproject.toml."""
    session.install("--require-hashes", "-r", "requirements/lint.lock")
    session.run("ruff", "check")
    session.run("ruff", "format", "--check")


@nox.session
def types(session: nox.Session) -> None:
    """Check types with mypy, strictly."""
    _install(session, "types")
    session.run("mypy", *session.posargs)


@nox.session
def bench(session: nox.Session) -> None:
    """Measure speed against other packages and against C; writes benchmarks/RESULTS.md."""
    _install(session, "browser")
    environment = {**ONE_THREAD, "REPRO_PEERS": str(_peers(session))}
    options = ("--benchmark-only", "--results", "benchmarks/RESULTS.md")
    session.run("pytest", "benchmarks", *options, *session.posargs, env=environment)


@nox.session
def docs(session: nox.Session) -> None:
    """Build the manual from docs/ into docs/_build/html, with Python for its page; needs npm."""
    _install(session, "docs")
    target = "docs/_build/html"
    session.run("sphinx-build", "-W", "--keep-going", "-q", "-b", "html", "docs", target)
    with session.chdir("docs/pyodide"):
        session.run("npm", "ci", "--ignore-scripts", external=True)
    session.run("python", "docs/pyodide/bundle.py", target)


@nox.session(venv_backend="none")
def bundle(session: nox.Session) -> None:
    """Build the script of the robot's view anew, with node and npm (see repro/report/arm)."""
    session.chdir("repro/report/arm")
    session.run("npm", "ci", "--ignore-scripts", external=True)
    session.run("npm", "run", "build", external=True)


@nox.session
def scale(session: nox.Session) -> None:
    """Measure studies of 10^4, 10^5 and 10^6 short runs (-- RUNS…, --dask ADDRESS)."""
    _install(session, "cluster")
    session.run("python", "-m", "benchmarks.scale", *session.posargs, env=ONE_THREAD)


@nox.session
def lock(session: nox.Session) -> None:
    """Write the hashed locks in requirements/ anew from pyproject.toml."""
    session.install("uv")
    for name, extras in LOCKS.items():
        options = [word for extra in extras for word in ("--extra", extra)]
        session.run(
            *("uv", "pip", "compile", "pyproject.toml", "requirements/build.in", *options),
            *("--universal", "--python-version", "3.11", "--generate-hashes", "--upgrade"),
            *("--no-annotate", "--no-header", "--quiet", "-o", f"requirements/{name}.lock"),
        )
    for name in (*PEERS, "urdf"):
        alone = ("--no-deps",) if name == "urdf" else ()
        session.run(
            *("uv", "pip", "compile", f"requirements/{name}.in", "--universal", *alone),
            *("--python-version", "3.11", "--generate-hashes", "--upgrade", "--no-annotate"),
            *("--no-header", "--quiet", "-o", f"requirements/{name}.lock"),
        )


def _peers(session: nox.Session) -> pathlib.Path:
    """Return a folder with an environment per lock of the peers; one that fails is left out."""
    folder = pathlib.Path(session.create_tmp()).resolve()
    session.install("uv")
    for name in PEERS:
        python = folder / name / "bin" / "python"
        lock = f"requirements/{name}.lock"
        if not python.exists():
            ours = str(pathlib.Path(session.bin) / "python")
            session.run("uv", "venv", "--quiet", "--python", ours, str(folder / name))
        options = ("--quiet", "--require-hashes", "--python", str(python), "-r", lock)
        try:
            session.run("uv", "pip", "install", *options)
        except nox.command.CommandFailed:
            session.warn(f"{lock} cannot be installed here; the page says which peers are missing")
            shutil.rmtree(folder / name)
    return folder


def _pythons(session: nox.Session) -> dict[tuple[int, ...], str]:
    """Return the interpreters that are here and new enough, by version; pyenv's too."""
    kept = pathlib.Path(os.environ.get("PYENV_ROOT", pathlib.Path.home() / ".pyenv"))
    folders = [*map(str, kept.glob("versions/*/bin")), os.environ["PATH"]]
    listing = ("uv", "python", "list", "--only-installed", "--output-format", "json")
    environment = {"PATH": os.pathsep.join(folders), "UV_PYTHON_DOWNLOADS": "never"}
    told = session.run(*listing, env=environment, silent=True, stderr=None)
    found: dict[tuple[int, ...], str] = {}
    for each in json.loads(str(told)):
        version = tuple(map(int, each["version"].split(".")[:2])) if each["path"] else ()
        if each["implementation"] == "cpython" and version >= LOWEST:
            found.setdefault(version, each["path"])
    return found


def _chromium(session: nox.Session) -> str:
    """Return a Chromium; as root, install Debian's where none is. In CI, fail without one."""
    known = (os.environ.get("REPRO_BROWSER"), "chromium", "chromium-browser", "google-chrome")
    for name in filter(None, known):
        if path := shutil.which(name):
            return path
    if shutil.which("apt-get") and os.geteuid() == 0:
        session.run("apt-get", "update", "-qq", external=True)
        session.run(
            *("apt-get", "install", "-y", "-qq", "--no-install-recommends", "chromium"),
            external=True,
            silent=True,
        )
        if path := shutil.which("chromium"):
            return path
    reason = "no Chromium: install one, or name it in REPRO_BROWSER"
    if os.environ.get("CI"):
        session.error(reason)
    session.skip(reason)
    return ""


if __name__ == "__main__":
    nox.main()
