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
