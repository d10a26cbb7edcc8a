"""The words that are seen in motion: each a documented function of a clip's signals, and other words for the same.

A word without sides gives one score a frame. A word with sides gives one for each side; "left" asks for the left
one alone, "both" for both together, and none of them for either.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from core.retrieval.words import gestures as g
from core.retrieval.words import movements as m
from core.retrieval.words.signals import Signals, all_of, any_of

Plain = Callable[[Signals], np.ndarray]
Sided = Callable[[Signals, str], np.ndarray]


@dataclass(frozen=True)
class Word:
    """A word of the vocabulary.

    needs: parts of the body without which nothing can be said (NEEDS). sided: whether it has a left and a right.
    lasts: whether it goes on for a while, as walking does, or happens, as a kick does. implies: words that are seen
    as well wherever this one is. marked: whether a clip in which it is seen is remarkable for it, and so less of an
    answer to other words.
    """

    name: str
    see: Callable[..., np.ndarray]
    needs: tuple[str, ...]
    others: tuple[str, ...] = ()
    sided: bool = False
    lasts: bool = False
    implies: tuple[str, ...] = ()
    marked: bool = False

    @property
    def help(self) -> str:
        """What is seen, in words."""
        return (self.see.__doc__ or "").strip()

    def scores(self, signals: Signals, side: str | None = None) -> np.ndarray | None:
        """Scores ``(n,)`` of every frame, 0 to 1; None where the body lacks what the word needs.

        side: "left", "right" (that one and not the other), "both", or None for either.
        """
        if not set(self.needs) <= signals.parts:
            return None
        if not self.sided:
            return np.asarray(self.see(signals))
        left, right = self.see(signals, "left"), self.see(signals, "right")
        if side == "both":
            return all_of(left, right)
        if side is None:
            return any_of(left, right)
        own, other = (left, right) if side == "left" else (right, left)
        return np.asarray(own * (1 - 0.6 * other))


def _plain(
    name: str, see: Plain, needs: str, others: str = "", *, implies: str = "", lasts: bool = False, marked: bool = False
) -> Word:
    return Word(name, see, _listed(needs, " "), _listed(others), False, lasts, _listed(implies), marked)


def _sided(
    name: str, see: Sided, needs: str, others: str = "", *, implies: str = "", lasts: bool = False, marked: bool = False
) -> Word:
    return Word(name, see, _listed(needs, " "), _listed(others), True, lasts, _listed(implies), marked)


def _listed(text: str, between: str = ", ") -> tuple[str, ...]:
    return tuple(filter(None, text.split(between)))


WORDS: tuple[Word, ...] = (
    _plain("move", m.move, "body", "travel, go, locomotion, come", lasts=True),
    _plain("walk", m.walk, "legs", "stroll, pace, amble, wander, saunter", implies="step, forwards", lasts=True),
    _plain("run", m.run, "legs", "race", implies="step, fast, forwards, jog, sprint", lasts=True, marked=True),
    _plain("jog", m.jog, "legs", "trot", implies="run, step, forwards, fast", lasts=True),
    _plain("sprint", m.sprint, "legs", "dash, rush, bolt", implies="run, step, forwards, fast", lasts=True),
    _plain("march", m.march, "legs knees", "parade", implies="walk, step, raise knee", lasts=True),
    _plain("stand", m.stand, "body", "wait, idle, upright", lasts=True),
    _plain("stand still", m.stand_still, "body", "rest, freeze", implies="stand, still", lasts=True),
    _plain("still", m.still, "body", "motionless, stationary, pause", lasts=True),
    _plain("forwards", m.forwards, "hips", "forward, ahead, onwards", lasts=True),
    _plain("backwards", m.backwards, "hips", "backward, back, reverse, retreat", lasts=True, marked=True),
    _sided("sideways", m.sideways, "hips", "sideward, sidewards, sidestep, lateral, crab", lasts=True, marked=True),
    _sided("turn", m.turn, "hips", "rotate, pivot, veer, steer", marked=True),
    _sided("turn around", m.turn_around, "hips", "about-face, u-turn", implies="turn"),
    _sided("spin", m.spin, "hips", "twirl, whirl, pirouette, revolve", implies="turn, turn around", marked=True),
    _plain("straight", m.straight, "hips", "directly", lasts=True),
    _plain("circle", m.circle, "hips", "curve, loop, arc", implies="turn", lasts=True),
    _plain("start", m.start, "body", "begin, depart, set-off"),
    _plain("stop", m.stop, "body", "halt, end"),
    _sided("step", m.step, "legs", "stride, pace-out"),
    _plain("jump", m.jump, "legs", "bounce, vault, spring", marked=True),
    _plain("leap", m.leap, "legs", "bound, jete", implies="jump"),
    _sided("hop", m.hop, "legs", "skip", implies="jump, balance, raise leg"),
    _plain("crouch", m.crouch, "legs", "duck, hunker, stoop", implies="squat", lasts=True),
    _plain("squat", m.squat, "legs knees arms", "knee-bend", implies="crouch", marked=True),
    _plain("kneel", m.kneel, "legs knees", "genuflect", implies="crouch", lasts=True),
    _plain("sit", m.sit, "legs knees", "seated, perch", implies="crouch, still, stand still", lasts=True, marked=True),
    _plain("sit down", m.sit_down, "legs knees", "take-a-seat", implies="sit, crouch"),
    _plain("get up", m.get_up, "legs", "stand up, rise, arise", implies="sit, crouch, lie, bow, crawl"),
    _plain("lie", m.lie, "body", "recline, prone, supine", implies="still", lasts=True, marked=True),
    _plain("lie down", m.lie_down, "body", implies="lie"),
    _plain("fall", m.fall_down, "body", "collapse, tumble, drop", implies="lie, lie down"),
    _plain("crawl", m.crawl, "arms", "creep", implies="bend over, crouch, kneel", lasts=True, marked=True),
    _plain("upside down", m.upside_down, "body", "inverted, handstand"),
    _plain("cartwheel", m.cartwheel, "legs arms", implies="upside down, bend over, lean"),
    _plain("flip", m.flip, "legs", "backflip, somersault, handspring", implies="upside down, bend over, jump"),
    _plain("roll", m.roll, "legs", "tumble-over", implies="upside down, lie, crouch, bend over"),
    _plain("climb", m.climb, "legs", "ascend, clamber, mount, scale", lasts=True),
    _sided("kick", m.kick, "legs", "punt", implies="raise leg, balance", marked=True),
    _sided("raise leg", m.raise_leg, "legs", "lift leg, raise foot, lift foot"),
    _sided("raise knee", m.raise_knee, "legs knees", "lift knee, knee"),
    _sided("balance", m.balance, "legs", "one leg, arabesque, attitude", implies="raise leg, stand", lasts=True),
    _plain("lunge", m.lunge, "legs knees"),
    _plain("legs apart", m.legs_apart, "legs", "straddle, feet apart", lasts=True),
    _plain("jumping jack", m.jumping_jack, "arms legs", "star jump",
        implies="jump, raise, overhead, repeated, legs apart, lower, wave", marked=True),
    _sided("raise", g.raise_hand, "arms", "lift, put up, hands up", implies="raised, overhead, lower"),
    _sided("raised", g.raised, "arms", "up", implies="raise, overhead", lasts=True),
    _sided("overhead", g.overhead, "arms", "over head, above head", implies="raise, raised", lasts=True),
    _sided("lower", g.lower_hand, "arms", "put down", implies="raise, raised"),
    _sided("wave", g.wave, "arms", "greet, bye, byebye, beckon", implies="raise, raised, overhead, lower, repeated",
        marked=True),
    _plain("clap", g.clap, "arms", "applaud, applause", implies="hands together, repeated"),
    _plain("hands together", g.hands_together, "arms", "pray, join hands", lasts=True),
    _sided("punch", g.punch, "arms", "strike, hit, box, jab, slash", implies="reach, point, push, raise", marked=True),
    _sided("throw", g.throw, "arms", "toss, hurl, pitch, fling, cast", implies="raise, lower, punch, raised"),
    _sided("reach", g.reach_out, "arms", "extend, hold out"),
    _sided("point", g.point, "arms", "indicate, guide, show", implies="reach, raised, raise"),
    _plain("arms out", g.arms_out, "arms", "t-pose, arms wide, spread arms", implies="raised, raise", lasts=True),
    _plain("fold arms", g.fold_arms, "arms", "cross arms, arms crossed, arms folded", lasts=True),
    _plain("hands on hips", g.hands_on_hips, "arms elbows", "akimbo", lasts=True),
    _sided("hand to head", g.hand_to_head, "arms head", "call, phone, telephone, salute", implies="raise, raised",
        lasts=True),
    _plain("swing arms", g.swing_arms, "arms", lasts=True),
    _plain("push", g.push, "arms", "shove", implies="reach"),
    _plain("pull", g.pull, "arms", "tug, drag"),
    _plain("carry", g.carry, "arms", "hold, bear", lasts=True),
    _plain("stretch", g.stretch, "arms", "yawn", implies="raise, raised, overhead", lasts=True),
    _plain("still arms", g.still_arms, "arms", "arms still", lasts=True),
    _plain("bow", g.bow, "body", "bob, curtsy", implies="bend over", marked=True),
    _plain("bend over", g.bend_over, "body", "bend, bend down, bend forward", lasts=True),
    _plain("lean back", g.lean_back, "body", "bend back, arch", lasts=True),
    _sided("lean", g.lean, "body", "tilt, side bend", lasts=True),
    _plain("twist", g.twist, "arms hips", "side twist, contort"),
    _plain("pick up", g.pick_up, "arms", "grab, scoop, collect", implies="bend over, crouch, squat, lower"),
    _plain("fast", m.fast, "body", "quick, quickly, brisk, briskly, rapid, hurry", lasts=True),
    _plain("slow", m.slow, "body", "slowly, gentle, gently, calm", lasts=True),
    _plain("repeated", m.repeated, "body", "repeatedly, rhythmic, again and again", lasts=True),
    _plain("dance", m.dance, "arms hips", "ballet, groove", lasts=True),
    _plain("energetic", m.energetic, "body", "lively, vigorous, exercise", lasts=True),
)  # fmt: skip
"""All words."""

SAME: Mapping[str, str] = {other: word.name for word in WORDS for other in (word.name, *word.others)}
"""Word or another word for it -> the word's name."""


@cache
def word(name: str) -> Word:
    """The word of a name; raises KeyError for none."""
    return {each.name: each for each in WORDS}[name]
