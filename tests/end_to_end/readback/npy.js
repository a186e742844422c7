// NumPy arrays (format 1.0, C order, little-endian floats) as plain arrays.
import { readFileSync } from 'node:fs';

/// @returns {{shape: number[], data: Float32Array|Float64Array}}
export function readNpy(path) {
    const bytes = readFileSync(path);
    if (bytes.subarray(0, 8).toString('latin1') !== '\x93NUMPY\x01\x00')
        throw new Error(`${path}: not a NumPy array of format 1.0`);
    const start = 10 + bytes.readUInt16LE(8);
    const head = bytes.subarray(10, start).toString('latin1');
    const element = /'descr': '(<f[48])'/.exec(head)[1];
    const numbers = /'shape': \(([^)]*)\)/.exec(head)[1].split(',');
    const shape = numbers.filter((n) => n.trim()).map(Number);
    const ArrayType = element === '<f4' ? Float32Array : Float64Array;
    const data = new ArrayType(bytes.buffer.slice(bytes.byteOffset + start,
                                                  bytes.byteOffset + bytes.length));
    if (data.length !== shape.reduce((a, b) => a * b, 1))
        throw new Error(`${path}: ${data.length} numbers do not fill [${shape}]`);
    return { shape, data };
}
