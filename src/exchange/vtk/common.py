"""A superquadric for VTK 9, as either of its sources; run it with a file to write as .vtp."""

import sys

from vtkmodules.vtkCommonComputationalGeometry import (
    vtkParametricSuperEllipsoid,
    vtkParametricSuperToroid,
)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkSuperquadricSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SIZE = (@SIZE@)  # semi-axes
EXPONENTS = (@EXPONENTS@)  # e1 north-south, e2 east-west
WORLD_FROM_MODEL = (
    @WORLD_FROM_MODEL@,
    0.0, 0.0, 0.0, 1.0,
)


@SOURCES@


def in_world(source):
    """The source, moved from the model's frame to the world in doubles."""
    world_from_model = vtkTransform()
    world_from_model.SetMatrix(WORLD_FROM_MODEL)
    moved = vtkTransformFilter()
    moved.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    moved.SetTransform(world_from_model)
    moved.SetInputConnection(source.GetOutputPort())
    return moved


if __name__ == "__main__":
    surface = superquadric_source()
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(sys.argv[1])
    writer.SetInputConnection(surface.GetOutputPort())
    writer.Write()
