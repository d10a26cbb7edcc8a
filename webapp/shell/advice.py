"""Adds advice to messages of ``core``, which knows neither the options of commands nor the buttons of pages."""

from __future__ import annotations

from core.mocap.recordings import NEEDS_SKELETON


def on_the_command_line(message: str) -> str:
    """The message, with the option that helps where there is one."""
    return message.replace(NEEDS_SKELETON, "one of them, or --skeleton FILE.asf")


def in_the_browser(message: str) -> str:
    """The message, with what to do on the Library page where there is something."""
    return message.replace(f"expected {NEEDS_SKELETON}", "add the recording again, together with its .asf file")
