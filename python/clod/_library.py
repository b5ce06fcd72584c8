"""libclod by cffi, with nothing compiled: its functions, its errors, the fields of its contacts."""

import os

import cffi
import numpy

from ._cdef import CDEF, LIBRARY

ffi = cffi.FFI()
ffi.cdef(CDEF)


def _load():
    """The library that CLOD_LIBRARY names, or the installed one."""
    name = os.environ.get("CLOD_LIBRARY", LIBRARY)
    try:
        return ffi.dlopen(name)
    except OSError as error:
        raise ImportError(f"{name}: {error}. Install clod, or let CLOD_LIBRARY name "
                          "libclod.so.") from error


lib = _load()
TYPES = {lib.CLOD_SIM_F64: "<f8", lib.CLOD_SIM_U64: "<u8", lib.CLOD_SIM_U16: "<u2",
         lib.CLOD_SIM_I32: "<i4"}


class Error(RuntimeError):
    """What clod says when something went wrong; `usage`: the caller or the case is wrong."""

    def __init__(self, status):
        super().__init__(ffi.string(status.text).decode())
        self.usage = status.code == lib.CLOD_USAGE


def _contact_type():
    """clod_sim_contact as NumPy sees it, and the units of its fields by name."""
    names, formats, offsets, units = [], [], [], {}
    field, status = ffi.new("clod_sim_contact_field *"), ffi.new("clod_status *")
    for index in range(lib.clod_sim_contact_field_count()):
        if not lib.clod_sim_contact_field_look(index, field, status):
            raise Error(status)
        names.append(ffi.string(field.name).decode())
        formats.append((TYPES[field.type], field.components) if field.components > 1
                       else TYPES[field.type])
        offsets.append(field.offset)
        units[names[-1]] = ffi.string(field.unit).decode()
    return numpy.dtype({"names": names, "formats": formats, "offsets": offsets,
                        "itemsize": ffi.sizeof("clod_sim_contact")}), units


CONTACT, CONTACT_UNITS = _contact_type()
