use super::*;
use crate::view::AnyCamera;

const JSON: &str = r#"{
    "schema": "superquadric.scene/1",
    "solids": [
        {"solid": {"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]}},
         "material": {"color": [1, 0.5, 0], "specular": 0}},
        {"solid": {"difference": [
            {"shape": {"family": "superellipsoid", "size": [1, 2, 3], "exponents": [0.1, 1]},
             "pose": {"translation": [3, 0, 0]}},
            {"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]},
             "deformations": [{"kind": "scale", "factors": [1, 2, 1]}]}
        ]}}
    ],
    "camera": {"kind": "pinhole", "fx": 60, "fy": 60, "cx": 20, "cy": 15, "width": 41, "height": 31,
               "depth_units_m": 0.001,
               "view": {"eye": [0, 0, -5], "target": [0, 0, 0], "up": [0, -1, 0]}},
    "ambient": [0.1, 0.1, 0.2],
    "lights": [
        {"kind": "directional", "to_light": [0, 0, -2], "intensity": 0.5},
        {"kind": "point", "position": [0, 0, -3], "color": [1, 0, 0.5], "intensity": 4}
    ],
    "background": [0, 0, 0.2]
}"#;

const TOML: &str = r#"
schema = "superquadric.scene/1"
ambient = [0.1, 0.1, 0.2]
background = [0, 0, 0.2]

[camera]
kind = "pinhole"
fx = 60
fy = 60
cx = 20
cy = 15
width = 41
height = 31
depth_units_m = 1e-3
view = { eye = [0, 0, -5], target = [0, 0, 0], up = [0, -1, 0] }

[[lights]]
kind = "directional"
to_light = [0, 0, -2]
intensity = 0.5

[[lights]]
kind = "point"
position = [0, 0, -3]
color = [1, 0, 0.5]
intensity = 4

[[solids]]
solid.shape = { family = "superellipsoid", size = [1, 1, 1], exponents = [1, 1] }
material = { color = [1, 0.5, 0], specular = 0 }

[[solids]]
[[solids.solid.difference]]
shape = { family = "superellipsoid", size = [1, 2, 3], exponents = [0.1, 1] }
pose.translation = [3, 0, 0]

[[solids.solid.difference]]
shape = { family = "superellipsoid", size = [1, 1, 1], exponents = [1, 1] }
deformations = [{ kind = "scale", factors = [1, 2, 1] }]
"#;

fn read() -> Scene {
    scene_from_json(JSON).unwrap()
}

#[test]
fn one_scene_in_both_formats() {
    assert_eq!(scene_from_toml(TOML).unwrap(), read());
}

#[test]
fn a_scene_is_what_its_document_says() {
    let scene = read();
    assert_eq!(scene.items.len(), 2);
    assert_eq!(scene.items[0].material.color, [1.0, 0.5, 0.0]);
    assert_eq!(scene.items[1].material, Material::default());
    assert!(scene.items[1].solid.contains(&Vector3::new(3.0, 1.5, 0.0)));
    let Some(AnyCamera::Pinhole(camera)) = scene.camera else { panic!("{:?}", scene.camera) };
    assert_eq!((camera.width, camera.depth_unit), (41, Some(1e-3)));
    let at_eye = scene.camera_from_world.world_from_model(&Vector3::zeros());
    assert!((at_eye - Vector3::new(0.0, 0.0, 5.0)).norm() < 1e-15);
    let Lighting { lights, ambient } = scene.lighting.unwrap();
    assert_eq!(ambient, [0.1, 0.1, 0.2]);
    assert_eq!(lights[0], Light { source: Source::Far(-Vector3::z()), power: [0.5; 3] });
    let position = Vector3::new(0.0, 0.0, -3.0);
    assert_eq!(lights[1], Light { source: Source::Near(position), power: [4.0, 0.0, 2.0] });
    assert_eq!(scene.background, [0, 0, 51]);
}

