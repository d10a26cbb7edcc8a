"""Small recordings made for the tests, as text and as clips."""

from __future__ import annotations

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.skeleton import Skeleton

BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Chest
  {
    OFFSET 0 20 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 50 0
    }
  }
  JOINT LeftLeg
  {
    OFFSET 9 -4 0
    CHANNELS 3 Yrotation Xrotation Zrotation
    End Site
    {
      OFFSET 0 -85 0
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.0333333
0 90 0 0.0 -2 0.5 3 0 0 -4 0 0
0 91 2 1.5 -2 0.5 3 0 1 -4 10 0
.5 +92. 4e0 3.0 -2 0.5 3 0 2 -4 20 -1E+1
"""

ASF = """# made for the tests
:version 1.10
:name TEST
:units
  mass 1.0
  length 0.45
  angle deg
:documentation
   made for the tests
:root
   order TX TY TZ RX RY RZ
   axis XYZ
   position 0 0 0
   orientation 0 0 0
:bonedata
  begin
     id 1
     name hipjoint
     direction 0.6 -0.8 0
     length 2.0
     axis 0 0 0 XYZ
  end
  begin
     id 2
     name femur
     direction 0.34202 -0.939693 0
     length 7.2
     axis 10 -30 20 XYZ
    dof rx ry rz
    limits (-90.0 90.0)
           (-90.0 90.0)
           (-90.0 90.0)
  end
  begin
     id 3
     name foot
     direction 0 0 1
     length 3.5
     axis -90 7.62852e-016 20 XYZ
    dof rx rz
    limits (-90.0 90.0)
           (-90.0 90.0)
  end
  begin
     id 4
     name back
     direction 0 1 0
     length 9
     axis 0 0 0 XYZ
    dof rx ry rz
  end
:hierarchy
  begin
    root hipjoint back
    hipjoint femur
    femur foot
  end
"""

AMC = """#!OML:ASF test.ASF
:FULLY-SPECIFIED
:DEGREES
1
root 1 17.1 2 10 20 30
back 1 2 3
femur -10 5 15
foot 21 -3.5e-002
2
root 1 17.2 2 0 2 0
back 4 5 6
femur -20 0 5
foot 22 4
3
root 1 17.3 2 0 3 0
back 7 8 9
femur -30 7 5
foot 23 0
"""

# A plain body: joint, parent, offset in metres.
_BODY = (
    ("Hips", None, (0, 0, 0)),
    *(("Spine", "Hips", (0, 0.12, 0)), ("Chest", "Spine", (0, 0.3, 0)), ("Neck", "Chest", (0, 0.15, 0))),
    *(("Head", "Neck", (0, 0.1, 0)), ("Head_end", "Head", (0, 0.18, 0))),
    *(("LeftShoulder", "Chest", (0.04, 0.1, 0)), ("LeftArm", "LeftShoulder", (0.14, 0, 0))),
    *(("LeftForeArm", "LeftArm", (0.29, 0, 0)), ("LeftHand", "LeftForeArm", (0.25, 0, 0))),
    ("LeftHand_end", "LeftHand", (0.16, 0, 0)),
    *(("RightShoulder", "Chest", (-0.04, 0.1, 0)), ("RightArm", "RightShoulder", (-0.14, 0, 0))),
    *(("RightForeArm", "RightArm", (-0.29, 0, 0)), ("RightHand", "RightForeArm", (-0.25, 0, 0))),
    ("RightHand_end", "RightHand", (-0.16, 0, 0)),
    *(("LeftUpLeg", "Hips", (0.09, -0.05, 0)), ("LeftLeg", "LeftUpLeg", (0, -0.42, 0))),
    *(("LeftFoot", "LeftLeg", (0, -0.42, 0)), ("LeftToeBase", "LeftFoot", (0, -0.07, 0.14))),
    ("LeftToeBase_end", "LeftToeBase", (0, 0, 0.07)),
    *(("RightUpLeg", "Hips", (-0.09, -0.05, 0)), ("RightLeg", "RightUpLeg", (0, -0.42, 0))),
    *(("RightFoot", "RightLeg", (0, -0.42, 0)), ("RightToeBase", "RightFoot", (0, -0.07, 0.14))),
    ("RightToeBase_end", "RightToeBase", (0, 0, 0.07)),
)
STANDING = 0.96  # height of the hips over the soles


def body(scale: float = 1.0) -> Skeleton:
    """A person of about 1.8 m times ``scale``, arms out to the sides at rest."""
    names = tuple(name for name, _, _ in _BODY)
    return Skeleton(
        names=names,
        parents=tuple(-1 if parent is None else names.index(parent) for _, parent, _ in _BODY),
        offsets=np.array([offset for _, _, offset in _BODY]) * scale,
        end_sites=tuple(name.endswith("_end") for name in names),
        unit=0.01,
    )


def idling(name: str = "idling", seconds: float = 4.0, fps: float = 60.0, seed: int = 0, scale: float = 1.0) -> Clip:
    """A body that stands, arms down, and sways: smooth, irregular, feet on the spot; different for each seed."""
    rng = np.random.default_rng(seed)
    skeleton, n = body(scale), round(seconds * fps)
    t = np.arange(n) / fps
    rotations = np.tile(np.array([1, 0, 0, 0], np.float32), (n, skeleton.n_joints, 1))
    for side, down in (("Left", -1.2), ("Right", 1.2)):
        for joint, centre, swing in ((f"{side}Arm", down, 0.25), (f"{side}ForeArm", 0.2 * down, 0.5)):
            waves = [np.sin(2 * np.pi * rng.uniform(0.2, 0.9) * t + rng.uniform(0, 6)) for _ in range(4)]
            turned = np.stack([swing * waves[0], 0.5 * swing * waves[1], centre + swing * waves[2] * waves[3]], axis=1)
            rotations[:, skeleton.index(joint)] = quat.from_rotvec(turned)
    root = np.zeros((n, 3), np.float32)
    root[:, 1] = STANDING * scale
    return Clip(name, skeleton, fps, root, rotations)
