"""A method as a program of its own: reads an OBJ file, moves its vertices and writes another one."""

import sys

import numpy as np

with open(sys.argv[1], encoding="utf-8") as file:
    lines = [line.split() for line in file]
vertices = np.array([line[1:] for line in lines if line[:1] == ["v"]], float)
faces = np.array([line[1:] for line in lines if line[:1] == ["f"]], int) - 1

sides = np.sort(np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]))
edges, uses = np.unique(sides, axis=0, return_counts=True)
moves = np.ones(len(vertices), bool)
moves[edges[uses == 1]] = False  # the border stays
edges = np.vstack([edges, edges[:, ::-1]])
counts = np.bincount(edges[:, 0], minlength=len(vertices))

for _ in range(10):  # every vertex goes halfway to the mean of its neighbours
    sums = np.zeros(vertices.shape)
    np.add.at(sums, edges[:, 0], vertices[edges[:, 1]])
    means = sums / np.maximum(counts, 1)[:, None]
    vertices[moves] = 0.5 * (vertices + means)[moves]

with open(sys.argv[2], "w", encoding="utf-8") as file:
    for vertex in vertices.tolist():
        print("v", *vertex, file=file)  # all digits: eight are too few
    for face in faces.tolist():
        print("f", *(corner + 1 for corner in face), file=file)
