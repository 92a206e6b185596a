//! Replacement of lines while tasks execute the program.

use val3_debug::{AdvanceResult, Debugger, PastLimits, StepKind, Stop};
use val3_session::{FrameEvaluator, ReplaceFault};
use val3_test::Fixture;
use val3_tests::running::{Running, application};
use val3_vm::ProgramId;

/// Loops, branches and calls by reference, whose result is the same with all lines of [`VARIANTS`].
const LISTING: &str = r#"
num nSum
num nOther
num nUnused
string sText
num nGrid[3]
program start()
num l_n
num l_nK
begin
  for l_n=1 to 40
    nSum=nSum+l_n
    call add(l_n,l_nK)
    // first note
    while l_nK>0
      l_nK=l_nK-1
      nGrid[l_nK%3]=nGrid[l_nK%3]+l_n
    endWhile
    switch l_n%3
      case 0
        sText=left(sText+"a",20)
      break
      default
        nOther=nOther+2
      break
    endSwitch
    if l_n>20 and nOther<100
      nOther=nOther+1
    else
      do
        nOther=nOther-1
      until nOther<5000
    endIf
  endFor
end
program add(num x_nAt, num& x_nOut)
num l_nTwice
begin
  l_nTwice=x_nAt*2
  call half(l_nTwice,x_nOut)
  // second note
  nOther=nOther+l_nTwice
end
program half(num x_nAt, num& x_nOut)
num l_nFrom
begin
  for l_nFrom=x_nAt/2 to x_nAt/2+1
    x_nOut=roundDown(x_nAt/4)%5
  endFor
  x_nOut=x_nOut+1
end
"#;

/// Lines with the same effect, the line of the listing first.
const VARIANTS: &[&[&str]] = &[
    &["nSum=nSum+l_n", "nSum=(nSum+17)+(l_n-17)", "nSum=l_n+nSum"],
    &["call add(l_n,l_nK)", "call add(l_n*3-l_n*2,l_nK)"],
    &["// first note", "nUnused=nUnused+31", "nUnused=max(nUnused*5,min(l_n,71))", ""],
    &["while l_nK>0", "while l_nK>0 and l_nK<977", "while l_nK*11>0"],
    &["l_nK=l_nK-1", "l_nK=(l_nK+100)-101"],
    &["nGrid[l_nK%3]=nGrid[l_nK%3]+l_n", "nGrid[(l_nK+3)%3]=l_n+nGrid[(l_nK+6)%3]"],
    &["switch l_n%3", "switch (l_n+9)%3"],
    &["case 0", "case 0,77"],
    &["sText=left(sText+\"a\",20)", "sText=left(sText+left(\"abc\",1),20)"],
    &["if l_n>20 and nOther<100", "if nOther<100 and l_n*2>40"],
    &["until nOther<5000", "until !(nOther>=5000)"],
    &["for l_n=1 to 40", "for l_n=1 to 80/2"],
    &["l_nTwice=x_nAt*2", "l_nTwice=x_nAt*3-x_nAt"],
    &["call half(l_nTwice,x_nOut)", "call half(l_nTwice+0,x_nOut)"],
    &["// second note", "nUnused=nUnused-l_nTwice*43", "// other note"],
    &["nOther=nOther+l_nTwice", "nOther=nOther+(l_nTwice*8)/8"],
    &["for l_nFrom=x_nAt/2 to x_nAt/2+1", "for l_nFrom=(x_nAt*2)/4 to 1+x_nAt/2"],
    &["x_nOut=roundDown(x_nAt/4)%5", "x_nOut=roundDown((x_nAt+x_nAt)/8)%5"],
    &["x_nOut=x_nOut+1", "x_nOut=(x_nOut*2+2)/2"],
];

/// Line of the listing in the application.
struct ListedLine {
    program: ProgramId,
    row: u32,
    variants: &'static [&'static str],
}

