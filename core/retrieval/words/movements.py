"""Words for the whole body and the legs: scores ``(n,)`` of every frame, 0 to 1, from a clip's signals."""

from __future__ import annotations

import numpy as np

from core.retrieval.words.signals import (
    SIDES,
    Signals,
    above,
    all_of,
    any_of,
    change,
    length,
    mean_over,
    most_over,
    speeds,
    swing_size,
    swings,
)

UP, FORWARD = 1, 2
_SIGN = {"left": 1, "right": -1}


def move(s: Signals) -> np.ndarray:
    """The body travels over the ground."""
    return above(s.speed, 0.12, 0.3)


def airborne(s: Signals) -> np.ndarray:
    """Neither foot is near the ground, neither heel nor toes."""
    feet = []
    for side in SIDES:
        for joint in ("ankle", "toe"):
            if f"{side}_{joint}" in s.joints:
                height = s.joints[f"{side}_{joint}"][:, 1]
                feet.append(height - np.percentile(height, 5))
    return above(np.min(feet, axis=0), 0.02, 0.05)


def _flight(s: Signals) -> np.ndarray:
    """Share of the last second in which both feet are off the ground."""
    return mean_over(airborne(s), 1.0)


def _stepping(s: Signals) -> np.ndarray:
    """The feet pass one another again and again."""
    ahead = s.local("left_ankle")[:, [0, 2]] - s.local("right_ankle")[:, [0, 2]]
    way = np.max([swing_size(ahead[:, k], 1.4) for k in (0, 1)], axis=0)
    return above(most_over(way, 1.0), 0.03, 0.08)


def upright(s: Signals) -> np.ndarray:
    """The trunk is upright and the hips are high."""
    return all_of(above(s.trunk[:, UP], 0.5, 0.75), above(s.pelvis, 0.6, 0.78))


def walk(s: Signals) -> np.ndarray:
    """Steps over the ground, slower than a run and never with both feet in the air for long."""
    pace = all_of(above(s.speed, 0.1, 0.25), above(s.speed, 1.6, 1.15))
    return all_of(pace, _stepping(s), upright(s), above(_flight(s), 0.3, 0.1))


def run(s: Signals) -> np.ndarray:
    """Steps over the ground, with both feet in the air between them, or too fast to walk."""
    flying = above(mean_over(airborne(s), 0.8), 0.04, 0.16) * above(s.speed, 0.5, 0.9)
    return all_of(any_of(flying, above(s.speed, 1.15, 1.6)), above(s.speed, 0.5, 0.9), _stepping(s))


def jog(s: Signals) -> np.ndarray:
    """Runs at an easy pace."""
    return np.asarray(run(s) * above(s.speed, 2.4, 1.8))


def sprint(s: Signals) -> np.ndarray:
    """Runs at full speed."""
    return np.asarray(run(s) * above(s.speed, 1.5, 2.3))


def stand(s: Signals) -> np.ndarray:
    """Upright on the spot."""
    return all_of(above(s.speed, 0.2, 0.08), upright(s))


def stand_still(s: Signals) -> np.ndarray:
    """Upright on the spot, and hardly anything moves."""
    return all_of(stand(s), above(s.motion, 0.25, 0.1))


def still(s: Signals) -> np.ndarray:
    """Hardly anything moves."""
    return all_of(above(s.speed, 0.15, 0.05), above(s.motion, 0.25, 0.1))


def _heading(s: Signals) -> np.ndarray:
    """Where the body travels, as it sees it: a unit vector ``(n, 2)`` left and forward, 0 where it stands."""
    velocity = mean_over(s.velocity[:, [0, 2]], 0.8)
    return np.asarray(velocity / np.maximum(length(velocity), 0.05)[:, None])


def forwards(s: Signals) -> np.ndarray:
    """Travels the way it faces."""
    return all_of(move(s), above(_heading(s)[:, 1], 0.5, 0.85))


