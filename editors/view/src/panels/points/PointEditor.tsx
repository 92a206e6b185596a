// Fields with the values of a point, and Teach here.

import type { JSX, TargetedSubmitEvent } from "preact";
import { useState } from "preact/hooks";
import { Button } from "../shared/Button";
import type { Cell, CellPoint, Notice } from "../shared/cell";
import { COORDINATES, editedTrsf, fieldTexts, pointText } from "./edits";

interface Props {
  cell: Cell;
  notice: Notice;
  point: CellPoint;
  fathers: string;
}

export function PointEditor({ cell, notice, point, fathers }: Props): JSX.Element {
  const [texts, setTexts] = useState(() => fieldTexts(point.local));
  const { name, key } = point;
  const blocked = cell.blocked.value;
  const refused = (reason: string): void => void (notice.text.value = reason);
  const apply = (): void => {
    const edited = editedTrsf(texts, point.local);
    if ("wrong" in edited) {
      notice.text.value = edited.wrong;
    } else {
      void notice.send(cell, "setPoint", { name, key, local: edited.trsf });
    }
  };
  const submit = (event: TargetedSubmitEvent<HTMLFormElement>): void => {
    event.preventDefault();
    if (blocked === undefined) {
      apply();
    } else {
      refused(blocked);
    }
  };
  return (
    <form class="point-editor" aria-label={`Values of ${pointText(point)}`} onSubmit={submit}>
      <p><strong>{pointText(point)}</strong> in {fathers}{point.config ? `, ${point.config}` : ""}</p>
      <div class="row">
        {COORDINATES.map((coordinate, at) => (
          <label key={coordinate}>{coordinate}{" "}
            <input inputMode="decimal" value={texts[at]} readOnly={blocked !== undefined} title={blocked} onInput={({ currentTarget }) => setTexts(texts.with(at, currentTarget.value))} />
          </label>
        ))}
      </div>
      <div class="row">
        <button type="submit" aria-disabled={blocked === undefined ? undefined : true} title={blocked}>Apply</button>
        <Button reason={blocked} title="Takes the present position of the tool centre point" onPress={() => void notice.send(cell, "teach", { name, key })} onRefused={refused}>Teach here</Button>
        <button type="button" onClick={() => setTexts(fieldTexts(point.local))}>Reset fields</button>
      </div>
    </form>
  );
}
