"""
Settings that a page may change before a run: from a scenario to a form, and back.
"""

from collections.abc import Mapping

import yaml

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.display import Form, Setting
from rvd_dynamics.diagram.params import leaves
from rvd_dynamics.diagram.scenario import Scenario, sections_of
from rvd_dynamics.given import value_of


def setting(scenario: Scenario, section: str, key: str, label: str, unit: str = '') -> Setting:
    """Return the field of a key: its value in this scenario, its choices, its meaning as a hint."""
    value = scenario.resolved()[section]['ros__parameters']
    for name in key.split('.'):
        value = value[name]
    found = next(f for prefix, cls in sections_of(scenario.mission, (section,))[section]
                 for name, f in leaves(cls) if prefix + name == key)
    bounds = found.metadata.get('bounds')
    choices = tuple(map(str, getattr(bounds, 'choices', ()) or ()))
    if isinstance(value, bool):
        choices = ('true', 'false')
    return Setting(section, key, label, _written(value), unit, choices, found.metadata['doc'])


def _written(value: object) -> str:
    text = yaml.safe_dump(value, default_flow_style=True, width=1000).split('\n')[0]
    return text.strip('[]')


def with_wishes(scenario: Scenario, forms: tuple[Form, ...], wishes: Mapping[str, str]) -> Scenario:
    """
    Return the scenario with what a page wrote into its forms; the keys are 'section key'.

    Raises
    ------
    BadInput
        If a key stands in no form, or a value is refused: one line that names it.
    """
    known = {f'{field.section} {field.key}': field for form in forms for field in form.fields}
    values: dict[str, dict[str, object]] = {}
    for name, text in wishes.items():
        if name not in known:
            raise BadInput(f'{name} is no setting of the page')
        field = known[name]
        if text.strip() != field.value:
            values.setdefault(field.section, {})[field.key] = _read(field, text)
    for section, changed in values.items():
        scenario = scenario.with_values(section, **{
            key.replace('.', '__'): value for key, value in changed.items()})
    return scenario


def _read(field: Setting, text: str) -> object:
    several = ',' in field.value
    try:
        value = value_of(f'[{text}]' if several else text)
    except BadInput:
        value = None
    if value is None or value == '' or (not several and isinstance(value, (list, dict))):
        raise BadInput(f'{field.key} must be {"numbers" if several else "a value"} like '
                       f'{field.value}, got {text!r}')
    return value
