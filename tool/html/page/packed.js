// The inverse of packed.cpp: columns of numbers from base64.
function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text), bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// Numbers below 2^32, one after the other.
class PackedReader {
  constructor(text) {
    this.bytes = bytesOf(text);
    this.at = 0;
  }
  next() {
    let value = 0, scale = 1, byte;
    do {
      byte = this.bytes[this.at++];
      value += (byte & 127) * scale;
      scale *= 128;
    } while (byte & 128);
    return value;
  }
  column(count) {
    const numbers = new Uint32Array(count);
    for (let i = 0; i < count; i++) numbers[i] = this.next();
    return numbers;
  }
}
