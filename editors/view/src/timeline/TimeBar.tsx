// Shown time: pause, single cycle, speed, and the entire history.

import { computed } from "@preact/signals";
import type { JSX, TargetedWheelEvent } from "preact";
import { useEffect, useMemo } from "preact/hooks";
import { hasFailed } from "../panels/pendant/robotState";
import { Button } from "../panels/shared/Button";
import { Notice } from "../panels/shared/cell";
import { NoticeLine } from "../panels/shared/NoticeLine";
import type { Range } from "../panels/tasks/range";
import type { Store } from "../store";
import { jumpFrom, type Target } from "./jumps";
import { listen } from "./keys";
import { Marks } from "./Marks";
import { Player } from "./player";
import { TimeZoom } from "./zoom";

/** Distance from the track to the slider ends, in px. */
const THUMB = 7;

const TARGET_NAMES: Record<Target, string> = { move: "a move", error: "an error", near: "things that are too near to each other" };

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 25, 50, 100] as const;

export function TimeBar({ store }: { store: Store }): JSX.Element {
  const notice = useMemo(() => new Notice(), []);
  const player = useMemo(() => new Player(store), [store]);
  const { time, newest, earliest, chosen, isPaused } = store;
  const zoom = useMemo(() => new TimeZoom(computed(() => [earliest.value, Math.max(newest.value, earliest.value + 0.004)]), time), [store]);
  const isPast = chosen.value !== undefined;
  const isRecording = store.scene.value?.role === "recording";
  const present = (): void => {
    player.pause();
    chosen.value = undefined;
  };
  const seek = (t: number): void => {
    player.pause();
    chosen.value = t;
  };
  const toggle = (): void => {
    if (player.isPlaying.peek()) {
      player.pause();
    } else if (chosen.peek() !== undefined || isRecording) {
      player.play();
    } else {
      void notice.send(store.panels.cell, "pace", { isPaused: !isPaused.peek() });
    }
  };
  const bounded = (t: number): number => Math.min(Math.max(earliest.peek(), t), newest.peek());
  // An export shows its run without a click.
  useEffect(() => {
    if (isRecording && !matchMedia("(prefers-reduced-motion: reduce)").matches) {
      player.playWhenRead();
    }
  }, [player, isRecording]);
  useEffect(() => listen({
    toggle, step: (seconds) => seek(bounded(time.peek() + seconds)), first: () => seek(earliest.peek()), last: () => (isRecording ? seek(newest.peek()) : present()),
  }), [store, isRecording]);
  return (
    <section class="time-bar" aria-label="Time">
      {isPast || isRecording ? <PastControls store={store} player={player} /> : <LiveControls store={store} notice={notice} />}
      <Track store={store} zoom={zoom} onSeek={seek} onToggle={toggle} />
      <Jumps store={store} onSeek={seek} />
      <output class="time" title={earliest.value > 0 ? `What was before ${earliest.value.toFixed(0)} s is forgotten` : undefined}>{time.value.toFixed(3)} s of {newest.value.toFixed(3)} s</output>
      {isRecording ? null : <button type="button" aria-pressed={!isPast} onClick={present}>{isPast ? "Return to the present" : presentText(store)}</button>}
      <NoticeLine notice={notice} />
    </section>
  );
}

/** Returns a word about the newest time. */
function presentText({ end, isPaused, isStopped, lost, panels }: Store): string {
  const isOver = end.value !== undefined || hasFailed(panels.cell.state.value);
  return isOver ? "End" : lost.value !== undefined ? "Lost" : isStopped.value ? "Stopped" : isPaused.value ? "Paused" : "Live";
}

/** The time as a slider. The wheel zooms into it. */
function Track({ store: { time }, store, zoom, onSeek, onToggle }: { store: Store; zoom: TimeZoom; onSeek: (t: number) => void; onToggle: () => void }): JSX.Element {
  const [start, end] = zoom.range.value;
  const wheel = (event: TargetedWheelEvent<HTMLDivElement>): void => {
    event.preventDefault();
    const { left, width } = event.currentTarget.getBoundingClientRect();
    const around = start + ((event.clientX - left - THUMB) / Math.max(1, width - 2 * THUMB)) * (end - start);
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      zoom.shift(event.deltaX + event.deltaY > 0 ? 0.1 : -0.1);
    } else {
      zoom.zoom(event.deltaY > 0 ? 1.25 : 0.8, Math.min(Math.max(around, start), end));
    }
  };
  return (
    <div class="track" title="The wheel zooms, with Shift it moves the shown range" onWheel={wheel}>
      <Marks store={store} zoom={zoom} />
      <AwaitedPast store={store} range={zoom.range.value} />
      <input
        type="range" aria-label="Shown time" aria-valuetext={`${time.value.toFixed(3)} seconds`} min={start} max={end} step={0.004} value={time.value}
        onKeyDown={(event) => {
          if (event.key === " ") {
            event.preventDefault();
            onToggle();
          }
        }}
        onInput={({ currentTarget }) => onSeek(Number(currentTarget.value))}
      />
      {zoom.isZoomed.value ? <button type="button" class="whole" title="Show the entire time" onClick={() => zoom.reset()}>{start.toFixed(1)}–{end.toFixed(1)} s ×</button> : null}
    </div>
  );
}

