"""Fits an infant's joints to key points of a video (2-D, with its camera) or markers (3-D). Needs the extra [motion].

    points = mimo.motion.read_points("points.csv")
    found = mimo.motion.fit(world, points)              # a world with an infant of that age, in a plausible pose
    found.errors                                        # m or pixels: a row per frame, a column per point
    found.write("motion.csv")                           # for mimo replay --motion

    python -m mimo.motion points.csv --out motion.csv --errors errors.csv --age 6
    python -m mimo.motion video.csv --camera camera.json --out motion.csv
    python -m mimo.motion deeplabcut.csv --rate 30 --camera camera.json --out motion.csv    # or a folder of OpenPose

Each frame is a least-squares fit over the joints that move the points, within their limits, from the frame before.
Joints that the points hardly determine stay near the first pose.
"""

from __future__ import annotations

import argparse
import sys
from typing import Any, Dict, List, Literal, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._files import require_writable
from .constants import Kind, Quantity
from .errors import Error
from .frames import after, placed
from .key_points import Camera, KeyPoints, Place, places_of, read_points, write_table
from .results import Numbers
from .scene import Scene
from .world import World

try:
    from scipy.optimize import least_squares
    from scipy.signal import butter, sosfiltfilt
except ImportError as error:
    raise ImportError("fitting key points needs SciPy: pip install 'mimo[motion]'") from error

__all__ = ["Camera", "Found", "KeyPoints", "fit", "read_points"]

Loss = Literal["linear", "soft_l1", "huber", "cauchy", "arctan"]
METRES, PIXELS = 0.01, 5.0  # errors that count as 1
SMOOTHED_ROWS = 10
ROOT_PARTS = ("x", "y", "z", "qw", "qx", "qy", "qz")


class Found(NamedTuple):
    """The result of a fit: times (n,), columns of a table for `mimo replay --motion`, their values and the errors."""

    times: Numbers
    columns: List[str]  # joints; root:x ... root:qz
    positions: Numbers  # (n, columns), rad and m
    points: List[str]
    errors: Numbers  # (n, points): distance from the observed point, m or pixels; NaN for unseen points

    def smoothed(self, cutoff: float) -> "Found":
        """Low-pass filtered at `cutoff`, Hz, by a Butterworth filter of second order in both directions.

        Pose estimation is noisy, and forces follow from accelerations; gait is usually filtered at 6 Hz. `errors` stay
        the errors of the fit.
        """
        steps = np.diff(self.times)
        if len(steps) < SMOOTHED_ROWS or np.ptp(steps) > 0.01 * steps.mean():
            least = f"{SMOOTHED_ROWS + 1} rows or more in equal steps of time"
            raise ValueError(f"cutoff is {cutoff} Hz and needs {least}; there are {len(self.times)}")
        rate = 1 / steps.mean()
        if not 0 < cutoff < rate / 2:
            raise ValueError(
                f"cutoff is {cutoff} Hz, expected more than 0 and less than half of the rate, {rate / 2:g}"
            )
        positions = self.positions.copy()
        turns = np.sign(np.sum(positions[1:, 3:7] * positions[:-1, 3:7], axis=1))  # q and -q are one orientation
        positions[1:, 3:7] *= np.cumprod(turns)[:, None]
        positions = sosfiltfilt(butter(2, cutoff, fs=rate, output="sos"), positions, axis=0)
        positions[:, 3:7] /= np.linalg.norm(positions[:, 3:7], axis=1, keepdims=True)
        return self._replace(positions=positions)

    def write(self, path: str) -> None:
        """A table for `mimo replay --motion`."""
        write_table(path, ["time", *self.columns], np.column_stack([self.times, self.positions]))

    def write_errors(self, path: str) -> None:
        """A row per frame, a column per point."""
        write_table(path, ["time", *self.points], np.column_stack([self.times, self.errors]))


