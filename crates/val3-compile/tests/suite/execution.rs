//! Execution of compiled programs: the output of `?`, and the error that stops them.

use std::sync::Arc;

use expect_test::{Expect, expect};
use val3_bytecode::Image;
use val3_lang::ports::Time;
use val3_machine::controller::{Controller, RunStatus};
use val3_machine::devices::{Devices, Libraries};
use val3_machine::event::{Event, EventKind};
use val3_machine::files::{ControllerPath, LibraryFiles, Roots};

use crate::show::image;

struct NoLibraries;

impl Libraries for NoLibraries {
    fn image(&mut self, _: &ControllerPath, _: LibraryFiles) -> Result<Arc<Image>, String> {
        Err("none".to_owned())
    }
}

/// Longest duration of an application, in ns of its own time.
const LONGEST: Time = 1_000_000_000_000;

/// Duration of a line, in ns.
pub(crate) const LINE_COST: Time = 2_000;

/// Creates a controller whose application has begun.
pub(crate) fn started(image: &Arc<Image>, line_cost: Time) -> Controller {
    let devices = Devices::new(Roots::default(), Box::new(NoLibraries));
    let mut controller = Controller::new(devices, Arc::clone(image), "Disk://main".to_owned(), line_cost).unwrap();
    controller.start("start").unwrap();
    controller
}

/// Runs an application, and returns its events.
pub(crate) fn events(image: &Arc<Image>, line_cost: Time) -> Vec<Event> {
    rest(&mut started(image, line_cost))
}

/// Runs an application to its end, and returns the remaining events.
pub(crate) fn rest(controller: &mut Controller) -> Vec<Event> {
    let mut events = Vec::new();
    while controller.now() < LONGEST {
        let step = controller.step();
        events.extend(controller.devices.take_events());
        match step {
            status if status.is_final() => return events,
            RunStatus::Waiting(Some(wake)) => controller.jump(wake),
            _ => {}
        }
    }
    panic!("goes on: {events:?}");
}

/// Runs an application, and returns the printed lines and its tasks' errors.
#[track_caller]
pub(crate) fn run(listing: &str) -> String {
    run_at(listing, LINE_COST)
}

/// Like [`run`], with a line duration of `line_cost` ns.
#[track_caller]
pub(crate) fn run_at(listing: &str, line_cost: Time) -> String {
    let image = Arc::new(image(listing));
    events(&image, line_cost)
        .into_iter()
        .filter_map(|event| match event.kind {
            EventKind::Print { text } => Some(text + "\n"),
            EventKind::Error { code, line, .. } => Some(format!("error {code} in line {line:?}\n")),
            _ => None,
        })
        .collect()
}

fn check(listing: &str, expected: Expect) {
    expected.assert_eq(&run(listing));
}

