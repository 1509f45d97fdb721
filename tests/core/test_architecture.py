"""The layout shows the flow: which part may import which, held by reading the sources."""

import ast
import contextlib
import importlib
import sys
from functools import cache
from pathlib import Path

import haptonic
from sources import tree_of

SOURCE = Path(haptonic.__file__).parent
FILES = sorted(SOURCE.rglob("*.py"))
TESTS = Path(__file__).parents[1]

BASE = {
    "arrays",
    "errors",
    "fields",
    "foreign",
    "gate",
    "hdf5",
    "names",
    "parallel",
    "paths",
    "progress",
    "units",
}
LATTICES = {"translations", "lattice", "brillouin"}
CORE = BASE | LATTICES | {"materials", "cell", "elements", "solvers", "superelement", "bloch"}
LOWER = CORE | {"atomic", "design", "friction", "plate", "response", "store", "updating", "vibrometry"}
EVERYWHERE = {"later"}  # imports libraries of others
ALLOWED: dict[str, set[str]] = {
    "arrays": set(),
    "later": set(),
    "names": set(),
    "hdf5": set(),
    "gate": {"errors"},
    "foreign": {"errors"},
    "errors": {"names"},
    "units": {"errors"},
    "fields": {"errors", "names", "units"},
    "materials": BASE,
    "translations": BASE,
    "lattice": BASE | {"translations"},
    "brillouin": BASE | {"lattice", "translations"},
    "solvers": {"arrays", "errors"},
    "paths": {"errors", "units"},
    "progress": set(),
    "parallel": set(),
    "atomic": {"errors"},
    "store": {"atomic", "errors", "gate", "hdf5", "paths"},
    "jobs": BASE | {"store"},
    "cell": BASE | LATTICES | {"materials"},
    "elements": {"arrays", "cell", "materials"},
    "superelement": {"arrays", "cell", "elements", "errors", "lattice", "materials", "parallel", "solvers"},
    "bloch": {
        "arrays",
        "superelement",
        "cell",
        "lattice",
        "brillouin",
        "materials",
        "errors",
        "fields",
        "gate",
        "names",
        "parallel",
        "units",
    },
    "channels": {"arrays", "errors", "foreign", "hdf5", "names", "paths", "units"},
    "response": BASE | {"channels"},
    "vibrometry": CORE | {"channels", "plate", "response"},
    "friction": BASE | {"channels", "response"},
    "design": CORE,
    "plate": CORE - {"bloch"} | {"response"},
    "updating": BASE | {"materials", "plate", "response"},
    "vtu": {"arrays", "atomic"},
    "plots": CORE | {"atomic", "friction", "plate", "response", "updating", "vibrometry"},
    "workshop": BASE | {"atomic", "cell", "materials", "plate", "plots"},
    "pages": {"plots"},
    # from here on down to the command line: what is reported, what is asked, what is computed, what shows it
    "views": {"gate", "pages", "progress"},
    "results": LOWER | {"pages", "plots", "views", "vtu"},
    "description": LOWER - {"atomic", "store"} | {"foreign", "results"},
    "report": LOWER | {"description", "pages", "plots", "results", "views"},
    "analyses": LOWER | {"channels", "description", "jobs", "plots", "report", "results", "workshop"},
    "study": {"analyses", "description", "errors", "fields", "progress", "results", "store"},
    "verification": {"arrays", "atomic", "errors", "plots", "results", "store", "study", "units"},
    "studio": BASE
    | {
        "analyses",
        "atomic",
        "cell",  # the endings of files of cells
        "channels",
        "design",
        "description",
        "pages",
        "plate",
        "plots",
        "results",
        "store",
        "study",
        "views",
    }
    | {"workshop", "__init__"},
    "cli": CORE | {"analyses", "atomic", "results", "store", "studio", "study", "verification", "__init__"},
}
TOP = {"__init__", "__main__"}
ROOMS = {"plate": ("layout", "body", "vibration")}  # folders of a part; each may import those before it
INSIDE_FUNCTIONS = {
    "solvers": {"pypardiso", "sksparse"},
    "foreign": {
        "fcntl",
        "meshio",
        "netgen",
        "ngsolve",
        "nptdms",
        "psutil",
        "scipy",
    },  # a child process loads what a file needs and no more
    "jobs": {"dask", "distributed"},
    "views": {"anywidget", "traitlets"},
    "workshop": {"netgen"},
    "vibrometry": {"nptdms", "sdypy"},
    "friction": {"nptdms", "statsmodels"},
    "updating": {"sdypy"},
}


