#!/usr/bin/env python3
"""`isogloss batch --slurm` on a real Slurm of this machine alone: controller and node run as this user, on free ports.

  slurm_test.py --isogloss PATH [--programs N] [unittest's own options]

Skipped where slurmctld, slurmd or sbatch is missing, or where they do not start (in some containers).
"""
import argparse
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

OPTIONS = None
RESULTS = ("results.jsonl", "results.csv", "results.xml", "overview.html")
TOOLS = ("slurmctld", "slurmd", "sbatch", "squeue", "scontrol")
MOST_SECONDS = 15  # of a program that takes less
PATIENCE = 90  # seconds; the controller looks at its jobs now and then
PATH = f"{os.environ['PATH']}:/usr/sbin:/sbin"
CONFIGURATION = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/node.pid
SlurmctldLogFile={folder}/controller.log
SlurmdLogFile={folder}/node.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,bf_interval=1
ReturnToService=2
MailProg=/bin/true
JobCompType=jobcomp/none
AccountingStorageType=accounting_storage/none
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def until(condition, what):
    deadline = time.monotonic() + PATIENCE
    while not (found := condition()):
        if time.monotonic() > deadline:
            raise AssertionError(f"{what}: not within {PATIENCE} s")
        time.sleep(0.05)
    return found


class Cluster:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        file = self.folder / "slurm.conf"
        file.write_text(CONFIGURATION.format(host=socket.gethostname().split(".")[0], user=getpass.getuser(),
                                             ports=free_ports(2), folder=folder))
        self.environment = {**os.environ, "SLURM_CONF": str(file), "PATH": PATH}
        self.processes = [self.start("slurmctld", "-D", "-c"), self.start("slurmd", "-D")]
        self.waiting = {}  # since when jobs wait for their time

    def start(self, *command):
        return subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                start_new_session=True)

    def ask(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, timeout=60)

    def is_up(self):
        return "idle" in self.ask("sinfo", "-h", "-o", "%t").stdout

    def lose_node(self):
        """The node and all that runs on it is gone at once; the controller is told, and the node comes back."""
        node = self.processes.pop()
        node.kill()
        node.wait()
        # What slurmd has just forked becomes a slurmstepd after its end: one that outlives its part would tell the controller
        # that the part has failed, which no lost node does. So the parts end last.
        quiet_since = time.monotonic()
        while time.monotonic() - quiet_since < 0.5:
            if self.kill(self.found("slurmstepd") + self.found("slurmd", "-D")):
                quiet_since = time.monotonic()
            time.sleep(0.02)
        while self.kill(self.workers()):
            time.sleep(0.02)
        name = socket.gethostname().split(".")[0]
        self.ask("scontrol", "update", f"NodeName={name}", "State=DOWN", "Reason=lost")
        self.processes.append(self.start("slurmd", "-D"))
        self.ask("scontrol", "update", f"NodeName={name}", "State=RESUME")

    @staticmethod
    def kill(processes):
        """How many of them were there to be killed."""
        count = 0
        for process in processes:
            try:
                os.kill(process, signal.SIGKILL)
                count += 1
            except (ProcessLookupError, PermissionError):
                pass
        return count

    @staticmethod
    def found(*words):
        out = []
        for entry in pathlib.Path("/proc").iterdir():
            try:
                given = (entry / "cmdline").read_bytes().split(b"\0")
            except OSError:
                continue
            if all(any(word.encode() in g for g in given) for word in words):
                out.append(int(entry.name))
        return out

    def workers(self):
        """The processes that run a part, not those of its programs."""
        return [p for p in self.found("--shard", str(self.folder)) if p not in self.found("--work", str(self.folder))]

    def hurry(self):
        """A job that was requeued waits for two minutes otherwise, and one that the node refused is held until somebody
        releases it. Two seconds it needs: a node counts those in which the credential of a job was revoked, and refuses
        the job when it begins in the same one."""
        for line in self.ask("squeue", "-h", "-t", "PD", "-o", "%A %r").stdout.splitlines():
            job, reason = line.split(" ", 1)
            is_held = reason.endswith("held")
            if not is_held and reason != "BeginTime":
                continue
            if time.monotonic() - self.waiting.setdefault(job, time.monotonic()) > 2:
                del self.waiting[job]
                self.ask("scontrol", *(["release", job] if is_held else ["update", f"JobId={job}", "StartTime=now"]))

    def stop(self):
        for process in reversed(self.processes):
            process.terminate()
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


