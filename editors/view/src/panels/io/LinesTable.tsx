// Sockets and serial lines with their last bytes.

import type { JSX } from "preact";
import type { Cell } from "../shared/cell";
import { asHex, asText, lastTransfers } from "./lineBytes";

const SHOWN = 3;

export function LinesTable({ cell }: { cell: Cell }): JSX.Element | null {
  const lines = cell.scene.value?.lines ?? [];
  const end = cell.slowTime.value;
  if (lines.length === 0) {
    return null;
  }
  return (
    <div class="lines" tabIndex={0} role="region" aria-label="Sockets and serial lines">
      <table>
        <caption>Sockets and serial lines</caption>
        <thead><tr><th scope="col">Line</th><th scope="col">Time</th><th scope="col">Way</th><th scope="col">Text</th><th scope="col" class="bytes">Bytes</th></tr></thead>
        <tbody>
          {lines.flatMap(({ link, type }) => {
            const transfers = lastTransfers(cell.history.transfers, link, end, SHOWN);
            const first = <th scope="row" rowSpan={Math.max(1, transfers.length)} title={link}>{link} <span class="direction">{type}</span></th>;
            return transfers.length === 0
              ? [<tr key={link}>{first}<td colSpan={4}>no bytes yet</td></tr>]
              : transfers.map(({ t, dir, bytes }, index) => (
                <tr key={`${link} ${t} ${index}`}>
                  {index === 0 ? first : null}
                  <td>{t.toFixed(3)} s</td><td>{dir === "in" ? "received" : "sent"}</td><td><code>{asText(bytes)}</code></td><td class="bytes"><code>{asHex(bytes)}</code></td>
                </tr>
              ));
          })}
        </tbody>
      </table>
    </div>
  );
}
