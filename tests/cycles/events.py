"""What a machine does, event by event: models and `isogloss run` are converted to events before they are compared."""
import dataclasses

AXES = "XYZ"
LENGTH = 1e-6  # mm
LINEAR = ("rapid", "feed")


@dataclasses.dataclass
class Event:
    kind: str  # rapid, feed, dwell, spindle, orient, coolant, stop, end
    line: int
    end: tuple = ()  # X Y Z in mm, of rapid and feed
    value: object = None  # feed in mm/min, dwell in s, direction of the spindle, mode of the coolant, M code of a stop
    by_hand: bool = False
    speed: object = None  # of the spindle, 1/min

    def __str__(self):
        text = self.kind
        if self.end:
            text += "".join(f" {a}{float(v):.6f}".rstrip("0").rstrip(".") for a, v in zip(AXES, self.end))
        if self.kind == "feed" and self.value is not None:
            text += f" F{float(self.value):g}"
        elif self.value is not None:
            text += f" {self.value}" if isinstance(self.value, str) else f" {float(self.value):g}"
        if self.speed is not None and self.value != "STOP":
            text += f" S{float(self.speed):g}"
        return text + (" by hand" if self.by_hand else "")


def differ(a, b):
    """How two events differ, or None."""
    if a is None or b is None:
        return "one side has an event more"
    for name in ("kind", "line", "by_hand"):
        if getattr(a, name) != getattr(b, name):
            return name
    if len(a.end) != len(b.end):
        return "end"
    for axis, one, other in zip(AXES, a.end, b.end):
        if abs(one - other) > LENGTH:
            return axis
    if a.value == "STOP" or None in (a.speed, b.speed):
        pass  # the speed means nothing, or is not said
    elif abs(a.speed - b.speed) > LENGTH:
        return "speed"
    if isinstance(a.value, str) or isinstance(b.value, str) or a.value is None or b.value is None:
        return None if a.value == b.value else "value"
    return None if abs(a.value - b.value) <= LENGTH * max(1, abs(a.value)) else "value"


def moves_only(events, at=(0, 0, 0)):
    """Without linear moves that go nowhere; the tool starts at `at`."""
    for event in events:
        if event.kind in LINEAR:
            if max(abs(p - q) for p, q in zip(at, event.end)) <= LENGTH / 10:
                continue
            at = event.end
        yield event


def settled(events):
    """Without the spindle and coolant events that repeat what is in force already, as the motion stream has it."""
    spindle, coolant = ("STOP", None), "OFF"
    for event in events:
        if event.kind == "spindle":
            before, spindle = spindle, (event.value, None if event.value == "STOP" else event.speed)
            if before == spindle:
                continue
        elif event.kind == "orient":
            spindle = ("orient", None)
        elif event.kind == "coolant":
            before, coolant = coolant, event.value
            if before == coolant:
                continue
        yield event


def from_stream(rows, work_offset=(0, 0, 0)):
    """Rows of the motion stream of `isogloss run`, read from its JSON Lines; positions are the program's."""
    for row in rows:
        kind, line = row["Event"], row["Line"]
        if kind in LINEAR:
            end = tuple(row["ProgramXyz"][a] for a in AXES)
            machine = (row["MachineCoordinate"][a] for a in AXES)
            if max(abs(m - p - o) for m, p, o in zip(machine, end, work_offset)) > LENGTH:
                raise ValueError(f"line {line}: program and machine coordinates part by more than the work offset")
            feed = row.get("Feedrate_mmds")
            yield Event(kind, line, end, None if feed is None else feed * 60, row.get("Manual", False))
        elif kind == "arc":
            raise ValueError(f"line {line}: an arc")
        elif kind == "dwell":
            yield Event(kind, line, value=row["Time"])
        elif kind == "spindle":
            yield Event(kind, line, value=row["Direction"], speed=row.get("SpindleSpeed_rpm"))
        elif kind == "orient":
            yield Event(kind, line)
        elif kind == "coolant":
            yield Event(kind, line, value=row["Mode"])
        elif kind in ("stop", "end"):
            yield Event(kind, line, value=row["Term"])
        elif kind != "tool":
            raise ValueError(f"line {line}: event {kind}")
