# SPDX-License-Identifier: GPL-3.0-or-later
"""Small meshes made by formulas, in millimetres: what the samples do not have."""
import math
import struct


def obj(vertices, faces):
    return "".join(f"v {x:.4f} {y:.4f} {z:.4f}\n" for x, y, z in vertices) + \
        "".join("f " + " ".join(str(v + 1) for v in face) + "\n" for face in faces)


def grid(across, along, place, closed=False):
    """A grid of triangles. @param place  of two shares from 0 to 1  @param closed  around"""
    columns = across if closed else across + 1
    vertices = [place(i / across, j / along) for j in range(along + 1) for i in range(columns)]
    faces = []
    for j in range(along):
        for i in range(across):
            a, b = j * columns + i, j * columns + (i + 1) % columns
            c, d = b + columns, a + columns
            faces += [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
    return vertices, faces


def joined(*meshes):
    vertices, faces = [], []
    for more, corners in meshes:
        faces += [tuple(v + len(vertices) for v in face) for face in corners]
        vertices += more
    return vertices, faces


def noise(k):
    """From -1 to 1, the same everywhere."""
    k = (k * 2654435761 + 12345) & 0xFFFFFFFF
    k ^= k >> 15
    k = (k * 2246822519) & 0xFFFFFFFF
    return ((k >> 8) & 0xFFFF) / 32767.5 - 1


def panel(u, v):
    """A bent panel of 300 x 400 mm, curved more at one corner, so that nothing about it is symmetric."""
    x, y = 300 * u - 150, 400 * v + 900
    return x, y, 60 * math.sin(1.3 * u + 0.4) * math.cos(1.1 * v) + 25 * u * v * v


def bump(u, v):
    """A panel with a bump of 45 mm beside its middle, which no flat cloth lies on without strain."""
    x, y, z = panel(u, v)
    return x, y, z + 45 * math.exp(-9 * (u - 0.42) ** 2 - 7 * (v - 0.6) ** 2)


def shell():
    """The panel with a thickness of 2 mm, closed by rims."""
    n, m = 14, 18
    outer = grid(n, m, panel)
    inner = grid(n, m, lambda u, v: (panel(u, v)[0], panel(u, v)[1], panel(u, v)[2] - 2.0))
    vertices = outer[0] + inner[0]
    count = len(outer[0])
    faces = list(outer[1]) + [(c + count, b + count, a + count) for a, b, c in inner[1]]
    row = n + 1
    rim = [i for i in range(row)] + [j * row + n for j in range(1, m + 1)] + \
        [m * row + i for i in range(n - 1, -1, -1)] + [j * row for j in range(m - 1, 0, -1)]
    for a, b in zip(rim, rim[1:] + rim[:1]):
        faces += [(b, a, a + count), (b, a + count, b + count)]
    return vertices, faces


def tube(radius, bottom=500, top=1000, across=28, along=22):
    """A skirt: an oval tube, wider below, and not quite symmetric."""
    def place(u, v):
        a = 2 * math.pi * u
        r = radius * (1 + 0.35 * (1 - v) + 0.02 * math.sin(a + 0.7))
        return r * math.cos(a), bottom + (top - bottom) * v, 0.75 * r * math.sin(a)
    return grid(across, along, place, closed=True)


def ball():
    n, m = 18, 11
    vertices = [(0, 100, 0)] + [
        (130 * math.sin(math.pi * j / m) * math.cos(2 * math.pi * (i + 0.1) / n),
         100 * math.cos(math.pi * j / m),
         110 * math.sin(math.pi * j / m) * math.sin(2 * math.pi * (i + 0.1) / n))
        for j in range(1, m) for i in range(n)] + [(0, -100, 0)]
    last = len(vertices) - 1
    faces = [(0, 1 + (i + 1) % n, 1 + i) for i in range(n)]
    for j in range(m - 2):
        for i in range(n):
            a, b = 1 + j * n + i, 1 + j * n + (i + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    faces += [(last, last - n + i, last - n + (i + 1) % n) for i in range(n)]
    return vertices, faces


def scan():
    """A measured skirt: noise of 0.4 mm, two holes, and two crumbs of debris beside it."""
    vertices, faces = tube(140, across=60, along=40)
    vertices = [(x + 0.4 * noise(3 * k), y + 0.4 * noise(3 * k + 1), z + 0.4 * noise(3 * k + 2))
                for k, (x, y, z) in enumerate(vertices)]
    gone = [vertices[60 * 12 + 10], vertices[60 * 25 + 40]]
    faces = [face for face in faces
             if all(min(math.dist(vertices[v], hole) for v in face) > 12 for hole in gone)]
    used = sorted({v for face in faces for v in face})
    number = {v: k for k, v in enumerate(used)}
    sheet = [vertices[v] for v in used], [tuple(number[v] for v in face) for face in faces]
    crumb = grid(2, 2, lambda u, v: (400 + 9 * u, 600 + 7 * v, 3 * u * v))
    other = grid(3, 1, lambda u, v: (-390 + 5 * u, 820 + 11 * v, 2 * u))
    return joined(sheet, crumb, other)


def half():
    """The half of a tunic that lies at x >= 0, open in the plane of symmetry."""
    def place(u, v):
        a = math.pi * (u - 0.5)
        r = 160 * (1 + 0.3 * (1 - v) ** 2)
        return (0.0 if u in (0, 1) else r * math.cos(a)), 600 + 500 * v, 0.7 * r * math.sin(a) + 20 * v
    return grid(16, 20, place)


def holed():
    """The panel with a hole in it."""
    vertices, faces = grid(20, 26, panel)
    return vertices, [face for face in faces
                      if all(math.dist(vertices[v][:2], (10, 1120)) > 42 for v in face)]


def bent(text):
    """A sample bent to one side, so that no piece is symmetric: labels, grain lines and notches of symmetric
    pieces have two places that are equally good, and rounding would choose between them."""
    lines = []
    for line in text.split("\n"):
        if line.startswith("v "):
            x, y, z = (float(word) for word in line.split()[1:])
            x += 0.00025 * x * x + 0.04 * (y - 1100) + 0.03 * z + 6 * math.sin(0.004 * y + 0.002 * x)
            line = f"v {x:.4f} {y + 0.00012 * x * x + 0.02 * x:.4f} {z:.4f}"
        lines.append(line)
    return "\n".join(lines)


def stl(vertices, faces):
    text = "solid panel\n"
    for face in faces:
        text += " facet normal 0 0 0\n  outer loop\n"
        text += "".join("   vertex {:.4f} {:.4f} {:.4f}\n".format(*vertices[v]) for v in face)
        text += "  endloop\n endfacet\n"
    return text + "endsolid panel\n"


def off(vertices, faces):
    return f"OFF\n{len(vertices)} {len(faces)} 0\n" + \
        "".join(f"{x:.4f} {y:.4f} {z:.4f}\n" for x, y, z in vertices) + \
        "".join("3 {} {} {}\n".format(*face) for face in faces)


def ply(vertices, faces):
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
            "property float x\nproperty float y\nproperty float z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    return head.encode() + b"".join(struct.pack("<3f", *v) for v in vertices) + \
        b"".join(struct.pack("<B3i", 3, *face) for face in faces)


def all_meshes(samples):
    """Bytes by the name of the file. @param samples  the folder of the sample garments"""
    panel_mesh = grid(14, 18, panel)
    texts = {
        "panel.obj": obj(*panel_mesh),
        "panel.stl": stl(*panel_mesh),
        "panel.off": off(*panel_mesh),
        "bump.obj": obj(*grid(16, 20, bump)),
        "holed.obj": obj(*holed()),
        "shell.obj": obj(*shell()),
        "tube.obj": obj(*tube(140)),
        "layers.obj": obj(*joined(tube(140), tube(134, bottom=520))),
        "ball.obj": obj(*ball()),
        "scan.obj": obj(*scan()),
        "half.obj": obj(*half()),
        **{f"bent-{path.name}": bent(path.read_text()) for path in samples.glob("*.obj")},
    }
    files = {name: text.encode() for name, text in texts.items()}
    files["panel.ply"] = ply(*panel_mesh)
    return files
