"""Fitted numbers go back to where they came from in the study."""

from haptonic.study import loads

BOND, LOSS = "plate.actuator[1].bond.thickness", "plate.loss_factor"


def test_a_study_takes_fitted_numbers_and_nothing_else(every_key_text):
    study = loads(every_key_text)
    other = study.with_fitted({BOND: 72e-6, LOSS: 4e-3})
    assert other.plate_settings.actuator[0].bond.thickness == 72e-6
    assert other.plate_settings.loss_factor == 4e-3
    assert other.with_fitted({BOND: 50e-6, LOSS: 2e-3}) == study
    assert loads(other.to_toml()) == other


def test_a_loss_of_the_material_becomes_one_of_the_plate(edited):
    unknown = '[[fit.vary]]\nparameter = "plate.loss_factor"\nfrom = 1e-4\nto = 1e-2\n\n[[sweep]]'
    study = loads(edited(("loss_factor = 2e-3", ""), ("[[sweep]]", unknown)))
    assert study.mounted_plate().loss_factor == 1e-3
    assert study.with_fitted({LOSS: 3e-3}).mounted_plate().loss_factor == 3e-3


def test_designs_beyond_the_bounds_of_a_fit_are_designs(edited):
    """Whoever varies the material of the study does not fit it."""
    unknown = (
        '[[fit.vary]]\nparameter = "material.youngs_modulus"\nfrom = "65 GPa"\nto = "75 GPa"\n\n[[sweep]]'
    )
    study = loads(edited(("[[sweep]]", unknown)))
    assert study.with_parameter("material.youngs_modulus", 90e9).cell.material.youngs_modulus == 90e9
