"""The methods of a study; docs/write_reference.py writes this from the table of analyses."""

import pathlib
import typing

import haptonic.analyses.chirp
import haptonic.analyses.export
import haptonic.analyses.reproduce
import haptonic.plate.vibration.settings
import haptonic.progress
import haptonic.response.value
import haptonic.results.bands
import haptonic.results.comparison
import haptonic.results.design
import haptonic.results.feel.value
import haptonic.results.friction
import haptonic.results.guides
import haptonic.results.layers
import haptonic.results.plan
import haptonic.results.plate.value
import haptonic.results.protocol
import haptonic.results.ribbon
import haptonic.results.scan.simulated
import haptonic.results.scan.value
import haptonic.results.simulated_trials
import haptonic.results.sweeps
import haptonic.results.tolerance
import haptonic.results.verdict
import haptonic.store

class Methods:
    def plan(
        self,
        *,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.plan.StudyPlan:
        """Map of the plate and time and memory of each command, before anything is computed."""

    def bands(
        self,
        *,
        surface: bool = ...,
        modes_at: str | None = ...,
        html: bool = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.bands.Bands:
        """Band diagram, gaps and mode shapes of the unit cell."""

    def compare(
        self,
        *,
        frequency_unit: str | None = ...,
        first: str | pathlib.Path,
        second: str | pathlib.Path,
        wavevector: str | None = ...,
        skip_lines: int = ...,
        any_difference: bool = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.comparison.Comparison:
        """Bands of two studies or results, or of another program's table over those of a study."""

    def sweep(
        self,
        *,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.sweeps.Sweeps:
        """Complete gaps along the study's sweeps."""

    def reproduce(
        self,
        *,
        references: typing.Any = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.analyses.reproduce.Reproduction:
        """All analyses of the study, and one report that compares them with reference values."""

    def layers(
        self,
        *,
        html: bool = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.layers.Layers:
        """Insertion loss of rows of cells between plain plates, and the number of rows for the carrier."""

    def waveguide(
        self,
        *,
        html: bool = ...,
        mode: str | None = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.guides.Guides:
        """Width, length and frequency of a waveguide between two mirrors of cells."""

    def ribbon(
        self,
        *,
        html: bool = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.ribbon.RibbonWaves:
        """Waves along columns of cells side by side: projected bands, and modes of guides and edges."""

    def design(
        self,
        *,
        pareto: bool = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.design.Design:
        """The cell whose gap contains the carrier with the widest margin, within the study's [design]."""

    def tolerance(
        self,
        *,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.tolerance.Tolerance:
        """Probability that the gap contains the carrier, the size that matters most, and the loosest
        tolerances."""

    def export(
        self,
        *,
        step: bool = ...,
        dxf: bool = ...,
        stl: bool = ...,
        drawing: bool = ...,
        columns: int | None = ...,
        rows: int | None = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.analyses.export.Workshop:
        """Files for the workshop, of the plate or a piece of lattice; all of them if none is named. The
        drawing has tolerances, or a note that explains why there are none."""

    def plate(
        self,
        *,
        at: str | float | None = ...,
        html: bool = ...,
        settings: haptonic.plate.vibration.settings.ResponseSettings | None = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.plate.value.PlateResult:
        """Vibration of the finite plate: response, localisation, energies, impedance, modes."""

    def feel(
        self,
        *,
        voltage: str | float | None = ...,
        at: str | float | None = ...,
        reduction: float | None = ...,
        html: bool = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.feel.value.Feel:
        """Friction under a finger on the plate: a map, reductions, and whether people notice them."""

    def chirp(
        self,
        *,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.analyses.chirp.Excitation:
        """The drive of a scan as WAV, CSV and HDF5, and its points in the order of measurement."""

    def scan(
        self,
        *,
        estimator: typing.Literal["H1", "H2", "Hv"] = ...,
        window: typing.Literal["none", "hann", "exponential"] = ...,
        decay: str | float | None = ...,
        segment: str | float | None = ...,
        overlap: float = ...,
        align: bool = ...,
        repair: tuple[str, ...] = ...,
        frequency_unit: str | None = ...,
        corners: typing.Any = ...,
        mirrored: bool = ...,
        path: str | pathlib.Path | None = ...,
        response: haptonic.response.value.FrequencyResponse | None = ...,
        against: str | pathlib.Path | None = ...,
        at: typing.Any = ...,
        model: bool = ...,
        html: bool = ...,
        unit: str | None = ...,
        length_unit: str | None = ...,
        variables: typing.Any = ...,
        reference: str | None = ...,
        phase_unit: str | None = ...,
        points_in: typing.Literal["rows", "columns"] | None = ...,
        simulated: bool = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.scan.value.ScanResult:
        """Analysis of a scan: responses, maps, contrast, the gap, waves; and agreement with a model."""

    def protocol(
        self,
        *,
        amplitudes: typing.Any = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.protocol.TrialPlan:
        """Order of friction trials: list, printed sheet, metronome, and how many participants are needed."""

    def friction(
        self,
        *,
        path: str | pathlib.Path,
        study: str | pathlib.Path | None = ...,
        html: bool = ...,
        settings: typing.Any = ...,
        draft: bool = ...,
        references: typing.Any = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.friction.FrictionResult:
        """Coefficients of friction from force records, and tests of their reduction."""

    def verdict(
        self,
        *,
        response: typing.Any,
        computed: typing.Any = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.verdict.Verdict:
        """Comparison of a measured response with the model, with chosen numbers fitted to it."""

    def simulate_friction(
        self,
        *,
        seed: int = ...,
        participants: int | None = ...,
        form: typing.Literal["csv", "h5", "mat", "tdms"] = ...,
        per: typing.Literal["trial", "block"] = ...,
        raw: bool = ...,
        amplitudes: typing.Any = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.simulated_trials.SimulatedFriction:
        """Strokes of simulated participants, as a folder that `haptonic friction` reads."""

    def simulate_scan(
        self,
        *,
        seed: int = ...,
        form: typing.Literal["h5", "nc", "uff", "mat", "csv", "tdms"] = ...,
        time: bool | None = ...,
        response: typing.Any = ...,
        store: haptonic.store.Store | None = None,
        workers: int = 0,
        scheduler: str | None = None,
        progress: haptonic.progress.Progress | None = None,
        budget: float | str | None = None,
    ) -> haptonic.results.scan.simulated.SimulatedScan:
        """A simulated scan of the study's plate. Everything is marked as simulated."""
