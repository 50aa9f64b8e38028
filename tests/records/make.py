"""Makes the records that the readers are tested with: python make.py, with numpy, scipy, pyuff and soundfile.

Sample i of channel c is ((7919 i + 104729 c + 12345) mod 65536 - 32768) / 32768, which 16 bits hold exactly. The files have
the form of what test rigs publish; no data of theirs are in them.
"""

import pathlib
import struct
import zlib

import numpy as np
import pyuff
import scipy.io
import scipy.sparse
import soundfile

HERE = pathlib.Path(__file__).parent
N = 100
RATE = 25600


def whole(channel, count=N):
    return (7919 * np.arange(count) + 104729 * channel + 12345) % 65536 - 32768


def samples(channel, count=N):
    return whole(channel, count) / 32768


def columns(*channels, count=N):
    return np.stack([samples(channel, count) for channel in channels], axis=1)


def write(name, text, encoding="utf-8"):
    (HERE / name).write_bytes(text.encode(encoding))


def table(name, head, rows, separator=",", comma=False, end="\n", encoding="utf-8", form=repr):
    def cell(value):
        text = value if isinstance(value, str) else form(float(value))
        return text.replace(".", ",") if comma else text

    lines = head + [separator.join(cell(value) for value in row) for row in rows]
    write(name, end.join(lines) + end, encoding)


def texts():
    two, times = columns(0, 1), np.arange(N) / RATE
    timed = np.column_stack([times, two])
    table("xjtu.csv", ["Horizontal_vibration_signals,Vertical_vibration_signals"], two)
    table("ims", [], columns(0, 1, 2, 3), "\t", form=lambda value: f"{value:.15f}")
    table("mafaulda.csv", [], columns(*range(8)))
    clock = [[9.0, 39.0, 39.0, round(65664 + 1e6 * i / RATE), *two[i]] for i in range(N)]
    for name, separator in [("femto.csv", ","), ("femto_semicolons.csv", ";")]:
        table(name, [], clock, separator, form=lambda value: f"{value:.15g}")
    table("timed.csv", ["Time [s],acc x [m/s^2],acc y (g)"], timed)
    german = ["\ufeffZeit/ms;Weg x [\u00b5m];Weg y [\u03bcm]"]
    table("german.csv", german, np.column_stack([1e3 * times, two]), ";", True, "\r\n")
    table("latin1.txt", ["t (s)\tx (\u00b5m)\ty (m/s\u00b2)"], timed, "\t", True, encoding="latin-1")
    units = ["Recorder 7", "Sample rate;25600", "Time;Acc 1;Acc 2;", "s;g;m/s^2;"]
    table("units_row.csv", units, [[*row, ""] for row in timed], ";")
    np.savetxt(HERE / "savetxt.txt", two, fmt="%.17g", header="made by NumPy\nleft right")
    table("percent.dat", ["% a comment", "%", ""], two, "   ")
    uneven = np.column_stack([np.cumsum(1e-3 * (1 + 0.5 * (np.arange(N) % 3))), two])
    table("uneven.csv", ["time_s,a,b"], uneven)
    slow = [[times[i], two[i, 0], 10 * times[i] if i < 50 else "", two[i, 1] if i < 50 else ""] for i in range(N)]
    table("two_rates.csv", ["Time 1 (s),fast,Time 2 (s),slow"], slow)
    gaps = [[a, b if i != 7 else ""] for i, (a, b) in enumerate(two)]
    table("gaps.csv", ["a,b"], gaps)
    table("quoted.csv", ['"t, rel. [s]","acc, x"'], timed[:, :2])
    table("trace.csv", ["t_s,x_m,x_velocity_m_s,balls_loaded"], np.column_stack([timed, whole(2)]))


def waves():
    two = columns(0, 1)
    for name, subtype, form in [
        ("i16.wav", "PCM_16", "WAV"),
        ("i24.wav", "PCM_24", "WAV"),
        ("i32.wav", "PCM_32", "WAV"),
        ("f32.wav", "FLOAT", "WAV"),
        ("f64.wav", "DOUBLE", "WAV"),
        ("u8.wav", "PCM_U8", "WAV"),
        ("extensible.wav", "PCM_24", "WAVEX"),
        ("long.wav", "PCM_16", "RF64"),
        ("alaw.wav", "ALAW", "WAV"),
    ]:
        soundfile.write(HERE / name, two, RATE, subtype, format=form)


