"""Every word on a motion that shows it, and on a near miss that does not."""

from __future__ import annotations

import numpy as np
import pytest

from core.demo import make_demo
from core.retrieval.words.signals import signals_of
from core.retrieval.words.vocabulary import WORDS, word
from tests.core.retrieval.words.puppet import UPPER, Puppet

DEMO = {
    "move": ("walk", "squat"), "walk": ("walk", "squat"), "run": ("run", "walk"), "jog": ("run", "walk"),
    "sprint": ("run", "dance"), "stand": ("idle", "walk"), "stand still": ("idle", "dance"), "still": ("idle", "walk"),
    "forwards": ("walk", "backflip"), "backwards": ("backflip", "walk"), "turn": ("spin kick", "walk"),
    "spin": ("spin kick", "kick"), "jump": ("jump", "squat"), "leap": ("jump", "walk"), "squat": ("squat", "walk"),
    "crouch": ("squat", "walk"), "get up": ("get up", "lie down"), "lie": ("lie down", "squat"),
    "lie down": ("lie down", "get up"), "crawl": ("crawl", "squat"), "upside down": ("cartwheel", "kick"),
    "cartwheel": ("cartwheel", "backflip"), "flip": ("backflip", "roll"), "roll": ("roll", "cartwheel"),
    "kick": ("kick", "run"), "raise leg": ("kick", "walk"), "raise knee": ("kick", "walk"), "step": ("walk", "squat"),
    "punch": ("punch", "kick"), "dance": ("dance", "walk"), "energetic": ("run", "walk"), "fast": ("run", "walk"),
    "swing arms": ("walk", "squat"), "still arms": ("idle", "walk"), "fall": ("lie down", "squat"),
}  # fmt: skip
"""Word -> action of the demo that shows it, and one that does not."""

SQUARE = 1 / (1 + np.exp(-12 * (Puppet().t - 2)))  # from 0 to 1 about the second second
HUMP = np.exp(-(((Puppet().t - 2) / 0.4) ** 2))  # there and back


def swing(rate, size):
    return size * np.sin(2 * np.pi * rate * Puppet().t)


def sat(depth=0.24):
    return Puppet().lower(depth).shift(("knee",), up=0.13, forward=0.12)


