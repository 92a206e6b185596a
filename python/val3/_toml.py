"""Scripts as TOML."""

import json
from collections.abc import Mapping, Sequence

#: A value of a script.
Value = bool | int | float | str | Sequence["Value"] | Mapping[str, "Value"]


def document(script: Mapping[str, Value]) -> str:
    r"""Write a script as a TOML document.

    >>> print(document({"at": [{"t": 1, "io": {"Board\\in": True}}], "silent": ["Socket\\host"]}), end="")
    at = [{t = 1, io = {"Board\\in" = true}}]
    silent = ["Socket\\host"]
    """
    return "".join(f"{_key(key)} = {_value(value)}\n" for key, value in script.items())


def _value(value: Value) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(key)} = {_value(item)}" for key, item in value.items()) + "}"
    return "[" + ", ".join(_value(item) for item in value) + "]"


def _key(key: str) -> str:
    return key if key.isidentifier() and key.isascii() else json.dumps(key)
