"""What a person is told where something they asked for cannot be done, told apart from our own faults."""

from __future__ import annotations

import traceback

_OURS = ("core.", "webapp.")


def said(error: ValueError) -> str:
    """The words of a refusal as a sentence. Raises the error again where a library raised it: that is a fault of ours,

    for the log and not for people.
    """
    if type(error) is ValueError and error.__traceback__ is not None:
        *_, (innermost, _) = traceback.walk_tb(error.__traceback__)
        if not innermost.f_globals.get("__name__", "").startswith(_OURS):
            raise error
    text = str(error)
    if text.partition(" ")[0].isalpha():  # else it is the name of a clip or a file
        text = text[:1].upper() + text[1:]
    return text if text.endswith((".", "?", "!")) else f"{text}."