def fit(
    world: World,
    points: KeyPoints,
    camera: Optional[Camera] = None,
    places: Optional[Dict[str, Place]] = None,
    stiffness: float = 0.1,
    loss: Loss = "linear",
    agent: int = 0,
) -> Found:
    """Fits joint angles and the pose of the body, frame after frame.

    It moves the world's infant, whose first pose is the initial guess and the value of everything that no point
    determines. `places` defines key points: {"sock": ("left_foot", (0.03, 0, 0))}, m, in the body's frame. `stiffness`
    is the cost of a radian from the first pose, where an error of 1 cm or 5 pixels costs 1. `loss` is SciPy's:
    "soft_l1" gives outliers less weight.
    """
    if points.values.shape[2] == 2 and camera is None:
        raise ValueError("the points are pixels, and camera is None, expected a mimo.motion.Camera")
    if points.values.shape[2] == 3 and camera is not None:
        raise ValueError("the points are in m (:x, :y, :z), and camera is given, expected pixels or no camera")
    if not stiffness > 0:
        raise ValueError(f"stiffness is {stiffness}, expected a number above 0")
    chain = _Chain(world, agent, *places_of(world, points.names, places or {}, agent))
    rows, errors = [], []
    state = chain.state()
    for row in range(len(points.times)):
        frame = _Frame(chain, points.values[row], points.weights[row], camera, stiffness, loss)
        state = frame.first(state) if row == 0 else frame.solve(state)
        rows.append(state)
        errors.append(frame.errors(state))
    return Found(points.times, chain.columns, np.array(rows), points.names, np.array(errors))


class _Chain:
    """The joints that move the points. A state is the root's position, its quaternion, and the hinges' angles."""

    def __init__(self, world: World, agent: int, bodies: List[int], offsets: Numbers) -> None:
        self.world, self.bodies, self.offsets = world, bodies, offsets
        self.all = list(range(1, world.count(Kind.BODY)))
        self.parents = dict(enumerate(world.bodies().body_ids.tolist()))
        ways = {body: self._way(body) for body in set(bodies)}
        on_way = set().union(*ways.values())
        self.root, self.hinges, self.owners = -1, [], []
        for joint, owner in enumerate(world.joints().body_ids.tolist()):
            if owner not in on_way:
                continue
            width = world.get(Quantity.JOINT_POSITION, [joint]).size
            if width == 1:
                self.hinges.append(joint)
                self.owners.append(owner)
            elif width == 7:
                self.root, self.root_body = joint, owner
        if self.root < 0:
            raise ValueError("the infant has no free joint; key points are fitted to infants that move freely")
        self.rest = world.get(Quantity.JOINT_POSITION, self.hinges).ravel()
        self.moves = np.array([[owner in ways[body] for owner in self.owners] for body in bodies])
        self.limits = world.get(Quantity.JOINT_RANGE, self.hinges).reshape(-1, 2)
        turns = [self.owners[: place + 1].count(owner) - 1 for place, owner in enumerate(self.owners)]
        self.rounds = [[i for i, turn in enumerate(turns) if turn == n] for n in range(max(turns, default=-1) + 1)]
        names = [world.name(Kind.JOINT, hinge) for hinge in self.hinges]
        label = world.name(Kind.JOINT, self.root) or f"free:{world.name(Kind.BODY, self.root_body)}"
        self.columns = [f"{label}:{part}" for part in ROOT_PARTS] + names

    def _way(self, body: int) -> List[int]:
        way = []
        while body != 0:
            way.append(body)
            body = self.parents[body]
        return way

    def state(self) -> Numbers:
        root = self.world.get(Quantity.JOINT_POSITION, [self.root]).ravel()
        return np.concatenate([root, self.world.get(Quantity.JOINT_POSITION, self.hinges).ravel()])

    def moved(self, state: Numbers, by: Numbers) -> Numbers:
        """The state after a translation, a rotation in the world's frame, and changes of angles."""
        angle = np.linalg.norm(by[3:6])
        half = np.concatenate([[np.cos(angle / 2)], 0.5 * np.sinc(angle / (2 * np.pi)) * by[3:6]])
        root = after(half, state[3:7])[0]
        return np.concatenate([state[:3] + by[:3], root / np.linalg.norm(root), state[7:] + by[6:]])

    def put(self, state: Numbers) -> Numbers:
        """The points in a state, (k, 3)."""
        self.world.set(Quantity.JOINT_POSITION, state[:7], [self.root])
        self.world.set(Quantity.JOINT_POSITION, state[7:], self.hinges)
        pose = self.world.get(Quantity.BODY_POSE, self.bodies, now=True)
        return placed(pose[:, :3], pose[:, 3:], self.offsets)

    def slopes(self, at: Numbers) -> Numbers:
        """Derivatives of the points by translation, rotation and hinges: (k, 3, 6 + hinges), in the state of `put`."""
        axes, anchors = self._axes()
        result = np.zeros((len(at), 3, 6 + len(self.hinges)))
        result[:, :, :3] = np.eye(3)
        root = self.world.get(Quantity.BODY_POSITION, [self.root_body], now=True)[0]
        result[:, :, 3:6] = np.cross(np.eye(3)[None], (at - root)[:, None]).transpose(0, 2, 1)
        turns = np.cross(axes[None], at[:, None] - anchors[None]) * self.moves[:, :, None]
        result[:, :, 6:] = turns.transpose(0, 2, 1)
        return result

    def _axes(self) -> Tuple[Numbers, Numbers]:
        """Axis and a point of each hinge.

        Hinges of one body are turned one after the other, so that each shows in the body's motion.
        """
        axes, anchors = np.zeros((len(self.hinges), 3)), np.zeros((len(self.hinges), 3))
        place = np.vstack([np.zeros(3), self.world.get(Quantity.BODY_POSITION, self.all, now=True)])
        for some in self.rounds:
            speeds = np.zeros(len(self.hinges))
            speeds[some] = 1
            self.world.set(Quantity.JOINT_VELOCITY, np.zeros(6), [self.root])
            self.world.set(Quantity.JOINT_VELOCITY, speeds, self.hinges)
            velocity = np.vstack([np.zeros(6), self.world.get(Quantity.BODY_VELOCITY, self.all, now=True)])
            for i in some:
                body, parent = self.owners[i], self.parents[self.owners[i]]
                carried = velocity[parent, :3] + np.cross(velocity[parent, 3:], place[body] - place[parent])
                axes[i] = velocity[body, 3:] - velocity[parent, 3:]
                anchors[i] = place[body] - np.cross(velocity[body, :3] - carried, axes[i])
        self.world.set(Quantity.JOINT_VELOCITY, np.zeros(len(self.hinges)), self.hinges)
        return axes, anchors


