"""What one can do about a message of core, in the place where one reads it: core knows neither options nor buttons."""

from __future__ import annotations

from core.mocap.recordings import NO_SKELETON


def on_the_command_line(message: str) -> str:
    """The message, with the option that helps where there is one."""
    return f"{message}: --skeleton FILE.asf" if NO_SKELETON in message else message


def in_the_browser(message: str) -> str:
    """The message, with what to do on the Library page where there is something."""
    if NO_SKELETON not in message:
        return message
    return f"{message.partition('; expected')[0]}. Add the recording again together with its .asf file"
