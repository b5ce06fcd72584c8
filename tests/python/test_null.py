"""A NULL for every argument of every public function.

The table of functions and arguments is made from include/clod, so a new function has its rows at
once; what the shared library exports must be in it. A function that has a status must answer with
one that names function and argument, any other one must end the program with both names. Where a
NULL is allowed stands in MAY_BE_NULL, and is tried too.
"""

import ctypes
import glob
import json
import os
import re
import resource
import signal
import subprocess
import tempfile
import unittest

SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
LIBRARY = os.environ["CLOD_LIBRARY"]
USAGE = 2  # CLOD_USAGE of clod/status.h
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)
PROTOTYPE = re.compile(r"^(?!static|typedef)(\w[\w *]*?)(clod_\w+)\(([^(){}]*)\)[^;{}]*;", re.M)
CASE = b"""
materials: {ore: {density: 2000 kg/m3}, steel: {}}
contacts: {default: {law: hooke, k1: 1000 N/m, restitution: 0.5, friction: 0}}
domain: {min: [0 mm, 0 mm, 0 mm], max: [9 mm, 9 mm, 9 mm]}
grains:
  - material: ore
    count: 1
    radius: {mean: 1 mm, sd: 0.1 mm, min: 0.9 mm, max: 1.1 mm}
    region: {box: {min: [2 mm, 2 mm, 2 mm], max: [8 mm, 8 mm, 8 mm]}}
walls:
  floor: {material: steel, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}
stages: [{name: fall, duration: 1 s}]
"""
# function, argument: the header says that NULL is fine
MAY_BE_NULL = {
    ("clod_case_destroy", "self"), ("clod_contact_bench_run", "context"),
    ("clod_hopper_destroy", "self"), ("clod_hopper_free", "text"),
    ("clod_locus_free", "memory"), ("clod_locus_parse", "defaults"),
    ("clod_locus_read", "defaults"), ("clod_locus_study_destroy", "self"),
    ("clod_measured_read", "defaults"), ("clod_measured_warnings", "context"),
    ("clod_mesh_destroy", "self"), ("clod_mesh_free", "memory"), ("clod_run_free", "report"),
    ("clod_schema_explain", "key"), ("clod_schema_explain", "schemas"), ("clod_schema_free", "text"),
    ("clod_schema_manual", "schemas"), ("clod_sim_create", "options"),
    ("clod_sim_create_from_file", "options"), ("clod_sim_create_from_text", "options"),
    ("clod_sim_destroy", "self"), ("clod_sim_read_checkpoint", "part"),
}


class Status(ctypes.Structure):
    _fields_ = [("code", ctypes.c_int), ("text", ctypes.c_char * 16384)]


class SimOptions(ctypes.Structure):
    _fields_ = [("threads", ctypes.c_int), ("simd", ctypes.c_char_p),
                ("each_process", ctypes.c_bool), ("ranks", ctypes.c_void_p)]


class Argument:
    """One of a prototype: `const double velocity[3]`."""

    def __init__(self, text):
        self.text = " ".join(text.split())
        self.name = re.search(r"(\w+)(\[\w*\])*$", self.text).group(1)
        self.type = self.text[:self.text.rindex(self.name)].replace("const", "").strip()
        self.is_pointer = "*" in self.text or "[" in self.text or "sink" in self.type
        self.is_status = self.type == "clod_status *"


def read_functions():
    """name: (type that is returned, arguments), of all headers."""
    found = {}
    for header in glob.glob(os.path.join(SOURCE, "include", "clod", "*.h")):
        with open(header) as file:
            code = COMMENT.sub("", file.read())
        for returned, name, arguments in PROTOTYPE.findall(code):
            texts = [] if arguments.strip() == "void" else arguments.split(",")
            found[name] = (returned.strip(), [Argument(t) for t in texts if t.strip() != "..."])
    return found