/** Hatches the part of the shown range whose messages are not there yet. */
function AwaitedPast({ store: { earliest, oldest }, range: [start, end] }: { store: Store; range: Range }): JSX.Element | null {
  const share = (Math.min(oldest.value, end) - start) / (end - start);
  if (earliest.value >= oldest.value || share <= 0) {
    return null;
  }
  const text = `The run before ${oldest.value.toFixed(0)} s is being loaded`;
  return <div class="awaited" role="img" aria-label={text} title={text} style={{ width: `calc(${share} * (100% - 14px))` }} />;
}

/** Buttons to the previous and the next move, error, and, in a cell with things, encounter. */
function Jumps({ store, onSeek }: { store: Store; onSeek: (t: number) => void }): JSX.Element {
  const jump = (target: Target, isForward: boolean): void => {
    const t = jumpFrom(store.panels.cell.history.events, target, store.time.peek(), isForward);
    if (t !== undefined) {
      onSeek(t);
    }
  };
  const targets: readonly Target[] = store.scene.value?.objects?.length ? ["move", "error", "near"] : ["move", "error"];
  return (
    <>
      {targets.map((target) => (
        <span key={target} class="jumps" role="group" aria-label={`Jump to ${TARGET_NAMES[target]}`}>
          <button type="button" aria-label={`Previous ${target}`} title={`Previous ${target}`} onClick={() => jump(target, false)}>◀</button>
          <span aria-hidden="true">{target}</span>
          <button type="button" aria-label={`Next ${target}`} title={`Next ${target}`} onClick={() => jump(target, true)}>▶</button>
        </span>
      ))}
    </>
  );
}

function PastControls({ store, player }: { store: Store; player: Player }): JSX.Element {
  const isPlaying = player.isPlaying.value;
  const step = (cycles: number): void => {
    player.pause();
    store.chosen.value = Math.min(Math.max(0, store.time.peek() + cycles * 0.004), store.newest.peek());
  };
  return (
    <>
      <button type="button" onClick={() => (isPlaying ? player.pause() : player.play())}>{isPlaying ? "Pause" : "Play"}</button>
      <button type="button" title="One cycle back" onClick={() => step(-1)}>−4 ms</button>
      <button type="button" title="One cycle forward" onClick={() => step(1)}>+4 ms</button>
      <label title="How fast the past is shown">Playback speed{" "}
        <select value={player.speed.value} onChange={({ currentTarget: { value } }) => (player.speed.value = value === "max" ? value : Number(value))}>
          {SPEEDS.map((speed) => <option key={speed} value={speed}>{speed} ×</option>)}
          <option value="max">as fast as it goes</option>
        </select>
      </label>
    </>
  );
}

function LiveControls({ store, notice }: { store: Store; notice: Notice }): JSX.Element {
  const { cell } = store.panels;
  const blocked = store.blocked.value ?? (store.end.value === undefined ? undefined : "The run has ended.");
  const isPaused = store.isPaused.value;
  const speed = store.speed.value;
  const refused = (reason: string): void => void (notice.text.value = reason);
  if (store.scene.value?.role === "debugger") {
    return <span class="pace">{store.isStopped.value ? "Stopped by the debugger" : "Run by the debugger"}</span>;
  }
  return (
    <>
      <Button reason={blocked} title={isPaused ? "Continue the clock of the run" : "Stop the clock of the run, with all tasks and the arm"} onPress={() => void notice.send(cell, "pace", { isPaused: !isPaused })} onRefused={refused}>{isPaused ? "Play" : "Pause"}</Button>
      <Button reason={blocked ?? (isPaused ? undefined : "Pause the run to execute single cycles.")} title="Execute one cycle of 4 ms" onPress={() => void notice.send(cell, "cycle", {})} onRefused={refused}>+4 ms</Button>
      <label title="How fast the clock of the controller runs. The arm keeps its speed on this clock.">Clock speed{" "}
        <select value={String(speed)} disabled={blocked !== undefined} title={blocked} onChange={({ currentTarget: { value } }) => void notice.send(cell, "pace", { speed: value === "max" ? value : Number(value) })}>
          {SPEEDS.some((known) => known === speed) || speed === "max" ? null : <option value={speed}>{speed} ×</option>}
          {SPEEDS.map((known) => <option key={known} value={known}>{known} ×</option>)}
          <option value="max">as fast as it goes</option>
        </select>
      </label>
    </>
  );
}
