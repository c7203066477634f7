// Compiles a file of WGSL by naga and by Dawn (without a GPU): node compile_wgsl.mjs <file>, beside node_modules.
import { readFileSync } from "fs";
import { parseWgsl, validate } from "naga-wasm";
import { create, globals } from "webgpu";

const code = readFileSync(process.argv[2], "utf8");
validate(parseWgsl(code));

Object.assign(globalThis, globals);
const gpu = create(["backend=null"]);  // by name: Dawn crashes when it is collected too early
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();
device.pushErrorScope("validation");
const module = device.createShaderModule({ code });
const { messages } = await module.getCompilationInfo();
const error = await device.popErrorScope();
for (const { type, lineNum, message } of messages) console.log(`${type}, line ${lineNum}: ${message}`);
process.exit(error || messages.some(({ type }) => type === "error") ? 1 : 0);
