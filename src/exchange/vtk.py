"""A superquadric for VTK 9, as either of its sources; run it with a file to write as .vtp."""

import sys

from vtkmodules.vtkCommonComputationalGeometry import vtkParametricSuperEllipsoid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkSuperquadricSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SIZE = (@SIZE@)  # semi-axes
EXPONENTS = (@EXPONENTS@)  # e1 north-south, e2 east-west
WORLD_FROM_MODEL = (
    @WORLD_FROM_MODEL@,
    0.0, 0.0, 0.0, 1.0,
)


def superquadric_source(resolution=64):
    """vtkSuperquadricSource, about z, in the world."""
    source = vtkSuperquadricSource()
    source.SetAxisOfSymmetry(2)
    source.SetSize(1.0)
    source.SetScale(SIZE)
    source.SetPhiRoundness(EXPONENTS[0])
    source.SetThetaRoundness(EXPONENTS[1])
    source.SetPhiResolution(resolution)
    source.SetThetaResolution(resolution)
    return in_world(source)


def parametric_super_ellipsoid(resolution=64):
    """vtkParametricSuperEllipsoid, in the world."""
    function = vtkParametricSuperEllipsoid()
    function.SetXRadius(SIZE[0])
    function.SetYRadius(SIZE[1])
    function.SetZRadius(SIZE[2])
    function.SetN1(EXPONENTS[0])
    function.SetN2(EXPONENTS[1])
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(function)
    source.SetUResolution(resolution)
    source.SetVResolution(resolution)
    return in_world(source)


def in_world(source):
    """The source, moved from the model's frame to the world, in doubles."""
    world_from_model = vtkTransform()
    world_from_model.SetMatrix(WORLD_FROM_MODEL)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(world_from_model)
    moved.SetInputConnection(source.GetOutputPort())
    return moved


if __name__ == "__main__":
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(sys.argv[1])
    writer.SetInputConnection(superquadric_source().GetOutputPort())
    writer.Write()
