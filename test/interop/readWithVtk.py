"""VTK's OpenFOAM reader, which is ParaView's, finds the particles and fields that writeSample wrote: readWithVtk.py writeSample format"""
import glob
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader

import sample
from vtkOutput import blocks, output

# VTK shows symmetric tensors as xx yy zz xy yz xz: where each of OpenFOAM's xx xy xz yy yz zz is found.
SYMM_TENSOR = [0, 3, 5, 1, 4, 2]


def check(case, time):
    found = dict(blocks(output(vtkOpenFOAMReader(), case, time)))
    cloud = next(block for name, block in found.items() if name.endswith("sph"))
    points = [cloud.GetPoint(i) for i in range(cloud.GetNumberOfPoints())]
    sample.expect(f"positions at {time}", points, sample.positions(time), sample.SINGLE_PRECISION)
    data = cloud.GetPointData()
    for name, wanted in sample.fields(time).items():
        array = data.GetArray(name)
        values = [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]
        if name in ("sigma", "planeStrain"):
            values = [tuple(v[k] for k in SYMM_TENSOR) for v in values]
        sample.expect(f"{name} at {time}", values, wanted, sample.SINGLE_PRECISION)
    empty = next(block for name, block in found.items() if name.endswith("empty"))
    sample.expect_equal("particles of the empty cloud", empty.GetNumberOfPoints() if empty else 0, 0)


def main(program, form):
    said = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(said)
    with tempfile.TemporaryDirectory() as folder:
        sample.write(program, folder, form)
        (case,) = glob.glob(folder + "/*.foam")
        for time in sample.TIMES:
            check(case, time)
    sample.expect_equal("messages of the reader", said.GetOutput(), "")


main(*sys.argv[1:])
