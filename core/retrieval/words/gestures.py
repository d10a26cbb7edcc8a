"""Words for arms, hands and the trunk: scores ``(n,)`` of every frame, 0 to 1, from a clip's signals."""

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


def raised(s: Signals, side: str) -> np.ndarray:
    """The hand is at the height of the shoulder or above."""
    return above(s.hand(side)[:, UP], -0.25, 0.15)


def overhead(s: Signals, side: str) -> np.ndarray:
    """The hand is well above the shoulder."""
    return above(s.hand(side)[:, UP], 0.25, 0.6)


def raise_hand(s: Signals, side: str) -> np.ndarray:
    """The hand goes up by half an arm's length or more within a second and a half, to the shoulder or above."""
    rise = most_over(change(s.hand(side)[:, UP], 1.2), 0.6)
    return all_of(above(rise, 0.35, 0.8), above(most_over(s.hand(side)[:, UP], 1.2), -0.25, 0.2))


def lower_hand(s: Signals, side: str) -> np.ndarray:
    """The hand comes down by half an arm's length or more, from the shoulder or above."""
    fall = most_over(-change(s.hand(side)[:, UP], 1.2), 0.6)
    return all_of(above(fall, 0.35, 0.8), above(most_over(s.hand(side)[:, UP], 1.2), -0.25, 0.2))


def wave(s: Signals, side: str) -> np.ndarray:
    """The raised hand swings to and fro, across or up and down, again and again."""
    hand = s.hand(side)
    across, up = hand[:, 0], hand[:, UP]
    often = any_of(
        all_of(above(swings(across), 0.6, 1.1), above(swing_size(across), 0.05, 0.16)),
        all_of(above(swings(up), 0.9, 1.4), above(swing_size(up), 0.09, 0.2)) * 0.8,
    )
    held = above(mean_over(up, 1.0), -0.75, -0.3)
    calm = above(s.speed, 0.8, 0.3) * above(s.trunk[:, UP], 0.6, 0.85)
    return np.asarray(all_of(mean_over(often, 0.7), held) * calm)


def clap(s: Signals) -> np.ndarray:
    """The hands meet in front of the body and part again, fast."""
    apart = length(s.joints["left_wrist"] - s.joints["right_wrist"])
    met = above(apart, 0.2, 0.11)
    parts = above(most_over(apart, 0.8) - apart, 0.04, 0.1)
    fast = above(most_over(np.abs(np.gradient(apart) * 30 if len(apart) > 1 else apart * 0), 0.5), 0.25, 0.6)
    front = above(any_of(*(s.local(f"{side}_wrist")[:, FORWARD] for side in SIDES)), 0.05, 0.12)
    return all_of(met, parts, fast, front)


def hands_together(s: Signals) -> np.ndarray:
    """Both hands stay close together."""
    apart = length(s.joints["left_wrist"] - s.joints["right_wrist"])
    return above(mean_over(apart, 0.7), 0.2, 0.1)


def punch(s: Signals, side: str) -> np.ndarray:
    """The hand shoots out to about the shoulder's height and the arm is straight for a moment."""
    hand = s.hand(side)
    reach = length(hand)
    out = np.gradient(reach) * 30 if len(reach) > 1 else reach * 0
    there = all_of(above(length(hand[:, [0, 2]]), 0.5, 0.8), above(np.abs(hand[:, UP]), 0.75, 0.5))
    found = all_of(above(most_over(out, 0.3), 1.8, 3.2), above(most_over(there, 0.3), 0.2, 0.9))
    upright = above(s.trunk[:, UP], 0.6, 0.85)
    return all_of(found, above(most_over(s.hand_speed(side), 0.3), 2.5, 5.0), upright)


