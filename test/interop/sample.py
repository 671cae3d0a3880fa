"""What writeSample.cpp has written, stated once more, and the comparison with what another program has read."""
import math
import os
import subprocess
import sys

PARTICLES = 7
TIMES = [0.0, 0.5, 1.0]
PARTS = 3
# ParaView's reader keeps single precision: half a unit in the last of its 24 binary digits.
SINGLE_PRECISION = 6e-8


def write(program, folder, form):
    subprocess.run([program, folder, form], check=True)


def decompose(program, folder):
    header = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
    for file, text in {"system/decomposeParDict": f"numberOfSubdomains {PARTS};\nmethod rcb;\n",
                       "constant/geometry": "dimension 2; domain { min (-1 -1 0); max (2 2 0); }\n"}.items():
        with open(os.path.join(folder, file), "w", encoding="ascii") as out:
            out.write(header.format(os.path.basename(file)) + text)
    subprocess.run([program, "-case", folder, "-time", "0:"], check=True, stdout=subprocess.DEVNULL)


def positions(t):
    return [(0.1*i + 0.01*t, 0.5, 0.0) for i in range(PARTICLES)]


def fields(t):
    """In OpenFOAM's order: symmetric tensors xx xy xz yy yz zz, tensors xx xy xz yx yy yz zx zy zz."""
    particles = range(PARTICLES)
    return {
        "U": [(i + t, -0.25*i, 0.0) for i in particles],
        "rho": [(1000 + 0.5*i,) for i in particles],
        "phase": [(i % 3,) for i in particles],
        "uniform": [(0.375,) for i in particles],
        "sigma": [tuple(factor + 0.5*i for factor in range(1, 7)) for i in particles],
        "planeStrain": [(1 + 0.5*i, 2 + 0.5*i, 0.0, 4 + 0.5*i, 0.0, 6 + 0.5*i) for i in particles],
        "gradU": [(1 + 0.5*i, 2 + 0.5*i, 0.0, 4 + 0.5*i, 6 + 0.5*i, 0.0, 0.0, 0.0, 0.0) for i in particles],
    }


def expect(what, found, wanted, tolerance=0.0):
    same = len(found) == len(wanted) and all(
        len(a) == len(b) and all(math.isclose(p, q, rel_tol=tolerance, abs_tol=tolerance) for p, q in zip(a, b))
        for a, b in zip(found, wanted))
    if not same:
        sys.exit(f"{what}: found {found}, wanted {wanted}")


def expect_equal(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: found {found!r}, wanted {wanted!r}")
