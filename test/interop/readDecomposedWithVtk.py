"""VTK's OpenFOAM reader shows the particles of all processor folders that decomposeParticles has made: readDecomposedWithVtk.py writeSample decomposeParticles format"""
import glob
import sys
import tempfile

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkIOParallel import vtkPOpenFOAMReader
from vtkmodules.vtkParallelCore import vtkDummyController, vtkMultiProcessController

import sample


def blocks(data):
    for k in range(data.GetNumberOfBlocks()):
        block = data.GetBlock(k)
        if block is not None and block.IsA("vtkMultiBlockDataSet"):
            yield from blocks(block)
        elif block is not None:
            yield data.GetMetaData(k).Get(vtkCompositeDataSet.NAME()), block


def particles(case, time):
    """Place, velocity and density of each, by place."""
    reader = vtkPOpenFOAMReader()
    reader.SetFileName(case)
    reader.SetCaseType(vtkPOpenFOAMReader.DECOMPOSED_CASE)
    reader.SkipZeroTimeOff()
    reader.UpdateInformation()
    times = reader.GetTimeValues()
    sample.expect_equal("times", [times.GetValue(k) for k in range(times.GetNumberOfValues())], sample.TIMES)
    for k in range(reader.GetNumberOfPatchArrays()):
        reader.SetPatchArrayStatus(reader.GetPatchArrayName(k), 1)
    reader.SetTimeValue(time)
    reader.Update()
    found = []
    for name, cloud in blocks(reader.GetOutput()):
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
