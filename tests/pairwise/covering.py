"""Rows of settings in which every two settings that may stand together do so in some row: a covering
array of strength two, by a greedy search. The same rows every time."""

import itertools


def cover(settings, completed, may_stand):
    """
    settings   list of (flag, value)
    completed  rows need more than was chosen: row -> row with what it needs, or None
    may_stand  whether no rule forbids a row
    A row is a dict flag -> value. Returns the rows, and the pairs that are in none as rules forbid them.
    """
    count = len(settings)
    partners = [0] * count  # of each setting, as bits: those that it has not stood with yet
    for a, b in itertools.combinations(range(count), 2):
        if settings[a][0] != settings[b][0]:
            partners[a] |= 1 << b
            partners[b] |= 1 << a
    alone = (1 << count) - 1  # settings that were in no row yet
    numbers = {setting: number for number, setting in enumerate(settings)}
    rows, forbidden = [], []

    def extended(row, added):
        row = completed({**row, **dict(added)})
        return row if row is not None and may_stand(row) else None

    def bits(row):
        return sum(1 << numbers[setting] for setting in row.items() if setting in numbers)

    for a in range(count):
        while partners[a] or alone >> a & 1:
            others = partners[a] >> (a + 1) << (a + 1)
            b = (others & -others).bit_length() - 1 if others else a
            if not others and not alone >> a & 1:
                break
            row = extended({}, [settings[a], settings[b]])
            if row is None or any(row.get(flag) != value for flag, value in (settings[a], settings[b])):
                forbidden.append((settings[a], settings[b]))
                partners[a] &= ~(1 << b)
                partners[b] &= ~(1 << a)
                if a == b:
                    alone &= ~(1 << a)
                continue
            row = filled(row, settings, partners, bits, extended)
            present = bits(row)
            for number in range(count):
                if present >> number & 1:
                    partners[number] &= ~present
            alone &= ~present
            rows.append(row)
    return rows, forbidden


def filled(row, settings, partners, bits, extended):
    """The row with all settings that still have partners to meet in it, those with most first."""
    refused = set()
    while True:
        present = bits(row)
        gains = [((partners[n] & present).bit_count(), -n) for n, (flag, _) in enumerate(settings)
                 if flag not in row and n not in refused]
        gain, number = max(gains, default=(0, 0))
        if gain == 0:
            return row
        longer = extended(row, [settings[-number]])
        if longer is None or any(longer.get(flag) != value for flag, value in row.items()):
            refused.add(-number)
        else:
            row = longer
