"""Pictures of the window: what stands in Xvfb's framebuffer, and PNG files, as numpy arrays
[height, width, 3] of bytes."""

import pathlib
import struct
import subprocess
import zlib

import numpy as np


def framebuffer(path):
    """The screen that Xvfb keeps in `path` (its -fbdir), as it is now."""
    data = path.read_bytes()
    (header, _, _, _, width, height, _, _, _, _, _, bits, stride) = struct.unpack_from(">13I", data)
    colours = struct.unpack_from(">I", data, 76)[0]
    assert bits == 32, f"{bits} bits a pixel"
    rows = np.frombuffer(data, np.uint8, height * stride, header + 12 * colours)
    return rows.reshape(height, stride)[:, :4 * width].reshape(height, width, 4)[:, :, 2::-1].copy()


def read_png(path):
    width, height = struct.unpack(">II", path.read_bytes()[16:24])
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", str(path), "-f", "rawvideo",
                          "-pix_fmt", "rgb24", "-"], check=True, capture_output=True).stdout
    return np.frombuffer(raw, np.uint8).reshape(height, width, 3)


def write_png(path, picture):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width, _ = picture.shape
    rows = np.zeros((height, 1 + 3 * width), np.uint8)  # each begins with its filter: none
    rows[:, 1:] = picture.reshape(height, -1)
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"\x89PNG\r\n\x1a\n"
                     + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows.tobytes(), 1)) + chunk(b"IEND", b""))


def changed(one, other, by=40):
    """[height, width] of bool: where two pictures differ by more than `by` of 255."""
    return np.abs(one.astype(int) - other).max(axis=2) > by


# How much the window's pictures of one thing may differ: it draws edges and shadows with less effort
# where the machine is slow.
NOISE = 0.005


def difference(one, other):
    """The part of the pixels that are clearly different, 0 to 1."""
    return 1.0 if one.shape != other.shape else float(changed(one, other).mean())


def count_of(picture, colour):
    """Pixels of nearly that colour."""
    return int((~changed(picture, np.array(colour), by=6)).sum())


def boxes_of(picture, colour, smallest=40, tolerance=6):
    """Rectangles (left, top, right, bottom) that hold patches of one colour, the largest first.
    A patch is what one gets to by rows and columns without a gap."""
    mask = (np.abs(picture.astype(int) - np.array(colour)).max(axis=2) <= tolerance)
    boxes = []
    for top, bottom in runs(mask.any(axis=1)):
        for left, right in runs(mask[top:bottom].any(axis=0)):
            inner = runs(mask[top:bottom, left:right].any(axis=1))
            for low, high in inner:
                count = int(mask[top + low:top + high, left:right].sum())
                if count >= smallest:
                    boxes.append((count, (left, top + low, right, top + high)))
    return [box for _, box in sorted(boxes, reverse=True)]


def runs(flags):
    """(first, one past the last) of each run of true values."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(np.int8), [0]])))
    return [(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2])]
