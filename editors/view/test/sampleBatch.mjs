// Encodes samples as a run sends them (docs/src/view.md), for tests.

/** Encoded units per second, per degree or mm, and per mm/s. */
const [TIME, JOINT, SPEED] = [1e9, 1e6, 100];
const NO_SOURCE = 65535;

/** Returns a batch: a list of samples with `t`, `joints`, and optionally `speed`, `phase`, `tool`, `source` and `limit`. */
export function encoded(list) {
  const axes = list[0].joints.length;
  const head = Buffer.alloc(8);
  head.writeUInt8(1, 0);
  head.writeUInt8(axes, 1);
  head.writeUInt32LE(list.length, 4);
  const columns = [
    column(list.map(({ t }) => Math.round(t * TIME)), 2),
    ...Array.from({ length: axes }, (_, axis) => column(list.map(({ joints }) => Math.round(joints[axis] * JOINT)), 3)),
    column(list.map(({ speed = 0 }) => Math.round(speed * SPEED)), 2),
  ];
  return Buffer.concat([head, Buffer.from([...columns.flat(), ...origins(list)])]);
}

function column(values, order) {
  const last = [];
  return values.flatMap((value, index) => {
    let difference = value;
    for (let level = 0; level < Math.min(order, index); level += 1) {
      [difference, last[level]] = [difference - last[level], difference];
    }
    last[Math.min(order, index)] = difference;
    return number(difference >= 0 ? 2 * difference : -2 * difference - 1);
  });
}

function origins(list) {
  const bytes = [];
  let length = 0;
  list.forEach(({ phase = 0, tool = 0, limit = 0, source = NO_SOURCE }, index) => {
    const next = list[index + 1];
    length += 1;
    if (next === undefined || (next.phase ?? 0) !== phase || (next.tool ?? 0) !== tool || (next.limit ?? 0) !== limit || (next.source ?? NO_SOURCE) !== source) {
      bytes.push(...number(length), phase, tool, limit, ...number(source));
      length = 0;
    }
  });
  return bytes;
}

function number(value) {
  const bytes = [];
  for (; value >= 128; value = Math.floor(value / 128)) {
    bytes.push((value % 128) + 128);
  }
  return [...bytes, value];
}