#[test]
fn numbers_and_loops() {
    check(
        "
        num nSum
        program start()
          num i
          num j
        begin
          for i=1 to 10
            for j=i to 1 step -1
              nSum=nSum+j
            endFor
          endFor
          ? nSum
          ? i
          while i>0 and nSum!=217
            i=i-3
            nSum=nSum-1
          endWhile
          ? i
          do
            i=i+1
          until i>=2.5 or !(i<100)
          ? i
          ? 7%3-2*4/(1+1)
          ? -i%2
        end",
        expect![[r#"
            220
            11
            2
            3
            -3
            -1
        "#]],
    );
}

#[test]
fn calls_and_references() {
    check(
        "
        num nA[4]
        string sColl[\"k\"]
        program fib(num x_n, num& x_r)
          num l_a
          num l_b
        begin
          if x_n<2
            x_r=x_n
            return
          endIf
          call fib(x_n-1,l_a)
          call fib(x_n-2,l_b)
          x_r=l_a+l_b
        end
        program fill(num& x_a[], string& x_c[\"\"])
          num i
        begin
          for i=0 to size(x_a)-1
            x_a[i]=i+1
          endFor
          x_c[\"k\"]=\"v\"
        end
        program twice(num& x_a[])
        begin
          x_a[0]=2*x_a
        end
        program start()
          num n
          num l_nB[2]
        begin
          call fib(15,n)
          ? n
          call fill(nA[1],sColl)
          ? nA[3]+10*nA[1]
          ? sColl[\"k\"]
          call twice(n)
          ? n
          call fib(10,l_nB[1])
          ? l_nB[1]
        end",
        expect![[r#"
            610
            13
            v
            1220
            55
        "#]],
    );
}

#[test]
fn structures_and_user_types() {
    check(
        "
        type Slot \"Disk://Slot/Slot.pjx\"
        Slot tSlot[3]
        point pA[2]
        trsf trA
        joint jA
        program change(Slot x_t)
        begin
          x_t.nCount=99
        end
        program start()
          Slot l_t
          num i
        begin
          trA={10,20,30,,,90}
          ? trA*trA
          ? trA*!trA==trA
          pA[1].trsf=trA
          pA[1].config={lefty}
          pA[0]=pA[1]
          ? pA[0]
          ? pA[0]==pA[1]
          i=2
          tSlot[i].nCount=i*21
          tSlot[i].sNames[1]=\"b\"
          l_t=tSlot[0]=tSlot[i]
          call change(l_t)
          ? l_t.nCount
          ? l_t
          ? l_t==tSlot[2]
          l_t.sNames[1]=\"c\"
          ? l_t==tSlot[2]
          jA={1,2,3,4,5,6}
          ? jA+jA-{0,0,0,0,0,6}
          ? jA=={1,2,3,4,5,6.00001}
          ? jA<{2,3,4,5,6,6}
        end
        --- Slot
        public num nCount
        public string sNames[2]
        public trsf trAt
        ",
        expect![[r#"
            {-10,30,60,0,0,180}
            false
            {{10,20,30,0,0,90},{lefty,esame,wsame}}
            true
            42
            {42,{"","b"},{0,0,0,0,0,0}}
            true
            false
            {2,4,6,8,10,6}
            true
            false
        "#]],
    );
}

#[test]
fn switches() {
    check(
        "
        num n
        string s
        trsf tr
        program day()
        begin
          switch n
            case 1,2
              ? \"low\"
            break
            case 3
              ? \"three\"
            break
            default
              ? \"other\"
            break
          endSwitch
        end
        n=2
        call day()
        n=3
        call day()
        n=4
        call day()
        s=\"b\"
        switch s+\"c\"
          case \"ac\"
            ? 1
          break
          case \"bc\"
            ? 2
          break
        endSwitch
        tr={1,2,3,,,}
        switch tr
          case {1,2,3,,,}
            ? 3
          break
        endSwitch
        ",
        expect![[r#"
            low
            three
            other
            2
            3
        "#]],
    );
}

#[test]
fn errors_stop_at_their_line() {
    check(
        "num n[2]\nnum i\ni=1\ni=i+1\nn[i]=3\n? i",
        expect![[r#"
        error 20 in line 7
    "#]],
    );
    check(
        "num i\n? 1\n? 1/i\n? 2",
        expect![[r#"
        1
        error 10 in line 6
    "#]],
    );
    check(
        "string s[\"a\"]\ns[\"b\"]=\"x\"",
        expect![[r#"
        error 20 in line 5
    "#]],
    );
    check(
        "program start()\nbegin\ncall start()\nend",
        expect![[r#"
        error 41 in line 5
    "#]],
    );
}

#[test]
fn powers_of_negative_numbers() {
    for (version, output) in [("s8.10", "-27\n0\nerror 11 in line 8\n"), ("s7.11", "error 11 in line 6\n")] {
        let listing = format!(
            "version {version}\nnum nX\nprogram start()\nbegin\n  nX=-3\n  ? power(nX,3)\n  ? power(nX+3,2)\n  ? power(nX,0.5)\nend"
        );
        assert_eq!(run(&listing), output);
    }
}

/// An index is rounded as floor(x + 0.5) without rounding errors: the largest number below one half is index 0.
#[test]
fn indexes_are_rounded() {
    check(
        "
        num nA[3]
        program start()
          num i
        begin
          nA[0]=10
          nA[1]=11
          nA[2]=12
          for i=0 to 2.4 step 0.4
            ? nA[i]
          endFor
          ? nA[0.49999999999999994]
          i=-0.5
          ? nA[i]
          i=-0.6
          ? nA[i]
        end",
        expect![[r#"
            10
            10
            11
            11
            12
            12
            12
            10
            10
            error 21 in line 18
        "#]],
    );
}
