"""VTK's OpenFOAM reader shows the particles of all processor folders that decomposeParticles has made: readDecomposedWithVtk.py writeSample decomposeParticles format"""
import glob
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOParallel import vtkPOpenFOAMReader
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController

import sample
from vtkOutput import blocks, output


def particles(case, time):
    """Place, velocity and density of each, by place."""
    reader = vtkPOpenFOAMReader()
    reader.SetCaseType(vtkPOpenFOAMReader.DECOMPOSED_CASE)
    found = []
    for name, cloud in blocks(output(reader, case, time)):
        if not name.endswith("sph"):
            continue
        data = cloud.GetPointData()
        found += [cloud.GetPoint(i) + data.GetArray("U").GetTuple(i) + data.GetArray("rho").GetTuple(i) for i in range(cloud.GetNumberOfPoints())]
    return sorted(found)


def main(program, decompose, form):
    said = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(said)
    # Without one, which nobody else holds, the reader ends with a segmentation fault (VTK 9.1).
    controller = vtkDummyController()
    vtkMultiProcessController.SetGlobalController(controller)
    with tempfile.TemporaryDirectory() as folder:
        sample.write(program, folder, form)
        sample.decompose(decompose, folder)
        (case,) = glob.glob(folder + "/*.foam")
        for time in sample.TIMES:
            fields = sample.fields(time)
            wanted = sorted(x + U + rho for x, U, rho in zip(sample.positions(time), fields["U"], fields["rho"]))
            sample.expect(f"particles at {time}", particles(case, time), wanted, sample.SINGLE_PRECISION)
    sample.expect_equal("messages of the reader", said.GetOutput(), "")


main(*sys.argv[1:])
