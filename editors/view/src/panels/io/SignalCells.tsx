// Row of a signal: its value, its last seconds, and the operator's locks.

import type { JSX } from "preact";
import { Button } from "../shared/Button";
import type { Cell, Notice } from "../shared/cell";
import { addressOf, forceKeys, levelText, nameOf, numberFrom, placeOf, type SignalInfo, type SignalState } from "./signalRows";
import { HEIGHT, sparkPath, WIDTH } from "./sparkline";

const UNKNOWN: SignalState = { value: 0, isLocked: false, isSimulated: false, isProtected: false, fault: null };

interface Props {
  cell: Cell;
  notice: Notice;
  signal: SignalInfo;
}

interface StateProps extends Props {
  state: SignalState;
}

export function SignalCells({ cell, notice, signal }: Props): JSX.Element {
  const state = cell.levels.value.get(signal.link) ?? UNKNOWN;
  return (
    <>
      <th scope="row" title={`${nameOf(signal)}: ${signal.link}`}><span class={`dot ${signal.isDigital ? (state.value === 0 ? "off" : "on") : "analog"}`} aria-hidden="true" />{nameOf(signal)} <span class="direction">{placeOf(signal)}</span></th>
      <td class="level">{signal.isDigital ? <Digital {...{ cell, notice, signal, state }} /> : <Analog {...{ cell, notice, signal, state }} />}</td>
      <td class="marks"><Marks {...{ cell, notice, signal, state }} /></td>
      <td><Fault {...{ cell, notice, signal, state }} /></td>
      <td><Sparkline cell={cell} signal={signal} /></td>
    </>
  );
}

function Digital({ cell, notice, signal, state }: StateProps): JSX.Element {
  const text = levelText(signal, state.value);
  return (
    <Button
      className={`toggle ${state.value === 0 ? "off" : "on"}`} label={`${addressOf(signal.link)} is ${text}`} reason={cell.blocked.value} title={`${state.isLocked ? "Hold" : "Force"} ${signal.link} ${state.isLocked ? "at" : "to"} ${state.value === 0 ? "true" : "false"}`}
      onPress={() => void notice.operate(cell, forceKeys(signal, state.value === 0 ? 1 : 0, state.isLocked))} onRefused={(reason) => (notice.text.value = reason)}
    >
      {text}
    </Button>
  );
}

function Analog({ cell, notice, signal, state }: StateProps): JSX.Element {
  const text = String(Number(state.value.toFixed(3)));
  const blocked = cell.blocked.value;
  const force = (field: HTMLInputElement): void => {
    const value = numberFrom(field.value);
    if (value === undefined) {
      notice.text.value = `${signal.link} needs a number, not "${field.value}".`;
      field.value = text;
    } else {
      void notice.operate(cell, forceKeys(signal, value, state.isLocked));
    }
  };
  return (
    <>
      <input class="number" inputMode="decimal" aria-label={`Value of ${signal.link}`} value={text} readOnly={blocked !== undefined} title={blocked ?? `${state.isLocked ? "Held value of" : "Force"} ${signal.link}`} onChange={({ currentTarget }) => force(currentTarget)} />
      {signal.unit ? <span class="unit"> {signal.unit}</span> : null}
    </>
  );
}

function Sparkline({ cell, signal }: { cell: Cell; signal: SignalInfo }): JSX.Element {
  const path = sparkPath(cell.history.signals.of(signal.link), cell.slowTime.value, signal.isDigital);
  return <svg class="spark" width={WIDTH} height={HEIGHT} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true"><path d={path} /></svg>;
}

function Marks({ cell, notice, signal: { link, direction }, state }: StateProps): JSX.Element {
  const blocked = cell.blocked.value;
  const mark = (text: string, isOn: boolean, keys: object, title: string): JSX.Element => (
    <Button label={`${text} ${link}`} title={title} reason={blocked} isPressed={isOn} onPress={() => void notice.operate(cell, keys)} onRefused={(reason) => (notice.text.value = reason)}>{text}</Button>
  );
  const { isLocked, isSimulated, isProtected } = state;
  return (
    <>
      {mark("Lock", isLocked, { [isLocked ? "unlock" : "lock"]: link }, isLocked ? "Release the value, which the operator holds" : "Hold the present value. Its button then changes the held value")}
      {mark("Sim", isSimulated, { simulate: { [link]: !isSimulated } }, "The controller simulates the signal")}
      {direction === "output" ? mark("Prot", isProtected, { protect: { [link]: !isProtected } }, "The system reserves the output; programs that write it get error 124") : null}
    </>
  );
}

const FAULTS = [["0", "none"], ["-2", "-2 absent"], ["-3", "-3 failed"]] as const;

function Fault({ cell, notice, signal: { link }, state: { fault } }: StateProps): JSX.Element {
  const blocked = cell.blocked.value;
  return (
    <select
      class={fault === null ? "" : "faulty"} aria-label={`Fault of ${link}`} title={blocked ?? fault ?? "The status of the signal"} value={faultCode(fault)} disabled={blocked !== undefined}
      onChange={({ currentTarget }) => void notice.operate(cell, { fault: { link, code: Number(currentTarget.value) } })}
    >
      {FAULTS.map(([code, text]) => <option key={code} value={code}>{text}</option>)}
    </select>
  );
}

/** Returns the status of a faulty signal: -2 if its device is absent, otherwise -3. */
function faultCode(fault: string | null): string {
  return fault === null ? "0" : /absent|-2/.test(fault) ? "-2" : "-3";
}
