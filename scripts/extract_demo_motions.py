"""Write core/data/demo_motions.npz from the motions that the package pybullet 3.2.7 carries.

usage: pip install pybullet==3.2.7 && python scripts/extract_demo_motions.py

The source is X forward, Y up, Z right; we write Z forward, X left. Known faults are mended here: steps of a joint
between two frames are spread over their neighbours, the last frame's missing duration is filled in. The file holds

    names   (n_clips,)            clip names
    starts  (n_clips + 1,)        first row of each clip
    rows    (n_rows, 35) int16    first differences down the rows (modulo 2**16) of: frame duration in 0.1 ms, pelvis
                                  x y z in 0.1 mm, then joint rotations in pi / 32767 radians in the order of JOINTS:
                                  rotation vectors, or one angle about X for a hinge
"""

from __future__ import annotations

import json
import sys
import zipfile
from pathlib import Path

import numpy as np

REPOSITORY = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(REPOSITORY))

from core.mocap import quaternions as quat  # noqa: E402

# joint, first column, number of columns in the source: 4 is a quaternion (w, x, y, z), 1 an angle about Z
JOINTS = [
    *(("Hips", 4, 4), ("Chest", 8, 4), ("Neck", 12, 4)),
    *(("RightUpLeg", 16, 4), ("RightLeg", 20, 1), ("RightFoot", 21, 4), ("RightArm", 25, 4), ("RightForeArm", 29, 1)),
    *(("LeftUpLeg", 30, 4), ("LeftLeg", 34, 1), ("LeftFoot", 35, 4), ("LeftArm", 39, 4), ("LeftForeArm", 43, 1)),
]
# clip -> (joint, frame) pairs: the joint steps between this frame and the next
STEPS = {
    "walk": [("LeftArm", 18), ("RightArm", 18), ("LeftUpLeg", 18), ("RightFoot", 18)],
    "run": [("Hips", 11)],
    "getup_facedown": [("Neck", 162)],
    "roll": [("Neck", 46), ("Neck", 58)],
}
SPREAD = 6  # frames to either side
WRAPPED = {"walk": ["RightArm"]}  # joints that step where the loop closes


def main() -> None:
    """Extract all clips; says what it wrote."""
    import pybullet_data

    files = sorted(Path(pybullet_data.getDataPath(), "data", "motions").glob("humanoid3d_*.txt"))
    names = [path.stem.removeprefix("humanoid3d_") for path in files]
    rows = [extract(name, path) for name, path in zip(names, files, strict=True)]
    target = REPOSITORY / "core" / "data" / "demo_motions.npz"
    write(target, names, rows)
    print(f"{target}: {len(names)} clips, {sum(map(len, rows))} frames, {target.stat().st_size} bytes")


def extract(name: str, path: Path) -> np.ndarray:
    """The quantised rows of one clip: (n_frames, 35) int16."""
    source = np.array(json.loads(path.read_text(encoding="utf-8"))["Frames"])
    durations = source[:, 0].copy()
    if durations[-1] <= 0:
        durations[-1] = durations[-2]
    columns = [np.round(durations * 1e4)[:, None], np.round(turn_axes(source[:, 1:4]) * 1e4)]
    for joint, first, width in JOINTS:
        values = source[:, first : first + width]
        if width == 4:
            q = quat.continuous(quat.normalise(values))
            for step_joint, frame in STEPS.get(name, []):
                if step_joint == joint:
                    q = spread_step(q, frame)
            if joint in WRAPPED.get(name, []):
                q = spread_wrap(q)
            values = turn_axes(quat.to_rotvec(q))
        else:
            values = -values
        columns.append(np.round(values / np.pi * 32767))
    return np.concatenate(columns, axis=1).astype(np.int16)


def turn_axes(vectors: np.ndarray) -> np.ndarray:
    """X forward, Z right to Z forward, X left: (..., 3)."""
    return vectors[..., [2, 1, 0]] * [-1, 1, 1]


def spread_step(q: np.ndarray, frame: int) -> np.ndarray:
    """The step of a joint ``(n, 4)`` between ``frame`` and the next, beyond its usual speed, spread over both sides."""
    between = [quat.to_rotvec(quat.multiply(quat.conjugate(q[k]), q[k + 1])) for k in range(frame - 1, frame + 2)]
    excess = between[1] - (between[0] + between[2]) / 2
    k = np.arange(len(q))
    u = np.clip((k - (frame - SPREAD)) / (2 * SPREAD + 1), 0, 1)
    share = u * u * (3 - 2 * u) - (k > frame)
    return quat.multiply(q, quat.from_rotvec(share[:, None] * excess))


def spread_wrap(q: np.ndarray) -> np.ndarray:
    """Half of the gap between the last and the first rotation of a loop ``(n, 4)`` faded in at either end."""
    gap = quat.to_rotvec(quat.multiply(quat.conjugate(q[-1]), q[0]))
    k = np.arange(len(q))
    share = 0.5 * (np.clip(1 - (len(q) - 1 - k) / SPREAD, 0, 1) ** 2 - np.clip(1 - k / SPREAD, 0, 1) ** 2)
    return quat.multiply(q, quat.from_rotvec(share[:, None] * gap))


def write(target: Path, names: list[str], clips: list[np.ndarray]) -> None:
    """An npz whose bytes depend on nothing but its content."""
    rows = np.concatenate(clips)
    arrays = {
        "names": np.array(names),
        "starts": np.cumsum([0, *map(len, clips)]).astype(np.int32),
        "rows": np.diff(rows, axis=0, prepend=np.zeros((1, rows.shape[1]), np.int16)),
    }
    target.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for key, array in arrays.items():
            entry = zipfile.ZipInfo(f"{key}.npy", (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            with archive.open(entry, "w") as file:
                np.lib.format.write_array(file, np.asfortranarray(array), allow_pickle=False)


if __name__ == "__main__":
    main()