class _Frame:
    """A row of the table."""

    def __init__(
        self, chain: _Chain, seen: Numbers, weights: Numbers, camera: Optional[Camera], stiffness: float, loss: Loss
    ) -> None:
        self.chain, self.camera, self.stiffness, self.loss = chain, camera, stiffness, loss
        self.which = np.flatnonzero(weights > 0)
        self.seen, self.all_seen = seen[self.which], seen
        unit = METRES if seen.shape[1] == 3 else PIXELS
        self.scale = np.sqrt(weights[self.which])[:, None] / unit

    def first(self, start: Numbers) -> Numbers:
        """Fits the pose of the whole body first, from four sides, because a fit rarely finds its heading."""
        found = []
        for quarter in range(4):
            turn = np.zeros(len(start) - 1)
            turn[5] = quarter * np.pi / 2
            found.append(self._solve(self.chain.moved(start, turn), rigid=True))
        return self.solve(min(found, key=self._cost))

    def solve(self, start: Numbers) -> Numbers:
        return self._solve(start, rigid=False)

    def errors(self, state: Numbers) -> Numbers:
        return np.asarray(np.linalg.norm(self._project(self.chain.put(state)) - self.all_seen, axis=1))

    def _cost(self, state: Numbers) -> float:
        return float(np.nansum(self.errors(state) ** 2))

    def _project(self, at: Numbers) -> Numbers:
        return at if self.camera is None else self.camera.project(at)

    def _solve(self, start: Numbers, rigid: bool) -> Numbers:
        free = 6 if rigid else len(start) - 1
        low, high = np.full(free, -np.inf), np.full(free, np.inf)
        if not rigid:
            inside = np.clip(start[7:], *self.chain.limits.T)
            start = np.concatenate([start[:7], inside])
            low[6:], high[6:] = (self.chain.limits - inside[:, None]).T
            low, high = low - 1e-9, high + 1e-9  # a start on a limit is within

        rest = np.concatenate([np.zeros(6), self.chain.rest - start[7:]])[:free]

        def whole(by: Numbers) -> Numbers:
            return np.concatenate([by, np.zeros(len(start) - 1 - free)])

        def residuals(by: Numbers) -> Numbers:
            at = self._project(self.chain.put(self.chain.moved(start, whole(by))))[self.which]
            return np.concatenate([(self.scale * (at - self.seen)).ravel(), self.stiffness * (by - rest)])

        def slopes(by: Numbers) -> Numbers:
            at = self.chain.put(self.chain.moved(start, whole(by)))
            by_points = self.chain.slopes(at)[self.which][:, :, :free]
            by_points[:, :, 3:6] = by_points[:, :, 3:6] @ _turning(by[3:6])
            if self.camera is not None:
                by_points = self.camera.slopes(at)[self.which] @ by_points
            return np.vstack([(self.scale[:, :, None] * by_points).reshape(-1, free), self.stiffness * np.eye(free)])

        result = least_squares(
            residuals,
            np.zeros(free),
            slopes,
            (low, high),
            loss=self.loss,
            xtol=1e-10,
            ftol=1e-10,
            gtol=1e-10,
            max_nfev=100,
        )
        return self.chain.moved(start, whole(result.x))


