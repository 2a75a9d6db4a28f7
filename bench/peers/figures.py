"""What was measured of a row, as figures: medians, quartiles, ratios turn by turn, which is best."""
import statistics

import contenders

ORIGINAL = "gcc -O3 -march=native"
TITLES = {"fk": "forward kinematics", "rnea": "inverse dynamics", "crba": "mass matrix", "aba": "forward dynamics"}


def quartiles(values):
    low, middle, high = statistics.quantiles(values, n=4)
    return {"median": middle, "low": low, "high": high}


class Row:
    def __init__(self, data):
        self.kernel, self.joints, self.contenders = data["kernel"], data["joints"], data["contenders"]

    def there(self, name):
        return name in self.contenders and "missing" not in self.contenders[name] and any(
            "times" in variant for variant in self.contenders[name]["variants"].values())

    def missing(self, name):
        return self.contenders[name]["missing"] if name in self.contenders else "not tried"

    def levels(self, name):
        return {level: variant for level, variant in self.contenders[name]["variants"].items() if "times" in variant}

    def best_level(self, name):
        """The compiler and flags whose code is fastest. The original's other flags stand apart: it is compared as a user builds it."""
        levels = self.levels(name)
        return min(levels, key=lambda level: statistics.median(levels[level]["times"]))

    def variant(self, name, level=None):
        return self.contenders[name]["variants"][level or self.best_level(name)]

    def time(self, name, level=None):
        return quartiles(self.variant(name, level)["times"])

    def median(self, name, level=None):
        return statistics.median(self.variant(name, level)["times"])

    def ratio(self, slow, fast, slow_level=None):
        """How many times as fast `fast` is, turn by turn."""
        return quartiles([a / b for a, b in zip(self.variant(slow, slow_level)["times"], self.variant(fast)["times"])])

    def fastest(self, names):
        there = [name for name in names if self.there(name)]
        return min(there, key=self.median) if there else None

    def operations(self, name):
        return self.contenders[name].get("operations") if name in self.contenders else None

    def difference(self, name):
        """By how much the results are not the original's, relative to the largest output, where no operations are fused."""
        variants = self.contenders[name].get("variants", {})
        compared = variants.get("reference") or variants.get("gcc -O2")
        return compared.get("difference") if compared else None

    @property
    def title(self):
        return f"{TITLES[self.kernel]}, N = {self.joints}"


def ours(row):
    """What Symreal makes of the textbook source."""
    return row.fastest([*contenders.MODES, *contenders.LOOPED])


def peer(row):
    return row.fastest(contenders.PEERS)
