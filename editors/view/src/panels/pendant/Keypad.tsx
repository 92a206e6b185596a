// Keys of the pendant.

import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { Button } from "../shared/Button";
import type { Cell, Notice } from "../shared/cell";
import { LAYERS } from "./keyLayers";
import { CODES, type PendantKey, USER_KEYS } from "./keyMapping";
import { pressKey } from "./press";

interface KeypadProps {
  cell: Cell;
  notice: Notice;
}

interface KeyCap {
  sign: string;
  label: string;
  key: PendantKey;
}

const cap = (sign: string, label: string, key: PendantKey): KeyCap => ({ sign, label, key });

const EDITING: readonly KeyCap[] = [
  cap("Esc", "Esc", { code: CODES.Esc }),
  cap("Tab", "Tab", { code: CODES.Tab }),
  cap("▲", "Up", { code: CODES.Up }),
  cap("⌫", "Bksp", { code: CODES.Bksp }),
  cap("Home", "Home", { code: CODES.Home }),
  cap("◀", "Left", { code: CODES.Left }),
  cap("▼", "Down", { code: CODES.Down }),
  cap("▶", "Right", { code: CODES.Right }),
  cap("End", "End", { code: CODES.End }),
  cap("PgUp", "PgUp", { code: CODES.PgUp }),
  cap("PgDn", "PgDn", { code: CODES.PgDn }),
  cap("Return", "Return", { code: CODES.Return }),
];

const PAGES: readonly KeyCap[] = [
  cap("User ▲", "Previous user page", { page: "previous" }),
  cap("User ▼", "Next user page", { page: "next" }),
];

export function Keypad({ cell, notice }: KeypadProps): JSX.Element {
  const blocked = cell.blocked.value;
  const button = ({ sign, label, key }: KeyCap): JSX.Element => (
    <Button key={label} label={label} reason={blocked} onPress={() => pressKey(cell, notice, key)}>{sign}</Button>
  );
  return (
    <div class="keypad">
      <div class="keys user-keys" role="group" aria-label="Keys at the edge of the pendant">
        {USER_KEYS.map((code, at) => button(cap(String(at + 1), `Key ${at + 1} at the edge`, { code })))}
        {["Menu", "Help"].map((name) => (
          <Button key={name} reason={`The key ${name} opens pages of the pendant that this controller does not have.`} onPress={() => undefined} onRefused={(reason) => (notice.text.value = reason)}>{name}</Button>
        ))}
        {PAGES.map(button)}
      </div>
      <div class="keys editing-keys" role="group" aria-label="Editing keys">{EDITING.map(button)}</div>
      <CharacterKeys cell={cell} notice={notice} />
    </div>
  );
}

function CharacterKeys({ cell, notice }: KeypadProps): JSX.Element {
  const [layer, setLayer] = useState(1);
  const blocked = cell.blocked.value;
  return (
    <div class="characters">
      <div class="keys layers" role="group" aria-label="Characters of the keys">
        {LAYERS.map(({ label, title }, index) => (
          <Button key={label} title={title} isPressed={index === layer} onPress={() => setLayer(index)}>{label}</Button>
        ))}
        <Button label="Space" reason={blocked} onPress={() => pressKey(cell, notice, { code: 32 })}>Space</Button>
      </div>
      <div class="keys character-keys" role="group" aria-label="Character keys">
        {(LAYERS[layer]?.rows ?? []).flatMap((row, line) => Array.from(row, (character, at) => (
          <Button key={`${line}.${at}`} reason={blocked} onPress={() => pressKey(cell, notice, { code: character.charCodeAt(0) })}>{character}</Button>
        )))}
      </div>
    </div>
  );
}
