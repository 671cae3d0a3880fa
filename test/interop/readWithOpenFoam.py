"""OpenFOAM's own tools read what writeSample wrote: readWithOpenFoam.py writeSample format [decomposeParticles]; with the latter as ranks do that
have a processor folder each"""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import sample

# foamToVTK writes single precision.
TOLERANCE = sample.SINGLE_PRECISION


def run(*command, cwd):
    # The tools compare PWD with the folder they are in, and warn. The folders of two mpirun in one TMPDIR can be in one another's way.
    done = subprocess.run(command, cwd=cwd, env={**os.environ, "PWD": cwd, "TMPDIR": cwd}, capture_output=True, text=True)
    said = done.stdout + done.stderr
    # OpenFOAM's tools go on after some errors, with exit code 0.
    if done.returncode != 0 or "FATAL" in said or "--> FOAM Warning" in said:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{said}")
    return done.stdout


def tuples(array):
    width = int(array.get("NumberOfComponents", 1))
    numbers = [float(word) for word in (array.text or "").split()]
    return [tuple(numbers[k:k + width]) for k in range(0, len(numbers), width)]


def check_cloud(file, time):
    piece = xml.parse(file).getroot().find("PolyData/Piece")
    sample.expect(f"positions at {time}", tuples(piece.find("Points/DataArray")), sample.positions(time), TOLERANCE)
    found = {array.get("Name"): tuples(array) for array in piece.findall("PointData/DataArray")}
    for name, wanted in sample.fields(time).items():
        values = found[name]
        if name in ("sigma", "planeStrain"):
            # As VTK: xx yy zz xy yz xz.
            values = [tuple(v[k] for k in (0, 3, 5, 1, 4, 2)) for v in values]
        sample.expect(f"{name} at {time}", values, wanted, TOLERANCE)


def check_clouds(folder):
    for k, time in enumerate(sample.TIMES):
        # The files are numbered by the index of each time.
        check_cloud(f"{folder}/VTK/lagrangian/sph/sph_{2*k}.vtp", time)


def main(program, form, decompose=None):
    with tempfile.TemporaryDirectory() as folder:
        sample.write(program, folder, form)
        if decompose:
            sample.decompose(decompose, folder)
            # Parts of a row follow upon one another in the order of its particles.
            run("mpirun", "-np", str(sample.PARTS), "foamToVTK", "-parallel", "-ascii", cwd=folder)
            check_clouds(folder)
            return
        times = run("foamListTimes", "-withZero", cwd=folder).split()
        sample.expect_equal("foamListTimes", times, ["0", "0.5", "1"])
        if "Mesh OK." not in run("checkMesh", "-latestTime", cwd=folder):
            sys.exit("checkMesh: the mesh is not OK")
        mass = run("foamDictionary", "-precision", "17", "-entry", "massOfInlet(water)", "-value", "1/uniform/sphState", cwd=folder)
        sample.expect_equal("massOfInlet(water)", float(mass), 0.1 + 0.2)
        index = run("foamDictionary", "-entry", "index", "-value", "1/uniform/time", cwd=folder)
        sample.expect_equal("index", int(index), 4)
        run("foamToVTK", "-ascii", cwd=folder)
        check_clouds(folder)


main(*sys.argv[1:])
