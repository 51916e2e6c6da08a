#!/usr/bin/env python3
"""Makes the motions in assets/motions: BVH files for the skeleton of mannequin_male_40.glb.

Usage: make_motions.py [BODY.glb [FOLDER]]

Each motion is a few key poses; between them every angle follows a smooth curve. Frame 0 is the pose the mannequins are
stored in, all angles 0; within the first half second it passes into the motion, which then repeats itself. The rest of
the conventions stand in assets/motions/README.md.
"""

import json
import math
import os
import struct
import sys

FRAMES_PER_SECOND = 30
BLEND_FRAMES = 15
HANG = -25.0  # how arms are raised from the stored 43 degrees below the horizontal, in degrees

# Sagittal angles in degrees over one stride, from heel strike to heel strike: (percent, angle). Drawn by eye after the
# form that these curves have in the literature (as Winter 1991, "The Biomechanics and Motor Control of Human Gait"), not
# copied from a measurement. Flexion is positive, of the ankle dorsiflexion.
HIP = [(0, 27), (10, 24), (20, 16), (30, 6), (40, -3), (50, -10), (60, -5), (70, 10), (80, 23), (90, 28)]
KNEE = [(0, 5), (8, 14), (15, 18), (25, 13), (40, 5), (50, 10), (60, 36), (70, 58), (76, 57), (84, 34), (92, 8)]
ANKLE = [(0, 0), (7, -6), (15, 0), (30, 6), (45, 10), (54, 3), (62, -16), (70, -9), (80, 0), (90, 2)]


def axis_turn(axis, degrees):
    """The matrix of a turn about an axis of any length."""
    length = math.hypot(*axis)
    x, y, z = (a / length for a in axis)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    t = 1 - c
    return ((t * x * x + c, t * x * y - s * z, t * x * z + s * y), (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
            (t * x * z - s * y, t * y * z + s * x, t * z * z + c))


def times(a, b):
    return tuple(tuple(sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)) for i in range(3))


def apply(a, v):
    return tuple(sum(a[i][k] * v[k] for k in range(3)) for i in range(3))


def bvh_angles(r):
    """Degrees about z, x, y with r = Rz Rx Ry."""
    x = math.asin(max(-1.0, min(1.0, r[2][1])))
    return tuple(math.degrees(a) for a in (math.atan2(-r[0][1], r[1][1]), x, math.atan2(-r[2][0], r[2][2])))


def curve(keys, period, time):
    """The value of a periodic cubic curve through (time, value); its slope at a key is that of its neighbours."""
    time %= period
    count = len(keys)
    i = max((k for k in range(count) if keys[k][0] <= time), default=count - 1)

    def key(n):
        return keys[n % count][0] + period * (n // count), keys[n % count][1]

    def slope(n):
        (t0, v0), (t1, v1) = key(n - 1), key(n + 1)
        return (v1 - v0) / (t1 - t0)

    (t0, v0), (t1, v1) = key(i), key(i + 1)
    step = t1 - t0
    s = (time - t0) / step
    end = s * s * (3 - 2 * s)
    return (v0 + end * (v1 - v0) + step * (s * (1 - s) ** 2 * slope(i) - s * s * (1 - s) * slope(i + 1)))


class Skeleton:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        nodes = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])["nodes"]
        self.children = {n["name"]: [nodes[c]["name"] for c in n.get("children", [])] for n in nodes}
        self.offset = {n["name"]: tuple(n.get("translation", (0, 0, 0))) for n in nodes}

    def place(self, turns, chain):
        """Where the last joint of a chain from the root is, if the root stays."""
        turn, at = axis_turn((0, 1, 0), 0), (0.0, 0.0, 0.0)
        for name in chain:
            at = tuple(a + b for a, b in zip(at, apply(turn, self.offset[name])))
            turn = times(turn, turns.get(name, axis_turn((0, 1, 0), 0)))
        return at


AXES = {  # right-handed; of the left side or the middle, z to be mirrored for the right and y as well
    "forward": (-1, 0, 0),  # of a limb that hangs, or the toes up
    "bow": (1, 0, 0),  # of the trunk; of a limb that hangs: back
    "raise": (0, 0, 1),  # of an arm; of the trunk: to the right
    "turn": (0, 1, 0),  # of the trunk: to the left; of an arm that points to the side: back
    "bend": (-0.682, -0.7314, 0),  # of the lower arm, across the direction it is stored in
}


def turns_of(angles):
    """Turns of joints from {"Joint.kind": degrees}; of two at a joint the later one is done first."""
    turns = {}
    for name, degrees in angles.items():
        joint, kind = name.split(".")
        x, y, z = AXES[kind]
        mirror = -1 if joint.startswith("Right") else 1
        turns[joint] = times(turns.get(joint, axis_turn((0, 1, 0), 0)), axis_turn((x, mirror * y, mirror * z), degrees))
    return turns