def module_name(file: Path) -> str:
    parts = ["haptonic", *file.relative_to(SOURCE).with_suffix("").parts]
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def part_of(module: str) -> str:
    """``haptonic.cell.mesh`` belongs to ``cell``; ``haptonic`` itself to ``__init__``."""
    part, *rest = [*module.split("."), "__init__"][1:]
    # what is asked and the study that computes it share a package: the analyses lie between them
    return (
        "description"
        if part == "study" and rest[:1] not in (["runs"], ["computing"], ["__init__"], [])
        else part
    )


@cache
def trees() -> dict[str, ast.Module]:
    """Trees of all modules of the package; not parsed by each process that only collects tests."""
    return {module_name(file): tree_of(file) for file in FILES}


def imported(node: ast.AST) -> list[str]:
    """Modules that an import statement names; a name in a package counts if it is a module."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    assert isinstance(node, ast.ImportFrom)
    assert node.level == 0, "relative import"
    inner = [f"{node.module}.{alias.name}" for alias in node.names]
    modules = [name for name in inner if name in trees()]
    # with only modules taken out of it, the package itself is no more than the road to them
    return modules if len(modules) == len(inner) else [node.module or "", *modules]


@cache
def imports_of(module: str, *, at_run_time: bool = False) -> set[str]:
    """All imports of a module; ``at_run_time`` leaves out those that only a type checker follows."""
    tree = trees()[module]
    for_types = {
        inner
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
        for inner in ast.walk(node)
    }
    nodes = [n for n in ast.walk(tree) if isinstance(n, ast.Import | ast.ImportFrom)]
    return {name for node in nodes if not (at_run_time and node in for_types) for name in imported(node)}


def own_imports_of(module: str, *, at_run_time: bool = False) -> set[str]:
    names = imports_of(module, at_run_time=at_run_time)
    return {name for name in names if name == "haptonic" or name.startswith("haptonic.")}


def test_every_part_is_in_the_table():
    assert {part_of(module) for module in trees()} <= ALLOWED.keys() | TOP


def test_imports_follow_the_table():
    forbidden = [
        f"{module} must not import {name}"
        for module in trees()
        if (part := part_of(module)) not in TOP
        for name in sorted(own_imports_of(module))
        if part_of(name) not in ALLOWED.get(part, set()) | EVERYWHERE | {part}
    ]
    assert forbidden == []


def room_of(module: str) -> tuple[str, int] | None:
    """Part of a module and place of its folder among the rooms of that part; -1 for none of them."""
    _, part, room, *_ = [*module.split("."), "", ""]
    if part not in ROOMS:
        return None
    return part, ROOMS[part].index(room) if room in ROOMS[part] else -1


def test_rooms_import_one_way():
    faults = []
    for module in trees():
        room = room_of(module)
        if room is None or module == f"haptonic.{room[0]}":  # the public face of all rooms
            continue
        part, place = room
        if place < 0:
            faults.append(f"{module} is in no room of {part}")
        for name in sorted(own_imports_of(module)):
            other = room_of(name)
            if other is not None and other[0] == part and not 0 <= other[1] <= place:
                faults.append(f"{module} must not import {name}")
    assert faults == []


def cycle_in(graph: dict[str, set[str]]) -> list[str]:
    """Some cycle, or nothing."""
    done: set[str] = set()

    def visit(node: str, trail: list[str]) -> list[str]:
        if node in trail:
            return [*trail[trail.index(node) :], node]
        if node in done:
            return []
        for following in sorted(graph.get(node, set())):
            cycle = visit(following, [*trail, node])
            if cycle:
                return cycle
        done.add(node)
        return []

    for node in graph:
        cycle = visit(node, [])
        if cycle:
            return cycle
    return []


def test_a_cycle_would_be_found():
    assert cycle_in({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c", "b"]
    assert cycle_in({"a": {"b", "c"}, "b": {"c"}}) == []


def test_no_import_cycle_between_modules():
    graph = {
        module: own_imports_of(module, at_run_time=True) & trees().keys() - {module} for module in trees()
    }
    cycle = " -> ".join(cycle_in(graph))
    assert not cycle, cycle


def test_no_import_cycle_between_parts():
    graph: dict[str, set[str]] = {}
    for module in trees():
        others = {part_of(name) for name in own_imports_of(module)}
        graph.setdefault(part_of(module), set()).update(others - {part_of(module)})
    # `haptonic` itself, for its version, is imported by the parts that it opens to the user
    for part in TOP:
        graph.get(part, set()).discard("__init__")
    cycle = " -> ".join(cycle_in(graph))
    assert not cycle, cycle


def hidden_imports(tree: ast.AST) -> set[str]:
    """Libraries that are imported inside functions."""
    functions = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
    return {
        name.split(".")[0]
        for function in ast.walk(tree)
        if isinstance(function, functions)
        for node in ast.walk(function)
        if isinstance(node, ast.Import | ast.ImportFrom)
        for name in imported(node)
    }


def test_only_optional_dependencies_are_imported_inside_functions():
    hidden = {
        module: hidden_imports(tree) - INSIDE_FUNCTIONS.get(part_of(module), set())
        for module, tree in trees().items()
    }
    assert {module: names for module, names in hidden.items() if names} == {}


def test_no_module_is_longer_than_400_lines():
    """Make a longer one a folder with the same public name."""
    lengths = {str(file.relative_to(SOURCE)): len(file.read_text("utf-8").splitlines()) for file in FILES}
    assert {file: length for file, length in lengths.items() if length > 400} == {}


def test_the_core_needs_no_more_than_numpy_scipy_and_what_counts_memory_and_threads():
    outside = {
        "numpy",
        "scipy",
        "pydantic",
        "psutil",
        "threadpoolctl",
        "xarray",
        "pypardiso",
        "sksparse",
        "haptonic",
    }
    for module in trees():
        if part_of(module) in CORE - {"units", "fields", "foreign"}:
            roots = {name.split(".")[0] for name in imports_of(module)} - set(sys.stdlib_module_names)
            assert roots <= outside, module


def aliases_in(tree: ast.Module) -> dict[str, str]:
    """Types of arrays that a module gives names to, by what they are."""
    aliases = [
        node for node in tree.body if isinstance(node, ast.Assign) and isinstance(node.value, ast.Subscript)
    ]
    return {ast.unparse(node.value): ast.unparse(node.targets[0]) for node in aliases}


def test_types_of_arrays_are_named_once():
    known = aliases_in(trees()["haptonic.arrays"])
    again = [
        f"{module}.{name} is {what}, which haptonic.arrays names"
        for module in trees().keys() - {"haptonic.arrays"}
        for what, name in aliases_in(trees()[module]).items()
        if what in known and what != "NDArray[Any]"
    ]
    assert again == []


def patched_names():
    """(place, dotted name) of every attribute of the package that a test replaces by name."""
    for path in sorted(TESTS.rglob("*.py")):
        if "patch.setattr" not in path.read_text("utf-8"):
            continue
        tree = tree_of(path)
        modules = {}
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                modules |= {
                    a.asname: a.name for a in node.names if a.asname and a.name.startswith("haptonic")
                }
            elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("haptonic"):
                modules |= {name.asname or name.name: f"{node.module}.{name.name}" for name in node.names}
        for node in ast.walk(tree):
            is_patch = isinstance(node, ast.Call) and ast.unparse(node.func).endswith("patch.setattr")
            if not is_patch or any(word.arg == "raising" for word in node.keywords):
                continue
            first, second = node.args[:2]
            place = f"{path.name}:{node.lineno}"
            if isinstance(first, ast.Constant) and str(first.value).startswith("haptonic."):
                yield place, str(first.value)
            elif isinstance(first, ast.Name) and first.id in modules and isinstance(second, ast.Constant):
                yield place, f"{modules[first.id]}.{second.value}"


def test_names_that_tests_replace_exist():
    # a nightly test with an old name would fail a night later than the change
    unknown = [(place, name) for place, name in patched_names() if not is_there(name)]
    assert not unknown


def is_there(name):
    """True if a dotted name is a module of the package or an attribute in one."""
    parts = name.split(".")
    for count in range(len(parts), 0, -1):
        with contextlib.suppress(ImportError):
            value = importlib.import_module(".".join(parts[:count]))
            for part in parts[count:]:
                if not hasattr(value, part):
                    return False
                value = getattr(value, part)
            return True
    return False
