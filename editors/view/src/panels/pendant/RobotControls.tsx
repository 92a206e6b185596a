// Run, Stop, Move/Hold, power, E-stop, working mode and monitor speed.

import type { JSX } from "preact";
import { Button } from "../shared/Button";
import type { Cell, Notice } from "../shared/cell";
import { endReason, hasFailed, MODES, nextSpeed, powerReason, runReason, speedFrom } from "./robotState";
import { type ArmStart, startAgain } from "./startAgain";
import { AT_ONCE, pressNow } from "./stopNow";

interface Props {
  cell: Cell;
  notice: Notice;
}

export function RobotControls({ cell, notice }: Props): JSX.Element {
  const state = cell.state.value;
  const blocked = cell.blocked.value;
  const ended = endReason(cell.hasEnded.value, cell.canRestart.value);
  const armEnded = cell.armEnded.value;
  const isOver = cell.hasEnded.value || hasFailed(state);
  const operate = (keys: object): void => void notice.operate(cell, keys);
  const refused = (reason: string): void => void (notice.text.value = reason);
  const run = (arm: ArmStart): void => void startAgain(cell, notice, arm);
  const isPast = cell.isPastOnly.value;
  const stopNow = (keys: object, text: string): void => void pressNow(cell, notice, keys, text);
  const isPowered = state?.power ?? false;
  const isStopped = state?.emergencyStop === "open";
  const isHeld = state?.isHeld ?? false;
  return (
    <div class="robot-controls" role="group" aria-label="Robot">
      <div class="row">
        <Button title="Read the files and start the application again. The arm stays where it is." reason={blocked ?? runReason(cell.isPaused.value, isOver, cell.canRestart.value)} onPress={() => run("stays")} onRefused={refused}>Run</Button>
        <Button reason={blocked ?? ended} title="Stop the application" onPress={() => operate({ stop: true })} onRefused={refused}>Stop</Button>
        {isPast ? <Button reason={ended} title={`Hold the arm. ${AT_ONCE}`} onPress={() => stopNow({ move: false }, "Hold was pressed.")} onRefused={refused}>Hold now</Button> : (
          <Button reason={blocked ?? ended} title={isHeld ? "Let the programs move the arm" : "Hold the arm"} onPress={() => operate({ move: isHeld })} onRefused={refused}>
            {isHeld ? "Move" : "Hold"}
          </Button>
        )}
        <Button className={isPowered ? "power on" : "power"} title={isPowered ? "The power is on" : "The power is off"} reason={blocked ?? armEnded ?? powerReason(state)} onPress={() => operate({ power: !isPowered })} onRefused={refused}>
          Switch power {isPowered ? "off" : "on"}
        </Button>
        {isPast ? <Button className="e-stop" reason={armEnded} title={`Press the E-stop. ${AT_ONCE}`} onPress={() => stopNow({ estop: true }, "The E-stop was pressed.")} onRefused={refused}>E-stop now</Button> : (
          <Button className={isStopped ? "e-stop pressed" : "e-stop"} reason={blocked ?? armEnded} onPress={() => operate({ estop: !isStopped })} onRefused={refused}>
            {isStopped ? "Release E-stop" : "E-stop"}
          </Button>
        )}
      </div>
      <div class="row">
        <ModeChoice cell={cell} notice={notice} />
        <SpeedField cell={cell} notice={notice} />
        {/* The last button, because it appears at the end of a run and must not move other buttons of the robot. */}
        {isOver && cell.canRestart.value ? <Button title="Start the application again with the arm at the initial position of the settings" reason={blocked} onPress={() => run("initial")} onRefused={refused}>Run from initial position</Button> : null}
      </div>
    </div>
  );
}

function ModeChoice({ cell, notice }: Props): JSX.Element {
  const mode = cell.state.value?.mode ?? "";
  const blocked = cell.blocked.value ?? cell.armEnded.value;
  return (
    <label>
      Mode{" "}
      <select value={mode} disabled={blocked !== undefined} title={blocked} onChange={({ currentTarget }) => void notice.operate(cell, { mode: currentTarget.value })}>
        {MODES.some((known) => known === mode) ? null : <option value={mode}>{mode}</option>}
        {MODES.map((name) => <option key={name} value={name}>{name}</option>)}
      </select>
    </label>
  );
}

function SpeedField({ cell, notice }: Props): JSX.Element {
  const speed = cell.state.value?.monitorSpeed ?? 0;
  const blocked = cell.blocked.value ?? cell.armEnded.value;
  const turn = (to: number): void => void notice.operate(cell, { monitor_speed: to });
  const enter = (field: HTMLInputElement): void => {
    const to = speedFrom(field.value);
    if (to === undefined) {
      notice.text.value = `The monitor speed is 0 to 100 %, not "${field.value}".`;
      field.value = String(speed);
    } else {
      turn(to);
    }
  };
  return (
    <div class="speed" role="group" aria-label="Monitor speed">
      <span>Monitor speed</span>
      <Button label="Slower" reason={blocked} onPress={() => turn(nextSpeed(speed, -1))}>−</Button>
      <input aria-label="Monitor speed in per cent" inputMode="decimal" value={speed} readOnly={blocked !== undefined} title={blocked} onChange={({ currentTarget }) => enter(currentTarget)} />
      <span aria-hidden="true">%</span>
      <Button label="Faster" reason={blocked} onPress={() => turn(nextSpeed(speed, 1))}>+</Button>
    </div>
  );
}