def both(**angles):
    """Arm_raise=10 means LeftArm.raise and RightArm.raise."""
    return {side + name.replace("_", "."): value for name, value in angles.items() for side in ("Left", "Right")}


def from_poses(period, poses):
    """Angles of a time from [(time, {"Joint.kind": degrees})]; what a pose does not name is 0 there."""
    names = list(dict.fromkeys(name for _, pose in poses for name in pose))
    keys = {name: [(time, pose.get(name, 0.0)) for time, pose in poses] for name in names}
    return lambda time: {name: curve(keys[name], period, time) for name in names}


def stand(time):
    breath = 0.5 - 0.5 * math.cos(2 * math.pi * time / 3.5)
    return {**both(Shoulder_raise=1.5 * breath, Arm_raise=HANG - 1.2 * breath, ForeArm_bend=10.0), "Spine1.bow": 0.6 * breath,
            "Spine2.bow": -1.8 * breath, "Neck.bow": 1.0 * breath}


def walk(time):
    angles = {}
    percent = 100.0 * time / WALK_S
    for side, ahead in (("Left", 0.0), ("Right", 50.0)):
        hip, knee, ankle = (curve(keys, 100.0, percent + ahead) for keys in (HIP, KNEE, ANKLE))
        # The arm is farthest ahead when the other leg's heel strikes.
        swing = -math.cos(2 * math.pi * (percent + ahead - 4.0) / 100.0)
        angles.update({f"{side}UpLeg.forward": hip - 3.0, f"{side}Leg.bow": knee, f"{side}Foot.forward": ankle,
                       f"{side}Arm.forward": 3.0 + 15.0 * swing, f"{side}Arm.raise": HANG + 3.0,
                       f"{side}ForeArm.bend": 22.0 + 8.0 * swing})
    turn = 4.0 * math.cos(2 * math.pi * percent / 100.0)
    drop = 3.0 * math.sin(2 * math.pi * (percent - 4.0) / 100.0)
    angles.update({"Hips.turn": -turn, "Spine.turn": turn, "Spine1.turn": 0.6 * turn, "Spine2.turn": 0.6 * turn,
                   "Neck.turn": -0.6 * turn, "Head.turn": -0.6 * turn, "Hips.raise": drop, "Spine.raise": -0.6 * drop,
                   "Spine1.raise": -0.4 * drop, "LeftUpLeg.raise": -drop, "RightUpLeg.raise": drop, "Spine.bow": 2.0})
    return angles


WALK_S = 1.1
HANGING = both(Arm_raise=HANG, ForeArm_bend=10.0)
RAISED = both(Shoulder_raise=20.0, Arm_raise=68.0, ForeArm_bend=5.0)
SEATED = {**both(UpLeg_forward=80.0, Leg_bow=90.0, Arm_forward=28.0, Arm_raise=HANG + 5.0, ForeArm_bend=40.0,
                 ForeArm_turn=-25.0),
          "Hips.bow": -10.0, "Spine.bow": 7.0, "Spine1.bow": 4.0}
RISING = {**both(UpLeg_forward=68.0, Leg_bow=62.0, Foot_forward=12.0, Arm_forward=30.0, Arm_raise=HANG + 5.0,
                 ForeArm_bend=30.0), "Hips.bow": 18.0, "Spine.bow": 12.0, "Spine1.bow": 6.0, "Neck.bow": -14.0}
REACHING = {"RightShoulder.raise": 3.0, "RightArm.turn": -55.0, "RightArm.raise": 42.0, "RightForeArm.bend": 8.0,
            "LeftArm.forward": -8.0, "LeftArm.raise": HANG, "LeftForeArm.bend": 14.0, "Spine.turn": 6.0, "Spine1.turn": 7.0,
            "Spine2.turn": 7.0, "Spine.bow": 5.0, "Spine1.bow": 4.0, "Neck.turn": -8.0, "Head.bow": -6.0}


def twisted(degrees):
    return {**both(Arm_raise=-12.0, ForeArm_bend=20.0), "Spine.turn": 0.3 * degrees, "Spine1.turn": 0.35 * degrees,
            "Spine2.turn": 0.35 * degrees, "Neck.turn": -0.1 * degrees, "Head.turn": -0.1 * degrees}


# Seconds of one repetition, how many of them, angles of a time, and whether feet stay where they are.
MOTIONS = {
    "stand": (3.5, 1, stand, False),
    "walk": (WALK_S, 3, walk, False),
    "raise_arms": (4.0, 1, from_poses(4.0, [(0.0, HANGING), (1.7, RAISED), (2.3, RAISED)]), False),
    "reach": (4.0, 1, from_poses(4.0, [(0.0, HANGING), (1.6, REACHING), (2.3, REACHING)]), False),
    "twist": (4.0, 1, from_poses(4.0, [(0.0, twisted(0.0)), (1.0, twisted(40.0)), (2.0, twisted(0.0)),
                                       (3.0, twisted(-40.0))]), False),
    "sit": (5.0, 1, from_poses(5.0, [(0.0, HANGING), (0.9, RISING), (1.8, SEATED), (3.2, SEATED), (4.1, RISING)]), True),
}


