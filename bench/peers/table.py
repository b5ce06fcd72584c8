"""Medians of records, and tables in Markdown."""

import statistics


def chosen(records, **keys):
    """Records with these values."""
    return [r for r in records if all(r.get(key) == value for key, value in keys.items())]


def median(records, key):
    """Median of one number, or None without records."""
    return statistics.median(r[key] for r in records) if records else None


def ratio(ours, theirs):
    """Median over the rounds of the ratio of two rates of a round, or None: a machine that is
    slower for a while is so for both."""
    other = {r["run"]: r["rate"] for r in theirs}
    pairs = [r["rate"] / other[r["run"]] for r in ours if r["run"] in other]
    return statistics.median(pairs) if pairs else None


def spread(records, key="rate", scale=1e-6):
    """`median (min - max)` of one number."""
    values = [scale * r[key] for r in records]
    return f"{statistics.median(values):.2f} ({min(values):.2f} - {max(values):.2f})"


def text(head, rows):
    """A table; nothing without rows."""
    if not rows:
        return ""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n\n"


def ordered(values, order):
    """The values that occur, in the order of a table."""
    found = set(values)
    return [value for value in order if value in found]
