"""The results so far: one JSON object a line, so that an interrupted bench goes on."""

import datetime
import json
import os

# `beside` is the version of clod in whose rounds a program ran
KEY = ("kind", "size", "case", "program", "version", "beside", "machine", "threads", "run", "warm",
       "steps")


class Book:

    def __init__(self, path):
        self.path = path
        self.records = []
        if os.path.exists(path):
            with open(path) as file:
                self.records = [json.loads(line) for line in file]

    def has(self, record):
        """Whether this run of this version of the program is there."""
        return any(all(old.get(key) == record.get(key) for key in KEY) for old in self.records)

    def add(self, record):
        """Keep a record, with the time it has none of yet."""
        record = {"date": datetime.datetime.now().isoformat(timespec="seconds"), **record}
        os.makedirs(os.path.dirname(self.path), exist_ok=True)
        self.records.append(record)
        with open(self.path, "a") as file:
            file.write(json.dumps(record) + "\n")

    def latest(self):
        """Records whose program has not been measured in a later version, steps or machine."""
        last = {}
        for record in self.records:
            last[_subject(record)] = _edition(record)
        return [r for r in self.records if _edition(r) == last[_subject(r)]]


def _subject(record):
    return tuple(record.get(key) for key in ("kind", "size", "case", "program"))


def _edition(record):
    return tuple(record.get(key) for key in ("version", "beside", "machine", "warm", "steps"))
