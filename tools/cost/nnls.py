# SPDX-License-Identifier: MIT
"""Least squares without negative values (Lawson and Hanson, 1974: Solving Least Squares Problems, chapter 23)."""


def solve(matrix, right):
    """The solution of a symmetric positive definite system, by Gauss with the largest pivot."""
    size = len(right)
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for i in range(size):
        pivot = max(range(i, size), key=lambda j: abs(rows[j][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for j in range(i + 1, size):
            by = rows[j][i] / rows[i][i]
            if by:
                rows[j] = [b - by * a for a, b in zip(rows[i], rows[j])]
    result = [0.0] * size
    for i in reversed(range(size)):
        result[i] = (rows[i][size] - sum(rows[i][j] * result[j] for j in range(i + 1, size))) / rows[i][i]
    return result


def nnls(rows, wanted, ridge=1e-9):
    """x >= 0 for which |rows x - wanted| is least. Columns are scaled to a length of 1, and `ridge` of that keeps those
    that depend on each other apart."""
    count = len(rows[0])
    scale = [sum(row[i] * row[i] for row in rows) ** 0.5 or 1.0 for i in range(count)]
    scaled = [[value / by for value, by in zip(row, scale)] for row in rows]
    columns = list(zip(*scaled))
    gram = [[sum(a * b for a, b in zip(c, d)) + (ridge if i == j else 0) for j, d in enumerate(columns)]
            for i, c in enumerate(columns)]
    right = [sum(a * b for a, b in zip(c, wanted)) for c in columns]
    x, free = [0.0] * count, []
    while True:
        slope = [right[i] - sum(gram[i][j] * x[j] for j in free) for i in range(count)]
        best = max((i for i in range(count) if i not in free), key=lambda i: slope[i], default=None)
        if best is None or slope[best] <= 1e-9 * max(map(abs, right)):
            return [value / by for value, by in zip(x, scale)]
        free.append(best)
        while True:
            tried = solve([[gram[i][j] for j in free] for i in free], [right[i] for i in free])
            if min(tried) > 0:
                break
            part = min(x[i] / (x[i] - value) for i, value in zip(free, tried) if value <= 0)
            for i, value in zip(free, tried):
                x[i] += part * (value - x[i])
            x = [0.0 if i in free and x[i] <= 1e-12 else x[i] for i in range(count)]
            free = [i for i in free if x[i] > 0]
        for i, value in zip(free, tried):
            x[i] = value
