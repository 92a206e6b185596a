// Screen of the pendant. While it has the focus, it receives the keyboard input.

import type { JSX, TargetedKeyboardEvent } from "preact";
import { useState } from "preact/hooks";
import type { Cell, CellPage, Notice } from "../shared/cell";
import { Button } from "../shared/Button";
import { HtmlPage } from "./HtmlPage";
import { KEYBOARD_HELP, pendantKey } from "./keyMapping";
import { pressKey } from "./press";
import { menuTexts, ROWS, type Span, spansOf } from "./pageCells";

const EMPTY: CellPage = { screen: "", title: "", lines: [] };

export function UserPage({ cell, notice }: { cell: Cell; notice: Notice }): JSX.Element {
  const page = cell.page.value ?? EMPTY;
  const [isTyping, setTyping] = useState(false);
  const type = (event: TargetedKeyboardEvent<HTMLDivElement>): void => {
    const key = pendantKey({
      key: event.key, code: event.code, altKey: event.altKey, ctrlKey: event.ctrlKey, metaKey: event.metaKey,
      shiftKey: event.shiftKey, isAltGraph: event.getModifierState("AltGraph"), isComposing: event.isComposing,
    });
    if (key !== undefined) {
      event.preventDefault();
      event.stopPropagation();
      pressKey(cell, notice, key);
    }
  };
  return (
    <div class="user-page">
      <div
        class="screen" tabIndex={0} role="application" aria-label="User page. Keys that are typed here go to the pendant; Tab leaves it."
        onKeyDown={type} onFocus={() => setTyping(true)} onBlur={() => setTyping(false)}
      >
        <div class="screen-title">{page.title || page.screen || "User page"}</div>
        <div class="screen-text" aria-live="polite">
          {Array.from({ length: ROWS }, (_, row) => (
            <div class="screen-line" key={row}>{spansOf(page.lines[row] ?? "", page.modes?.[row]).map(drawSpan)}</div>
          ))}
        </div>
      </div>
      {page.html ? <HtmlPage page={page.html} cell={cell} notice={notice} /> : null}
      {page.popUp ? <PopUp text={page.popUp} cell={cell} notice={notice} /> : null}
      <MenuKeys page={page} cell={cell} notice={notice} />
      <details class="help">
        <summary>{isTyping ? "The keyboard types into the page. Tab leaves it." : "Keys of the keyboard (click the page to type into it)"}</summary>
        <dl>{KEYBOARD_HELP.map(([keys, meaning]) => <div key={keys}><dt>{keys}</dt><dd>{meaning}</dd></div>)}</dl>
      </details>
    </div>
  );
}

function drawSpan({ text, isInverse, isFlashing }: Span, index: number): JSX.Element {
  return <span key={index} class={`${isInverse ? "inverse" : ""} ${isFlashing ? "flashing" : ""}`}>{text}</span>;
}

function PopUp({ text, cell, notice }: { text: string; cell: Cell; notice: Notice }): JSX.Element {
  return (
    <div class="pop-up" role="alertdialog" aria-label="Message">
      <p>{text}</p>
      <Button reason={cell.blocked.value} onPress={() => pressKey(cell, notice, { code: 255 })}>OK</Button>
    </div>
  );
}

/** Shows F1 to F8 below the last line, with the menus that the program has written there. */
function MenuKeys({ page, cell, notice }: { page: CellPage; cell: Cell; notice: Notice }): JSX.Element {
  const menus = menuTexts(page.lines[ROWS - 1] ?? "");
  return (
    <div class="menu-keys" role="group" aria-label="Menu keys">
      {Array.from({ length: 8 }, (_, at) => {
        const menu = (menus[at] ?? "").trim();
        const name = `F${at + 1}`;
        return (
          <Button key={name} label={menu === "" ? name : `${name} ${menu}`} reason={cell.blocked.value} onPress={() => pressKey(cell, notice, { code: 271 + at })}>
            {name}
          </Button>
        );
      })}
    </div>
  );
}