def root_of(skeleton, turns, feet_stay):
    """Where the hips are: so that the lower foot is on the floor, and the left one where it was if it is to stay."""
    rest = skeleton.offset["Hips"]
    if not feet_stay and not any(name.endswith("UpLeg") for name in turns):
        return rest
    lowest = []
    for side in ("Left", "Right"):
        leg = ["Hips"] + [side + name for name in ("UpLeg", "Leg", "Foot")]
        moved = tuple(skeleton.place(turns, leg)[k] - skeleton.place({}, leg)[k] for k in range(3))
        if feet_stay:
            return tuple(rest[k] - moved[k] for k in range(3))
        lowest.append(moved[1])
    return rest[0], rest[1] - smooth_min(lowest[0], lowest[1], 0.03) + smooth_min(0.0, 0.0, 0.03), rest[2]


def smooth_min(a, b, width):
    h = max(width - abs(a - b), 0.0) / width
    return min(a, b) - h ** 3 * width / 6


def frames_of(skeleton, motion):
    """For every frame the place of the hips and the turns of the joints."""
    period, repetitions, angles_at, feet_stay = motion
    count = BLEND_FRAMES + round(period * repetitions * FRAMES_PER_SECOND)
    for frame in range(count + 1):
        s = min(frame / BLEND_FRAMES, 1.0)
        share = s * s * (3 - 2 * s)
        time = (frame - BLEND_FRAMES) / FRAMES_PER_SECOND
        angles = {name: share * value for name, value in angles_at(time % period).items()}
        if feet_stay:  # soles stay flat
            for side in ("Left", "Right"):
                angles[side + "Foot.forward"] = (angles[side + "Leg.bow"] - angles[side + "UpLeg.forward"]
                                                 + angles["Hips.bow"])
        turns = turns_of(angles)
        yield root_of(skeleton, turns, feet_stay), turns


def hierarchy(skeleton, name, indent, order):
    order.append(name)
    is_root = not indent
    # The root's own place is all in its channels.
    offset = (0.0, 0.0, 0.0) if is_root else skeleton.offset[name]
    position = "Xposition Yposition Zposition " if is_root else ""
    lines = [indent + ("ROOT " if is_root else "JOINT ") + name, indent + "{",
             indent + "\tOFFSET " + " ".join(f"{v:.6f}" for v in offset),
             indent + f"\tCHANNELS {6 if is_root else 3} {position}Zrotation Xrotation Yrotation"]
    for child in skeleton.children[name]:
        lines += hierarchy(skeleton, child, indent + "\t", order)
    if not skeleton.children[name]:
        tip = {"Head": (0, 0.2, 0), "LeftHand": (0.14, -0.13, 0), "RightHand": (-0.14, -0.13, 0)}.get(name, (0, 0, 0.07))
        lines += [indent + "\tEnd Site", indent + "\t{", indent + "\t\tOFFSET " + " ".join(f"{v:.6f}" for v in tip),
                  indent + "\t}"]
    return lines + [indent + "}"]


def bvh(skeleton, motion):
    order = []
    lines = ["HIERARCHY"] + hierarchy(skeleton, "Hips", "", order)
    frames = list(frames_of(skeleton, motion))
    lines += ["MOTION", f"Frames: {len(frames)}", f"Frame Time: {1 / FRAMES_PER_SECOND:.7f}"]
    still = axis_turn((0, 1, 0), 0)
    for root, turns in frames:
        angles = [a for name in order for a in bvh_angles(turns.get(name, still))]
        # Adding 0 turns -0 into 0.
        lines.append(" ".join([f"{v:.5f}" for v in root] + [f"{round(a, 3) + 0.0:.3f}" for a in angles]))
    return "\n".join(lines) + "\n"


def main(arguments):
    assets = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
    body = arguments[0] if arguments else os.path.join(assets, "bodies", "mannequin_male_40.glb")
    folder = arguments[1] if len(arguments) > 1 else os.path.join(assets, "motions")
    skeleton = Skeleton(body)
    os.makedirs(folder, exist_ok=True)
    for name, motion in MOTIONS.items():
        path = os.path.join(folder, name + ".bvh")
        with open(path + ".part", "w", encoding="ascii", newline="\n") as file:
            file.write(bvh(skeleton, motion))
        os.replace(path + ".part", path)
        print(path)


if __name__ == "__main__":
    main(sys.argv[1:])
