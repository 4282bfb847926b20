#!/usr/bin/env python3
"""How long pages of `isogloss view` take to open, and how many frames a second they draw: measure.py PAGE…

Prints for each the time and the processor seconds until it stands, and frames a second while it plays and while the view
turns, with the processor time of a frame: a machine with other work draws fewer, at the same cost each.
"""
import os
import pathlib
import sys
import time

from browser import Browser

TURN = """
window.turns = true;
const { camera, controls } = isogloss.stage, up = camera.up;
(function turn() {
  if (!window.turns) return;
  camera.position.sub(controls.target).applyAxisAngle(up, 0.01).add(controls.target);
  controls.update();
  requestAnimationFrame(turn);
})();
"""


def processor_seconds(root):
    """Of all processes below one, by their kind."""
    children, out = {}, {}
    for process in filter(str.isdigit, os.listdir("/proc")):
        try:
            fields = pathlib.Path("/proc", process, "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue
        ticks = int(fields[11]) + int(fields[12])
        children.setdefault(int(fields[1]), []).append((int(process), ticks / os.sysconf("SC_CLK_TCK")))
    waiting = [root]
    while waiting:
        for process, seconds in children.get(waiting.pop(), []):
            waiting.append(process)
            try:
                command = pathlib.Path("/proc", str(process), "cmdline").read_text()
            except OSError:
                continue
            kind = "gpu" if "type=gpu" in command else "page" if "type=renderer" in command else "other"
            out[kind] = out.get(kind, 0) + seconds
    return out


def frames(browser, what, seconds=5):
    time.sleep(1)
    count = lambda: int(browser.run("return document.getElementById('canvas').dataset.frames"))
    before, processor, begin = count(), processor_seconds(browser.driver.pid), time.monotonic()
    time.sleep(seconds)
    drawn, passed = max(1, count() - before), time.monotonic() - begin
    cost = {kind: 1000 * (value - processor.get(kind, 0)) / drawn
            for kind, value in processor_seconds(browser.driver.pid).items()}
    print(f"  {what}: {drawn / passed:.1f} frames/s; processor of a frame, ms: "
          + ", ".join(f"{kind} {value:.1f}" for kind, value in sorted(cost.items())))


def main():
    for page in sys.argv[1:]:
        with Browser(1280, 800) as browser:
            browser.open(pathlib.Path(page).resolve().as_uri(), 120)
            after = int(browser.run("return document.body.dataset.openedAfter")) / 1000
            cost = sum(processor_seconds(browser.driver.pid).values())
            print(f"{page}: {browser.run('return isogloss.paths[0].moves')} moves, {after:.1f} s to open, "
                  f"{cost:.1f} s of processor with the start of the browser")
            browser.run("isogloss.timeline.set(0); document.getElementById('speed').value = 20; isogloss.timeline.toggle()")
            frames(browser, "playing")
            browser.run("isogloss.timeline.pause(); isogloss.timeline.set(isogloss.timeline.total)")
            browser.run(TURN)
            frames(browser, "turning")
            browser.run("window.turns = false")


main()