def _turning(turn: Numbers) -> Numbers:
    """What a change of a turn (axis times angle) turns by, in the world's frame: the left Jacobian of rotations."""
    angle = np.linalg.norm(turn)
    x, y, z = turn
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    if angle < 1e-6:
        return np.asarray(np.eye(3) + cross / 2)
    first, second = (1 - np.cos(angle)) / angle**2, (angle - np.sin(angle)) / angle**3
    return np.asarray(np.eye(3) + first * cross + second * cross @ cross)


def _report(found: Found, unit: str, factor: float) -> str:
    lines = [f"{len(found.times)} rows", f"{'point':24} {'median':>10} {'largest':>10}  {unit}"]
    for name, errors in zip(found.points, found.errors.T):
        known = errors[np.isfinite(errors)] * factor
        text = f"{np.median(known):10.3g} {known.max():10.3g}" if len(known) else f"{'never seen':>21}"
        lines.append(f"{name:24} {text}")
    return "\n".join(lines)


def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m mimo.motion", description=(__doc__ or "").splitlines()[0])
    told = "time, NAME:x, NAME:y, NAME:z or NAME:u, NAME:v, NAME:w"
    parser.add_argument("points", help=f"table of key points: {told}; or of DeepLabCut; or a folder of OpenPose")
    parser.add_argument("--rate", type=float, help="frames a second, of DeepLabCut and OpenPose")
    parser.add_argument("--out", required=True, help="joints, a table for mimo replay --motion")
    parser.add_argument("--errors", help="how far each point is from where it was seen, a table")
    parser.add_argument("--camera", help="JSON: matrix, or fovy, width, height, position and look_at")
    parser.add_argument("--scene", default="free", help="a built-in scene with the infant's first pose (free)")
    parser.add_argument("--age", type=float, help="months (18)")
    parser.add_argument("--cutoff", type=float, help="Hz: filter the joints over time; 6 is usual")
    parser.add_argument("--robust", action="store_true", help="believe points less that are far off")
    options = parser.parse_args(arguments)
    try:
        for path in filter(None, (options.out, options.errors)):
            require_writable(path)  # before the work, not after it
        points = read_points(options.points, options.rate)
        camera = Camera.read(options.camera) if options.camera else None
        scene = Scene(options.scene)
        growth: Dict[str, Any] = {} if options.age is None else {"age": options.age}
        scene.add_agent(vision=False, touch=False, **growth)
        with World(scene) as world:
            world.reset(seed=0)
            found = fit(world, points, camera, loss="soft_l1" if options.robust else "linear")
        if options.cutoff is not None:
            found = found.smoothed(options.cutoff)
        found.write(options.out)
        if options.errors:
            found.write_errors(options.errors)
    except (Error, ValueError, OSError) as error:
        print(f"mimo.motion: {error}", file=sys.stderr)
        return 1
    flat = points.values.shape[2] == 2
    print(_report(found, "pixels" if flat else "mm", 1 if flat else 1000))
    if points.left_out:
        print(f"no places on the infant: {', '.join(points.left_out)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
