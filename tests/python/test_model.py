"""The model as a Python value: made, shown, compared, copied and stored."""

import copy
import json
import pickle

import numpy as np
import pytest

import superquadric
from superquadric import Superellipsoid

RANDOM = np.random.default_rng(5)
MODELS = [
    Superellipsoid([1, 2, 3], [0.5, 1]),
    Superellipsoid([1e-9, 1.0, 1e12], [0.1, 2.0], translation=[1e6, -0.1, 1e-30]),
    Superellipsoid([1, 2, 3], [0.5, 1], euler_zyz=[0.1, 1e-13, 0.2]),
    Superellipsoid([1, 2, 3], [0.5, 1], euler_zyz=[0.1, np.pi, 0.2]),
    *(
        Superellipsoid(
            RANDOM.uniform(0.1, 9, 3),
            RANDOM.uniform(0.1, 2, 2),
            euler_zyz=RANDOM.uniform(-9, 9, 3),
            translation=RANDOM.normal(size=3),
        )
        for _ in range(50)
    ),
]


def same_to_the_last_bit(a, b):
    return (
        np.array_equal(a.size, b.size)
        and np.array_equal(a.exponents, b.exponents)
        and np.array_equal(a.rotation, b.rotation)
        and np.array_equal(a.translation, b.translation)
    )


@pytest.mark.parametrize("model", MODELS, ids=range(len(MODELS)))
def test_a_model_comes_back_from_wherever_it_went(model, tmp_path):
    model.save(tmp_path / "model.json")
    for again in [
        *(pickle.loads(pickle.dumps(model, protocol)) for protocol in (2, 3, 4, 5)),
        copy.copy(model),
        copy.deepcopy(model),
        Superellipsoid.from_json(model.to_json()),
        Superellipsoid.from_dict(model.to_dict()),
        Superellipsoid.load(tmp_path / "model.json"),
        Superellipsoid(
            model.size,
            model.exponents,
            rotation=np.asfortranarray(model.rotation),
            translation=model.translation,
        ),
    ]:
        assert same_to_the_last_bit(again, model)
        assert again == model
    assert eval(repr(model), {"Superellipsoid": Superellipsoid}) == model


def test_models_differ_in_any_parameter():
    def make(**changes):
        arguments = {
            "size": [1, 2, 3],
            "exponents": [0.5, 1],
            "euler_zyz": [0.1, 0.2, 0.3],
            "translation": [1, 2, 3],
        }
        return Superellipsoid(**(arguments | changes))

    assert make() == make()
    assert make() != make(size=[1, 2, 3.0000000000000004])
    assert make() != make(exponents=[0.5, 1.1])
    assert make() != make(euler_zyz=[0.1, 0.2, 0.3 + 1e-10])
    assert make() != make(translation=[1, 2, 4])
    assert make() != "a model"
    assert (make() == 3) is False


def test_repr_leaves_out_what_is_default():
    assert repr(MODELS[0]) == "Superellipsoid([1.0, 2.0, 3.0], [0.5, 1.0])"
    moved = Superellipsoid([1, 2, 3], [0.5, 1], translation=[0, 0, 1e-20])
    assert repr(moved) == (
        "Superellipsoid([1.0, 2.0, 3.0], [0.5, 1.0], translation=[0.0, 0.0, 1e-20])"
    )


