import * as fs from "node:fs";
import * as readline from "node:readline";
import * as kernel from "./@BASE@.mjs";

const values = Float64Array.from(fs.readFileSync("values", "utf8").trim().split(/\s+/), Number);
const first = values[0];
const constants = new Float64Array(@CONSTANTS@), output = new Float64Array(@OUTPUTS@);
kernel.preprocess(values.slice(@INPUTS@), constants);
for await (const line of readline.createInterface({ input: process.stdin })) {
  const calls = Number(line), begin = process.hrtime.bigint();
  let sum = 0;
  for (let i = 0; i < calls; ++i) {
    values[0] = first + 1e-7 * (i & 15);
    kernel.compute(values, constants, output);
    sum += output[0];
  }
  console.log(Number(process.hrtime.bigint() - begin) / calls + " " + sum);
}
