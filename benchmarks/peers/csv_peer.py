# SPDX-License-Identifier: Apache-2.0
"""Reading a record by Python's csv module, or by pandas (variant pandas)."""
import csv
import os

import contract


def by_csv(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        next(rows)
        return [[float(field) for field in row] for row in rows]


def by_pandas(path):
    return pandas.read_csv(path, comment="#", engine="c", float_precision="round_trip").to_numpy()


if __name__ == "__main__":
    asked = contract.request()
    reader = by_csv
    if asked.variant == "pandas":
        import pandas

        reader = by_pandas
    table = []

    def work():
        table[:] = [reader(asked.data)]

    seconds, repetitions = contract.measure(asked.seconds, work)
    mean_square = sum(float(row[3]) ** 2 for row in table[0]) / len(table[0])
    contract.answer(seconds, repetitions, os.path.getsize(asked.data), [len(table[0]), mean_square])