def test_a_model_cannot_be_changed(model):
    with pytest.raises(AttributeError):
        model.size = [1, 2, 3]
    model.size[0] = 100
    assert model.size[0] == 2
    with pytest.raises(TypeError, match="unhashable"):
        hash(model)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"size": [1, 0, 3]}, r"size\[1\] must be a positive number, found 0"),
        ({"size": [1, 2, np.nan]}, r"size\[2\]"),
        ({"size": [1, 2, np.inf]}, r"size\[2\]"),
        ({"exponents": [1, -1]}, r"exponents\[1\]"),
        ({"euler_zyz": [0, np.nan, 0]}, "euler_zyz must be finite"),
        ({"translation": [np.inf, 0, 0]}, "translation must be finite"),
        ({"rotation": 2 * np.eye(3)}, "orthonormal"),
        ({"rotation": np.diag([1, 1, -1])}, "right-handed"),
        ({"rotation": np.full((3, 3), np.nan)}, "orthonormal"),
        ({"rotation": np.eye(3), "euler_zyz": [0, 0, 0]}, "not both"),
    ],
)
def test_parameters_outside_their_domain_are_named(changes, message):
    with pytest.raises(superquadric.ModelError, match=message):
        Superellipsoid(**({"size": [1, 2, 3], "exponents": [1, 1]} | changes))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"size": 1.0}, r"size: expected an array of shape \(3,\), found \(\)"),
        ({"size": [[1, 2, 3]]}, r"size: expected an array of shape \(3,\), found \(1, 3\)"),
        ({"exponents": [1, 1, 1]}, r"exponents: expected an array of shape \(2,\), found \(3,\)"),
        ({"rotation": np.eye(4)}, r"rotation: expected an array of shape \(3, 3\)"),
        ({"translation": []}, r"translation: expected an array of shape \(3,\), found \(0,\)"),
    ],
)
def test_arguments_of_another_shape_are_named(changes, message):
    with pytest.raises(superquadric.ArrayError, match=message):
        Superellipsoid(**({"size": [1, 2, 3], "exponents": [1, 1]} | changes))


def test_a_model_is_found_in_the_document_of_a_fit(fit, tmp_path):
    fit.save(tmp_path / "fit.json")
    assert same_to_the_last_bit(Superellipsoid.load(tmp_path / "fit.json"), fit.model)
    assert same_to_the_last_bit(Superellipsoid.from_dict(fit.to_dict()), fit.model)
    assert same_to_the_last_bit(Superellipsoid.from_json(fit.to_json()), fit.model)


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"shape": 3}', '{"schema": "x/1"}', "3"])
def test_text_that_holds_no_model_is_a_document_error(text, tmp_path):
    with pytest.raises(superquadric.DocumentError):
        Superellipsoid.from_json(text)
    (tmp_path / "file").write_bytes(text.encode() + b"\xff")
    with pytest.raises(superquadric.DocumentError):
        Superellipsoid.load(tmp_path / "file")


def test_documents_with_parameters_outside_their_domain_are_refused(model):
    document = model.to_dict()
    document["shape"]["size"][1] = -2
    with pytest.raises(superquadric.DocumentError, match=r"size\[1\]"):
        Superellipsoid.from_dict(document)
    document["shape"]["size"][1] = float("nan")
    with pytest.raises(superquadric.DocumentError):
        Superellipsoid.from_dict(document)


def test_files_that_cannot_be_opened_are_os_errors(model, tmp_path):
    with pytest.raises(FileNotFoundError, match=r"none\.json"):
        Superellipsoid.load(tmp_path / "none.json")
    with pytest.raises(FileNotFoundError, match="cannot write"):
        model.save(tmp_path / "no folder" / "model.json")
    with pytest.raises(IsADirectoryError):
        model.save(tmp_path)


def test_json_is_that_of_the_dictionary(model, fit):
    for value in [model, fit]:
        assert json.loads(value.to_json()) == value.to_dict()
        assert value.to_json().endswith("}\n")


@pytest.mark.parametrize("resolution", [0, 1, 3, 5000])
def test_resolutions_are_even_and_bounded(model, resolution):
    with pytest.raises(superquadric.ModelError, match="even number from 2 to 4096"):
        model.mesh(resolution)


def test_more_points_than_there_is_memory_are_a_memory_error(model):
    for draw in [model.sample, model.sample_solid]:
        with pytest.raises(MemoryError):
            draw(2**60)
