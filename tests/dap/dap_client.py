"""A client of the Debug Adapter Protocol, as small as tests need one."""
import json
import os
import queue
import subprocess
import threading


class Refused(Exception):
    """The adapter answered with an error."""


class Client:
    """Starts the adapter and talks to it. Every wait ends: `seconds` is its limit."""

    def __init__(self, command, seconds=30, cwd=None):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, cwd=cwd, env=environment)
        self.seconds = seconds
        self.sequence = 0
        self.responses = {}
        self.events = queue.Queue()
        self.outputs = []
        self.arrived = threading.Condition()
        self.is_at_end = False
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()

    def _read(self):
        stream = self.process.stdout
        while True:
            length = None
            while True:
                line = stream.readline()
                if not line:
                    with self.arrived:
                        self.is_at_end = True
                        self.arrived.notify_all()
                    self.events.put(None)
                    return
                if line in (b"\r\n", b"\n"):
                    break
                name, _, value = line.partition(b":")
                if name.strip().lower() == b"content-length":
                    length = int(value)
            message = json.loads(stream.read(length))
            if message["type"] == "response":
                with self.arrived:
                    self.responses[message["request_seq"]] = message
                    self.arrived.notify_all()
            elif message["event"] == "output":
                self.outputs.append(message["body"])
            else:
                self.events.put(message)

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, command, arguments=None):
        self.sequence += 1
        message = {"seq": self.sequence, "type": "request", "command": command}
        if arguments is not None:
            message["arguments"] = arguments
        body = json.dumps(message).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        return self.sequence

    def answer(self, number):
        with self.arrived:
            there = self.arrived.wait_for(lambda: number in self.responses or self.is_at_end, self.seconds)
            if number not in self.responses:
                raise AssertionError("no answer" if not there else "the adapter has ended")
            return self.responses.pop(number)

    def request(self, command, **arguments):
        """The body of the answer; Refused where it is an error."""
        response = self.answer(self.send(command, arguments))
        if not response["success"]:
            raise Refused(response["message"])
        return response.get("body", {})

    def event(self, *names):
        """The next event of one of these names; others before it are dropped."""
        while True:
            event = self.events.get(timeout=self.seconds)
            if event is None:
                raise AssertionError("the adapter has ended")
            if event["event"] in names:
                return event

    def stop(self):
        """Where the run stands next: reason, line, and the whole event; None where it has ended."""
        event = self.event("stopped", "terminated")
        return None if event["event"] == "terminated" else event["body"]

    def launch(self, program, breakpoints=None, logic=(), filters=(), **arguments):
        """From initialize to the first block; breakpoints by path. Their answers."""
        self.request("initialize", adapterID="isogloss", linesStartAt1=True, columnsStartAt1=True)
        self.request("launch", program=str(program), **arguments)
        self.event("initialized")
        answers = {}
        for path, wanted in (breakpoints or {}).items():
            lines = [b if isinstance(b, dict) else {"line": b} for b in wanted]
            answers[path] = self.request("setBreakpoints", source={"path": str(path)}, breakpoints=lines)["breakpoints"]
        if logic:
            wanted = [one if isinstance(one, dict) else {"name": one} for one in logic]
            answers["logic"] = self.request("setFunctionBreakpoints", breakpoints=wanted)["breakpoints"]
        self.request("setExceptionBreakpoints", filters=list(filters))
        self.request("configurationDone")
        return answers

    def frames(self):
        return self.request("stackTrace", threadId=1)["stackFrames"]

    def line(self):
        return self.frames()[0]["line"]

    def step(self, command="next"):
        """The line where the run stands after a step; None where it has ended."""
        self.request(command, threadId=1)
        return None if self.stop() is None else self.line()

    def scope(self, name, frame=0):
        scopes = self.request("scopes", frameId=self.frames()[frame]["id"])["scopes"]
        return next(s["variablesReference"] for s in scopes if s["name"] == name)

    def variables(self, reference):
        return {v["name"]: v for v in self.request("variables", variablesReference=reference)["variables"]}

    def values(self, name, frame=0):
        return {n: v["value"] for n, v in self.variables(self.scope(name, frame)).items()}

    def value(self, expression):
        return self.request("evaluate", expression=expression, context="watch")["result"]

    def close(self):
        """Disconnects; the exit status of the adapter."""
        if self.process.poll() is None:
            try:
                self.request("disconnect")
            except (Refused, AssertionError, BrokenPipeError):
                pass
            try:
                self.process.stdin.close()
            except BrokenPipeError:
                pass
        try:
            status = self.process.wait(timeout=self.seconds)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        self.reader.join(timeout=self.seconds)
        self.process.stdout.close()
        self.errors = self.process.stderr.read().decode(errors="replace")
        self.process.stderr.close()
        return status
