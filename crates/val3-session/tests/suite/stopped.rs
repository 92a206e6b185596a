//! A stopped run, and the evaluator for its stack frames.

use camino::Utf8Path;
use tempfile::TempDir;
use val3_analysis::system::Disk;
use val3_debug::{AdvanceResult, Breakpoint, BreakpointId, Debugger, DisplayFormat, Stop};
use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_session::{Application, ControllerSettings, Evaluation, EvaluationError, FrameEvaluator, Purpose, Tape};
use val3_test::Fixture;
use val3_tests::running::{Running, application};
use val3_vm::FragmentContext;

/// Variables of all kinds, and programs that change them.
pub(crate) const VARIABLES: &str = r#"
type Slot "Disk://Slot/Slot.pjx"
num nCount
string sNames[2]
point pHome
frame fTable
tool tGripper
mdesc mFast
Slot tSlots["left","right"]
num nGrid[2,3]
program start()
num l_nOuter
begin
  nCount=3
  sNames[1]="bolt"
  l_nOuter=4
  link(fTable,world)
  link(pHome,fTable)
  link(tGripper,flange)
  fTable.trsf.z=100
  pHome.trsf={1,2,3,0,0,90}
  tSlots["right"].nCount=7
  nGrid[1,2]=5
  call show(nCount,pHome,sNames,1.5)
end
program show(num& x_nTotal, point& x_pAt, string& x_sNames[], num x_nFactor)
num l_nMany[3]
bool l_bDone
Slot l_tSlot
begin
  l_nMany[2]=9
  l_tSlot.nCount=2
  ? "here"
end
program double(num& x_nValue)
begin
  x_nValue=x_nValue*2
  ? x_nValue
end
program again(num x_nDepth)
num l_nMany[100]
begin
  call again(x_nDepth+1)
end
program endless()
begin
  while true
    nCount=nCount+1
  endWhile
end
--- Slot
public num nCount
public string sNames[2]
"#;

/// A run stopped at the last line of the program `show`.
pub(crate) struct Stopped {
    pub(crate) debugger: Debugger,
    pub(crate) evaluator: FrameEvaluator,
    pub(crate) task: TaskNumber,
    /// Folder of the application, if its files are on a disk.
    pub(crate) folder: Option<TempDir>,
}

impl Stopped {
    #[track_caller]
    pub(crate) fn at(listing: &str) -> Self {
        Self::on(Running::devices(), listing)
    }

    /// Runs the application on a controller with these devices.
    #[track_caller]
    pub(crate) fn on(devices: Devices, listing: &str) -> Self {
        Self::of(Running::on(devices, listing).controller, application(listing), None)
    }

    /// Runs the application from a folder, so that its libraries can be loaded.
    #[track_caller]
    pub(crate) fn on_disk(listing: &str) -> Self {
        let (folder, mut controller, application) = on_disk(listing);
        controller.start("start").unwrap();
        Self::of(controller, application, Some(folder))
    }

    #[track_caller]
    fn of(controller: Controller, application: Application, folder: Option<TempDir>) -> Self {
        let mut debugger = Debugger::new(controller);
        let (file, row) = last_line(&debugger, "show");
        debugger.set_breakpoints(&file, vec![Breakpoint::new(BreakpointId(0), row)]);
        for _ in 0..1000 {
            if let AdvanceResult::Stopped(Stop::Breakpoints { task, .. }) = debugger.advance() {
                return Self { debugger, evaluator: FrameEvaluator::new(application), task, folder };
            }
        }
        panic!("it does not stop: {:?}", debugger.controller.devices.take_events());
    }

    pub(crate) fn evaluate(
        &mut self,
        depth: usize,
        text: &str,
        purpose: Purpose,
    ) -> Result<Evaluation, EvaluationError> {
        let context = FragmentContext::Frame(self.task, depth);
        self.evaluator.evaluate(&mut self.debugger.controller, context, text, purpose, DisplayFormat::default())
    }

    /// `type value` of a watched expression, or the error.
    pub(crate) fn watch(&mut self, text: &str) -> String {
        shown(self.evaluate(0, text, Purpose::Watch))
    }

    /// Response of the debug console.
    pub(crate) fn execute(&mut self, text: &str) -> String {
        shown(self.evaluate(0, text, Purpose::Execute))
    }

    pub(crate) fn assign(&mut self, target: &str, value: &str) -> String {
        let context = FragmentContext::Frame(self.task, 0);
        let assigned =
            self.evaluator.assign(&mut self.debugger.controller, context, target, value, DisplayFormat::default());
        assigned.map_or_else(|error| error.to_string(), |value| value.shown)
    }
}

/// Printed lines, and the value as `type value` or the error.
pub(crate) fn shown(result: Result<Evaluation, EvaluationError>) -> String {
    match result {
        Ok(Evaluation { value, mut output, .. }) => {
            output.extend(value.map(|value| format!("{} {}", value.type_name, value.shown)));
            output.join("\n")
        }
        Err(error) => {
            let mut output = error.done().map(|done| done.output.clone()).unwrap_or_default();
            output.push(error.to_string());
            output.join("\n")
        }
    }
}

/// An application in a folder, on its controller.
#[track_caller]
pub(crate) fn on_disk(listing: &str) -> (TempDir, Controller, Application) {
    let folder = tempfile::tempdir().unwrap();
    let root = Utf8Path::from_path(folder.path()).unwrap();
    for (path, text) in &Fixture::parse(listing).files {
        let path = root.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let application = Application::open(&Disk, &root.join("usrapp/main"), None).unwrap();
    let image = application.compile().unwrap();
    let settings = ControllerSettings::default();
    let controller = application.controller(&settings, Tape::default(), image).unwrap();
    (folder, controller, application)
}

/// File and row of the last line of a program, in any application or library.
fn last_line(debugger: &Debugger, name: &str) -> (String, u32) {
    let found = debugger.controller.vm.space.loaded().find_map(|(_, instance)| {
        let program = &instance.image.programs[usize::from(instance.image.program(name)?)];
        Some((instance.image.files[program.file as usize].clone(), program.lines.last()?.row))
    });
    found.unwrap()
}
