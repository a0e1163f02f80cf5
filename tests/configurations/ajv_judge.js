// ajv_judge.js SCHEMA: a line of standard input is a JSON value; prints "ok" or the first error of each.
const Ajv = require("ajv");
const fs = require("fs");
const valid = new Ajv().compile(JSON.parse(fs.readFileSync(process.argv[2], "utf8")));
for (const line of fs.readFileSync(0, "utf8").split("\n").filter(Boolean)) {
  console.log(valid(JSON.parse(line)) ? "ok" : `${valid.errors[0].dataPath} ${valid.errors[0].message}`);
}