#[test]
fn a_parallel_camera_and_a_matrix_will_do() {
    let view = r#""view": {"camera_from_world": [[1,0,0,0],[0,0,-1,0],[0,1,0,7]]}"#;
    let (start, rest) = JSON.split_once("\"camera\"").unwrap();
    let (_, rest) = rest.split_once("}},\n    \"ambient\"").unwrap();
    let camera = format!(
        r#""camera": {{"kind": "orthographic", "scale": [6, 6], "origin": [10, 8], "width": 21,
            "height": 17, {view}}}, "ambient""#
    );
    let scene = scene_from_json(&format!("{start}{camera}{rest}")).unwrap();
    assert!(matches!(scene.camera, Some(AnyCamera::Orthographic(_))));
    let y = scene.camera_from_world.world_from_model(&Vector3::y());
    assert!((y - Vector3::new(0.0, 0.0, 8.0)).norm() < 1e-15);
}

#[test]
fn a_solid_alone_is_a_scene_of_one() {
    let text = r#"{"shape": {"family": "superellipsoid", "size": [1, 1, 1], "exponents": [1, 1]}}"#;
    let scene = scene_from_json(text).unwrap();
    assert_eq!((scene.items.len(), scene.camera, &scene.lighting), (1, None, &None));
    let text = "shape = { family = \"superellipsoid\", size = [1, 1, 1], exponents = [1, 1] }";
    assert_eq!(scene_from_toml(text).unwrap(), scene);
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    for (from, to, expected) in [
        ("scene/1", "scene/9", "superquadric.scene/9"),
        ("\"ambient\"", "\"ambience\"", "ambience"),
        ("\"specular\": 0", "\"gloss\": 0", "solids[0].material"),
        (
            "\"specular\": 0",
            "\"specular\": 2",
            "solids[0]: material: expected specular from 0 to 1",
        ),
        ("[1, 0.5, 0]", "[1, 1.5, 0]", "solids[0]: material: expected color"),
        ("translation", "place", "solids[1]: solid: difference[0]: unknown key `pose.place`"),
        ("[1, 2, 3]", "[1, -2, 3]", "solids[1]: solid: difference[0]: "),
        ("[1, 2, 1]", "[1, 0, 1]", "solids[1]: solid: difference[1]: "),
        ("\"pinhole\"", "\"fisheye\"", "camera"),
        ("\"cx\"", "\"cz\"", "camera"),
        ("\"fx\": 60", "\"fx\": 0", "camera: expected a positive fx"),
        ("\"width\": 41", "\"width\": 0", "camera: expected a width"),
        ("\"up\": [0, -1, 0]", "\"up\": [0, 0, 1]", "camera: view: expected eye, target and up"),
        ("\"up\"", "\"camera_from_world\"", "camera"),
        ("[0, 0, -2]", "[0, 0, 0]", "lights[0]: expected a to_light"),
        ("\"position\"", "\"place\"", "lights[1]"),
        ("\"intensity\": 4", "\"intensity\": -4", "lights[1]: expected intensity from 0 up"),
        ("\"background\": [0", "\"background\": [-1", "background from 0 to 1"),
        ("[0.1, 0.1, 0.2]", "[0.1, 0.1]", "ambient"),
    ] {
        assert!(JSON.contains(from), "{from}");
        let message = scene_from_json(&JSON.replace(from, to)).unwrap_err().to_string();
        assert!(message.contains(expected), "{message:?} does not name {expected:?}");
    }
    let message = scene_from_json("{\"solids\": []}").unwrap_err().to_string();
    assert!(message.contains("at least one solid"), "{message}");
    let message = scene_from_toml("solids = [\n1, ]]").unwrap_err().to_string();
    assert!(message.contains("line 2"), "{message}");
}

#[test]
fn damaged_documents_are_read_or_refused() {
    for (text, parse) in [(JSON, scene_from_json as fn(&str) -> _), (TOML, scene_from_toml)] {
        for at in 0..text.len() {
            let _ = parse(&text[..at]);
            for byte in ["\n", "[", "9", "=", "\""] {
                let _ = parse(&format!("{}{byte}{}", &text[..at], &text[at + 1..]));
            }
        }
    }
}
