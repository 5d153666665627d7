"""A skeleton as motion capture has them, made up for tests: it stands with its arms out, y is up, it looks along z."""

# Joint, parent, offset in cm; left is +x.
JOINTS = (
    ("Hips", None, (0, 0, 0)), ("Spine", "Hips", (0, 10, 0)), ("Chest", "Spine", (0, 15, 0)), ("Head", "Chest", (0, 20, 0)),
    ("LeftArm", "Chest", (15, 15, 0)), ("LeftForeArm", "LeftArm", (25, 0, 0)), ("LeftHand", "LeftForeArm", (22, 0, 0)),
    ("RightArm", "Chest", (-15, 15, 0)), ("RightForeArm", "RightArm", (-25, 0, 0)), ("RightHand", "RightForeArm", (-22, 0, 0)),
    ("LeftUpLeg", "Hips", (9, -2, 0)), ("LeftLeg", "LeftUpLeg", (0, -40, 0)), ("LeftFoot", "LeftLeg", (0, -40, 0)),
    ("RightUpLeg", "Hips", (-9, -2, 0)), ("RightLeg", "RightUpLeg", (0, -40, 0)), ("RightFoot", "RightLeg", (0, -40, 0)),
)


def bvh(*frames, rename=lambda name: name, up="y", joints=JOINTS):
    """A file: each frame has turns in degrees about z, x, y by joint, and "at", the place of the hips.

    With z up the same skeleton looks along -y: (x, y, z) is written as (x, -z, y).
    """
    order = []
    rotations = "Zrotation Xrotation Yrotation" if up == "y" else "Yrotation Xrotation Zrotation"

    def place(x, y, z):
        return (x, y, z) if up == "y" else (x, -z, y)

    def turns(about_z, about_x, about_y):
        return (about_z if up == "y" else -about_z, about_x, about_y)

    def joint(name, offset, depth):
        order.append(name)
        kind = "JOINT" if depth else "ROOT"
        channels = "3 " if depth else "6 Xposition Yposition Zposition "
        yield "%s %s\n{\nOFFSET %g %g %g\n" % (kind, rename(name), *place(*offset))
        yield "CHANNELS %s%s\n" % (channels, rotations)
        children = [(child, where) for child, parent, where in joints if parent == name]
        for child, where in children:
            yield from joint(child, where, depth + 1)
        yield "}\n" if children else "End Site\n{\nOFFSET %g %g %g\n}\n}\n" % place(0, -5, 0)

    text = "HIERARCHY\n" + "".join(joint("Hips", (0, 0, 0), 0))
    rows = []
    for frame in frames:
        numbers = list(place(*frame.get("at", (0, 90, 0))))
        for name in order:
            numbers += turns(*frame.get(name, (0, 0, 0)))
        rows.append(" ".join("%.9g" % number for number in numbers))
    return text + "MOTION\nFrames: %d\nFrame Time: 0.05\n" % len(rows) + "\n".join(rows) + "\n"