def throw(s: Signals, side: str) -> np.ndarray:
    """The hand goes up or back beside the head and then whips forward and down."""
    hand = s.hand(side)
    velocity = speeds(hand)
    forward = most_over(velocity[:, FORWARD], 0.3)
    before = most_over(np.roll(above(hand[:, UP], -0.1, 0.4) * above(hand[:, FORWARD], 0.5, 0.1), 8), 0.5)
    return all_of(above(forward, 2.0, 4.0), before)


def reach_out(s: Signals, side: str) -> np.ndarray:
    """The arm is stretched out in front, at the height of waist to head, and held."""
    hand = s.hand(side)
    return all_of(above(hand[:, FORWARD], 0.45, 0.8), above(mean_over(s.hand_speed(side), 0.5), 2.0, 0.8))


def point(s: Signals, side: str) -> np.ndarray:
    """The straight arm points away from the body, at about the shoulder's height, and is held still."""
    hand = s.hand(side)
    out = length(hand[:, [0, 2]])
    level = above(np.abs(hand[:, UP]), 0.65, 0.35)
    return all_of(above(out, 0.65, 0.9), level, above(mean_over(s.hand_speed(side), 0.5), 1.6, 0.5))


def arms_out(s: Signals) -> np.ndarray:
    """Both arms are stretched out to the sides."""
    left, right = s.hand("left"), s.hand("right")
    wide = all_of(above(left[:, 0], 0.55, 0.85), above(-right[:, 0], 0.55, 0.85))
    return all_of(wide, above(np.abs(left[:, UP]), 0.7, 0.4), above(np.abs(right[:, UP]), 0.7, 0.4))


def fold_arms(s: Signals) -> np.ndarray:
    """Both hands lie in front of the chest, each near the other's side."""
    left, right = s.local("left_wrist"), s.local("right_wrist")
    crossed = above(right[:, 0] - left[:, 0], -0.06, 0.04)
    chest = all_of(*(above(hand[:, UP], 0.06, 0.14) for hand in (left, right)))
    still = above(s.hand_speed("left") + s.hand_speed("right"), 2.0, 0.6)
    return all_of(crossed, chest, still)


def hands_on_hips(s: Signals) -> np.ndarray:
    """Both hands rest at the sides of the pelvis with bent elbows."""
    found = []
    for side, sign in (("left", 1), ("right", -1)):
        wrist, elbow = s.local(f"{side}_wrist"), s.local(f"{side}_elbow")
        near = all_of(above(np.abs(wrist[:, UP] - 0.03), 0.12, 0.06), above(np.abs(wrist[:, 0]), 0.24, 0.17))
        found.append(all_of(near, above(sign * elbow[:, 0], 0.14, 0.2), above(s.bend(side, "elbow"), 35, 65)))
    return all_of(*found)


def hand_to_head(s: Signals, side: str) -> np.ndarray:
    """The hand is held at the head, as on the phone or in thought."""
    apart = length(s.joints[f"{side}_wrist"] - s.joints["head"])
    return all_of(above(apart, 0.19, 0.13), above(s.hand_speed(side), 2.5, 1.0))


def swing_arms(s: Signals) -> np.ndarray:
    """Both hands swing forward and back, one against the other."""
    left, right = s.hand("left")[:, FORWARD], s.hand("right")[:, FORWARD]
    both = all_of(*(above(swing_size(hand), 0.08, 0.2) for hand in (left, right)))
    against = above(swing_size(left - right) - swing_size(left + right), 0.0, 0.15)
    return all_of(both, against)


def push(s: Signals) -> np.ndarray:
    """Both hands go out in front together and the arms get straight."""
    out = [change(s.hand(side)[:, FORWARD], 0.6) for side in SIDES]
    there = [above(most_over(s.hand(side)[:, FORWARD], 0.4), 0.4, 0.7) for side in SIDES]
    low = [above(s.hand(side)[:, UP], 0.5, 0.2) for side in SIDES]
    return all_of(*(above(most_over(x, 0.3), 0.2, 0.5) for x in out), *there, *low)


