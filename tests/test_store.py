"""The store: keys that change when they must, files that are whole or absent."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import textwrap
import time
import warnings
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import platformdirs
import pytest
import xarray as xr
from hypothesis import HealthCheck, given, settings, strategies as st

from five_parts import refusing
from haptonic import store as module
from haptonic.atomic import refuse_overwrite, whole_set, write_atomically
from haptonic.errors import HaptonicWarning, ResourceError
from haptonic.results import refuse_taken
from haptonic.store import Store, content_key

KEY = "ab" + "0" * 62
leaves = (
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | st.text()
)
values = st.recursive(
    leaves, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3)
)
inputs = st.dictionaries(st.text(), values, max_size=4)


def gaps(number: float = 1.0, count: int = 5) -> xr.Dataset:
    frequency = number * np.arange(count, dtype=float)
    return xr.Dataset({"frequency": ("band", frequency, {"units": "Hz"})}, attrs={"made_by": "a test"})


def files_below(root: Path) -> list[str]:
    return sorted(path.name for path in root.rglob("*") if path.is_file())


def run_script(folder: Path, source: str, *arguments: object) -> subprocess.Popen[str]:
    return run_script_as(folder, "script", source, *arguments)


def run_script_as(folder: Path, name: str, source: str, *arguments: object) -> subprocess.Popen[str]:
    script = folder / f"{name}.py"
    script.write_text(textwrap.dedent(source))
    command = [sys.executable, str(script), *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


class TestContentKey:
    @settings(max_examples=30)
    @given(inputs)
    def test_the_order_of_names_does_not_matter(self, given_inputs: dict[str, object]) -> None:
        turned = dict(reversed(list(given_inputs.items())))
        assert content_key(turned) == content_key(given_inputs)

    @settings(max_examples=30)
    @given(inputs, inputs)
    def test_different_inputs_have_different_keys(
        self, first: dict[str, object], second: dict[str, object]
    ) -> None:
        def exact(value: object) -> object:  # True, 1 and 1.0, 0.0 and -0.0 are equal in Python, not here
            if isinstance(value, dict):
                return {name: exact(inner) for name, inner in value.items()}
            return (
                [exact(inner) for inner in value] if isinstance(value, list) else (type(value), repr(value))
            )

        assert (content_key(first) == content_key(second)) == (exact(first) == exact(second))

    @given(st.floats(allow_nan=False, allow_infinity=False))
    def test_the_next_float_is_another_input(self, number: float) -> None:
        neighbour = np.nextafter(number, 0.0 if number else 1.0).item()
        assert content_key({"pitch": number}) != content_key({"pitch": neighbour})

    def test_a_numpy_float_is_the_same_input_as_a_float(self) -> None:
        assert content_key({"pitch": np.float64(0.1)}) == content_key({"pitch": 0.1})

    def test_it_is_the_same_in_another_process(self, tmp_path: Path) -> None:
        source = """
            from haptonic.store import content_key, fingerprint
            print(fingerprint(), content_key({"b": [1, 2.5], "a": {"x": None, "y": "é"}}))
        """
        printed, _ = run_script(tmp_path, source).communicate(timeout=30)
        key = content_key({"a": {"y": "é", "x": None}, "b": [1, 2.5]})
        assert printed.split() == [module.fingerprint(), key]

    def test_changed_code_changes_the_key(self, monkeypatch: pytest.MonkeyPatch) -> None:
        before = content_key({"pitch": 0.007})
        monkeypatch.setattr(module, "fingerprint", lambda: "0" * 64)
        assert content_key({"pitch": 0.007}) != before

    @pytest.mark.parametrize(
        ("value", "words"),
        [
            (object(), "inputs.cell.pitch: object has no fields"),
            ([1, [range(3)]], r"inputs.cell.pitch\[1\]\[0\]: range has no fields"),
            (np.array([None]), "inputs.cell.pitch: an array of objects"),
            (Store, "inputs.cell.pitch: type has no fields"),
        ],
    )
    def test_what_cannot_name_a_result_is_refused(self, value: object, words: str) -> None:
        with pytest.raises(AssertionError, match=words):
            content_key({"cell": {"pitch": value}})


class TestFingerprint:
    VERSIONS: dict[str, str] = {"numpy": "2.0", "scipy": "1.14"}  # noqa: RUF012 (a constant of the tests)

    @pytest.fixture
    def package(self, tmp_path: Path) -> Path:
        for name in (
            "bloch.py",
            "cell/mesh.py",
            "materials/library.toml",
            "cli.py",
            "report/gaps.py",
            "plots.py",
        ):
            path = tmp_path / name
            path.parent.mkdir(exist_ok=True)
            path.write_text("one = 1\n")
        return tmp_path

    def of(self, package: Path) -> str:
        return module.source_hash(package, self.VERSIONS)

    @pytest.mark.parametrize("name", ["bloch.py", "cell/mesh.py", "materials/library.toml", "cell/report.py"])
    def test_it_changes_with_the_code_that_computes(self, package: Path, name: str) -> None:
        before = self.of(package)
        (package / name).write_text("one = 2\n")
        assert self.of(package) != before

    @pytest.mark.parametrize("name", ["cli.py", "report/gaps.py", "plots.py", "README.md", "cell/mesh.pyc"])
    def test_it_does_not_change_with_what_only_shows(self, package: Path, name: str) -> None:
        before = self.of(package)
        (package / name).write_text("one = 2\n")
        assert self.of(package) == before

    def test_it_changes_when_a_file_is_renamed(self, package: Path) -> None:
        before = self.of(package)
        (package / "bloch.py").rename(package / "block.py")
        assert self.of(package) != before

    @pytest.mark.parametrize("library", ["numpy", "scipy"])
    def test_it_changes_with_the_libraries(self, package: Path, library: str) -> None:
        assert module.source_hash(package, {**self.VERSIONS, library: "9"}) != self.of(package)

    def test_the_package_itself_is_read(self) -> None:
        package = Path(module.__file__).parent
        versions = {"numpy": np.__version__, "scipy": module.scipy.__version__}
        assert module.fingerprint() == module.source_hash(package, versions)


class TestPutAndGet:
    def test_what_was_put_comes_back(self, tmp_path: Path) -> None:
        dataset = gaps().assign(
            mode=("band", np.exp(1j * np.arange(5))),
            complete=("band", np.arange(5) > 2),
            label=("band", np.array(list("ΓXMΓX"))),
            duration=((), 2.5, {"units": "seconds"}),
            nothing=("empty", np.zeros(0)),
            undefined=("band", np.full(5, np.nan), {"nan_means": "nothing was asked of it"}),
        )
        store = Store(tmp_path / "not" / "there" / "yet")
        assert store.get(KEY) is None
        assert KEY not in store
        store.put(KEY, dataset)
        assert KEY in store
        xr.testing.assert_identical(store.get(KEY), dataset)
        assert files_below(tmp_path) == [f"{KEY}.nc"]
        assert store.path(KEY).parent.name == KEY[:2]

    @settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
    @given(st.lists(st.floats(allow_infinity=False), max_size=8))
    def test_numbers_come_back_bit_by_bit(self, tmp_path: Path, numbers: list[float]) -> None:
        store = Store(tmp_path)
        array = np.array(numbers, dtype=float)
        store.put(KEY, xr.Dataset({"frequency": ("band", array, {"nan_means": "not found"})}))
        stored = store.get(KEY)
        assert stored is not None
        np.testing.assert_array_equal(stored.frequency.values.view(np.int64), array.view(np.int64))

    def test_xarray_reads_the_same_from_the_file(self, tmp_path: Path) -> None:
        """With names, types and attributes of all kinds, as `haptonic.hdf5.read_dataset`."""
        dataset = (
            gaps()
            .assign_coords(band=np.arange(5), place=("band", list("abcde")), height=3.5)
            .assign(
                single=("one", [2], {"wide": [1.0, 2.0], "count": 3, "names": ["a", "b"], "long_name": "ä"}),
                texts=(("one", "band"), [["", "x", "longer", "ΓX", "1"]]),
                fine=("band", np.arange(5, dtype=np.float32)),
            )
        )
        Store(tmp_path).put(KEY, dataset)
        usual = xr.load_dataset(Store(tmp_path).path(KEY), engine="h5netcdf", decode_timedelta=False)
        read = Store(tmp_path).get(KEY)
        assert read is not None
        xr.testing.assert_identical(read, usual)
        for name, values in usual.variables.items():
            assert read[name].dtype == values.dtype
            assert {k: type(v) for k, v in read[name].attrs.items()} == {
                k: type(v) for k, v in values.attrs.items()
            }

    def test_the_file_is_like_one_of_xarray(self, tmp_path: Path) -> None:
        """The same dimensions in the same order, types, attributes and coordinates, with empty arrays."""
        dataset = gaps().assign_coords(place=("band", list("abcde")), angle=(("band", "side"), np.eye(5, 2)))
        dataset = dataset.assign(
            nothing=(("empty", "band"), np.zeros((0, 5))),
            undefined=("band", [1.0, np.nan, 2.0, 3.0, 4.0], {"nan_means": "nothing was asked of it"}),
            complete=("band", np.arange(5) > 2),
            day=("side", np.array(["2025-01-01", "2025-03-01"], "datetime64[ns]")),
            large=(("row", "side"), np.ones((300_000, 2), np.float32)),
        )
        dataset.to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
        Store(tmp_path).put(KEY, dataset)
        paths = tmp_path / "a.nc", Store(tmp_path).path(KEY)
        read = [xr.load_dataset(path, engine="h5netcdf") for path in paths]
        xr.testing.assert_identical(*read)
        assert read[0].encoding["unlimited_dims"] == read[1].encoding["unlimited_dims"] == {"empty"}
        for name in dataset.variables:
            assert read[0][name].dtype == read[1][name].dtype

    @pytest.mark.parametrize("value", [True, None, {"pitch": 0.007}, [True, False], 2j, b"x"])
    def test_attributes_without_a_type_of_netcdf_are_refused(self, tmp_path: Path, value: object) -> None:
        with pytest.raises(TypeError, match="attribute 'note'"):
            Store(tmp_path).put(KEY, gaps().assign_attrs(note=value))
        assert files_below(tmp_path) == []

    def test_a_result_is_replaced(self, tmp_path: Path) -> None:
        store = Store(tmp_path)
        store.put(KEY, gaps(1.0))
        store.put(KEY, gaps(2.0))
        xr.testing.assert_identical(store.get(KEY), gaps(2.0))

    def test_names_that_are_not_keys_are_refused(self, tmp_path: Path) -> None:
        with pytest.raises(AssertionError, match="does not come from content_key"):
            Store(tmp_path).path("../../elsewhere")

    def test_the_file_follows_the_umask(self, tmp_path: Path) -> None:
        before = os.umask(0o027)
        try:
            Store(tmp_path).put(KEY, gaps())
        finally:
            os.umask(before)
        assert Store(tmp_path).path(KEY).stat().st_mode & 0o777 == 0o640


class TestDamage:
    def damaged(self, folder: Path, damage: Callable[[bytes], bytes]) -> None:
        store = Store(folder)
        store.put(KEY, gaps())
        path = store.path(KEY)
        content = damage(path.read_bytes())
        path.write_bytes(content)
        with pytest.warns(HaptonicWarning, match="damaged and will be computed again"):
            assert store.get(KEY) is None
        aside = path.with_name(f"{KEY}.nc.corrupt")
        assert aside.read_bytes() == content
        assert KEY not in store
        aside.unlink()

    @settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
    @given(st.floats(0.0, 1.0, exclude_max=True))
    def test_a_file_cut_short_counts_as_absent(self, tmp_path: Path, share: float) -> None:
        self.damaged(tmp_path, lambda content: content[: int(share * len(content))])

    @settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
    @given(st.floats(0.0, 1.0, exclude_max=True), st.integers(1, 255))
    def test_one_changed_byte_is_noticed(self, tmp_path: Path, share: float, change: int) -> None:
        def damage(content: bytes) -> bytes:
            place = int(share * len(content))
            return content[:place] + bytes([content[place] ^ change]) + content[place + 1 :]

        self.damaged(tmp_path, damage)

    def test_a_file_of_zeros_counts_as_absent(self, tmp_path: Path) -> None:
        self.damaged(tmp_path, lambda content: bytes(len(content)))

    def test_it_can_be_put_again(self, tmp_path: Path) -> None:
        self.damaged(tmp_path, lambda content: content[:100])
        Store(tmp_path).put(KEY, gaps())
        xr.testing.assert_identical(Store(tmp_path).get(KEY), gaps())


class TestAtomicity:
    @pytest.mark.parametrize("failure", [ValueError, KeyboardInterrupt])
    def test_an_exception_leaves_what_was_there(self, tmp_path: Path, failure: type[BaseException]) -> None:
        path = tmp_path / "gaps.csv"
        path.write_text("old")

        def writer(temporary: Path) -> None:
            temporary.write_text("half of the n")
            raise failure

        with pytest.raises(failure):
            write_atomically(path, writer)
        assert path.read_text() == "old"
        assert files_below(tmp_path) == ["gaps.csv"]

    def test_the_temporary_has_the_same_suffix_and_folder(self, tmp_path: Path) -> None:
        seen = []

        def writer(temporary: Path) -> None:
            seen.append(temporary)
            temporary.write_text("<svg/>")

        path = tmp_path / "new" / "bands.svg"
        write_atomically(path, writer)
        assert path.read_text() == "<svg/>"
        assert [(temporary.parent, temporary.suffix) for temporary in seen] == [(path.parent, ".svg")]
        assert files_below(tmp_path) == ["bands.svg"]

    def test_a_failing_put_leaves_what_was_there(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        store = Store(tmp_path)
        store.put(KEY, gaps(1.0))

        def fails(_: int) -> None:
            raise OSError(28, "No space left on device")

        monkeypatch.setattr(os, "fsync", fails)
        with pytest.warns(HaptonicWarning, match="are not stored.*the disk is full"):
            store.put(KEY, gaps(2.0))
        xr.testing.assert_identical(store.get(KEY), gaps(1.0))
        assert files_below(tmp_path) == [f"{KEY}.nc"]

    def test_a_process_killed_in_the_middle_of_a_put(self, tmp_path: Path) -> None:
        source = """
            import os, sys, time
            from pathlib import Path
            import xarray as xr
            from haptonic.store import Store

            def never_done(_):
                print("written, not renamed", flush=True)
                time.sleep(60)

            os.fsync = never_done
            Store(Path(sys.argv[1])).put(sys.argv[2], xr.Dataset({"x": ("n", [1.0])}))
        """
        store = Store(tmp_path / "store")
        child = run_script(tmp_path, source, store.root, KEY)
        assert child.stdout is not None
        assert child.stdout.readline() == "written, not renamed\n"
        child.kill()
        child.communicate()
        (leftover,) = files_below(store.root)
        assert leftover.startswith(".haptonic-")
        assert KEY not in store
        assert store.get(KEY) is None

        store.put(KEY, gaps())
        assert files_below(store.root) == [leftover, f"{KEY}.nc"], "it may belong to a run that goes on"
        yesterday = time.time() - 25 * 3600
        os.utime(store.path(KEY).parent / leftover, (yesterday, yesterday))
        store.put(KEY, gaps())
        assert files_below(store.root) == [f"{KEY}.nc"]

    WRITER = """
        import sys
        from pathlib import Path
        import numpy as np, xarray as xr
        from haptonic.store import Store

        store, number = Store(Path(sys.argv[1])), float(sys.argv[3])
        dataset = xr.Dataset({"frequency": ("band", np.full(20000, number))})
        for turn in range(int(sys.argv[4])):
            store.put(sys.argv[2], dataset)
            if turn == 0:
                print("begun", flush=True)
    """

    def test_two_writers_of_one_key_and_a_reader(self, tmp_path: Path) -> None:
        store = Store(tmp_path / "store")
        writers = [run_script(tmp_path, self.WRITER, store.root, KEY, number, 8) for number in (1.0, 2.0)]
        seen = set()
        while any(writer.poll() is None for writer in writers):
            stored = store.get(KEY)  # a torn file would warn, and warnings are errors here
            if stored is not None:
                seen.add(tuple(np.unique(stored.frequency.values)))
        for writer in writers:
            assert writer.communicate()[1] == ""
            assert writer.returncode == 0
        assert seen <= {(1.0,), (2.0,)}
        assert seen
        assert files_below(store.root) == [f"{KEY}.nc"]

    @pytest.mark.parametrize("delay", [0.0, 0.023])
    def test_kills_at_any_moment(self, tmp_path: Path, delay: float) -> None:
        store = Store(tmp_path / "store")
        child = run_script(tmp_path, self.WRITER, store.root, KEY, 3.0, 10**6)
        assert child.stdout is not None
        child.stdout.readline()
        time.sleep(delay)
        child.send_signal(signal.SIGKILL)
        child.communicate()
        stored = store.get(KEY)
        assert stored is not None
        assert np.all(stored.frequency.values == 3.0)


class TestUnusableFolders:
    """By a regular file in the path: permissions would not stop a test that runs as root."""

    @pytest.fixture
    def blocked(self, tmp_path: Path) -> Path:
        (tmp_path / "file").write_text("not a folder")
        return tmp_path / "file" / "store"

    def test_put(self, blocked: Path) -> None:
        with pytest.warns(HaptonicWarning, match="a part of the path is a file, not a folder") as caught:
            Store(blocked).put(KEY, gaps())
        assert str(blocked) in str(caught[0].message)

    def test_get(self, blocked: Path) -> None:
        with pytest.warns(HaptonicWarning, match="HAPTONIC_STORE"):
            assert Store(blocked).get(KEY) is None

    def test_a_folder_in_the_place_of_a_result(self, tmp_path: Path) -> None:
        Store(tmp_path).path(KEY).mkdir(parents=True)
        for use in (lambda: Store(tmp_path).get(KEY), lambda: Store(tmp_path).put(KEY, gaps())):
            with pytest.warns(HaptonicWarning, match="a folder of this name exists"):
                use()

    def test_output(self, blocked: Path) -> None:
        with refusing(ResourceError, "unwritable", "output file") as caught:
            write_atomically(blocked / "gaps.csv", lambda temporary: temporary.write_text("x"))
        assert all(caught.value.parts().values())

    @pytest.mark.skipif(sys.platform == "win32", reason="there is no limit on file sizes there")
    def test_a_disk_that_fills_up(self, tmp_path: Path) -> None:
        source = """
            import resource, signal, sys
            from pathlib import Path
            import numpy as np, xarray as xr
            from haptonic.store import Store

            store = Store(Path(sys.argv[1]))
            store.put(sys.argv[2], xr.Dataset({"x": ("n", [1.0])}))
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))
            store.put(sys.argv[2], xr.Dataset({"x": ("n", np.arange(1e5))}))
        """
        printed, noise = run_script(tmp_path, source, tmp_path / "store", KEY).communicate(timeout=30)
        assert printed == ""
        assert "HaptonicWarning" in noise
        assert "the file is larger than the system lets you write" in noise
        assert files_below(tmp_path / "store") == [f"{KEY}.nc"]
        stored = Store(tmp_path / "store").get(KEY)
        assert stored is not None
        assert stored.x.values == [1.0]


class TestPlaces:
    def test_the_variable_names_the_store(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.chdir(tmp_path)
        monkeypatch.setenv("HAPTONIC_STORE", "results")
        assert Store.default() == Store(tmp_path / "results")

    @pytest.mark.parametrize("value", [None, ""])
    def test_else_it_is_the_cache_folder(self, monkeypatch: pytest.MonkeyPatch, value: str | None) -> None:
        monkeypatch.delenv("HAPTONIC_STORE", raising=False)
        if value is not None:
            monkeypatch.setenv("HAPTONIC_STORE", value)
        assert Store.default().root == platformdirs.user_cache_path("haptonic", appauthor=False)

    def test_overwriting_has_to_be_asked_for(self, tmp_path: Path) -> None:
        path = tmp_path / "bands.nc"
        refuse_overwrite(path, overwrite=False)
        path.symlink_to(tmp_path / "gone")  # a link counts, wherever it leads
        refuse_overwrite(path, overwrite=True)
        with refusing(ResourceError, "repeated", "output file") as caught:
            refuse_overwrite(path, overwrite=False)
        assert json.loads(json.dumps(caught.value.parts()))["given"] == str(path)


def test_asking_whether_a_folder_can_be_written_leaves_nothing_behind(tmp_path):
    (tmp_path / "there").mkdir()
    for folder in (tmp_path / "there", tmp_path / "new" / "deeper"):
        refuse_taken(folder, ["a.nc"], overwrite=False)
    assert [path.name for path in tmp_path.rglob("*")] == ["there"]
    (tmp_path / "there" / "a.nc").touch()
    with refusing(ResourceError, "repeated", "output file", "a.nc"):
        refuse_taken(tmp_path / "there", ["a.nc"], overwrite=False)


RACER = """
    import sys, time
    from pathlib import Path
    from haptonic.errors import ResourceError
    from haptonic.results import refuse_taken, write_files
    from haptonic.atomic import whole_set

    root, number, turns = Path(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    for turn in range(turns):
        while time.time() < float(sys.argv[4]) + 0.02 * turn:
            pass
        folder = root / str(turn) / "results" / ("same" if turn % 2 else number)
        try:
            refuse_taken(folder, ["a", "b"], overwrite=False)
            with whole_set(folder, overwrite=False) as draft:
                write_files(draft, {n: lambda path: path.write_text(number) for n in "ab"}, overwrite=False)
            print(turn, flush=True)
        except ResourceError as error:
            assert "not taken" in error.allowed, error
"""


def test_two_commands_at_once_in_a_fresh_folder(tmp_path: Path) -> None:
    """Each writes its set into a folder that is not there yet, or is refused since the other was faster."""
    turns, start = 60, time.time() + 3
    racers = [run_script_as(tmp_path, f"racer{k}", RACER, tmp_path / "root", k, turns, start) for k in "AB"]
    done = []
    for racer in racers:
        out, noise = racer.communicate(timeout=60)
        assert noise == ""
        done += out.split()
    assert set(done) == {str(turn) for turn in range(turns)}, "somebody has to be first"
    for turn in range(turns):
        for folder in (tmp_path / "root" / str(turn) / "results").iterdir():
            assert sorted(path.name for path in folder.iterdir()) == ["a", "b"]
    assert not list((tmp_path / "root").rglob(".haptonic*"))


class TestWholeSets:
    NAMES = ("a.nc", "b.csv", "scan/c.csv")

    @given(st.integers(0, 3), st.sampled_from([OSError(28, "full"), ValueError, KeyboardInterrupt]),
           st.booleans(), st.sampled_from(["new", "new/deeper", "there"]), st.booleans())  # fmt: skip
    @settings(max_examples=60, deadline=None)
    def test_all_or_none(self, place: int, failure: Any, overwrite: bool, where: str, deep: bool) -> None:
        """Whatever fails and wherever: the folder is as it was; without a failure all files are there.

        ``deep``: the writer that fails writes a file in its turn.
        """
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            (root / "there").mkdir()
            (root / "there" / "mine").write_text("mine")
            if overwrite and where == "there":
                (root / where / "b.csv").write_text("old")
            before = {path: path.is_file() and path.read_text() for path in root.rglob("*")}

            def written() -> None:
                with whole_set(root / where, overwrite=overwrite) as draft:
                    for number, file in enumerate(self.NAMES):
                        if number == place:
                            fail = partial(write_atomically, writer=fails) if deep else fails
                            write_atomically(draft / file, fail)
                        write_atomically(draft / file, lambda path: path.write_text("new"))

            def fails(_: Path) -> None:
                raise failure

            if place == len(self.NAMES):
                written()
                assert all((root / where / file).read_text() == "new" for file in self.NAMES)
                assert (root / "there" / "mine").read_text() == "mine"
                assert not list(root.rglob(".haptonic*"))
                return
            expected = ResourceError if isinstance(failure, OSError) else failure
            with pytest.raises(expected) as caught:
                written()
            if expected is ResourceError:
                assert caught.value.given == str(root / where / self.NAMES[place])
            assert {path: path.is_file() and path.read_text() for path in root.rglob("*")} == before

    def test_a_taken_file_name_is_refused(self, tmp_path: Path) -> None:
        (tmp_path / "b.csv").write_text("old")

        def written() -> None:
            with whole_set(tmp_path, overwrite=False) as draft:
                for name in ("a.nc", "b.csv"):
                    (draft / name).write_text("new")

        with refusing(ResourceError, "repeated", "output file"):
            written()
        assert files_below(tmp_path) == ["b.csv"]
        assert (tmp_path / "b.csv").read_text() == "old"

    def test_what_a_killed_run_left_goes_a_day_later(self, tmp_path: Path) -> None:
        left = tmp_path / ".haptonic-0123.tmp"
        left.mkdir()
        (left / "a.nc").touch()
        with whole_set(tmp_path, overwrite=False):
            assert left.exists(), "it may belong to a run that goes on"
        yesterday = time.time() - 25 * 3600
        os.utime(left, (yesterday, yesterday))
        with whole_set(tmp_path, overwrite=False):
            assert not left.exists()


def test_a_store_that_cannot_keep_is_noticed_before_the_work(tmp_path: Path) -> None:
    """A read-only folder would not stop a test that runs as root; a file in the path does."""
    (tmp_path / "file").touch()
    with pytest.warns(HaptonicWarning, match="results of this run are not stored"):
        assert Store(tmp_path / "file" / "store").get(KEY) is None
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert Store(tmp_path / "new" / "store").get(KEY) is None
    assert not (tmp_path / "new").exists()


def test_files_unused_for_longest_leave_when_a_kind_has_too_many(tmp_path, monkeypatch):
    """A picture that was used again stays; datasets have their own limit. Once per process: a new root."""
    keys = [f"{k}{k}" + "0" * 62 for k in range(5)]
    for age, key in enumerate(keys):
        Store(tmp_path).write(key, bytes(1000), "png")
        moment = time.time() - 1000 * (len(keys) - age)
        os.utime(Store(tmp_path).path(key, "png"), (moment, moment))
    Store(tmp_path).put(KEY, gaps(count=1000))
    os.utime(Store(tmp_path).path(KEY), (0, 0))
    assert Store(tmp_path).read(keys[0], "png") == bytes(1000)
    monkeypatch.setitem(module.MOST_BYTES, "png", 4 * 1064 + 63)
    module._make_room.cache_clear()
    Store(tmp_path).write("ff" + "0" * 62, bytes(1000), "png")
    left = [key for key in keys if Store(tmp_path).path(key, "png").exists()]
    assert left == [keys[0], *keys[3:]]
    assert Store(tmp_path).path("ff" + "0" * 62, "png").exists()
    assert KEY in Store(tmp_path)