def backwards(s: Signals) -> np.ndarray:
    """Travels against the way it faces."""
    return all_of(above(s.speed, 0.08, 0.2), above(-_heading(s)[:, 1], 0.4, 0.8))


def sideways(s: Signals, side: str) -> np.ndarray:
    """Travels to one side, facing ahead."""
    return np.asarray(all_of(above(s.speed, 0.08, 0.2), above(_SIGN[side] * _heading(s)[:, 0], 0.55, 0.85)))


def turn(s: Signals, side: str) -> np.ndarray:
    """Turns to one side by some 60 degrees or more within two seconds."""
    return above(_SIGN[side] * np.degrees(most_over_signed(change(s.yaw, 1.6), _SIGN[side])), 22, 60)


def most_over_signed(values: np.ndarray, sign: int) -> np.ndarray:
    """The value ``(n,)`` furthest in one direction within half a second."""
    return np.asarray(sign * most_over(sign * values, 0.5))


def turn_around(s: Signals, side: str) -> np.ndarray:
    """Turns by half a circle or more within three seconds."""
    return above(_SIGN[side] * np.degrees(change(s.yaw, 3.0)), 100, 150)


def spin(s: Signals, side: str) -> np.ndarray:
    """Turns by a whole circle or more within two seconds."""
    return np.asarray(above(_SIGN[side] * np.degrees(change(s.yaw, 2.0)), 190, 300) * above(s.trunk[:, UP], 0.3, 0.6))


def straight(s: Signals) -> np.ndarray:
    """Travels without turning."""
    return all_of(move(s), above(np.degrees(np.abs(change(s.yaw, 2.0))), 40, 15))


def circle(s: Signals) -> np.ndarray:
    """Travels along a curve that goes on and on."""
    return all_of(move(s), above(np.degrees(np.abs(change(s.yaw, 4.0))), 70, 150), above(np.abs(s.turning), 2.5, 1.5))


def start(s: Signals) -> np.ndarray:
    """Stands, and then travels."""
    return all_of(above(np.roll(s.speed, 15), 0.35, 0.15), above(np.roll(s.speed, -15), 0.25, 0.45), _middle(s.n, 15))


def stop(s: Signals) -> np.ndarray:
    """Travels, and then stands."""
    return all_of(above(np.roll(s.speed, 15), 0.25, 0.45), above(np.roll(s.speed, -15), 0.35, 0.15), _middle(s.n, 15))


def _middle(n: int, reach: int) -> np.ndarray:
    """0 at the frames whose neighbours ``reach`` away are not there."""
    inside = np.zeros(n)
    inside[reach : n - reach] = 1
    return inside


def jump(s: Signals) -> np.ndarray:
    """Both feet leave the ground and the hips fly up and come down."""
    low = np.min([s.foot_height(side) for side in SIDES], axis=0)
    hips = s.joints["pelvis"][:, 1]
    rise = most_over(change(hips, 0.4), 0.5)
    fall = most_over(-change(hips, 0.4), 0.5)
    air = above(most_over(low, 0.3), 0.03, 0.07)
    high = all_of(above(most_over(s.pelvis, 0.3), 0.85, 0.97), above(s.trunk[:, UP], 0.2, 0.5))
    return np.asarray(all_of(air, high, above(rise, 0.05, 0.1), above(fall, 0.05, 0.1)) * (1 - 0.8 * run(s)))


def leap(s: Signals) -> np.ndarray:
    """A jump that travels."""
    return all_of(jump(s), above(s.speed, 0.3, 0.7))


def hop(s: Signals, side: str) -> np.ndarray:
    """Jumps on one leg while the other foot stays up."""
    other = "right" if side == "left" else "left"
    up = above(mean_over(s.foot_height(other), 0.8), 0.05, 0.1)
    own = above(most_over(s.foot_height(side), 0.4), 0.02, 0.05) * above(
        swing_size(s.joints["pelvis"][:, 1], 0.8), 0.008, 0.02
    )
    return all_of(up, own)