fn lines(debugger: &Debugger) -> Vec<ListedLine> {
    let (instance, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let fixture = Fixture::parse(LISTING);
    let found = VARIANTS.iter().map(|variants| {
        fixture.files.iter().find_map(|(path, text)| {
            let row = text.lines().position(|line| line.trim() == variants[0])?;
            let name = path.rsplit(['/', '\\']).next()?.strip_suffix(".pgx")?;
            let program = ProgramId { instance, number: application.image.program(name)? };
            Some(ListedLine { program, row: u32::try_from(row + 1).unwrap(), variants })
        })
    });
    found.map(Option::unwrap).collect()
}

/// Values of all compared data.
fn result(debugger: &Debugger) -> Vec<String> {
    let (_, application) = debugger.controller.vm.space.loaded().next().unwrap();
    let names = ["nSum", "nOther", "sText", "nGrid"].into_iter();
    let shown = names.map(|name| {
        let store = application.data[usize::from(application.image.data(name).unwrap())];
        let store = debugger.controller.vm.space.memory.store(store).unwrap();
        format!("{name} {:?} {:?}", store.nums, store.texts)
    });
    shown.collect()
}

/// Runs line by line to the end. `at_line` is called before each line with its number.
fn run(debugger: &mut Debugger, mut at_line: impl FnMut(&mut Debugger, usize)) {
    for number in 0.. {
        at_line(debugger, number);
        let Some(task) = debugger.controller.vm.tasks().first().map(|task| task.id) else { return };
        debugger.step(task, StepKind::In);
        loop {
            match debugger.advance() {
                AdvanceResult::Stopped(Stop::Step { .. }) => break,
                AdvanceResult::Ran(status) if status.is_final() => return,
                AdvanceResult::Ran(_) => {}
                AdvanceResult::Stopped(other) => panic!("{other:?}"),
            }
        }
    }
}

/// Next number of a sequence that only its start determines.
fn next(state: &mut u64, below: usize) -> usize {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    usize::try_from(*state >> 33).unwrap() % below
}

#[test]
fn replaced_lines_keep_the_state_of_running_tasks() {
    let mut plain = Debugger::new(Running::start(LISTING).controller);
    run(&mut plain, |_, _| {});
    let expected = result(&plain);
    let (mut replaced, mut busy) = (0, 0);
    for seed in 1..=10 {
        let running = match seed % 2 {
            0 => Running::start(LISTING),
            _ => Running::debugged_on(Running::devices(), LISTING),
        };
        let mut debugger = Debugger::new(running.controller);
        let mut evaluator = FrameEvaluator::new(application(LISTING));
        let (lines, mut state) = (lines(&debugger), seed);
        run(&mut debugger, |debugger, number| {
            if number % 11 != 0 {
                return;
            }
            let line = &lines[next(&mut state, lines.len())];
            let code = line.variants[next(&mut state, line.variants.len())];
            match evaluator.replace_line(debugger, line.program, line.row, code) {
                Ok(()) => replaced += 1,
                Err(ReplaceFault::Busy(_)) => busy += 1,
                Err(fault) => panic!("{code}: {fault}"),
            }
        });
        assert!(!debugger.controller.has_failed_tasks());
        assert_eq!(result(&debugger), expected, "seed {seed}");
    }
    assert!(replaced > 500 && busy > 0, "{replaced} {busy}");
}

#[test]
fn a_replacement_begins_the_history() {
    let mut debugger = Debugger::new(Running::start(LISTING).controller);
    let mut evaluator = FrameEvaluator::new(application(LISTING));
    debugger.record(PastLimits::default());
    let lines = lines(&debugger);
    let mut first = None;
    run(&mut debugger, |debugger, number| {
        if number == 200 {
            evaluator.replace_line(debugger, lines[0].program, lines[0].row, "nSum=nSum+1000").unwrap();
            first = debugger.first_moment();
            assert_eq!(debugger.reach().unwrap().time, 0);
        }
    });
    assert!(first.is_some() && debugger.first_moment() == first);
    // 40 rounds, of which the last ones add 1000.
    assert_ne!(result(&debugger)[0], "nSum [820.0] []");
}

#[test]
fn a_rejected_line_changes_nothing() {
    let mut debugger = Debugger::new(Running::start(LISTING).controller);
    let mut evaluator = FrameEvaluator::new(application(LISTING));
    let lines = lines(&debugger);
    let line = |code: &str| lines.iter().find(|line| line.variants[0] == code).unwrap();
    for (old, new, expected) in [
        ("nSum=nSum+l_n", "nSum=nUnknown", "Code"),
        ("nSum=nSum+l_n", "nSum=nSum+l_n\nnSum=0", "Code"),
        ("nSum=nSum+l_n", "if true", "Blocks"),
        ("nSum=nSum+l_n", "endFor", "Blocks"),
        ("while l_nK>0", "nSum=0", "Blocks"),
        ("while l_nK>0", "if l_nK>0", "Blocks"),
        ("case 0", "default", "Blocks"),
    ] {
        let ListedLine { program, row, .. } = *line(old);
        let fault = evaluator.replace_line(&mut debugger, program, row, new).unwrap_err();
        assert!(format!("{fault:?}").starts_with(expected), "{new}: {fault:?}");
    }
    let ListedLine { program, .. } = lines[0];
    for row in [0, 1, 9_999] {
        assert_eq!(evaluator.replace_line(&mut debugger, program, row, "nSum=0"), Err(ReplaceFault::Blocks));
    }
    let mut plain = Debugger::new(Running::start(LISTING).controller);
    run(&mut plain, |_, _| {});
    run(&mut debugger, |_, _| {});
    assert_eq!(result(&debugger), result(&plain));
}
