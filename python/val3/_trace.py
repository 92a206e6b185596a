"""The motion of a run, sample by sample."""

import csv
from dataclasses import dataclass
from pathlib import Path
from typing import Any

#: Columns with text; all others are numbers.
_TEXTS = {"phase", "limit"}


@dataclass(frozen=True, slots=True)
class Trace:
    """Samples every 4 ms while anything moves: a list for each column of ``val3 run --trace``.

    ``t`` is in seconds, joints in degrees or mm, ``x`` to ``z`` in mm, ``rx`` to ``rz`` in degrees, ``v`` in mm/s.
    """

    columns: dict[str, list[Any]]

    @classmethod
    def read(cls, path: Path) -> "Trace":
        """Read the table of ``val3 run --trace``."""
        with path.open(encoding="utf-8", newline="") as file:
            rows = csv.reader(file)
            names = next(rows, [])
            columns: dict[str, list[Any]] = {name: [] for name in names}
            for row in rows:
                for name, text in zip(names, row):
                    columns[name].append(text if name in _TEXTS else float(text) if text else float("nan"))
        return cls(columns)

    def __len__(self) -> int:
        return max((len(column) for column in self.columns.values()), default=0)

    def __getitem__(self, name: str) -> list[Any]:
        return self.columns[name]

    def __repr__(self) -> str:
        return f"<Trace of {len(self)} samples: {', '.join(self.columns)}>"

    def numpy(self) -> Any:
        """Return the columns as a structured array of numpy, which has to be installed."""
        import numpy

        arrays = {name: numpy.asarray(column) for name, column in self.columns.items()}
        samples = numpy.empty(len(self), dtype=[(name, array.dtype) for name, array in arrays.items()])
        for name, array in arrays.items():
            samples[name] = array
        return samples
