"""What one of VTK's OpenFOAM readers shows of a case at a time, and the parts of it."""
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

import sample


def output(reader, case, time):
    reader.SetFileName(case)
    reader.SkipZeroTimeOff()
    reader.UpdateInformation()
    times = reader.GetTimeValues()
    sample.expect_equal("times", [times.GetValue(k) for k in range(times.GetNumberOfValues())], sample.TIMES)
    for k in range(reader.GetNumberOfPatchArrays()):
        reader.SetPatchArrayStatus(reader.GetPatchArrayName(k), 1)
    reader.SetTimeValue(time)
    reader.Update()
    return reader.GetOutput()


def blocks(data, prefix=""):
    """Names as paths, and data sets, None where there are none."""
    for k in range(data.GetNumberOfBlocks()):
        name = prefix + data.GetMetaData(k).Get(vtkCompositeDataSet.NAME())
        block = data.GetBlock(k)
        if block is not None and block.IsA("vtkMultiBlockDataSet"):
            yield from blocks(block, name + "/")
        else:
            yield name, block
