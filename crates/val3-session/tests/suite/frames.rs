//! Evaluation in the frames of a stopped run.

use expect_test::expect;
use val3_debug::{Breakpoint, BreakpointId, Debugger, Format, Progress, Stop};
use val3_lang::ports::TaskNumber;
use val3_session::{Evaluation, EvaluationError, FrameEvaluator, Purpose};
use val3_tests::running::{Running, application};
use val3_vm::FragmentContext;

/// A run at the last line of the program `show`.
struct Stopped {
    debugger: Debugger,
    evaluator: FrameEvaluator,
    task: TaskNumber,
}

impl Stopped {
    #[track_caller]
    fn at(listing: &str) -> Self {
        let mut debugger = Debugger::new(Running::start(listing).controller);
        let (file, row) = last_line(&debugger, "show");
        debugger.set_breakpoints(&file, vec![Breakpoint::new(BreakpointId(0), row)]);
        for _ in 0..1000 {
            if let Progress::Stopped(Stop::Breakpoints { task, .. }) = debugger.advance() {
                return Self { debugger, evaluator: FrameEvaluator::new(application(listing)), task };
            }
        }
        panic!("it does not stop: {:?}", debugger.controller.devices.take_events());
    }

    fn evaluate(&mut self, depth: usize, text: &str, purpose: Purpose) -> Result<Evaluation, EvaluationError> {
        let context = FragmentContext::Frame(self.task, depth);
        self.evaluator.evaluate(&mut self.debugger.controller, context, text, (purpose, Format::default()))
    }

    /// `type value` of a watched expression, or the error.
    fn watch(&mut self, text: &str) -> String {
        shown(self.evaluate(0, text, Purpose::Watch))
    }

    /// What the debug console answers.
    fn execute(&mut self, text: &str) -> String {
        shown(self.evaluate(0, text, Purpose::Execute))
    }

    fn assign(&mut self, target: &str, value: &str) -> String {
        let context = FragmentContext::Frame(self.task, 0);
        let assigned =
            self.evaluator.assign(&mut self.debugger.controller, context, (target, value), Format::default());
        assigned.map_or_else(|error| error.to_string(), |value| value.shown)
    }
}

