// Bindings on an HTML user page: element values, and a button for each element with a program.

import type { JSX } from "preact";
import { Button } from "../shared/Button";
import type { Cell, HtmlPage as Page, Notice } from "../shared/cell";

export function HtmlPage({ page, cell, notice }: { page: Page; cell: Cell; notice: Notice }): JSX.Element {
  return (
    <fieldset class="html-page">
      <legend>Page {page.name}</legend>
      <dl>
        {page.values.map(({ id, attribute, value }, index) => (
          <div key={index}><dt>{id}.{attribute}</dt><dd>{value ?? ""}</dd></div>
        ))}
      </dl>
      <div class="row">
        {page.clicks.map(({ id, program }, index) => (
          <Button key={index} title={`Executes ${program}`} reason={cell.blocked.value} onPress={() => void notice.operate(cell, { click: id })}>
            {id}
          </Button>
        ))}
      </div>
    </fieldset>
  );
}
