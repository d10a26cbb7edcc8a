"""A second opinion on joint positions: plain parsers and 4x4 matrices, slow, sharing nothing with the readers."""

from __future__ import annotations

import gzip
import math
from pathlib import Path

import numpy as np


def turn(axis: str, degrees: float) -> np.ndarray:
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    m = np.eye(4)
    i, j = {"X": (1, 2), "Y": (2, 0), "Z": (0, 1)}[axis]
    m[i, i], m[i, j], m[j, i], m[j, j] = c, -s, s, c
    return m


def shift(x: float, y: float, z: float) -> np.ndarray:
    m = np.eye(4)
    m[:3, 3] = x, y, z
    return m


def text_of(path: Path) -> str:
    data = gzip.decompress(path.read_bytes()) if path.suffix == ".gz" else path.read_bytes()
    return data.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")


def bvh_positions(path: Path, frames: list[int]) -> dict[str, np.ndarray]:
    """Joint name -> (len(frames), 3) world positions in file units; an end site is ``<parent>_end``."""
    words = text_of(path).split()
    start = words.index("MOTION")
    joints, stack, columns, i = [], [], 0, 1
    while i < start:
        word = words[i]
        if word in ("ROOT", "JOINT"):
            joints.append({"name": words[i + 1], "parent": stack[-1] if stack else None, "channels": [], "first": 0})
            i += 1
        elif word == "End":
            joints.append({"name": joints[stack[-1]]["name"] + "_end", "parent": stack[-1], "channels": [], "first": 0})
            i += 1
        elif word == "{":
            stack.append(len(joints) - 1)
        elif word == "}":
            stack.pop()
        elif word == "OFFSET":
            joints[stack[-1]]["offset"] = [float(w) for w in words[i + 1 : i + 4]]
            i += 3
        elif word == "CHANNELS":
            n = int(words[i + 1])
            joints[stack[-1]].update(channels=words[i + 2 : i + 2 + n], first=columns)
            columns += n
            i += 1 + n
        i += 1
    table = np.array([float(w) for w in words[start + 6 :]]).reshape(-1, columns)
    result = {joint["name"]: [] for joint in joints}
    for frame in frames:
        world = []
        for joint in joints:
            place, rotation = list(joint["offset"]), np.eye(4)
            for k, channel in enumerate(joint["channels"]):
                value = table[frame, joint["first"] + k]
                if channel.endswith("position"):
                    place["XYZ".index(channel[0])] = value
                else:
                    rotation = rotation @ turn(channel[0], value)
            local = shift(*place) @ rotation
            world.append(local if joint["parent"] is None else world[joint["parent"]] @ local)
            result[joint["name"]].append(world[-1][:3, 3])
    return {name: np.array(rows) for name, rows in result.items()}


def asf(path: Path) -> tuple[dict, dict, float]:
    """Bones (name -> direction, length, axis, dof), parent of each, and metres per unit, of a CMU skeleton."""
    bones, parents, unit, section, bone = {}, {}, 1.0, "", {}
    for line in text_of(path).split("\n"):
        words = line.split()
        if not words:
            continue
        if words[0].startswith(":"):
            section = words[0]
        elif section == ":units" and words[0] == "length":
            unit = 0.0254 / float(words[1])
        elif section == ":bonedata":
            if words[0] == "begin":
                bone = {"dof": []}
            elif words[0] == "name":
                bones[words[1]] = bone
            elif words[0] in ("direction", "length", "axis"):
                bone[words[0]] = np.array([float(w) for w in words[1:4]])
            elif words[0] == "dof":
                bone["dof"] = words[1:]
        elif section == ":hierarchy" and len(words) > 1:
            parents.update({child: words[0] for child in words[1:]})
    return bones, parents, unit


def amc_positions(amc_path: Path, asf_path: Path, frames: list[int]) -> dict[str, np.ndarray]:
    """END of every bone (and "root") -> (len(frames), 3) world positions, metres."""
    bones, parents, unit = asf(asf_path)
    motion, values = [], {}
    for line in text_of(amc_path).split("\n"):
        words = line.split()
        if not words or words[0][0] in "#:":
            continue
        if words[0].isdigit():
            values = {}
            motion.append(values)
        else:
            values[words[0]] = [float(w) for w in words[1:]]

    def zyx(x: float, y: float, z: float) -> np.ndarray:
        return turn("Z", z) @ turn("Y", y) @ turn("X", x)

    result = {name: [] for name in ["root", *bones]}
    for frame in frames:
        values = motion[frame]
        world = {"root": shift(*values["root"][:3]) @ zyx(*values["root"][3:])}

        def place(name: str, values=values, world=world) -> np.ndarray:
            if name not in world:
                bone = bones[name]
                given = dict(zip(bone["dof"], values.get(name, []), strict=True))
                c = zyx(*bone["axis"])
                local = c @ zyx(*(given.get(d, 0.0) for d in ("rx", "ry", "rz"))) @ np.linalg.inv(c)
                world[name] = place(parents[name]) @ local @ shift(*(bone["direction"] * bone["length"]))
            return world[name]

        for name in result:
            result[name].append(place(name)[:3, 3] * unit)
    return {name: np.array(rows) for name, rows in result.items()}
