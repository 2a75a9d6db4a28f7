"""What came out of a batch."""
from collections import Counter
from dataclasses import dataclass, field


@dataclass
class Found:
    kernel: object
    kind: str          # different, lost, crashed, verify-..., broken
    details: str
    directory: str
    program: str | None = None  # what C-Reduce has left


@dataclass
class Outcome:
    count: int = 0
    compared: int = 0          # kernels
    samples: int = 0
    guarded: int = 0
    outside: int = 0
    verified: int = 0
    recorded_twice: int = 0    # kernels whose second recording is equal
    not_twice: Counter = field(default_factory=Counter)   # that it does not take, by diagnostic
    refused: Counter = field(default_factory=Counter)   # by diagnostic
    features_refused: Counter = field(default_factory=Counter)
    found: list = field(default_factory=list)

    def add(self, other):
        for name in ("count", "compared", "samples", "guarded", "outside", "verified", "recorded_twice"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        self.refused += other.refused
        self.not_twice += other.not_twice
        self.features_refused += other.features_refused
        self.found += other.found