def crouch(s: Signals) -> np.ndarray:
    """The hips are low over bent knees, the trunk is not lying."""
    return all_of(above(s.pelvis, 0.85, 0.62), above(s.trunk[:, UP], 0.2, 0.5), above(s.pelvis, 0.2, 0.3))


def squat(s: Signals) -> np.ndarray:
    """The hips go down between bent knees and up again."""
    knees = np.mean([s.bend(side, "knee") for side in SIDES], axis=0)
    down = all_of(above(s.pelvis, 0.88, 0.68), above(knees, 45, 85))
    stood = [most_over(np.roll(above(s.pelvis, 0.75, 0.9), k), 1.6) for k in (30, -30)]
    return all_of(down, *stood, above(s.speed, 0.4, 0.15), above(s.trunk[:, UP], 0.3, 0.6))


def kneel(s: Signals) -> np.ndarray:
    """A knee is near the floor, under a trunk that is upright."""
    knee = np.min([s.joints[f"{side}_knee"][:, 1] for side in SIDES], axis=0) - s.floor
    return all_of(above(knee, 0.12, 0.06), above(s.trunk[:, UP], 0.5, 0.75), above(s.pelvis, 0.3, 0.4))


def sit(s: Signals) -> np.ndarray:
    """The hips are at the height of a seat or the floor, the thighs level, the trunk upright, and nothing travels."""
    thighs = [s.joints[f"{side}_knee"][:, 1] - s.joints[f"{side}_hip"][:, 1] for side in SIDES]
    level = above(np.mean(thighs, axis=0), -0.21, -0.14)
    low = above(s.pelvis, 0.85, 0.68)
    return all_of(level, low, above(s.trunk[:, UP], 0.45, 0.7), above(s.speed, 0.3, 0.12))


def sit_down(s: Signals) -> np.ndarray:
    """Stands, goes down within two seconds and sits."""
    return all_of(
        _from_to(above(s.pelvis, 0.8, 0.92), mean_over(sit(s), 0.6)), above(-change(s.pelvis, 1.2), 0.12, 0.28)
    )


def get_up(s: Signals) -> np.ndarray:
    """The hips have been low for a second and come up to standing."""
    low = above(mean_over(above(s.pelvis, 0.82, 0.7), 1.0), 0.5, 0.9)
    rising = above(most_over(change(s.pelvis, 1.2), 0.6), 0.12, 0.28)
    return all_of(_from_to(low, above(s.pelvis, 0.78, 0.9), 60), rising)


def _from_to(before: np.ndarray, after: np.ndarray, reach: int = 36) -> np.ndarray:
    """One score within ``reach`` frames before, the other within as many after."""
    n = len(before)
    at = np.arange(n)
    earlier = np.max([before[np.maximum(at - k, 0)] for k in range(6, reach, 6)], axis=0)
    later = np.max([after[np.minimum(at + k, n - 1)] for k in range(6, reach, 6)], axis=0)
    return all_of(earlier, later)


def lie(s: Signals) -> np.ndarray:
    """The trunk is level and near the floor."""
    return all_of(above(s.pelvis, 0.45, 0.28), above(np.abs(s.trunk[:, UP]), 0.65, 0.4))


def lie_down(s: Signals) -> np.ndarray:
    """Comes down from standing or sitting to lying."""
    return np.asarray(_from_to(above(s.pelvis, 0.4, 0.6), lie(s), 75) * above(-change(s.pelvis, 1.5), 0.05, 0.2))


def fall_down(s: Signals) -> np.ndarray:
    """The hips drop to the floor fast."""
    return all_of(above(-change(s.pelvis, 0.7), 0.3, 0.5), above(np.roll(s.pelvis, -20), 0.6, 0.35))


