// Page that shows and operates a run.

import { type JSX, render } from "preact";
import { connect } from "./connection";
import { Border } from "./layout/Border";
import { hasPanels, share, showPanels } from "./layout/layout";
import { followLook, isDark, toggleLook } from "./look";
import { IoPanel } from "./panels/io/IoPanel";
import { PendantPanel } from "./panels/pendant/PendantPanel";
import { PointsPanel } from "./panels/points/PointsPanel";
import { ProgramPanel } from "./panels/program/ProgramPanel";
import { followReach } from "./panels/points/reachQuery";
import type { Cell } from "./panels/shared/cell";
import { type Tab, Tabs } from "./panels/shared/Tabs";
import { CELL_TABS } from "./panels/shared/tabChoice";
import { TasksPanel } from "./panels/tasks/TasksPanel";
import { countUpTo } from "./panels/tasks/upTo";
import { SceneView } from "./scene/SceneView";
import { FaultBar } from "./status/FaultBar";
import { StatusLine } from "./status/StatusLine";
import { Store } from "./store";
import { RecordScenario } from "./scenario/RecordScenario";
import { TimeBar } from "./timeline/TimeBar";
import "./view.css";
import "./panels/panels.css";

function Page({ store }: { store: Store }): JSX.Element {
  const scene = store.scene.value;
  const isRecording = scene?.role === "recording";
  const isPreview = scene?.role === "preview";
  const isShown = hasPanels(isRecording);
  const [width, height] = [share("beside"), share("below")];
  return (
    <div class="page">
      <header>
        <h1 title={scene?.arm.name}>{scene?.application ?? "VAL 3"}</h1>
        <span class="arm">{scene?.arm.name ?? ""}</span>
        {scene?.arm.isDefault === true ? <span class="note" title="Neither the settings nor the cell name an arm. Name yours with --arm, in val3.toml or in arm.cfx.">no arm is named</span> : undefined}
        {scene?.arm.timesNote == null ? undefined : <span class="note" title={scene.arm.timesNote}>times of a model arm</span>}
        <StatusLine store={store} />
        <span class="actions">
          <LaunchButtons store={store} />
          <RecordScenario store={store} />
          <button type="button" onClick={toggleLook}>{isDark.value ? "Light" : "Dark"}</button>
          <button type="button" aria-pressed={isShown} title="Show or hide the pendant, signals, programs, tasks and points" onClick={() => showPanels(isRecording, !isShown)}>Panels</button>
        </span>
      </header>
      <main
        class={isShown ? undefined : "without-panels"}
        style={{ "--panel-width": width === undefined ? undefined : `${width}%`, "--panel-height": height === undefined ? undefined : `${height}%` }}
      >
        <div class="picture-column">
          <FaultBar store={store} />
          <SceneView store={store} />
        </div>
        {isShown ? <Border /> : null}
        {isShown ? <Panels store={store} /> : null}
      </main>
      {isPreview ? null : <TimeBar store={store} />}
    </div>
  );
}

/** Buttons that start the application of a preview in an editor. */
function LaunchButtons({ store }: { store: Store }): JSX.Element | null {
  const launch = store.launch.value;
  return launch === undefined || store.scene.value?.role !== "preview" ? null : (
    <>
      <button type="button" title="Run the application" onClick={() => launch(true)}>Run</button>
      <button type="button" title="Run the application with the debugger" onClick={() => launch(false)}>Debug</button>
    </>
  );
}

function Panels({ store }: { store: Store }): JSX.Element {
  const { cell } = store.panels;
  const faults = countUpTo(cell.history.faults, cell.slowTime.value);
  // An editor shows the programs itself.
  const program: Tab[] = cell.openLine.value === undefined ? [{ id: "program", label: "Program", content: () => <ProgramPanel cell={cell} /> }] : [];
  const isPreview = store.scene.value?.role === "preview";
  return (
    <div class="column panel-tabs">
      <Tabs
        label={CELL_TABS}
        tabs={[
          { id: "pendant", label: "Pendant", content: () => (isPreview ? <NoRun name="Pendant" cell={cell} /> : <PendantPanel cell={cell} />) },
          { id: "io", label: "Inputs and outputs", content: () => (isPreview ? <NoRun name="Inputs and outputs" cell={cell} /> : <IoPanel cell={cell} />) },
          ...program,
          { id: "tasks", label: "Tasks", faults, content: () => (isPreview ? <NoRun name="Tasks" cell={cell} /> : <TasksPanel cell={cell} />) },
          { id: "points", label: "Points", content: () => <PointsPanel cell={cell} /> },
        ]}
      />
    </div>
  );
}

/** Panel before a run: its controls would do nothing. */
function NoRun({ name, cell }: { name: string; cell: Cell }): JSX.Element {
  return <section class="panel" aria-label={name}><p class="blocked">{cell.blocked.value}</p></section>;
}

const store = new Store();
followLook();
followReach(store.panels.cell);
render(<Page store={store} />, document.body);
connect(store);
