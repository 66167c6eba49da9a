// png.mjs — the pixels of a screenshot: 8 bits a channel, not interlaced, as browsers write them.

import { inflateSync } from 'node:zlib';

/** `at(x, y)` is [red, green, blue]. */
export function decodePng(bytes) {
  let width = 0;
  let height = 0;
  let channels = 0;
  const packed = [];
  for (let at = 8; at < bytes.length; ) {
    const length = bytes.readUInt32BE(at);
    const type = bytes.toString('latin1', at + 4, at + 8);
    const data = bytes.subarray(at + 8, at + 8 + length);
    if (type === 'IHDR') {
      width = data.readUInt32BE(0);
      height = data.readUInt32BE(4);
      channels = { 2: 3, 6: 4 }[data[9]];
      if (data[8] !== 8 || !channels || data[12] !== 0) throw new Error('a PNG of another kind');
    }
    if (type === 'IDAT') packed.push(data);
    at += length + 12;
  }
  const raw = inflateSync(Buffer.concat(packed));
  const stride = width * channels;
  const pixels = Buffer.alloc(stride * height);
  for (let y = 0; y < height; y++) unfilter(raw, pixels, y, stride, channels);
  return {
    width,
    height,
    at: (x, y) => [...pixels.subarray(y * stride + x * channels, y * stride + x * channels + 3)],
  };
}

/** Takes the filter off a row (PNG specification, chapter 9). */
function unfilter(raw, pixels, y, stride, channels) {
  const filter = raw[y * (stride + 1)];
  const from = y * (stride + 1) + 1;
  const to = y * stride;
  for (let i = 0; i < stride; i++) {
    const left = i >= channels ? pixels[to + i - channels] : 0;
    const above = y > 0 ? pixels[to - stride + i] : 0;
    const corner = y > 0 && i >= channels ? pixels[to - stride + i - channels] : 0;
    pixels[to + i] = raw[from + i] + [0, left, above, (left + above) >> 1, paeth(left, above, corner)][filter];
  }
}

function paeth(left, above, corner) {
  const guess = left + above - corner;
  const [a, b, c] = [left, above, corner].map((value) => Math.abs(guess - value));
  if (a <= b && a <= c) return left;
  return b <= c ? above : corner;
}
