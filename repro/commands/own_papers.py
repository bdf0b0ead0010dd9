"""The package of this house's papers: the one beside ours, whatever else has its name.

`python -m repro`, and a script that imports us, look into a folder of their own first, which may
hold a `papers` of somebody else.
"""

import sys
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import module_from_spec
from pathlib import Path
from types import ModuleType

NAME = "papers"
HOME = Path(__file__).parents[2]
"""Where our packages are."""


def found() -> ModuleSpec | None:
    """Return where the package is, without loading it; None where it is not beside ours."""
    spec = PathFinder.find_spec(NAME, [str(HOME)])
    known = getattr(sys.modules.get(NAME), "__spec__", None)
    return known if spec and known and known.origin == spec.origin else spec


def loaded() -> ModuleType:
    """Return the package; it has its name, unless another that is loaded already has."""
    spec, known = found(), sys.modules.get(NAME)
    if spec is None or spec.loader is None:
        message = f"no package {NAME} beside {HOME / 'repro'}"
        raise ImportError(message)
    if known is not None and known.__spec__ is spec:
        return known
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return sys.modules.setdefault(NAME, module) if known is None else module
