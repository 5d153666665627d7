"""A skeleton as motion capture has them, made up for tests: it stands with its arms out, y is up, it looks along z."""

# Joint, parent, offset in cm; left is +x.
JOINTS = (
    ("Hips", None, (0, 0, 0)), ("Spine", "Hips", (0, 10, 0)), ("Chest", "Spine", (0, 15, 0)), ("Head", "Chest", (0, 20, 0)),
    ("LeftArm", "Chest", (15, 15, 0)), ("LeftForeArm", "LeftArm", (25, 0, 0)), ("LeftHand", "LeftForeArm", (22, 0, 0)),
    ("RightArm", "Chest", (-15, 15, 0)), ("RightForeArm", "RightArm", (-25, 0, 0)), ("RightHand", "RightForeArm", (-22, 0, 0)),
    ("LeftUpLeg", "Hips", (9, -2, 0)), ("LeftLeg", "LeftUpLeg", (0, -40, 0)), ("LeftFoot", "LeftLeg", (0, -40, 0)),
    ("RightUpLeg", "Hips", (-9, -2, 0)), ("RightLeg", "RightUpLeg", (0, -40, 0)), ("RightFoot", "RightLeg", (0, -40, 0)),
)


def bvh(*frames, rename=lambda name: name):
    """A file: each frame has turns in degrees about z, x, y by joint, and "at", the place of the hips."""
    order = []

    def joint(name, offset, depth):
        order.append(name)
        kind = "JOINT" if depth else "ROOT"
        channels = "3 " if depth else "6 Xposition Yposition Zposition "
        yield "%s %s\n{\nOFFSET %g %g %g\n" % (kind, rename(name), *offset)
        yield "CHANNELS %sZrotation Xrotation Yrotation\n" % channels
        children = [(child, where) for child, parent, where in JOINTS if parent == name]
        for child, where in children:
            yield from joint(child, where, depth + 1)
        yield "}\n" if children else "End Site\n{\nOFFSET 0 -5 0\n}\n}\n"

    text = "HIERARCHY\n" + "".join(joint("Hips", (0, 0, 0), 0))
    rows = []
    for frame in frames:
        numbers = list(frame.get("at", (0, 90, 0)))
        for name in order:
            numbers += frame.get(name, (0, 0, 0))
        rows.append(" ".join("%.9g" % number for number in numbers))
    return text + "MOTION\nFrames: %d\nFrame Time: 0.05\n" % len(rows) + "\n".join(rows) + "\n"