MADE = {
    "march": (lambda: Puppet().steps(0.9, 0.1, 0.3).travel(forward=0.3 * Puppet().t), lambda: Puppet().steps(0.9, 0.1)),
    "sideways": (lambda: Puppet().travel(left=0.4 * Puppet().t), lambda: Puppet().travel(forward=0.4 * Puppet().t)),
    "straight": (
        lambda: Puppet().travel(forward=0.5 * Puppet().t),
        lambda: Puppet().turn(60 * Puppet().t).travel(0.3 * Puppet().t),
    ),
    "turn around": (lambda: Puppet().turn(180 * SQUARE), lambda: Puppet().turn(70 * SQUARE)),
    "circle": (
        lambda: Puppet().turn(50 * Puppet().t).travel(0.4 * Puppet().t),
        lambda: Puppet().travel(0.4 * Puppet().t),
    ),
    "start": (
        lambda: Puppet().travel(forward=np.maximum(0, Puppet().t - 2)),
        lambda: Puppet().travel(forward=0.6 * Puppet().t),
    ),
    "stop": (
        lambda: Puppet().travel(forward=np.minimum(2, Puppet().t)),
        lambda: Puppet().travel(forward=0.6 * Puppet().t),
    ),
    "hop": (
        lambda: (
            Puppet()
            .shift(("right_ankle", "right_toe"), up=0.15)
            .shift(("",), up=0.06 * np.maximum(0, np.sin(12 * Puppet().t)))
        ),
        lambda: Puppet().shift(("right_ankle", "right_toe"), up=0.15),
    ),
    "kneel": (
        lambda: Puppet().lower(0.2).shift(("left_knee",), up=-0.16),
        lambda: Puppet().lower(0.2),
    ),
    "sit": (lambda: sat(), lambda: Puppet().lower(0.05)),
    "sit down": (
        lambda: Puppet().lower(0.24 * SQUARE).shift(("knee",), up=0.13 * SQUARE, forward=0.12 * SQUARE),
        lambda: sat(),
    ),
    "climb": (
        lambda: Puppet().shift(("",), up=0.4 * np.minimum(1, np.maximum(0, Puppet().t - 1))),
        lambda: Puppet().shift(("",), up=0.3 * HUMP),
    ),
    "balance": (
        lambda: Puppet().shift(("right_ankle", "right_toe"), up=0.2 * SQUARE),
        lambda: Puppet().steps(0.9, 0.1, 0.1),
    ),
    "lunge": (
        lambda: Puppet().lower(0.15).shift(("left_ankle",), forward=0.3).shift(("right_ankle",), forward=-0.25),
        lambda: Puppet().lower(0.15),
    ),
    "legs apart": (
        lambda: Puppet().shift(("left_ankle",), left=0.18).shift(("right_ankle",), left=-0.18),
        lambda: Puppet().shift(("left_ankle",), forward=0.3),
    ),
    "jumping jack": (
        lambda: (
            Puppet()
            .both(0.6, swing(0.8, 0.75), 0.1)
            .shift(("left_ankle",), left=0.1 + swing(0.8, 0.1))
            .shift(("right_ankle",), left=-0.1 - swing(0.8, 0.1))
        ),
        lambda: Puppet().both(0.6, swing(0.8, 0.75), 0.1),
    ),
    "raise": (
        lambda: Puppet().hand("left", 0.1, -0.9 + 1.4 * SQUARE, 0.3),
        lambda: Puppet().hand("left", 0.1, 0.5, 0.3),
    ),
    "raised": (lambda: Puppet().hand("left", 0.1, 0.5, 0.3), lambda: Puppet().hand("left", 0.1, -0.5, 0.6)),
    "overhead": (lambda: Puppet().hand("left", 0.1, 0.8, 0.2), lambda: Puppet().hand("left", 0.1, 0.1, 0.8)),
    "lower": (
        lambda: Puppet().hand("left", 0.1, 0.5 - 1.4 * SQUARE, 0.3),
        lambda: Puppet().hand("left", 0.1, 0.5, 0.3),
    ),
    "wave": (
        lambda: Puppet().hand("left", 0.3 + swing(1.5, 0.25), 0.4, 0.3),
        lambda: Puppet().hand("left", 0.3, -0.9 + 1.3 * SQUARE, 0.3),
    ),
    "clap": (
        lambda: Puppet().both(0.05 + swing(1.5, 0.28), -0.3, 0.7),
        lambda: Puppet().both(-0.27, -0.3, 0.7),
    ),
    "hands together": (lambda: Puppet().both(-0.25, -0.3, 0.6), lambda: Puppet().both(0.2, -0.3, 0.6)),
    "throw": (
        lambda: Puppet().hand("right", -0.2, 0.6 - 0.6 * SQUARE, -0.3 + 1.1 * SQUARE),
        lambda: Puppet().hand("right", -0.2, -0.8 + 0.8 * SQUARE, 0.1 + 0.6 * SQUARE),
    ),
    "reach": (lambda: Puppet().hand("right", 0, 0, 0.95), lambda: Puppet().hand("right", 0, -0.95, 0.1)),
    "point": (lambda: Puppet().hand("left", 0.7, 0, 0.65), lambda: Puppet().hand("left", 0.3, -0.8, 0.3)),
    "arms out": (lambda: Puppet().both(0.95, 0, 0), lambda: Puppet().both(0.1, 0, 0.9)),
    "fold arms": (lambda: Puppet().both(-0.55, -0.4, 0.4), lambda: Puppet().both(0.1, -0.4, 0.5)),
    "hands on hips": (
        lambda: Puppet().both(0.05, -0.77, 0.02).shift(("left_elbow",), left=0.09).shift(("right_elbow",), left=-0.09),
        lambda: Puppet(),
    ),
    "hand to head": (lambda: Puppet().hand("left", -0.1, 0.2, 0.2), lambda: Puppet().hand("left", 0.2, -0.4, 0.5)),
    "push": (lambda: Puppet().both(0, -0.2, 0.2 + 0.7 * SQUARE), lambda: Puppet().both(0, -0.2, 0.9)),
    "pull": (lambda: Puppet().both(0, -0.3, 0.9 - 0.7 * SQUARE), lambda: Puppet().both(0, -0.2, 0.2 + 0.7 * SQUARE)),
    "carry": (lambda: Puppet().both(-0.1, -0.4, 0.6), lambda: Puppet()),
    "stretch": (lambda: Puppet().both(0.1, 0.95, 0), lambda: Puppet().both(0.1, 0.3, 0.5)),
    "bow": (lambda: Puppet().tilt(40 * HUMP), lambda: Puppet().tilt(-30 * HUMP)),
    "bend over": (lambda: Puppet().tilt(80 * HUMP), lambda: Puppet().tilt(25 * HUMP)),
    "lean back": (lambda: Puppet().tilt(-30 * HUMP), lambda: Puppet().tilt(30 * HUMP)),
    "lean": (lambda: Puppet().tilt(30 * HUMP, axis=2), lambda: Puppet().tilt(30 * HUMP)),
    "twist": (lambda: Puppet().turn(50 * HUMP, UPPER), lambda: Puppet().turn(50 * HUMP)),
    "pick up": (
        lambda: Puppet().tilt(75 * HUMP).shift(("wrist",), up=-0.35 * HUMP),
        lambda: Puppet().tilt(30 * HUMP),
    ),
    "slow": (lambda: Puppet().travel(forward=0.3 * Puppet().t), lambda: Puppet().travel(forward=1.5 * Puppet().t)),
    "repeated": (lambda: Puppet().both(0.1, swing(1, 0.3), 0.3), lambda: Puppet().both(0.1, -0.9 + SQUARE, 0.3)),
}
"""Word -> a puppet that shows it, and one that nearly does."""


@pytest.fixture(scope="module")
def actions():
    """One stretch of each of the demo's actions."""
    demo = make_demo(minutes=8)
    found = {}
    for label in demo.labels:
        if label.action not in found:
            found[label.action] = signals_of(demo.clip(label.clip).cut(label.start, label.end))
    return found


def seen(name, signals):
    """How well a word is seen at its best."""
    return float(word(name).scores(signals).max())


def test_every_word_is_tried():
    assert {each.name for each in WORDS} == DEMO.keys() | MADE.keys()


@pytest.mark.parametrize("name", DEMO)
def test_words_on_recorded_motion(actions, name):
    shows, misses = DEMO[name]
    assert seen(name, actions[shows]) >= 0.6 and seen(name, actions[misses]) < 0.5


@pytest.mark.parametrize("name", MADE)
def test_words_on_made_motion(name):
    shows, misses = (make().signals() for make in MADE[name])
    assert seen(name, shows) >= 0.6 and seen(name, misses) < 0.5


@pytest.mark.parametrize("name", ["turn", "sideways", "raise", "wave", "kick", "hop", "point", "lean"])
def test_left_is_not_right(actions, name):
    signals = MADE[name][0]().signals() if name in MADE else actions["kick" if name == "kick" else "spin kick"]
    sides = sorted(float(word(name).scores(signals, side).max()) for side in ("left", "right"))
    assert sides[0] < 0.5 * sides[1] and seen(name, signals) == pytest.approx(sides[1], abs=0.1)