def crawl(s: Signals) -> np.ndarray:
    """Travels on hands and knees, with a level trunk."""
    hands = np.min([s.joints[f"{side}_wrist"][:, 1] for side in SIDES], axis=0) - s.floor
    level = above(np.abs(s.trunk[:, UP]), 0.8, 0.55)
    return all_of(
        level, above(most_over(0.3 - hands, 0.8), 0.08, 0.18), above(s.pelvis, 0.75, 0.6), above(s.speed, 0.04, 0.12)
    )


def upside_down(s: Signals) -> np.ndarray:
    """The hips are above the head, as in a cartwheel, a handstand or a roll."""
    return above(-s.trunk[:, UP], 0.1, 0.5)


def _lowest_hand(s: Signals) -> np.ndarray:
    return np.asarray(np.min([s.joints[f"{side}_wrist"][:, 1] for side in SIDES], axis=0) - s.floor)


def _legs_over(s: Signals) -> np.ndarray:
    """The body turns over with the legs in the air."""
    feet = np.max([s.joints[f"{side}_ankle"][:, 1] for side in SIDES], axis=0) - s.floor
    return all_of(most_over(upside_down(s), 0.4), above(most_over(feet, 0.4), 0.5, 0.75))


def cartwheel(s: Signals) -> np.ndarray:
    """The body turns over its hands, sideways, with the legs in the air."""
    support = above(-most_over(-_lowest_hand(s), 0.6), 0.2, 0.1)
    wide = most_over(np.abs(s.local("left_ankle")[:, 0] - s.local("right_ankle")[:, 0]), 0.6)
    return all_of(_legs_over(s), support, above(wide, 0.25, 0.45))


def flip(s: Signals) -> np.ndarray:
    """The body turns over with the legs close together, off the ground for a moment."""
    wide = most_over(np.abs(s.local("left_ankle")[:, 0] - s.local("right_ankle")[:, 0]), 0.6)
    return all_of(_legs_over(s), above(wide, 0.45, 0.25))


def roll(s: Signals) -> np.ndarray:
    """The body goes over its back, low over the floor."""
    return all_of(most_over(upside_down(s), 0.5), above(s.pelvis, 0.75, 0.5))


def climb(s: Signals) -> np.ndarray:
    """The hips rise by more than a step and stay up, or the feet are far above the floor."""
    feet = np.min([s.joints[f"{side}_ankle"][:, 1] for side in SIDES], axis=0) - s.floor
    rising = above(change(mean_over(s.joints["pelvis"][:, 1], 1.0), 2.5), 0.15, 0.25)
    return any_of(above(mean_over(feet, 2.0), 0.1, 0.25), rising * 0.6)


def kick(s: Signals, side: str) -> np.ndarray:
    """The foot swings up fast and the leg gets straight in the air."""
    foot = s.local(f"{side}_ankle", f"{side}_hip") / s.leg
    up = above(most_over(s.foot_height(side), 0.3), 0.12, 0.25)
    fast = above(most_over(length(speeds(foot)), 0.3), 3.0, 5.0)
    out = above(most_over(length(foot[:, [0, 2]]), 0.3), 0.5, 0.75)
    over = most_over(above(-s.trunk[:, UP], -0.1, 0.2), 1.0)  # the legs of a cartwheel kick nothing
    return np.asarray(all_of(up, fast, out) * above(mean_over(s.speed, 0.6), 2.0, 1.2) * (1 - over))


def raise_leg(s: Signals, side: str) -> np.ndarray:
    """The foot is held well above the ground."""
    return above(mean_over(s.foot_height(side), 0.3), 0.1, 0.22)


def raise_knee(s: Signals, side: str) -> np.ndarray:
    """The knee comes up to the height of the hip."""
    up = above(s.joints[f"{side}_knee"][:, 1] - s.joints[f"{side}_hip"][:, 1], -0.12, -0.03)
    return all_of(up, above(s.pelvis, 0.75, 0.88))