FUNCTIONS = read_functions()
CALLED = [(name, argument.name) for name, (_, arguments) in sorted(FUNCTIONS.items())
          for argument in arguments if argument.is_pointer]


class Door:
    """The library with what its functions are given where no NULL is tried."""

    def __init__(self):
        self.library = ctypes.CDLL(LIBRARY)
        self.zeros = ctypes.create_string_buffer(1 << 20)
        status = Status()
        self.case = self.make("clod_case_parse", b"x.yaml", CASE, ctypes.c_size_t(len(CASE)), None,
                              ctypes.c_size_t(0), ctypes.byref(status))
        assert self.case, status.text.decode()
        self.sim = self.make("clod_sim_create", ctypes.c_void_p(self.case),
                             ctypes.byref(SimOptions(1, None, False, None)), ctypes.byref(status))
        assert self.sim, status.text.decode()

    def make(self, name, *arguments):
        function = self.library[name]
        function.restype = ctypes.c_void_p
        return function(*arguments)

    def value(self, argument):
        if argument.type == "clod_sim *":
            return ctypes.c_void_p(self.sim)
        if argument.type == "clod_case *":
            return ctypes.c_void_p(self.case)
        if argument.is_pointer:
            return self.zeros
        if argument.type == "double":
            return ctypes.c_double(1.0)
        return ctypes.c_size_t(1 if re.search("count|length|steps", argument.name) else 0)

    def call(self, name, without):
        """Call with NULL for one argument; what is returned, code and text of the status."""
        returned, arguments = FUNCTIONS[name]
        status = Status()
        values = []
        for argument in arguments:
            if argument.name == without:
                values.append(None)
            else:
                values.append(ctypes.byref(status) if argument.is_status else self.value(argument))
        function = self.library[name]
        function.restype = {"bool": ctypes.c_bool, "void": None}.get(returned, ctypes.c_void_p)
        answer = function(*values)
        return {"good": bool(answer), "code": status.code, "text": status.text.decode()}

    def try_call(self, name, without):
        """The same in a process of its own: answer, or signal, and what it wrote to its stderr."""
        with tempfile.TemporaryFile() as told, tempfile.TemporaryFile("w+") as answer:
            child = os.fork()
            if child == 0:
                os.dup2(told.fileno(), 2)
                resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
                json.dump(self.call(name, without), answer)
                answer.flush()
                os._exit(0)
            ended = os.waitpid(child, 0)[1]
            told.seek(0)
            answer.seek(0)
            text = answer.read()
            return (json.loads(text) if text else None, ended, told.read().decode())


class Nulls(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.door = Door()

    def test_the_table_has_what_the_library_exports(self):
        listed = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], check=True, text=True,
                                capture_output=True).stdout
        exported = {line.split()[-1] for line in listed.splitlines()}
        self.assertGreater(len(exported), 90)
        self.assertEqual(exported, set(FUNCTIONS))
        self.assertEqual(MAY_BE_NULL - set(CALLED), set(), "no such argument")

    def test_every_argument(self):
        for name, argument in CALLED:
            if argument == "args":  # a va_list
                continue
            with self.subTest(function=name, argument=argument):
                answer, ended, told = self.door.try_call(name, argument)
                arguments = FUNCTIONS[name][1]
                says = argument != "status" and any(a.is_status for a in arguments)
                if (name, argument) in MAY_BE_NULL:
                    self.assertEqual(ended, 0, told)
                    self.assertNotIn(" is NULL", answer["text"])
                elif says and not name.startswith("clod_status_"):
                    self.assertEqual(ended, 0, told)
                    self.assertEqual(answer, {"good": False, "code": USAGE,
                                              "text": f"{name}: {argument} is NULL"})
                else:
                    self.assertTrue(os.WIFSIGNALED(ended) and answer is None, answer)
                    self.assertEqual(os.WTERMSIG(ended), signal.SIGABRT, told)
                    self.assertIn(f"{name}: {argument} is NULL; the calling program must give one", told)


if __name__ == "__main__":
    unittest.main()