def matlab():
    def save(name, variables, **options):
        scipy.io.savemat(HERE / name, variables, **options)

    def column(channel, count=N):
        return samples(channel, count)[:, None]

    cwru = {"X112_DE_time": column(0), "X112_FE_time": column(1), "X112_BA_time": column(2), "X112RPM": 1797}
    save("cwru.mat", cwru)
    save("cwru_packed.mat", cwru, do_compression=True)
    save("version4.mat", cwru, format="4")
    curtin = {"Channel_1": column(0), "Channel_2": column(1)}
    save("curtin.mat", curtin, do_compression=True)
    save("mfpt.mat", {"bearing": {"sr": 97656.0, "gs": column(0), "load": 270.0, "rate": 25.0}}, do_compression=True)

    def measured(name, channel, count, raster, unit):
        return (name, 1.0, samples(channel, count)[None, :], raster, unit)

    fields = [(name, "O") for name in ["Name", "Type", "Data", "Raster", "Unit"]]
    fast, slow = "HostService", "Mech_4kHz"
    y = [
        measured("force", 0, 20, slow, "N"),
        measured("phase_current_1", 1, N, fast, "A"),
        measured("speed", 2, 20, slow, "rpm"),
        measured("temp_2_bearing_module", 3, 5, "Temp_1Hz", ""),
        measured("vibration_1", 4, N, fast, ""),
    ]
    top = {"Info": {"Version": 1.0}, "X": {"Raster": fast}, "Y": np.array([y], dtype=fields), "Description": {"Text": "made"}}
    save("paderborn.mat", {"N15_M07_F10_KA01_1": top})
    cells = np.empty((1, 3), dtype=object)
    cells[0] = [column(0), "text", samples(1)[None, :]]
    save(
        "kinds.mat",
        {
            "int16": whole(0).astype(np.int16)[:, None],
            "uint8": (whole(0) % 256).astype(np.uint8)[None, :],
            "int8": (whole(0) % 128).astype(np.int8)[None, :],
            "int64": whole(0).astype(np.int64)[:, None],
            "single": samples(0).astype(np.float32)[:, None],
            "logical": (whole(0) > 0)[:, None],
            "complex": (samples(0) + 1j * samples(1))[:, None],
            "tall": columns(0, 1, 2),
            "wide": columns(0, 1, 2).T,
            "cells": cells,
            "empty": np.zeros((0, 0)),
            "sparse": scipy.sparse.eye(3, format="csc"),
            "label": "m/s² of a housing",
            "fs": 25600,
        },
    )

    # SciPy writes no other order of bytes
    def element(kind, data):
        return struct.pack(">II", kind, len(data)) + data + bytes(-len(data) % 8)

    body = element(6, struct.pack(">II", 6, 0)) + element(5, struct.pack(">ii", N, 1)) + element(1, b"x")
    body += element(9, samples(0).astype(">f8").tobytes())
    packed = zlib.compress(element(14, body.replace(b"\x01x", b"\x01y")))
    head = b"MATLAB 5.0 MAT-file".ljust(124) + b"\x01\x00MI"
    (HERE / "big_endian.mat").write_bytes(head + element(14, body) + struct.pack(">II", 15, len(packed)) + packed)


def universal():
    times = np.arange(N) / RATE

    def dataset(channel, **changes):
        given = {
            "type": 58, "binary": 0, "func_type": 1, "id1": f"sensor {channel}", "rsp_node": 10 + channel, "rsp_dir": 3,
            "ref_node": 0, "ref_dir": 0, "orddenom_spec_data_type": 0, "z_axis_spec_data_type": 0, "data": samples(channel), "x": times, "ord_data_type": 4, "abscissa_spacing": 1,
            "abscissa_spec_data_type": 17, "ordinate_spec_data_type": 12, "ordinate_axis_lab": "acc",
            "ordinate_axis_units_lab": "m/s^2", "abscissa_axis_units_lab": "s",
        }
        return given | changes

    def save(name, sets, **options):
        (HERE / name).unlink(missing_ok=True)
        pyuff.UFF(str(HERE / name)).write_sets(sets, "add", **options)

    uneven = {"abscissa_spacing": 0, "x": np.cumsum(1e-3 * (1 + 0.5 * (np.arange(N) % 3)))}
    complex_values = {"data": samples(0) + 1j * samples(1)}
    save("text.uff", [dataset(0), dataset(1, id1="NONE", rsp_dir=-1)])
    save("text_uneven.uff", [dataset(0, **uneven)])
    save("text_complex.uff", [dataset(0, **complex_values)])
    save("text_single.uff", [dataset(0, ord_data_type=2)], force_double=False)
    save("binary.uff", [dataset(0, binary=1), dataset(1, binary=1)])
    save("binary_uneven.uff", [dataset(0, binary=1, **uneven)])
    save("binary_complex.uff", [dataset(0, binary=1, **complex_values)])
    response = {"func_type": 4, "abscissa_spec_data_type": 18, "x": np.arange(N) * 10.0}
    save("response.uff", [dataset(0, **response), dataset(1)])
    save("response_only.uff", [dataset(0, **response)])

    # what pyuff does not write: big-endian, single precision, a stray line end, other datasets, line ends of Windows
    def lines(name, kind, even, number, data, step=1 / RATE, order=2):
        head = [
            "    -1", "   151", "a model", "    -1", "    -1",
            f"    58b{order:6d}{2:6d}{11:12d}{len(data):12d}{0:6d}{0:6d}{0:12d}{0:12d}",
            name, "NONE", "01-Jan-26 00:00:00", "NONE", "NONE",
            f"{1:5d}{0:10d}{0:5d}{0:10d} {'hub':>10}{7:10d}{-4:4d} {'NONE':>10}{0:10d}{0:4d}",
            f"{kind:10d}{number:10d}{even:10d}{0.0:13.5E}{step if even else 0.0:13.5E}{0.0:13.5E}",
            f"{17:10d}{0:5d}{0:5d}{0:5d} {'Time':<20} {'s':<20}",
            f"{8:10d}{0:5d}{0:5d}{0:5d} {'Displacement':<20} {'m':<20}",
            f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':<20} {'NONE':<20}",
            f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':<20} {'NONE':<20}",
        ]
        return "\r\n".join(head).encode() + b"\r\n"

    single = samples(0).astype(">f4").tobytes()
    (HERE / "binary_single.uff").write_bytes(lines("big", 2, 1, N, single) + single + b"\r\n    -1\r\n")
    (HERE / "binary_stray.uff").write_bytes(lines("stray", 2, 1, N, single) + b"\n" + single + b"\n    -1\n")
    mixed = b"".join(struct.pack("<fd", 0.5 * i * i, value) for i, value in enumerate(samples(0)))
    (HERE / "binary_mixed.uff").write_bytes(lines("mixed", 4, 0, N, mixed, order=1) + mixed + b"    -1\n")


texts()
waves()
matlab()
universal()
