// A superquadric for POV-Ray 3.7. To put it into a scene of your own:
//   #declare Superquadric_Only = true;
//   #include "this file"
//   object { Superquadric ... }
#version 3.7;

#declare Superquadric = superellipsoid {
  <@EXPONENTS@> // e2 east-west, e1 north-south
  scale <@SIZE@>
  matrix <@AXES@, @CENTRE@>
}

#ifndef (Superquadric_Only)
  global_settings { assumed_gamma 1 }
  background { rgb 1 }
  camera {
    location <4, -3, 3>
    sky z
    right -x * image_width / image_height // right-handed, as the coordinates are
    angle 30
    look_at 0
  }
  light_source { <4, -8, 10> rgb 1 parallel point_at 0 }
  object {
    Superquadric
    translate -<@CENTRE@>
    scale 1 / @RADIUS@
    pigment { rgb <0.3, 0.5, 0.8> }
    finish { ambient 0.2 diffuse 0.8 }
  }
#end