fn shown(result: Result<Evaluation, EvaluationError>) -> String {
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

fn last_line(debugger: &Debugger, program: &str) -> (String, u32) {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let image = &application.image;
    let program = &image.programs[usize::from(image.program(program).unwrap())];
    (image.files[program.file as usize].clone(), program.lines.last().unwrap().row)
}

const VARIABLES: &str = r#"
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

#[test]
fn expressions_see_all_variables_of_a_frame() {
    let texts = "x_nTotal+x_nFactor
        l_nMany[2]
        l_bDone
        x_sNames[1]+\"s\"
        nCount==3
        l_tSlot.nCount
        tSlots[\"right\"].nCount
        nGrid[1,2]
        len(sNames[1])
        size(l_nMany)
        l_nMany
        tSlots
        l_tSlot
        pHome.trsf.rz
        distance(x_pAt,pHome)
        mFast.blend
        appro(pHome,{0,0,1,0,0,0})
        taskStatus(\"main~\")
        here(flange,world).trsf.x
        diMissing
        1/0
        sNames[5]
        {1,2,3,0,0,0}
        clock()>=0";
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> = texts.lines().map(|text| format!("{}: {}\n", text.trim(), stopped.watch(text))).collect();
    expect![[r#"
        x_nTotal+x_nFactor: num 4.5
        l_nMany[2]: num 9
        l_bDone: bool false
        x_sNames[1]+"s": string "bolts"
        nCount==3: bool true
        l_tSlot.nCount: num 2
        tSlots["right"].nCount: num 7
        nGrid[1,2]: num 5
        len(sNames[1]): num 4
        size(l_nMany): num 3
        l_nMany: num[3] 3 values
        tSlots: Slot[""] 2 values
        l_tSlot: Slot {nCount=2, sNames=…}
        pHome.trsf.rz: num 90
        distance(x_pAt,pHome): num 0
        mFast.blend: blend joint
        appro(pHome,{0,0,1,0,0,0}): point {{1,2,4,0,0,90},{ssame,esame,wsame}}
        taskStatus("main~"): num 1
        here(flange,world).trsf.x: num 50
        diMissing: `diMissing` is not declared: no local variable, parameter or data has this name
        1/0: error 10: division by zero
        sNames[5]: error 20: index too large
        {1,2,3,0,0,0}: the type of the values between these braces is not known
        clock()>=0: bool true
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(shown(stopped.evaluate(1, "l_nOuter", Purpose::Watch)), "num 4");
    assert!(shown(stopped.evaluate(1, "l_nMany", Purpose::Watch)).contains("not declared"));
    assert_eq!(shown(stopped.evaluate(2, "nCount", Purpose::Watch)), "the frame is no longer there");
}

#[test]
fn watched_expressions_have_no_side_effects() {
    let texts = "nCount=4
        nCount=nCount=4
        movej(pHome,tGripper,mFast)
        call double(nCount)
        delay(1)
        link(pHome,world)
        ? nCount
        toNum(\"3\",nCount,l_bDone)
        getKey()
        while true
        
        nCount";
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> = texts.lines().map(|text| format!("{}: {}\n", text.trim(), stopped.watch(text))).collect();
    expect![[r#"
        nCount=4: a statement has no value to show; execute it in the debug console
        nCount=nCount=4: a statement has no value to show; execute it in the debug console
        movej(pHome,tGripper,mFast): `movej` has side effects; execute it in the debug console
        call double(nCount): a statement has no value to show; execute it in the debug console
        delay(1): a statement has no value to show; execute it in the debug console
        link(pHome,world): a statement has no value to show; execute it in the debug console
        ? nCount: a statement has no value to show; execute it in the debug console
        toNum("3",nCount,l_bDone): `toNum` has side effects; execute it in the debug console
        getKey(): `getKey` has side effects; execute it in the debug console
        while true: `while` is a keyword of VAL 3 and cannot be a name
        : a statement has no value to show; execute it in the debug console
        nCount: num 3
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(stopped.watch("nCount\nnCount=4"), "write one expression");
}

#[test]
fn the_console_executes_statements() {
    let texts = "call double(x_nTotal)
        nCount
        ? nCount+1
        putln(\"a\")
        delay(5)
        wait(nCount==1)
        watch(nCount==1,2)
        ? 1/0
        call endless()
        nMissing=3
        logMsg(\"x\")
        taskStatus(\"main~\")
        taskCreate \"other\",10,show(nCount,pHome,sNames,2)
        taskStatus(\"other\")";
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> =
        texts.lines().map(|text| format!("{}: {}\n", text.trim(), stopped.execute(text))).collect();
    expect![[r#"
        call double(x_nTotal): 6
        nCount: num 6
        ? nCount+1: 7
        putln("a"): a
        delay(5): 
        wait(nCount==1): it waits for an event that cannot happen while the run stands still
        watch(nCount==1,2): bool false
        ? 1/0: error 10: division by zero
        call endless(): it was ended because it executes too many lines, probably in an endless loop
        nMissing=3: `nMissing` is not declared: no local variable, parameter or data has this name
        logMsg("x"): log: USR x
        bool true
        taskStatus("main~"): num 1
        taskCreate "other",10,show(nCount,pHome,sNames,2): 
        taskStatus("other"): num 1
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(stopped.execute("l_nMany[0]=2\n? l_nMany[0]+1\nput(\"a\")"), "3\na");
    assert_eq!(stopped.execute("? 1\n? 1/0"), "1\nerror 10: division by zero");
}

#[test]
fn values_are_assigned_to_all_that_is_assignable() {
    let pairs = [
        ("x_nTotal", "12.5"),
        ("nCount", "nCount+l_nMany[2]"),
        ("x_pAt.trsf", "{1,2,3,0,0,0}"),
        ("x_pAt.config.shoulder", "righty"),
        ("l_bDone", "true"),
        ("x_sNames[1]", "\"nut\""),
        ("tSlots[\"right\"].nCount", "1"),
        ("nGrid[1,2]", "-1"),
        ("pHome", "{{0,0,0,0,0,0},{lefty,epositive,wpositive}}"),
        ("mFast.vel", "50"),
        ("l_bDone", "3"),
        ("nCount+1", "3"),
        ("nMissing", "3"),
        ("l_nMany[7]", "3"),
        ("nCount", "3\nnGrid[0,0]=1"),
        ("nCount", "1/0"),
        ("x_nFactor", ""),
    ];
    let mut stopped = Stopped::at(VARIABLES);
    let values: Vec<String> =
        pairs.iter().map(|(target, value)| format!("{target}={value}: {}\n", stopped.assign(target, value))).collect();
    expect![[r#"
        x_nTotal=12.5: 12.5
        nCount=nCount+l_nMany[2]: 21.5
        x_pAt.trsf={1,2,3,0,0,0}: {1,2,3,0,0,0}
        x_pAt.config.shoulder=righty: righty
        l_bDone=true: true
        x_sNames[1]="nut": "nut"
        tSlots["right"].nCount=1: 1
        nGrid[1,2]=-1: -1
        pHome={{0,0,0,0,0,0},{lefty,epositive,wpositive}}: {{0,0,0,0,0,0},{lefty,epositive,wpositive}}
        mFast.vel=50: 50
        l_bDone=3: a `num` cannot be assigned to a `bool`
        nCount+1=3: a value can only be assigned to a variable
        nMissing=3: `nMissing` is not declared: no local variable, parameter or data has this name
        l_nMany[7]=3: error 20: index too large
        nCount=3
        nGrid[0,0]=1: `nCount` cannot be assigned to
        nCount=1/0: error 10: division by zero
        x_nFactor=: a value is expected here, but the line ends
    "#]]
    .assert_eq(&values.concat());
    assert_eq!(stopped.watch("nCount"), "num 21.5");
}