def balance(s: Signals, side: str) -> np.ndarray:
    """Stands on one leg for a second or longer."""
    other = "right" if side == "left" else "left"
    up = above(s.foot_height(other), 0.05, 0.1)
    down = above(s.foot_height(side), 0.06, 0.03)
    return above(mean_over(all_of(up, down, above(s.speed, 0.4, 0.2)), 1.2), 0.4, 0.85)


def lunge(s: Signals) -> np.ndarray:
    """One foot far in front of the other with a bent knee."""
    apart = np.abs(s.local("left_ankle")[:, FORWARD] - s.local("right_ankle")[:, FORWARD])
    bent = np.max([s.bend(side, "knee") for side in SIDES], axis=0)
    return all_of(above(apart, 0.3, 0.42), above(bent, 40, 70), above(s.speed, 0.8, 0.4))


def legs_apart(s: Signals) -> np.ndarray:
    """The feet stand far apart, sideways."""
    apart = s.local("left_ankle")[:, 0] - s.local("right_ankle")[:, 0]
    return above(apart, 0.25, 0.38)


def jumping_jack(s: Signals) -> np.ndarray:
    """Hands go up and feet apart together, again and again, on the spot."""
    hands = np.mean([s.hand(side)[:, UP] for side in SIDES], axis=0)
    feet = s.local("left_ankle")[:, 0] - s.local("right_ankle")[:, 0]
    wide = all_of(above(swing_size(hands, 1.6), 0.25, 0.5), above(swing_size(feet, 1.6), 0.05, 0.1))
    return all_of(wide, above(swings(hands), 0.4, 0.7), above(s.speed, 0.8, 0.4))


def march(s: Signals) -> np.ndarray:
    """Steps with knees that come up high."""
    knees = np.max([s.joints[f"{k}_knee"][:, 1] - s.joints[f"{k}_hip"][:, 1] for k in SIDES], axis=0)
    return all_of(above(most_over(knees, 1.0), -0.15, -0.06), _stepping(s), above(_flight(s), 0.3, 0.1), upright(s))


def step(s: Signals, side: str) -> np.ndarray:
    """The foot leaves the ground and is put down elsewhere."""
    return all_of(above(s.foot_speed(side), 0.5, 1.0), above(s.foot_height(side), 0.01, 0.03))


def fast(s: Signals) -> np.ndarray:
    """Travels or moves fast."""
    return any_of(above(s.speed, 0.9, 1.5), above(s.motion, 0.7, 1.3))


def slow(s: Signals) -> np.ndarray:
    """Moves, but slowly."""
    return all_of(above(s.speed, 0.8, 0.5), above(s.motion, 0.6, 0.3), any_of(move(s), above(s.motion, 0.08, 0.15)))


def repeated(s: Signals) -> np.ndarray:
    """Hands or feet do the same again and again."""
    found = []
    for joint in ("left_wrist", "right_wrist", "left_ankle", "right_ankle"):
        if joint in s.joints:
            up = s.local(joint)[:, UP]
            found.append(all_of(above(swings(up, 3.0), 0.4, 0.7), above(swing_size(up, 3.0), 0.02, 0.05)))
    return any_of(*found) if found else np.zeros(s.n)


def dance(s: Signals) -> np.ndarray:
    """Both arms rise and fall over steps that go nowhere in particular."""
    arms = np.mean([s.hand_speed(side) for side in SIDES], axis=0)
    varied = np.min([swing_size(s.hand(side)[:, UP], 3.0) for side in SIDES], axis=0)
    there = length(change(s.joints["pelvis"], 3.0)[:, [0, 2]])
    moving = all_of(
        above(mean_over(arms, 3.0), 0.7, 1.5), above(varied, 0.12, 0.3), above(mean_over(s.speed, 3.0), 0.05, 0.15)
    )
    return all_of(moving, above(there, 1.2, 0.7), above(mean_over(s.trunk[:, UP], 2.0), 0.7, 0.88))


def energetic(s: Signals) -> np.ndarray:
    """Hands and feet move a lot."""
    return above(mean_over(s.motion, 1.0), 0.5, 1.2)