def pull(s: Signals) -> np.ndarray:
    """A hand or both come back to the body from in front."""
    back = any_of(*(most_over(-change(s.hand(side)[:, FORWARD], 0.6), 0.3) for side in SIDES))
    there = any_of(*(above(most_over(s.hand(side)[:, FORWARD], 0.8), 0.4, 0.7) for side in SIDES))
    return all_of(above(back, 0.25, 0.55), there)


def carry(s: Signals) -> np.ndarray:
    """Both forearms are held in front of the body, still, as with a load."""
    found = []
    for side in SIDES:
        hand = s.hand(side)
        found += [above(hand[:, FORWARD], 0.2, 0.45), above(np.abs(hand[:, UP] + 0.4), 0.5, 0.3)]
        found.append(above(swing_size(hand[:, FORWARD]), 0.15, 0.07))
    return all_of(*found)


def stretch(s: Signals) -> np.ndarray:
    """Both arms are long and high above the head, or out behind the body, and held."""
    up = all_of(*(overhead(s, side) for side in SIDES), *(above(length(s.hand(side)), 0.7, 0.9) for side in SIDES))
    slow = above(np.mean([s.hand_speed(side) for side in SIDES], axis=0), 3.0, 1.0)
    return all_of(mean_over(up, 0.5), slow)


def still_arms(s: Signals) -> np.ndarray:
    """Neither hand moves."""
    return all_of(*(above(mean_over(s.hand_speed(side), 0.7), 0.6, 0.2) for side in SIDES))


def bow(s: Signals) -> np.ndarray:
    """The trunk tips forward over straight legs and comes up again."""
    tilt = np.degrees(np.arctan2(s.trunk[:, FORWARD], s.trunk[:, UP]))
    tipped = above(most_over(tilt, 0.6) - np.percentile(tilt, 10), 15, 32)
    legs = above(s.pelvis, 0.75, 0.88)
    return all_of(above(tilt, 12, 30), tipped, legs, above(s.speed, 0.45, 0.15))


def bend_over(s: Signals) -> np.ndarray:
    """The trunk is far forward: at 60 degrees or more."""
    tilt = np.degrees(np.arctan2(s.trunk[:, FORWARD], s.trunk[:, UP]))
    return all_of(above(tilt, 35, 60), above(s.pelvis, 0.45, 0.65))


def lean_back(s: Signals) -> np.ndarray:
    """The trunk leans backwards."""
    tilt = np.degrees(np.arctan2(-s.trunk[:, FORWARD], s.trunk[:, UP]))
    return all_of(above(tilt, 10, 22), above(s.pelvis, 0.5, 0.7))


def lean(s: Signals, side: str) -> np.ndarray:
    """The trunk leans to one side."""
    sign = 1 if side == "left" else -1
    return above(np.degrees(np.arctan2(sign * s.trunk[:, 0], s.trunk[:, UP])), 9, 22)


def twist(s: Signals) -> np.ndarray:
    """The shoulders turn against the hips, by 25 degrees or more."""
    shoulders, hips = (s.joints[f"left_{j}"] - s.joints[f"right_{j}"] for j in ("shoulder", "hip"))
    angle = np.arctan2(-shoulders[:, 2], shoulders[:, 0]) - np.arctan2(-hips[:, 2], hips[:, 0])
    turned = np.degrees(np.abs((angle + np.pi) % (2 * np.pi) - np.pi))
    return all_of(above(turned, 18, 38), above(s.trunk[:, UP], 0.5, 0.8))


def pick_up(s: Signals) -> np.ndarray:
    """A hand goes down to the shins or the floor and comes up again."""
    low = any_of(*(above(s.joints[f"{side}_wrist"][:, 1] - s.floor, 0.36, 0.22) for side in SIDES))
    before, after = (most_over(np.roll(above(s.pelvis, 0.7, 0.88), k), 1.2) for k in (30, -30))
    return all_of(low, before, after, above(s.trunk[:, UP], -0.2, 0.1))