@unittest.skipIf(any(shutil.which(tool, path=PATH) is None for tool in TOOLS), "Slurm is not installed")
class Slurm(unittest.TestCase):
    def setUp(self):
        self.start_anew()

    def start_anew(self):
        """A cluster and an archive, and what one process makes of it."""
        self.doCleanups()
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.cluster = Cluster(folder.name)
        self.addCleanup(self.cluster.stop)
        deadline = time.monotonic() + 30
        while not self.cluster.is_up():
            if time.monotonic() > deadline:
                self.skipTest("Slurm does not start here: " + (self.path / "controller.log").read_text()[-500:])
            time.sleep(0.2)
        for number in range(OPTIONS.programs):
            file = self.path / f"archive/{number % 7}/O{number:04}.nc"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(f"G21 G90\nG1 X{number}. F100.\n" + "X1.\nX2.\n" * 500 + ("G999\n" if number % 9 == 0 else "") + "M30\n")
        self.assertEqual(self.batch("-o", str(self.path / "whole")).returncode, 1)

    def batch(self, *more):
        return self.cluster.ask(OPTIONS.isogloss, "batch", str(self.path / "archive"), "-d", "fanuc", *more)

    def submit(self):
        done = self.batch("-o", str(self.path / "out"), "--slurm", "4")
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr.split()[1]

    def journal(self):
        return [line for file in (self.path / "out/journal").glob("*.jsonl")
                for line in file.read_text().splitlines()] if (self.path / "out").exists() else []

    def wait_for_end(self):
        def is_empty():
            self.cluster.hurry()
            return self.cluster.ask("squeue", "-h").stdout == ""
        try:
            until(is_empty, "all jobs end")
        except AssertionError:
            print(self.cluster.ask("squeue").stdout, self.cluster.ask("sinfo").stdout,
                  (self.path / "controller.log").read_text()[-3000:], file=sys.stderr)
            raise

    def assert_same_results(self):
        log = "".join(f.read_text() for f in (self.path / "out/slurm").glob("*.log"))
        for name in RESULTS:
            self.assertTrue((self.path / "out" / name).exists(), log)
            self.assertEqual((self.path / "out" / name).read_bytes(), (self.path / "whole" / name).read_bytes(), name)

    def test_requeued_parts_and_a_lost_node_lose_and_double_nothing(self):
        """Where a part has begun just as the node was lost, Slurm may end it for good. Then the merging job has to say so, and
        another submission to run what is missing; and the loss is tried again."""
        for _ in range(3):
            self.requeue_a_part_and_lose_the_node()
            self.wait_for_end()
            if (self.path / "out" / RESULTS[0]).exists():
                self.assert_same_results()
                lines = self.journal()
                self.assertGreaterEqual(len(lines), OPTIONS.programs)
                self.assertLess(len(lines), OPTIONS.programs + 8)  # of two processes with one part, each has finished a program
                return
            self.assertIn("[IG-0673]", (self.path / "out/slurm/merge.log").read_text())
            self.submit()
            self.wait_for_end()
            self.assert_same_results()
            self.start_anew()
        self.fail("each time a part has ended for good")

    def requeue_a_part_and_lose_the_node(self):
        job = self.submit()
        until(lambda: len(self.journal()) >= 5, "programs are finished")
        task = self.cluster.ask("squeue", "-h", "-t", "R", "-j", job, "-o", "%A").stdout.split()[0]
        self.assertEqual(self.cluster.ask("scontrol", "requeue", task).returncode, 0)
        done = len(self.journal())
        until(lambda: len(self.journal()) >= done + 5, "the others go on")
        self.cluster.lose_node()

    def test_a_part_that_was_killed_is_missed_and_run_by_the_next_submission(self):
        self.submit()
        until(lambda: len(self.journal()) >= 5, "programs are finished")
        os.kill(until(self.cluster.workers, "a part runs")[0], signal.SIGKILL)
        self.wait_for_end()
        self.assertFalse((self.path / "out/results.csv").exists())
        self.assertIn("[IG-0673]", (self.path / "out/slurm/merge.log").read_text())
        self.submit()
        self.wait_for_end()
        self.assert_same_results()
        self.assertEqual(len(self.journal()), OPTIONS.programs)

    def test_the_time_of_a_suspended_part_counts_for_no_limit(self):
        for file in (self.path / "archive").rglob("*.nc"):
            file.unlink()
        loop = "#1=0\nWHILE[#1LT900000]DO1\n#1=#1+1\n" + "#2=#1*2\n" * 12 + "END1\n"  # a second or more
        (self.path / "archive/long.nc").write_text("G21 G90\nG0 X1.\n" + 2 * loop + "M30\n")
        self.assertEqual(self.batch("-o", str(self.path / "out"), "--slurm", "1", "--max-time", str(MOST_SECONDS),
                                    "--max-jumps", "99999999", "--slurm-options", "--hold").returncode, 0)
        jobs = self.cluster.ask("squeue", "-h", "-o", "%A").stdout.split()
        self.assertEqual(self.cluster.ask("scontrol", "release", *jobs).returncode, 0)  # not before somebody watches
        until(lambda: self.cluster.found("--work", str(self.path)), "a program runs")
        job = self.cluster.ask("squeue", "-h", "-t", "R", "-o", "%A").stdout.split()[0]
        self.assertEqual(self.cluster.ask("scontrol", "suspend", job).returncode, 0)
        time.sleep(MOST_SECONDS + 2)
        self.assertEqual(self.cluster.ask("scontrol", "resume", job).returncode, 0)
        self.wait_for_end()
        self.assertIn('"Status":"ok"', (self.path / "out/results.jsonl").read_text())


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=150)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(OPTIONS.isogloss.resolve())
    unittest.main(argv=[sys.argv[0], *rest])
