RING = @RING@  # a4, the ring's radius over the tube's


def superquadric_source(resolution=64):
    """vtkSuperquadricSource, toroidal, about z, in the world."""
    source = vtkSuperquadricSource()
    source.SetAxisOfSymmetry(2)
    source.ToroidalOn()
    source.SetThickness(1.0 / RING)
    source.SetSize(1.0)
    source.SetScale([(1.0 + RING) * a for a in SIZE])
    source.SetPhiRoundness(EXPONENTS[0])
    source.SetThetaRoundness(EXPONENTS[1])
    source.SetPhiResolution(resolution)
    source.SetThetaResolution(resolution)
    return in_world(source)


def parametric_super_toroid(resolution=64):
    """vtkParametricSuperToroid, in the world."""
    function = vtkParametricSuperToroid()
    function.SetXRadius(SIZE[0])
    function.SetYRadius(SIZE[1])
    function.SetZRadius(SIZE[2])
    function.SetRingRadius(RING)
    function.SetCrossSectionRadius(1.0)
    function.SetN1(EXPONENTS[1])
    function.SetN2(EXPONENTS[0])
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(function)
    source.SetUResolution(resolution)
    source.SetVResolution(resolution)
    return in_world(source)
